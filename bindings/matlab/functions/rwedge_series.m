classdef rwedge_series < handle
%RWEDGE_SERIES  The paper's series of a pressure.
%   The rounded wedge's own series, cut after the first terms coefficients.
%      Eq. (29), (31) with E1; new
%     terms  1 <= terms <= 2^24
%   rwedge:domain, rwedge:range, rwedge:memory.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   s = rwedge_series(alpha, terms)         of the rounded wedge
%   s = rwedge_series.fit(x, p, terms)      of any pressure, by least squares
%   value = s.terms()
%   value = s.coefficient(k)
%   value = s.residual()
%   value = s.pressure(x)
%   [re, im] = s.potential(f, x, y)
%   [sxx, syy, txy] = s.stress(f, x, y)
%
%   It is freed when the last variable that holds it is cleared. "help rwedge_series.residual" and so on say more.
    properties (SetAccess = private, Hidden, Transient)
        number = 0
    end
    methods
        function series = rwedge_series(alpha, terms)
            if nargin == 1
                error('rwedge:arguments', 'too few arguments: series = rwedge_series(alpha, terms)');
            elseif nargin > 0
                series.number = rwedge_mex('series_create', alpha, terms);
            end
        end

        function delete(series)
        %DELETE  Frees the series; clear does so too.
            rwedge_mex('series_destroy', series.number);
        end

        function value = terms(series)
        %TERMS  value = series.terms()
        %   How many coefficients it holds.
            value = rwedge_mex('series_terms', series.number);
        end

        function value = coefficient(series, k)
        %COEFFICIENT  value = series.coefficient(k)
        %   a_k; 0 for k >= terms; NaN outside the domain.
        %     k  index of the coefficient, >= 0
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: value = series.coefficient(k)');
            end
            value = rwedge_mex('series_coefficient', series.number, k);
        end

        function value = residual(series)
        %RESIDUAL  value = series.residual()
        %   Error of the series as a pressure. From rwedge_series.fit(): the root mean square of fit minus
        %   sample. From rwedge_series(): an upper bound of what is cut off, sum |a_k| for k >=
        %   terms, valid for the pressure and for |G| anywhere (Inf for the sharp wedge, whose
        %   coefficients have no finite sum).
            value = rwedge_mex('series_residual', series.number);
        end

        function value = pressure(series, x)
        %PRESSURE  value = series.pressure(x)
        %   The pressure at x; 0 for |x| >= 1; NaN outside the domain.   Eq. (29)
        %     x  place along the surface, in b, finite
            if nargin < 2
                error('rwedge:arguments', 'too few arguments: value = series.pressure(x)');
            end
            value = rwedge_mex('series_pressure', series.number, x);
        end

        function [re, im] = potential(series, f, x, y)
        %POTENTIAL  [re, im] = series.potential(f, x, y)
        %   Muskhelishvili's potential Phi for q = f p: Phi = -((i+f)/2) sum a_k R^(k+1), R = z -
        %   sqrt(z^2-1).   Eq. (30), (34), E2, E3
        %   rwedge:domain, rwedge:handle.
        %     f  coefficient of friction, 0 <= f <= 1e6
        %     x  place along the surface, in b, finite
        %     y  depth below it, in b, finite, >= 0
            if nargin < 4
                error('rwedge:arguments', 'too few arguments: [re, im] = series.potential(f, x, y)');
            end
            [re, im] = rwedge_mex('series_potential', series.number, f, x, y);
        end

        function [sxx, syy, txy] = stress(series, f, x, y)
        %STRESS  [sxx, syy, txy] = series.stress(f, x, y)
        %   Stresses for q = f p.   Eq. (32), (33)
        %   rwedge:domain, rwedge:handle. The derivative converges like the series of R^k at the edges:
        %   slowly.
        %     f  coefficient of friction, 0 <= f <= 1e6
        %     x  place along the surface, in b, finite
        %     y  depth below it, in b, finite, >= 0
            if nargin < 4
                error('rwedge:arguments', 'too few arguments: [sxx, syy, txy] = series.stress(f, x, y)');
            end
            [sxx, syy, txy] = rwedge_mex('series_stress', series.number, f, x, y);
        end
    end
    methods (Static)
        function series = fit(x, p, terms)
        %FIT  series = rwedge_series.fit(x, p, terms)
        %   Least-squares fit to samples of any pressure that vanishes at x = +-1, even or not.
        %      Sec. 4 of the paper
        %     samples  number of samples, >= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33; a
        %              fit takes up to 1 GiB and half a minute
        %     x, p     place and pressure, |x| < 1, finite; samples near Chebyshev's points (x = cos t, t
        %              equally spaced) fit best
        %     terms    >= 1
        %   rwedge:rank where the samples do not determine the coefficients to half the digits of a double
        %   (repeated or clustered points, or fewer than terms); rwedge:domain, rwedge:range,
        %   rwedge:memory, rwedge:noconv.
            if nargin < 3
                error('rwedge:arguments', 'too few arguments: series = rwedge_series.fit(x, p, terms)');
            end
            series = rwedge_series();
            series.number = rwedge_mex('series_fit', x, p, terms);
        end
    end
end

% SPDX-License-Identifier: GPL-3.0-or-later

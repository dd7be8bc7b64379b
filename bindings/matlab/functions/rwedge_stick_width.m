function value = rwedge_stick_width(alpha, Q_over_fP)
%RWEDGE_STICK_WIDTH  value = rwedge_stick_width(alpha, Q_over_fP)
%   Half-width of the stick zone c/b, under a tangential force Q < fP that grew from zero under
%   constant P.   Eq. (25)
%     Q_over_fP  0 <= Q/(fP) <= 1; 0 sticks everywhere (1), 1 slides (0)
%   NaN outside the domain. Relative error below 1e-14. Inverse: rwedge_shear_ratio().
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_stick_width(alpha, Q_over_fP)');
end
value = rwedge_mex('stick_width', alpha, Q_over_fP);
end

% SPDX-License-Identifier: GPL-3.0-or-later

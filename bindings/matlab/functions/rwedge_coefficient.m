function value = rwedge_coefficient(alpha, n)
%RWEDGE_COEFFICIENT  value = rwedge_coefficient(alpha, n)
%   Coefficient b_n of the paper's series p = -sqrt(1-x^2) sum b_n U_2n(x).
%      Eq. (29), (31) with E1; new
%     n  index of the coefficient, >= 0
%   NaN outside the domain; 0 for alpha >= 1 and n >= 1. Relative error below 1e-14 for every n;
%   where alpha is within 1e-9 (relatively) of a zero of b_n, below 1e-22 of the values around.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_coefficient(alpha, n)');
end
value = rwedge_mex('coefficient', alpha, n);
end

% SPDX-License-Identifier: GPL-3.0-or-later

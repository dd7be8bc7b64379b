function value = rwedge_shear_ratio(alpha, c)
%RWEDGE_SHEAR_RATIO  value = rwedge_shear_ratio(alpha, c)
%   Q/(fP) from the half-width of the stick zone.   Eq. (25)
%   NaN outside the domain. Relative error below 1e-14, also where it goes to 0 (c near 1).
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%     c      half-width of the stick zone over b, 0 <= c <= 1; 0 is full sliding
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_shear_ratio(alpha, c)');
end
value = rwedge_mex('shear_ratio', alpha, c);
end

% SPDX-License-Identifier: GPL-3.0-or-later

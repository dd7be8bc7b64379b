function value = rwedge_shear(alpha, c, x)
%RWEDGE_SHEAR  value = rwedge_shear(alpha, c, x)
%   Shear traction A q/(f theta) at x, with a stick zone |x| < c; it has the sign of the pressure
%   (q = f p where it slips); 0 for |x| >= 1.   Eq. (23), (26), (27)
%   NaN outside the domain, and for alpha = c = x = 0. Error below 1e-14 (1 + |A p/theta|).
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%     c      half-width of the stick zone over b, 0 <= c <= 1; 0 is full sliding
%     x      place along the surface, in b, finite
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: value = rwedge_shear(alpha, c, x)');
end
value = rwedge_mex('shear', alpha, c, x);
end

% SPDX-License-Identifier: GPL-3.0-or-later

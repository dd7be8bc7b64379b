function value = rwedge_pressure(alpha, x)
%RWEDGE_PRESSURE  value = rwedge_pressure(alpha, x)
%   Contact pressure A p/theta at x, compression negative; 0 for |x| >= 1.   Eq. (8), (12), (14)
%   NaN outside the domain, and at the apex of the sharp wedge (alpha = 0, x = 0), where it is
%   infinite. Relative error below 1e-12, up to the zeros at x = +-1.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%     x      place along the surface, in b, finite
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_pressure(alpha, x)');
end
value = rwedge_mex('pressure', alpha, x);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_radius(theta, a)
%RWEDGE_RADIUS  value = rwedge_radius(theta, a)
%   Radius of the rounding, R = a/theta, length.   Sec. 2
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%     a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
%
%   The arguments are arrays of one size, or scalars, which go with every element.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_radius(theta, a)');
end
value = rwedge_mex('radius', theta, a);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_radius(theta, a)
%RWEDGE_RADIUS  value = rwedge_radius(theta, a)
%   Radius of the rounding, R = a/theta, length.   Sec. 2
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%     a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_radius(theta, a)');
end
value = rwedge_mex('radius', theta, a);
end

% SPDX-License-Identifier: GPL-3.0-or-later

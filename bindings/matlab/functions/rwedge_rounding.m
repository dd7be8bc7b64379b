function value = rwedge_rounding(theta, R)
%RWEDGE_ROUNDING  value = rwedge_rounding(theta, R)
%   Half-width of the rounding from its radius, a = R theta, length.   Sec. 2
%     R  radius, length, finite, >= 0
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_rounding(theta, R)');
end
value = rwedge_mex('rounding', theta, R);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_normal_load(theta, a, A, b)
%RWEDGE_NORMAL_LOAD  value = rwedge_normal_load(theta, a, A, b)
%   The load P whose contact has the half-width b, force/length.   Eq. (7), (11), (15)
%     b  length, finite, >= 0; 0 gives 0
%   Relative error below 1e-14. Inverse: rwedge_half_width().
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%     a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
%     A      composite compliance, 1/stress, finite, > 0: rwedge_compliance()
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 4
    error('rwedge:arguments', 'too few arguments: value = rwedge_normal_load(theta, a, A, b)');
end
value = rwedge_mex('normal_load', theta, a, A, b);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function [left, right] = rwedge_permanent_stick(theta, a, A, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2)
%RWEDGE_PERMANENT_STICK  [left, right] = rwedge_permanent_stick(theta, a, A, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2)
%   The zone that never slips while loads go to and fro between two points in a straight line, once
%   the first cycles are over, whatever was before.   new
%     P1, P2          finite, >= 0, as for rwedge_contact.apply()
%     M1, M2          finite; 0 where P is 0
%     Q1, Q2          |Q| <= f P
%     sigma1, sigma2  finite
%     left, right     its edges, length
%   The compliances are equal: a tension stretches the surface by A/4 of it.
%   rwedge:absent where all slides at times; rwedge:path where the edges slip in opposite
%   directions, or what sticks would reach beyond one of the contacts; rwedge:sliding,
%   rwedge:domain, rwedge:range, rwedge:memory. Error as that of
%   rwedge_contact.stick_zone().
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%     a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
%     A      composite compliance, 1/stress, finite, > 0: rwedge_compliance()
%     f      coefficient of friction, 0 <= f <= 1e6
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
%   Where rwedge:absent is said above, the results are NaN, and no error.
if nargin < 12
    error('rwedge:arguments', 'too few arguments: [left, right] = rwedge_permanent_stick(theta, a, A, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2)');
end
[left, right] = rwedge_mex('permanent_stick', theta, a, A, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2);
end

% SPDX-License-Identifier: GPL-3.0-or-later

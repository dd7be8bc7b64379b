function value = rwedge_yield_load(theta, a, A, f, nu, k)
%RWEDGE_YIELD_LOAD  value = rwedge_yield_load(theta, a, A, f, nu, k)
%   The load P at which a given contact first yields in full sliding, or under a normal load (f =
%   0), force/length. The contact grows with P, and the elastic limit depends on a/b: P is the root
%   of an equation.   Figs. 3 to 5
%     nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
%   It is 0 for the sharp wedge. It is Inf where the contact does not yield before it is 1e14
%   a wide. For f = 0 and nu = 0.5 it never yields if k > (2/pi) theta/A: the deviator stays
%   bounded however large the load. Relative error below 1e-11, and 1e-15 dlnP/dlnk, which is large
%   for f = 0 and nu near 0.5.
%     theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small angles
%     a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
%     A      composite compliance, 1/stress, finite, > 0: rwedge_compliance()
%     f      coefficient of friction, 0 <= f <= 1e6
%     k      yield stress in pure shear, stress, finite, > 0
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 6
    error('rwedge:arguments', 'too few arguments: value = rwedge_yield_load(theta, a, A, f, nu, k)');
end
value = rwedge_mex('yield_load', theta, a, A, f, nu, k);
end

% SPDX-License-Identifier: GPL-3.0-or-later

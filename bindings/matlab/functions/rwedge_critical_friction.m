function value = rwedge_critical_friction(alpha, nu)
%RWEDGE_CRITICAL_FRICTION  value = rwedge_critical_friction(alpha, nu)
%   Critical friction: the f at which yield jumps from below to the surface. It is 0 where yield is
%   at the surface without friction already. (The smallest of these tips, a/b < 0.0026, yield
%   below the surface again in an interval of f: lib/README.md.)   Fig. 4; new
%     alpha  0, or at least 1e-14; the sharp wedge yields at its apex: 0
%   NaN outside the domain. Error below 1e-11 f, or 1e-14/f next to its zero, from which it rises
%   like a square root.
%     nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 2
    error('rwedge:arguments', 'too few arguments: value = rwedge_critical_friction(alpha, nu)');
end
value = rwedge_mex('critical_friction', alpha, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

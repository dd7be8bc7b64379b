function [limit, x] = rwedge_surface_yield(alpha, f, nu)
%RWEDGE_SURFACE_YIELD  [limit, x] = rwedge_surface_yield(alpha, f, nu)
%   At the surface: the maximum of J2 over y = 0. It is at 0 <= x <= min(alpha, 1). rwedge:absent
%   for nu = 0.5 and f = 0, where J2 is 0 on the surface.
%     alpha  0, or at least 1e-14
%   rwedge:domain.   Fig. 4; new
%     f   coefficient of friction, 0 <= f <= 1e6
%     nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
%   Where rwedge:absent is said above, the results are NaN, and no error.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: [limit, x] = rwedge_surface_yield(alpha, f, nu)');
end
[limit, x] = rwedge_mex('surface_yield', alpha, f, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

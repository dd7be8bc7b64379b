function [limit, x, y] = rwedge_yield_point(alpha, f, nu)
%RWEDGE_YIELD_POINT  [limit, x, y] = rwedge_yield_point(alpha, f, nu)
%   The elastic limit and where it yields: y = 0 is at the surface.   Fig. 5
%     alpha  0, or at least 1e-14
%   The sharp wedge yields at its apex. For nu = 0.5 and alpha >= 1 the whole surface of the
%   contact is equally stressed.
%   rwedge:domain. Error of the place about 1e-12 where the maximum is not flat.
%     f   coefficient of friction, 0 <= f <= 1e6
%     nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: [limit, x, y] = rwedge_yield_point(alpha, f, nu)');
end
[limit, x, y] = rwedge_mex('yield_point', alpha, f, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

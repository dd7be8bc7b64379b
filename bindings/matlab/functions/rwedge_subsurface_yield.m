function [limit, x, y] = rwedge_subsurface_yield(alpha, f, nu)
%RWEDGE_SUBSURFACE_YIELD  [limit, x, y] = rwedge_subsurface_yield(alpha, f, nu)
%   The elastic limit has two branches, below the surface and at it. It is the smaller of the two,
%   and the cusps of Fig. 4 are where they cross. Each branch is smooth in alpha, f and nu, so that
%   each can be interpolated.   Fig. 4; new
%
%   Below the surface: the local maximum of J2 that is on the axis for f = 0. Large f and small
%   alpha have none: rwedge:absent.
%     alpha  0, or at least 1e-14
%   rwedge:domain.
%     f   coefficient of friction, 0 <= f <= 1e6
%     nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
%   Where rwedge:absent is said above, the results are NaN, and no error.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: [limit, x, y] = rwedge_subsurface_yield(alpha, f, nu)');
end
[limit, x, y] = rwedge_mex('subsurface_yield', alpha, f, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

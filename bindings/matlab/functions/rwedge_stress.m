function [sxx, syy, txy] = rwedge_stress(alpha, f, c, x, y)
%RWEDGE_STRESS  [sxx, syy, txy] = rwedge_stress(alpha, f, c, x, y)
%   Stresses at the point (x, y), in theta/A, tension positive; closed form.
%      Eq. (28), (32), (33) with E4, E8; new
%     x, y           in b, finite, y >= 0; not the apex (0, 0) of the sharp wedge
%     sxx, syy, txy  each receives one number
%   rwedge:domain.
%   Error below 1e-13 of the larger of the tensor's norm and max(1, f)/(1+|z|), z = x + iy.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%     f      coefficient of friction, 0 <= f <= 1e6
%     c      half-width of the stick zone over b, 0 <= c <= 1; 0 is full sliding
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 5
    error('rwedge:arguments', 'too few arguments: [sxx, syy, txy] = rwedge_stress(alpha, f, c, x, y)');
end
[sxx, syy, txy] = rwedge_mex('stress', alpha, f, c, x, y);
end

% SPDX-License-Identifier: GPL-3.0-or-later

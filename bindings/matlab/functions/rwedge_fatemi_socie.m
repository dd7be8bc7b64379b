function [value, angle] = rwedge_fatemi_socie(sxx, syy, txy, E, nu, k_over_sy)
%RWEDGE_FATEMI_SOCIE  [value, angle] = rwedge_fatemi_socie(sxx, syy, txy, E, nu, k_over_sy)
%   Fatemi and Socie's parameter of a cycle of stresses at one point, a strain: the largest value of
%       (dgamma/2) (1 + k sn_max/sy)
%   over the planes that contain z. In the cycle, dgamma is the range of the plane's shear strain,
%   2(1+nu)/E times its shear stress, and sn_max its largest normal stress: where that is
%   compressive it counts as it is, but no plane counts less than 0.
%      Fatemi and Socie (1988), see lib/README.md; new
%     k_over_sy  k over the yield stress in tension sy, 1/stress, 0 or 1e-60 to 1e60; k is 0.3 to 1
%                for most metals
%     others     as in rwedge_smith_watson_topper()
%   rwedge:domain; rwedge:range for n = 0. Error below 1e-14 (1 + s k/sy) s
%   (1+nu)/E.
%     sxx, syy, txy  stresses, of at most 1e60 in magnitude
%     E              Young's modulus, stress, 1e-60 to 1e60
%     nu             Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
if nargin < 6
    error('rwedge:arguments', 'too few arguments: [value, angle] = rwedge_fatemi_socie(sxx, syy, txy, E, nu, k_over_sy)');
end
[value, angle] = rwedge_mex('fatemi_socie', sxx, syy, txy, E, nu, k_over_sy);
end

% SPDX-License-Identifier: GPL-3.0-or-later

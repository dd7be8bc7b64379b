function [value, angle] = rwedge_smith_watson_topper(sxx, syy, txy, E, nu)
%RWEDGE_SMITH_WATSON_TOPPER  [value, angle] = rwedge_smith_watson_topper(sxx, syy, txy, E, nu)
%   Smith, Watson and Topper's parameter of a cycle of stresses at one point, a stress: the largest
%   value of
%       sn_max den/2
%   over the planes that contain z. In the cycle, sn_max is the plane's largest normal stress (0 for
%   a plane that is never in tension), den the range of its normal strain. Strains are elastic and
%   plane, exx = (1+nu)/E ((1-nu) sxx - nu syy). For plane stress give E (1+2nu)/(1+nu)^2 for E and
%   nu/(1+nu) for nu.
%      Smith, Watson, Topper (1970); on planes Socie (1987); see lib/README.md; new
%     n              number of loads of the cycle, >= 1; their order does not matter
%     sxx, syy, txy  n stresses each
%     E              Young's modulus, stress, 1e-60 to 1e60
%     value, angle   each receives one number. The angle is that of the plane, as in
%                    rwedge_principal_stresses(); of one of them where several planes have the
%                    value, 0 where the value is 0
%   rwedge:domain; rwedge:range for n = 0. Error below 1e-14 s^2 (1+nu)/E, s being
%   the largest principal stress of the cycle in magnitude: planes are not sampled, and none exceeds
%   the value by more. The time grows like n; like n^2 where n is above 64 and many loads in turn
%   are the worst for neighbouring planes, as on a circular path.
%     nu  Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
if nargin < 5
    error('rwedge:arguments', 'too few arguments: [value, angle] = rwedge_smith_watson_topper(sxx, syy, txy, E, nu)');
end
[value, angle] = rwedge_mex('smith_watson_topper', sxx, syy, txy, E, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

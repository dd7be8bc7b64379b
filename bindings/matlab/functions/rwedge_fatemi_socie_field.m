function [value, angle] = rwedge_fatemi_socie_field(sxx, syy, txy, E, nu, k_over_sy)
%RWEDGE_FATEMI_SOCIE_FIELD  [value, angle] = rwedge_fatemi_socie_field(sxx, syy, txy, E, nu, k_over_sy)
%   The same at n points.
%     loads          number of loads of the cycle, >= 1
%     sxx, syy, txy  loads * n stresses each: that of load i at point j is at [i n + j]
%     value, angle   each receives n numbers
%   Nothing is written unless every stress is in the domain.
%     E          Young's modulus, stress, 1e-60 to 1e60
%     nu         Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
%     k_over_sy  k over the yield stress in tension sy, 1/stress, 0 or 1e-60 to 1e60; k is 0.3 to 1 for most metals
if nargin < 6
    error('rwedge:arguments', 'too few arguments: [value, angle] = rwedge_fatemi_socie_field(sxx, syy, txy, E, nu, k_over_sy)');
end
[value, angle] = rwedge_mex('fatemi_socie_field', sxx, syy, txy, E, nu, k_over_sy);
end

% SPDX-License-Identifier: GPL-3.0-or-later

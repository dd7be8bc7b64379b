function [value, angle] = rwedge_smith_watson_topper_field(sxx, syy, txy, E, nu)
%RWEDGE_SMITH_WATSON_TOPPER_FIELD  [value, angle] = rwedge_smith_watson_topper_field(sxx, syy, txy, E, nu)
%   The same at n points.
%     loads          number of loads of the cycle, >= 1
%     sxx, syy, txy  loads * n stresses each: that of load i at point j is at [i n + j]
%     value, angle   each receives n numbers
%   Nothing is written unless every stress is in the domain.
%     E   Young's modulus, stress, 1e-60 to 1e60
%     nu  Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
if nargin < 5
    error('rwedge:arguments', 'too few arguments: [value, angle] = rwedge_smith_watson_topper_field(sxx, syy, txy, E, nu)');
end
[value, angle] = rwedge_mex('smith_watson_topper_field', sxx, syy, txy, E, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_validity(theta, alpha, beta, f, k_over_E, safety)
%RWEDGE_VALIDITY  value = rwedge_validity(theta, alpha, beta, f, k_over_E, safety)
%   What makes the results for such a contact doubtful, as a sum of bits: rwedge_validity_text()
%   says what each means. The sum is 0 where nothing does. What is not known is given as NaN; it adds
%   no doubt. Nor does a 0, except as safety.   new
%     theta     any number; the angle between flank and surface, rad
%     alpha     any number; a/b under the load; 0 is the sharp wedge
%     beta      any number; rwedge_dundurs_beta()
%     f         any number; the coefficient of friction
%     k_over_E  any number; yield stress in pure shear over Young's modulus of the half-plane
%     safety    any number; rwedge_yield_load() over P, or that of rwedge_contact.yield_factor()
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 6
    error('rwedge:arguments', 'too few arguments: value = rwedge_validity(theta, alpha, beta, f, k_over_E, safety)');
end
value = rwedge_mex('validity', theta, alpha, beta, f, k_over_E, safety);
end

% SPDX-License-Identifier: GPL-3.0-or-later

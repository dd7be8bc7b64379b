function value = rwedge_a_over_b(AP_over_theta_a)
%RWEDGE_A_OVER_B  value = rwedge_a_over_b(AP_over_theta_a)
%   The contact law solved for its half-width: a/b from A P/(theta a), over the whole range, Hertz
%   (a/b >= 1) included.   Eq. (7), (11), inverse
%     AP_over_theta_a  > 0, finite
%   NaN outside the domain, or where a/b leaves it. Relative error below 1e-14.
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_a_over_b(AP_over_theta_a)');
end
value = rwedge_mex('a_over_b', AP_over_theta_a);
end

% SPDX-License-Identifier: GPL-3.0-or-later

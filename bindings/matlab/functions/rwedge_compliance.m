function value = rwedge_compliance(E1, nu1, E2, nu2)
%RWEDGE_COMPLIANCE  value = rwedge_compliance(E1, nu1, E2, nu2)
%   Composite compliance A = 2(1-nu1^2)/E1 + 2(1-nu2^2)/E2, in 1/unit of E.   Eq. (2)
%     E1, E2    Young's moduli, > 0; Inf is a rigid body (one of the two at most)
%     nu1, nu2  Poisson's ratios, -1 < nu <= 0.5
%   NaN outside the domain, or where A leaves it. Relative error below 4 epsilon.
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 4
    error('rwedge:arguments', 'too few arguments: value = rwedge_compliance(E1, nu1, E2, nu2)');
end
value = rwedge_mex('compliance', E1, nu1, E2, nu2);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_dundurs_beta(E1, nu1, E2, nu2)
%RWEDGE_DUNDURS_BETA  value = rwedge_dundurs_beta(E1, nu1, E2, nu2)
%   Dundurs' second constant for plane strain. It couples the normal and the tangential problem: the
%   theory with friction is exact where it is 0 (elastically similar bodies).
%      Dundurs (1969), see lib/README.md
%     arguments as for rwedge_compliance(); beta changes sign when the bodies are exchanged;
%     |beta| <= 1/2 for nu >= 0
%   NaN outside the domain. Error below 4 epsilon, absolutely.
%     E1, E2    Young's moduli, > 0; Inf is a rigid body (one of the two at most)
%     nu1, nu2  Poisson's ratios, -1 < nu <= 0.5
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 4
    error('rwedge:arguments', 'too few arguments: value = rwedge_dundurs_beta(E1, nu1, E2, nu2)');
end
value = rwedge_mex('dundurs_beta', E1, nu1, E2, nu2);
end

% SPDX-License-Identifier: GPL-3.0-or-later

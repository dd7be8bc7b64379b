function value = rwedge_elastic_limit(alpha, f, nu)
%RWEDGE_ELASTIC_LIMIT  value = rwedge_elastic_limit(alpha, f, nu)
%   Elastic limit P/(bk): the load at first yield (von Mises, plane strain) in full sliding, or
%   under a normal load (f = 0).   Figs. 3 to 5
%   It belongs to the global maximum of J2 over the half-plane. It is 0 for the sharp wedge, whose
%   stresses are infinite; but pi for nu = 0.5 and f = 0.
%     alpha  0, or at least 1e-14: the J2 of smaller tips can be too flat for its maximum to be found
%   NaN outside the domain. Relative error below 1e-12.
%     f   coefficient of friction, 0 <= f <= 1e6
%     nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: value = rwedge_elastic_limit(alpha, f, nu)');
end
value = rwedge_mex('elastic_limit', alpha, f, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

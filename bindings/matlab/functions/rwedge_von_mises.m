function value = rwedge_von_mises(sxx, syy, txy, nu)
%RWEDGE_VON_MISES  value = rwedge_von_mises(sxx, syy, txy, nu)
%   Von Mises' equivalent stress, sqrt(3 J2).   von Mises (1913)
%   NaN outside the domain. Relative error below 4 epsilon.
%     sxx, syy, txy  stresses, of at most 1e60 in magnitude
%     nu             Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 4
    error('rwedge:arguments', 'too few arguments: value = rwedge_von_mises(sxx, syy, txy, nu)');
end
value = rwedge_mex('von_mises', sxx, syy, txy, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

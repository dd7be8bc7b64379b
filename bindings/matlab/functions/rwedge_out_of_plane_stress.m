function value = rwedge_out_of_plane_stress(sxx, syy, nu)
%RWEDGE_OUT_OF_PLANE_STRESS  value = rwedge_out_of_plane_stress(sxx, syy, nu)
%   The stress across the plane of x and y, szz = nu (sxx+syy). It is a principal stress.
%   NaN outside the domain. Relative error below 4 epsilon.
%     sxx, syy  stresses, of at most 1e60 in magnitude
%     nu        Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: value = rwedge_out_of_plane_stress(sxx, syy, nu)');
end
value = rwedge_mex('out_of_plane_stress', sxx, syy, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

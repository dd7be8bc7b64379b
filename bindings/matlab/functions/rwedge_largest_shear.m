function value = rwedge_largest_shear(sxx, syy, txy, nu)
%RWEDGE_LARGEST_SHEAR  value = rwedge_largest_shear(sxx, syy, txy, nu)
%   The largest shear stress on any plane: half of the difference between the largest and the
%   smallest principal stress, szz among them.   Tresca (1864)
%   NaN outside the domain. Relative error below 4 epsilon.
%     sxx, syy, txy  stresses, of at most 1e60 in magnitude
%     nu             Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane stress, szz = 0, give nu = 0
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 4
    error('rwedge:arguments', 'too few arguments: value = rwedge_largest_shear(sxx, syy, txy, nu)');
end
value = rwedge_mex('largest_shear', sxx, syy, txy, nu);
end

% SPDX-License-Identifier: GPL-3.0-or-later

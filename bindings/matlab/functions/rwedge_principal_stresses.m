function [s1, s2, angle] = rwedge_principal_stresses(sxx, syy, txy)
%RWEDGE_PRINCIPAL_STRESSES  [s1, s2, angle] = rwedge_principal_stresses(sxx, syy, txy)
%   Principal stresses in the plane of x and y, s1 >= s2, and the plane on which s1 acts.
%     s1, s2  each receives one number
%     angle   receives the angle between that plane's normal and the surface's normal, the y axis,
%             rad, -pi/2 < angle <= pi/2. The plane's normal is (x, y) = (sin(angle), cos(angle)):
%             positive angles turn from +y towards +x. 0 where s1 = s2
%   rwedge:domain. Error of s1 and s2 below 4 epsilon of the larger magnitude of the
%   two, of the angle below 4 epsilon.
%     sxx, syy, txy  stresses, of at most 1e60 in magnitude
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 3
    error('rwedge:arguments', 'too few arguments: [s1, s2, angle] = rwedge_principal_stresses(sxx, syy, txy)');
end
[s1, s2, angle] = rwedge_mex('principal_stresses', sxx, syy, txy);
end

% SPDX-License-Identifier: GPL-3.0-or-later

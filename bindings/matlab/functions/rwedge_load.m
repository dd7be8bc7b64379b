function value = rwedge_load(alpha)
%RWEDGE_LOAD  value = rwedge_load(alpha)
%   Load of a contact of half-width b, as A P/(theta b): 2 for the sharp wedge, (pi/2)/alpha for
%   Hertz.   Eq. (7), (11), (13), (15)
%   NaN outside the domain of alpha. Relative error below 4 epsilon. Inverse: rwedge_a_over_b().
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_load(alpha)');
end
value = rwedge_mex('load', alpha);
end

% SPDX-License-Identifier: GPL-3.0-or-later

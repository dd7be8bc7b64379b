function value = rwedge_max_tension(alpha)
%RWEDGE_MAX_TENSION  value = rwedge_max_tension(alpha)
%   Maximum tension b s1/(fP), at the trailing edge in full sliding: 1 for the sharp wedge, 4/pi
%   for Hertz.   Eq. (38); new
%   NaN outside the domain. Relative error below 1e-14.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_max_tension(alpha)');
end
value = rwedge_mex('max_tension', alpha);
end

% SPDX-License-Identifier: GPL-3.0-or-later

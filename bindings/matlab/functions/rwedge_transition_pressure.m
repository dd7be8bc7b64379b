function value = rwedge_transition_pressure(alpha)
%RWEDGE_TRANSITION_PRESSURE  value = rwedge_transition_pressure(alpha)
%   Magnitude of the pressure where the rounding meets the flank, x = +-a, as A p/theta; 0 for
%   alpha >= 1, where x = a is not inside the contact.   Eq. (9)
%   NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_transition_pressure(alpha)');
end
value = rwedge_mex('transition_pressure', alpha);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_peak_pressure(alpha)
%RWEDGE_PEAK_PRESSURE  value = rwedge_peak_pressure(alpha)
%   Magnitude of the peak pressure, at x = 0, as A p0/theta.   Eq. (10), (16)
%   NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14.
%     alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is Hertz' contact
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_peak_pressure(alpha)');
end
value = rwedge_mex('peak_pressure', alpha);
end

% SPDX-License-Identifier: GPL-3.0-or-later

function value = rwedge_strerror(status)
%RWEDGE_STRERROR  value = rwedge_strerror(status)
%   What a status means, in English. Static text.
%     status  any integer
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_strerror(status)');
end
value = rwedge_mex('strerror', status);
end

% SPDX-License-Identifier: GPL-3.0-or-later

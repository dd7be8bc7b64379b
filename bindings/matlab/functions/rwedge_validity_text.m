function value = rwedge_validity_text(doubt)
%RWEDGE_VALIDITY_TEXT  value = rwedge_validity_text(doubt)
%   What one bit of rwedge_validity() means, in English: a line for messages. Empty for any other
%   number. To list all bits, go through 1, 2, 4 ... until the text is empty.
%   Static text.
%     doubt  any integer
%
%   The arguments are arrays of one size; where one has the size 1, it goes with all along that dimension.
if nargin < 1
    error('rwedge:arguments', 'too few arguments: value = rwedge_validity_text(doubt)');
end
value = rwedge_mex('validity_text', doubt);
end

% SPDX-License-Identifier: GPL-3.0-or-later

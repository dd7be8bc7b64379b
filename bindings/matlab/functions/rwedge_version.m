function value = rwedge_version()
%RWEDGE_VERSION  value = rwedge_version()
%   The library's version, "MAJOR.MINOR.PATCH"; RWEDGE_VERSION is that of the header. Static text.
value = rwedge_mex('version');
end

% SPDX-License-Identifier: GPL-3.0-or-later

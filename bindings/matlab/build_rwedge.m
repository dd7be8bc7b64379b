% SPDX-License-Identifier: GPL-3.0-or-later
function folder = build_rwedge(prefix, folder)
%BUILD_RWEDGE  Builds rwedge for this MATLAB or GNU Octave.
%   build_rwedge(PREFIX, FOLDER) compiles rwedge_mex.c and writes the functions and classes, with help texts from rwedge.h,
%   into FOLDER, which is all that need be on the path. PREFIX is where rwedge is installed, built with
%   RWEDGE_PRIVATE_DEPS=ON (so that its static library needs no other): include/rwedge.h and lib/librwedge.a.
%   The default of PREFIX is three folders up, where an installed copy of this file finds it; of FOLDER, ./rwedge.
here = fileparts(mfilename('fullpath'));
if nargin < 1
    prefix = fullfile(here, '..', '..', '..');
end
if nargin < 2
    folder = fullfile(pwd, 'rwedge');
end
if ~exist(folder, 'dir')
    mkdir(folder);
end
header = fullfile(prefix, 'include', 'rwedge.h');
library = fullfile(prefix, 'lib', 'librwedge.a');
for needed = {header, library}
    if ~exist(needed{1}, 'file')
        error('rwedge:build', '%s is missing: is rwedge installed at %s?', needed{1}, prefix);
    end
end
compile(fullfile(here, 'rwedge_mex.c'), fullfile(prefix, 'include'), library, folder);
write_functions(header, here, folder);
try_out(folder, library);
end

% Does the MEX file load? Not where the library needs a GSL and LAPACK of its own still.
function try_out(folder, library)
before = path();
back = onCleanup(@() path(before)); %#ok<NASGU>
addpath(folder);
try
    rwedge_mex('version');
catch reason
    error('rwedge:build', 'rwedge_mex does not run: was %s built with -DRWEDGE_PRIVATE_DEPS=ON? %s', library, reason.message);
end
end

function compile(source, include, library, folder)
if exist('OCTAVE_VERSION', 'builtin')
    status = system(sprintf('mkoctfile --mex -I"%s" "%s" "%s" -o "%s"', include, source, library, ...
        fullfile(folder, ['rwedge_mex.' mexext()])));
    if status ~= 0
        error('rwedge:build', 'mkoctfile failed');
    end
else
    mex(['-I' include], source, library, '-outdir', folder, '-output', 'rwedge_mex');
end
end

% SPDX-License-Identifier: GPL-3.0-or-later
function folder = build_rwedge(prefix, folder)
%BUILD_RWEDGE  Builds rwedge for this MATLAB or GNU Octave.
%   build_rwedge(PREFIX, FOLDER) compiles rwedge_mex.c and puts it and the functions and classes into FOLDER, which is all
%   that need be on the path. PREFIX is where rwedge is installed, built with
%   RWEDGE_PRIVATE_DEPS=ON (so that its static library needs no other): include/rwedge.h and librwedge.a, in lib, lib64 or a
%   folder of lib, such as lib/x86_64-linux-gnu.
%   The default of PREFIX is the folder prebuilt/SYSTEM beside this file, in the folder for MATLAB that is given away; else three
%   folders up, where an installed copy of this file finds it. The default of FOLDER is ./rwedge.
%   After an error FOLDER is as it was.
here = fileparts(mfilename('fullpath'));
if nargin < 1
    prefix = default_prefix(here);
end
if nargin < 2
    folder = fullfile(pwd, 'rwedge');
end
include = {fullfile(prefix, 'include'), here}; % rwedge.h, entries.h
library = find_library(prefix);
for needed = {fullfile(prefix, 'include', 'rwedge.h'), library}
    if ~exist(needed{1}, 'file')
        error('rwedge:build', '%s is missing: is rwedge installed at %s?', needed{1}, prefix);
    end
end
[~, unique] = fileparts(tempname());
made = [regexprep(folder, '[/\\]+$', '') '-' unique]; % beside FOLDER, and moved into it when all is well
make_folder(made);
gone = onCleanup(@() remove_folder(made)); %#ok<NASGU>
compile(fullfile(here, 'rwedge_mex.c'), include, library, made);
copyfile(fullfile(here, 'functions', '*.m'), made);
try_out(made, library);
make_folder(folder);
[moved, reason] = movefile(fullfile(made, '*'), folder, 'f');
if ~moved
    error('rwedge:build', 'cannot write into %s: %s', folder, reason);
end
end

function prefix = default_prefix(here)
prebuilt = fullfile(here, 'prebuilt');
prefix = fullfile(prebuilt, this_system());
if ~exist(prebuilt, 'dir')
    prefix = fullfile(here, '..', '..', '..');
elseif ~exist(prefix, 'dir')
    offered = dir(prebuilt);
    offered = {offered([offered.isdir]).name};
    offered = offered(~strncmp(offered, '.', 1));
    error('rwedge:build', ['this folder has a library for %s, and none for this machine, %s: build rwedge from its sources with ' ...
        '-DRWEDGE_PRIVATE_DEPS=ON, and say where it is installed: build_rwedge(PREFIX)'], strjoin(offered, ' and '), this_system());
end
end

% Such as linux-x86_64. MATLAB calls that glnxa64, Octave gnu-linux-x86_64.
function name = this_system()
name = 'linux';
if ispc()
    name = 'windows';
elseif ismac()
    name = 'macos';
end
processor = computer('arch');
if ~isempty(regexp(processor, 'x86_64|^glnxa64$|^win64$|^maci64$', 'once'))
    processor = 'x86_64';
end
name = [name '-' processor];
end

% The static library, where CMake installs it on one system or another.
function library = find_library(prefix)
library = fullfile(prefix, 'lib', 'librwedge.a');
for folder = {'lib', 'lib64', fullfile('lib', '*')}
    found = dir(fullfile(prefix, folder{1}, 'librwedge.a'));
    if ~isempty(found)
        library = fullfile(found(1).folder, found(1).name);
        return
    end
end
end

function make_folder(folder)
if ~exist(folder, 'dir')
    [made, reason] = mkdir(folder);
    if ~made
        error('rwedge:build', 'cannot make %s: %s', folder, reason);
    end
end
end

function remove_folder(folder)
if exist('OCTAVE_VERSION', 'builtin')
    confirm_recursive_rmdir(false, 'local');
end
rmdir(folder, 's');
end

% Does the MEX file load? Not where the library needs a GSL and LAPACK of its own still.
function try_out(folder, library)
before = path();
back = onCleanup(@() path(before)); %#ok<NASGU>
clear('rwedge_mex'); % an earlier one
addpath(folder);
try
    rwedge_mex('version');
catch reason
    error('rwedge:build', 'rwedge_mex does not run: was %s built with -DRWEDGE_PRIVATE_DEPS=ON? %s', library, reason.message);
end
clear('rwedge_mex'); % so that its file can be moved
end

function compile(source, include, library, folder)
if exist('OCTAVE_VERSION', 'builtin')
    go = {'cd', 'cd /d'}; % mkoctfile would take a space in the path of its result for the end of it
    include = cellfun(@make_absolute_filename, include, 'UniformOutput', false);
    from = sprintf(' -I"%s"', include{:});
    status = system(sprintf('%s "%s" && mkoctfile --mex%s "%s" "%s" -o rwedge_mex.%s', go{1 + ispc()}, folder, from, ...
        make_absolute_filename(source), make_absolute_filename(library), mexext()));
    if status ~= 0
        error('rwedge:build', 'mkoctfile failed: it needs a C compiler, and Octave''s headers (in Debian''s package octave-dev)');
    end
else
    from = strcat('-I', include);
    mex(from{:}, source, library, '-outdir', folder, '-output', 'rwedge_mex');
end
end

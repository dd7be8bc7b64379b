#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the library with its own GSL and LAPACK, as the bindings link it, and installs it into FOLDER/private/prefix
# (include/, lib/). Quiet, unless it fails.    private.sh FOLDER
set -eu
source=$(cd "$(dirname "$0")/.." && pwd)
[ $# -ge 1 ] || { echo 'private.sh FOLDER: the FOLDER is missing' >&2; exit 2; }
folder=$1/private
mkdir -p "$folder"
# the bindings' tests may run side by side
exec 9>"$folder/lock"
flock 9
if ! {
    cmake -S "$source" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DRWEDGE_PRIVATE_DEPS=ON \
        -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_BUILD_TESTS=OFF -DCMAKE_INSTALL_LIBDIR=lib &&
        cmake --build "$folder" &&
        cmake --install "$folder" --prefix "$folder/prefix"
} >"$folder/log" 2>&1; then
    cat "$folder/log" >&2
    exit 1
fi

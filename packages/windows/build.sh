#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds rwedge.dll for 64-bit Windows, GSL, LAPACK and libm inside, and with --tool rwedge.exe, and installs them into
# FOLDER/windows/ (bin/, lib/, include/). Quiet, unless it fails. It needs gcc-mingw-w64-x86-64, gfortran-mingw-w64-x86-64,
# dpkg-dev, and half a minute the first time, with the tool a minute.
#     build.sh [--tool] FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tool=OFF
tools=x86_64-w64-mingw32-
[ "$1" != --tool ] || { tool=ON; shift; }
mkdir -p "$1"
cd "$1"
export PKG_CONFIG_LIBDIR="$PWD/dependencies/lib/pkgconfig" # nothing of this machine's
if ! {
    sh "$here/../sources.sh" sources gsl lapack musl && sh "$here/../dependencies.sh" sources dependencies $tools &&
        sh "$here/../libm.sh" sources dependencies $tools &&
        if [ $tool = ON ]; then
            sh "$here/../sources.sh" sources popt jansson libcsv libxlsxwriter zlib &&
                sh "$here/tool.sh" sources dependencies
        fi &&
        cmake -S "$here/../.." -B build -DCMAKE_TOOLCHAIN_FILE="$here/mingw.cmake" -DCMAKE_BUILD_TYPE=Release \
            -DRWEDGE_PRIVATE_DEPS=ON -DRWEDGE_BUILD_CLI=$tool -DRWEDGE_BUILD_TESTS=OFF -DCMAKE_INSTALL_LIBDIR=lib \
            -DRWEDGE_GSL_INCLUDE="$PWD/dependencies/include" -DRWEDGE_GSL_ARCHIVE="$PWD/dependencies/libgsl.a" \
            -DRWEDGE_LAPACK_ARCHIVE="$PWD/dependencies/liblapack.a" -DRWEDGE_BLAS_ARCHIVE="$PWD/dependencies/liblapack.a" \
            -DRWEDGE_LIBM_FOLDER="$PWD/dependencies" -DXLSXWRITER_LINKS=ON -DCMAKE_FIND_ROOT_PATH="$PWD/dependencies" &&
        cmake --build build && cmake --install build --prefix "$PWD/windows"
} >log 2>&1; then
    cat log >&2
    exit 1
fi

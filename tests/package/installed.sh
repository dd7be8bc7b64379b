#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Can others use it? Installed by find_package and pkg-config, as a subproject, from C++.
#     installed.sh SOURCE BUILD [all]      all: also without GSL and LAPACK, and by a static host
set -eu
source=$(realpath "$1") build=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
consumer=$source/tests/package/consumer

try()
{
    what=$1
    shift
    if ! "$@" >"$work/log" 2>&1; then
        echo "FAILED: $what"
        cat "$work/log"
        exit 1
    fi
    echo "ok: $what"
}

try "installs" cmake --install "$build" --prefix "$prefix"
[ -f "$prefix/include/rwedge.h" ] || { echo "FAILED: no header installed"; exit 1; }
pc=$(find "$prefix" -name rwedge.pc)
libdir=$(dirname "$(dirname "$pc")")

try "find_package configures" cmake -S "$consumer" -B "$work/found" -DCMAKE_PREFIX_PATH="$prefix"
try "find_package builds" cmake --build "$work/found"
try "the shared library runs" "$work/found/with_rwedge"
try "the static library runs" "$work/found/with_rwedge_static"

export PKG_CONFIG_PATH="$libdir/pkgconfig"
# shellcheck disable=SC2046
try "pkg-config, shared" cc "$consumer/consumer.c" -o "$work/shared" $(pkg-config --cflags --libs rwedge) -lm
try "runs" env LD_LIBRARY_PATH="$libdir" "$work/shared"
# shellcheck disable=SC2046
try "pkg-config, static" cc "$consumer/consumer.c" -o "$work/static" $(pkg-config --cflags rwedge) \
    "$libdir/librwedge.a" $(pkg-config --libs --static rwedge | sed "s/ *-lrwedge//")
try "runs" "$work/static"
if [ -f "$(cc -print-file-name=libgsl.a)" ]; then
    # shellcheck disable=SC2046
    try "pkg-config, all static" cc -static "$consumer/consumer.c" -o "$work/all_static" $(pkg-config --cflags --libs --static rwedge)
    try "runs" "$work/all_static"
else
    echo "not tried: all static (there is no libgsl.a)"
fi
try "C++ compiles the header" c++ -std=c++98 -Wall -Wextra -Wpedantic -Werror -Wno-long-long -x c++ -fsyntax-only \
    -I"$prefix/include" "$consumer/consumer.c"
try "C++ links" c++ -x c++ "$consumer/consumer.c" -x none -I"$prefix/include" -o "$work/cxx" -L"$libdir" -lrwedge
try "C99 compiles the header" cc -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I"$prefix/include" "$consumer/consumer.c"

if command -v gfortran >/dev/null 2>&1; then
    # Without -Werror: what is not of 2008 is an error, and gfortran 14 warns of finalizers (bindings/fortran/test.sh).
    try "Fortran takes the module" gfortran -std=f2008 -Wall -Wextra -pedantic -J"$work" -fsyntax-only "$prefix/include/rwedge.f90"
    cmake -S "$source" -B "$work/since" -DRWEDGE_HAS_GFORTRAN= >"$work/log"
    try "Fortran that came after the first configuration is linked" grep -q ' -lgfortran' "$work/since/lib/rwedge.pc"
fi
[ -f "$prefix/share/rwedge/matlab/build_rwedge.m" ] || { echo "FAILED: no MATLAB folder installed"; exit 1; }

try "the private build is there" sh "$source/bindings/private.sh" "$build"
try "find_package configures with it" cmake -S "$consumer" -B "$work/private" \
    -DCMAKE_PREFIX_PATH="$build/private/prefix" -DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON -DCMAKE_DISABLE_FIND_PACKAGE_LAPACK=ON
try "find_package builds with it" cmake --build "$work/private"
try "its shared library runs" "$work/private/with_rwedge"
try "its static library runs" "$work/private/with_rwedge_static"

# The host's programs load what it has installed, and nothing else.
try "an embedding host configures" cmake -S "$consumer" -B "$work/host" -DRWEDGE_SOURCE="$source" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_INSTALL_RPATH="\$ORIGIN/../lib" -DCMAKE_INSTALL_LIBDIR=lib
try "an embedding host builds, with unity builds" cmake --build "$work/host" --parallel 2
try "an embedding host installs" cmake --install "$work/host" --prefix "$work/installed"
mv "$work/host" "$work/elsewhere"
try "runs" "$work/installed/bin/with_rwedge"
[ "${3-}" = all ] || exit 0
no_dependencies="-DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON -DCMAKE_DISABLE_FIND_PACKAGE_LAPACK=ON"
# shellcheck disable=SC2086
try "find_package without GSL and LAPACK configures" cmake -S "$consumer" -B "$work/shared_only" -DLIBRARIES=rwedge \
    -DCMAKE_PREFIX_PATH="$prefix" $no_dependencies
try "find_package without GSL and LAPACK builds" cmake --build "$work/shared_only"
try "runs" "$work/shared_only/with_rwedge"
try "a static host configures" cmake -S "$consumer" -B "$work/static_host" -DRWEDGE_SOURCE="$source" -DCMAKE_BUILD_TYPE=Release \
    -DBUILD_SHARED_LIBS=OFF
try "a static host builds" cmake --build "$work/static_host" --parallel 2
try "a static host installs" cmake --install "$work/static_host" --prefix "$work/static_installed"
[ -z "$(find "$work/static_host" "$work/static_installed" -name 'librwedge.so*')" ] || { echo "FAILED: a shared library"; exit 1; }
try "runs" "$work/static_installed/bin/with_rwedge"

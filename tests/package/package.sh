#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Can others use it? Installed by find_package and pkg-config, as a subproject, in one compiler line, from C++.
#     package.sh SOURCE BUILD
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
try "pkg-config, shared" cc "$consumer/main.c" -o "$work/shared" $(pkg-config --cflags --libs rwedge) -lm
try "runs" env LD_LIBRARY_PATH="$libdir" "$work/shared"
# shellcheck disable=SC2046
try "pkg-config, static" cc "$consumer/main.c" -o "$work/static" $(pkg-config --cflags rwedge) \
    "$libdir/librwedge.a" $(pkg-config --libs --static rwedge | sed "s/ *-lrwedge//")
try "runs" "$work/static"
try "C++ compiles the header" c++ -std=c++98 -Wall -Wextra -Wpedantic -Werror -Wno-long-long -x c++ -fsyntax-only \
    -I"$prefix/include" "$consumer/main.c"
try "C++ links" c++ -x c++ "$consumer/main.c" -x none -I"$prefix/include" -o "$work/cxx" -L"$libdir" -lrwedge
try "C99 compiles the header" cc -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I"$prefix/include" "$consumer/main.c"

if command -v gfortran >/dev/null 2>&1; then
    try "Fortran compiles the module" gfortran -std=f2008 -Wall -Wextra -pedantic -Werror -J"$work" -c -o "$work/module.o" \
        "$prefix/include/rwedge.f90"
fi
[ -f "$prefix/share/rwedge/matlab/build_rwedge.m" ] || { echo "FAILED: no MATLAB folder installed"; exit 1; }

try "the private build is there" sh "$source/bindings/private.sh" "$build"
try "find_package configures with it" cmake -S "$consumer" -B "$work/private" \
    -DCMAKE_PREFIX_PATH="$build/private/prefix" -DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON -DCMAKE_DISABLE_FIND_PACKAGE_LAPACK=ON
try "find_package builds with it" cmake --build "$work/private"
try "its shared library runs" "$work/private/with_rwedge"
try "its static library runs" "$work/private/with_rwedge_static"

try "a subproject configures" cmake -S "$consumer" -B "$work/sub" -DRWEDGE_SOURCE="$source"
try "a subproject builds" cmake --build "$work/sub" --parallel 2
try "a subproject runs" "$work/sub/with_rwedge"

cd "$source"
try "one compiler line" cc -Iinclude -Ilib lib/*/*.c tests/package/consumer/main.c -o "$work/line" -lgsl -lgslcblas -llapack -lm
try "runs" "$work/line"

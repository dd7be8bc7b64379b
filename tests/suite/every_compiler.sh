#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# With each gcc and clang that is here: no warning, and the tests. The test of the tables, among these, writes them anew and compares.
#     every_compiler.sh SOURCE BUILD
set -eu
build=$(cd "$2" && pwd)
cd "$1"
. tests/support/compilers.sh
. tests/support/install.sh
tested=$(realpath "$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")")
failed=no

try()
{
    cmake -S . -B "$build/$1" -DCMAKE_C_COMPILER="$1" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS=-Werror \
        -DRWEDGE_BUILD_CLI=ON -DRWEDGE_BUILD_TESTS=ON >"$build/$1.log" &&
        cmake --build "$build/$1" --parallel "$(processors)" >"$build/$1.log" 2>&1 || { cat "$build/$1.log"; return 1; }
    [ "$(realpath "$(command -v "$1")")" = "$tested" ] ||
        ctest --test-dir "$build/$1" --exclude-regex "$of_another_compiler" --output-on-failure --parallel "$(processors)"
}

for compiler in $(compilers_here); do
    try "$compiler" && echo "ok: $compiler" || { echo "FAILED: $compiler"; failed=yes; }
done
[ $failed = no ]

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The unit tests reach every branch of lib/, except those that ALWAYS() and NEVER() argue (lib/base/always.h). The library is compiled
# without optimisation or inlining, so that the branches are those of the source. batch.c makes no choice by the processor here.
#     coverage.sh SOURCE BUILD
set -eu
: "${2:?usage: coverage.sh SOURCE BUILD}"
source=$(cd "$1" && pwd) build=$2/coverage

# The unit tests of lib/: those of the rooms, of calls with bad arguments or too little memory, and the searches. With the
# boundary-element solver other pads alone are followed, because the rest takes longer than all others.
unit_tests()
{
    for file in tests/proof/test_*.c tests/random/test_*.c tests/embedding/test_*.c tests/lib/*/test_*.c; do # the longest first
        basename "$file" .c
    done
}

for tool in gcc gcovr; do
    command -v $tool >/dev/null || { echo "SKIPPED: no $tool here"; exit 77; }
done

mkdir -p "$build"
build=$(cd "$build" && pwd)
log=$build/log
programs=$(cd "$source" && unit_tests)
# shellcheck disable=SC2086
cmake -S "$source" -B "$build" -DCMAKE_C_COMPILER=gcc -DCMAKE_BUILD_TYPE=None -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_INSTALL=OFF \
    -DCMAKE_C_FLAGS='-O0 --coverage -fprofile-update=atomic -Dalways_inline=unused -DRW_BASELINE -DRW_COVERAGE' >"$log" 2>&1 &&
    cmake --build "$build" --parallel 2 --target $programs >>"$log" 2>&1 || { cat "$log"; exit 1; }
find "$build" -name '*.gcda' -delete

# shellcheck disable=SC2016
printf '%s\n' $programs | xargs -P 2 -I {} sh -c '
    case $1 in test_boundary_element) cases="flat*" ;; *) cases= ;; esac
    "$(find "$2/tests" -type f -name "$1")" $cases >"$2/$1.log" 2>&1 || { cat "$2/$1.log"; echo "FAILED: $1"; exit 1; }' sh {} "$build"
gcovr --root "$source/lib" --object-directory "$build/lib" --branches --fail-under-branch 100 --fail-under-line 100 "$build/lib"

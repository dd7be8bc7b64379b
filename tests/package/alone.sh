#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every C file of the project compiles alone by the strict rules of newer compilers. Every function is declared; no type is
# implied to be int.
#     alone.sh SOURCE BUILD
set -eu
build=$(cd "$2" && pwd)
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
options='-std=c99 -Wall -Wextra -Wpedantic -Werror=implicit -fsyntax-only -D_XOPEN_SOURCE=700 -DTEST_DATA="" -DTABLES=""'
options="$options -DOPTIMISED_BUILD=0 -Iinclude -Ilib -Icli"
options="$options -Itests/host -Itests/host/calls -Itests/random -Itests/speed -Itests/support"
flint=/usr/include/flint/arb.h
[ ! -f $flint ] || options="$options -DBALLS_IN_FLINT"

compiled=0 failed=no
for file in $(find bindings cli lib tests -name '*.c' | sort); do
    case $file in
    bindings/matlab/rwedge_mex.c | bindings/python/src/loops.c) continue ;; # half of them is written when they are built
    bindings/excel/*) compiler=x86_64-w64-mingw32-gcc ;;
    *) compiler=cc ;;
    esac
    if ! command -v $compiler >/dev/null; then
        echo "SKIPPED: $file: no $compiler here"
    # shellcheck disable=SC2086
    elif $compiler $options -I"$build/made/c" "$file" 2>"$work/said"; then
        compiled=$((compiled + 1))
    elif grep -q 'fatal error: [^ ]*: No such file' "$work/said"; then
        echo "SKIPPED: $file: $(sed -n 's/.*fatal error: //p' "$work/said" | head -n 1)"
    else
        echo "FAILED: $file"
        cat "$work/said"
        failed=yes
    fi
done
echo "$compiled files compile alone"
[ $failed = no ] && [ $compiled -gt 0 ]

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The calls answered from C with the ordinary build, C with the private build and C++: the same bits.
#     doors.sh SOURCE BUILD
set -eu
source=$1 build=$2
here=$source/tests/doors
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sh "$source/bindings/private.sh" "$build"

sh "$here/calls.sh" >"$work/calls.csv"
answer="-I$source/include $here/door.c"
# shellcheck disable=SC2086
cc -std=c99 $answer -o "$work/c" -L"$build/lib" -lrwedge -Wl,-rpath,"$build/lib"
# shellcheck disable=SC2086
cc -std=c99 $answer -o "$work/private" "$build/private/prefix/lib/librwedge.a" -lm
# shellcheck disable=SC2086
c++ -x c++ $answer -x none -o "$work/c++" -L"$build/private/prefix/lib" -lrwedge -Wl,-rpath,"$build/private/prefix/lib"

"$work/c" <"$work/calls.csv" >"$work/answers"
[ "$(wc -l <"$work/answers")" -eq "$(wc -l <"$work/calls.csv")" ] || { echo "FAILED: calls without an answer"; exit 1; }
for door in private c++; do
    "$work/$door" <"$work/calls.csv" | cmp "$work/answers" - || { echo "FAILED: $door differs"; exit 1; }
done
echo "ok: $(wc -l <"$work/answers") calls, the same bits from C, C with the private build, and C++"

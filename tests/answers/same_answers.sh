#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The calls give the same bits from C with the ordinary build, from C with the private build, and from C++.
#     same_answers.sh SOURCE BUILD
set -eu
command -v python3 >/dev/null || { echo "SKIPPED: no python3 here, which lists the calls"; exit 77; }
source=$1 build=$2
here=$source/tests/answers
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sh "$here/answers.sh" "$build"
answers=$build/private/answers

set -- -I"$source/include" "$answers/answer.c"
cc -std=c99 "$@" -o "$work/c" -L"$build/lib" -lrwedge -Wl,-rpath,"$build/lib"
c++ -x c++ "$@" -x none -o "$work/c++" -L"$build/private/prefix/lib" -lrwedge -Wl,-rpath,"$build/private/prefix/lib"

"$work/c" >"$work/answers"
[ "$(wc -l <"$work/answers")" -eq "$(wc -l <"$answers/calls.csv")" ] || { echo "FAILED: calls without an answer"; exit 1; }
if grep ',error' "$work/answers"; then
    echo "FAILED: these calls are refused, and so show nothing: mend their arguments in calls.py"
    exit 1
fi
cmp "$work/answers" "$answers/answers.csv" || { echo "FAILED: the private build differs"; exit 1; }
"$work/c++" | cmp "$work/answers" - || { echo "FAILED: C++ differs"; exit 1; }
echo "ok: $(wc -l <"$work/answers") calls, the same bits from C, C with the private build, and C++"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The example in lib/README.md is the one that the tests run, and it prints what lib/README.md says.
#     example_in_readme.sh SOURCE
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^## Embedding/,/^## Accuracy/p' "$1/lib/README.md" >"$work/section"
sed -n '/^```c$/,/^```$/p' "$work/section" | sed '1d;$d' >"$work/shown"
sed 1d "$1/tests/repository/example_fretting.c" | diff "$work/shown" -
sed -n '/^It prints/,$s/^    //p' "$work/section" | diff - "$1/tests/data/example_fretting.txt"
lines=$(wc -l <"$work/shown")
[ "$lines" -gt 0 ] && [ "$lines" -lt 80 ] || { echo "FAILED: the example has $lines lines"; exit 1; }
echo "ok: $lines lines"

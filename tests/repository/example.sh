#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The example in lib/README.md compiles, and prints what lib/README.md says; so do those of the bindings
# (tests/data/example_fretting.txt).
#     example.sh SOURCE BUILD
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^## Embedding/,/^## Accuracy/p' "$1/lib/README.md" >"$work/section"
sed -n '/^```c$/,/^```$/p' "$work/section" | sed '1d;$d' >"$work/main.c"
[ "$(wc -l <"$work/main.c")" -lt 80 ] || { echo "FAILED: the example is too long"; exit 1; }
cc -std=c99 -Wall -Wextra -Wpedantic -Werror "$work/main.c" -I"$1/include" -L"$2/lib" -lrwedge -lm -Wl,-rpath,"$2/lib" -o "$work/example"
"$work/example" >"$work/printed"
sed -n '/^It prints/,$s/^    //p' "$work/section" | diff - "$work/printed"
diff "$1/tests/data/example_fretting.txt" "$work/printed"
echo "ok: $(wc -l <"$work/main.c") lines"

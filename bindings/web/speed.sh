#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Times of the package beside those of the library in C, in one run; fails where an array of stresses takes more than twice as long. After
# test.sh.    speed.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
prefix=$1/private/prefix
cc -std=c99 -O2 -D_POSIX_C_SOURCE=199309L -I"$prefix/include" "$here/test/speed.c" "$prefix/lib/librwedge.a" -lm -o "$1/web/speed"
{ "$1/web/speed" && node "$1/web/installed/speed.mjs"; } | awk -F ': ' '
    !($1 in c) { c[$1] = $2; next }
    { printf "%-40s %8.1f ns in C, %8.1f ns in JavaScript, %.2f times as long\n", $1, c[$1], $2, $2 / c[$1]; bad += $1 ~ /array/ && $2 > 2 * c[$1]; n++ }
    END { if (bad || n < 4) { print "FAILED: more than twice as long"; exit 1 } }'

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Times of the package beside those of the library in C, in one run. C is as it is, with the widest vectors that the processor has, and
# with vectors of two numbers: WebAssembly has no wider ones. Fails where an array of stresses takes more than twice as long as with
# the latter. After the tests in BUILD.    speed.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
cd "$1/web"

# in_c PROGRAM ARGUMENTS...
in_c()
{
    program=$1
    shift
    # shellcheck disable=SC2046
    cc -std=c99 -O3 -DNDEBUG -D_POSIX_C_SOURCE=199309L -ffp-contract=off -fno-math-errno -I"$top/include" -I"$top/lib" \
        "$here/test/speed.c" "$@" ../lib/librwedge_inside.a $(pkg-config --libs gsl lapack) -lm -o "$program"
}
in_c speed-widest
in_c speed-two -DRW_BASELINE "$top/lib/potential/batch.c" "$top/lib/potential/eccentric_batch.c"
echo 'ns a point or call                      C, widest  C, of two  JavaScript'
{ ./speed-widest && ./speed-two && node installed/speed.mjs; } | awk -F ': ' '
    { time[$1, ++count[$1]] = $2 }
    count[$1] == 3 {
        printf "%-38s %10.1f %10.1f %11.1f\n", $1, time[$1, 1], time[$1, 2], $2
        bad += $1 ~ /array/ && $2 > 2 * time[$1, 2]
        lines++
    }
    END { if (bad || lines < 4) { print "FAILED: more than twice as long"; exit 1 } }'

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The certificate rejects wrong tables, each for the right reason.    faults.sh CERTIFICATE TABLE
set -eu
certificate=$1 table=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# rejected WHAT STATUS MESSAGE AWK - the first rows of a/b = 0.5 with row 2 (f = 0, below the surface) changed by the awk action.
rejected()
{
    awk -F, -v OFS=, -v CONVFMT=%.16g -v OFMT=%.16g \
        "NR == 1 || \$1 == 0.5 && n < 5 { if (++n == 2) { $4 } print }" "$table" >"$work/table.csv"
    status=0
    "$certificate" "$work/table.csv" >"$work/out" 2>&1 || status=$?
    if [ $status -ne "$2" ] || ! grep -q "$3" "$work/out"; then
        echo "$1: expected status $2 and \"$3\", got status $status and:"
        cat "$work/out"
        failures=$((failures + 1))
    fi
}

rejected 'the table as it is' 0 '4 proved, 0 exceeded, 0 not reached, 0 misnamed, 0 open' ''
rejected 'a limit raised by 3e-9' 1 '3 proved, 1 exceeded' '$4 *= 1 + 3e-9'
rejected 'a limit lowered by 3e-9' 1 '3 proved, 0 exceeded, 1 not reached' '$4 *= 1 - 3e-9'
rejected 'the maximum of the surface, where that below governs' 1 'exceeded at x/b' '$4 = $9; $6 = 0; $7 = "surface"'
rejected 'a place too deep by 1 %' 1 '3 proved, 0 exceeded, 1 not reached' '$6 *= 1.01'
rejected 'a place too deep by 1e-5, where the limit is higher by less than 1e-9' 1 '3 proved, 1 exceeded' '$6 *= 1 + 1e-5'
rejected 'the wrong branch' 1 '3 proved, 0 exceeded, 0 not reached, 1 misnamed' '$7 = "surface"'
rejected 'another friction' 1 '3 proved, 1 exceeded' '$2 = 0.001'
rejected 'a number that is none' 2 'table.csv:2: not an entry' '$4 = "4.05x"'
rejected 'an empty limit' 2 'table.csv:2: not an entry' '$4 = ""'

# Where friction drags the highest point to x > 0: a lower place with the limit that belongs to it, which the first run tells.
decoy='$2 = 0.1; $4 = 1; $5 = 0.22; $6 = 0.53;'
rejected 'a place beside the highest point' 1 'not reached: the stated place alone' "$decoy"
limit=$(sed -n 's/.*alone gives a limit of //p' "$work/out")
rejected "that place with its own limit, $limit" 1 'exceeded at x/b = 0' "$decoy \$4 = $limit"
[ $failures -eq 0 ]

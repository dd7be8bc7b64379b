#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every function of the header has a target that calls it.     covered.sh SOURCE
set -eu
cd "$1"
command -v python3 >/dev/null || { echo "SKIPPED: no python3 here, which reads the header"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -B bindings/interface/header.py --names include/rwedge.h >"$work/declared"
grep -q '^rwedge_' "$work/declared" || { echo "FAILED: the header declares no function"; exit 1; }
python3 -B bindings/interface/generate.py "$work" c
cat tests/random/targets/*.c tests/host/calls/*.c "$work/c/entries.h" >"$work/targets"
status=0
while read -r function; do
    grep -qw "$function" "$work/targets" || {
        echo "FAILED: $function is called by no target"
        status=1
    }
done <"$work/declared"
echo "$(wc -l <"$work/declared") functions of the header"
exit $status

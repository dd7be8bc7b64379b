#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every function of the header has a target that calls it.     covered.sh SOURCE
set -eu
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed -n '/^RWEDGE_API/,/;/p' include/rwedge.h | grep -o 'rwedge_[a-zA-Z_0-9]*(' | sort -u >"$work/declared"
cat tests/random/targets/*.c tests/host/calls/*.c bindings/interface/entries.h >"$work/targets"
status=0
[ -s "$work/declared" ] || status=1
while read -r function; do
    grep -qw "${function%(}" "$work/targets" || {
        echo "FAILED: ${function%(} is called by no target"
        status=1
    }
done <"$work/declared"
echo "$(wc -l <"$work/declared") functions of the header"
exit $status

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Do all lists of what is linked in, beside the packages and in them, have the elements that ntia-checker wants?
#     sboms.sh BUILD PACKAGES TESTED
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
build=$1 packages=$2 tested=$3
. "$top/tests/support/venv.sh"
reason=$(venv "$top/packages/source/requirements.txt" "$build/ntia") ||
    { echo "not tested: the lists of what is linked in: $reason" | tee -a "$tested"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$packages"/*.spdx.json "$work"
for package in "$packages"/*.zip "$packages"/python/*.whl; do
    [ -f "$package" ] || continue
    list=$(unzip -Z1 "$package" | grep '\.spdx\.json$') || continue
    unzip -p "$package" "$list" >"$work/$(basename "$package").spdx.json"
done
count=0
for list in "$work"/*; do
    "$build/ntia/bin/ntia-checker" "$list" >"$build/ntia/log" 2>&1 ||
        { cat "$build/ntia/log"; echo "FAILED: $(basename "$list")"; exit 1; }
    count=$((count + 1))
done
echo "tested: $count SPDX lists, beside the packages and in them: ntia-checker finds the minimum elements" >>"$tested"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library's binary interface is the stored one: soname, exported symbols with their version and status codes (interface.txt),
# and the types of all parameters (librwedge.abi, by libabigail).
#     abi.sh SOURCE BUILD           compares
#     abi.sh SOURCE BUILD --store   stores it anew, after an addition. A change that breaks raises RWEDGE_ABI first.
set -eu
: "${2:?usage: abi.sh SOURCE BUILD [--store]}"
source=$(cd "$1" && pwd) build=$2 store=${3:-} # whole: the stored interface is to have no path of this machine
here=$source/tests/package/abi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake -S "$source" -B "$build/abi" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS="\"-ffile-prefix-map=$source=.\"" \
    -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_BUILD_TESTS=OFF >"$work/log" 2>&1 &&
    cmake --build "$build/abi" --target rwedge >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
library=$build/abi/lib/librwedge.so

{
    echo "soname $(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')"
    nm -D --defined-only --with-symbol-versions "$library" | awk '$2 == "T" { print $3 }' | LC_ALL=C sort
    python3 -B "$source/bindings/interface/header.py" "$source/include/rwedge.h" |
        python3 -c 'import json, sys
interface = json.load(sys.stdin)
for name, value in {**interface["statuses"], **interface["bits"]}.items():
    print(name, "=", value)'
} >"$work/interface.txt"
if [ "$store" = --store ]; then
    cp "$work/interface.txt" "$here/interface.txt"
elif ! diff "$here/interface.txt" "$work/interface.txt"; then
    echo "FAILED: < stored, > exported now; after an addition: sh tests/package/abi/abi.sh . build --store"
    exit 1
else
    echo "ok: soname, symbols and status codes as stored"
fi

command -v abidiff >/dev/null || { echo "SKIPPED: no abidiff here (Debian's abigail-tools); the symbols were compared"; exit 77; }
if [ "$store" = --store ]; then
    abidw --headers-dir "$source/include" --no-corpus-path --no-comp-dir-path --no-show-locs --no-elf-needed \
        --no-architecture \
        --out-file "$here/librwedge.abi" "$library"
elif ! abidiff --no-architecture --headers-dir2 "$source/include" "$here/librwedge.abi" "$library"; then
    echo "FAILED: the types of the interface have changed"
    exit 1
else
    echo "ok: types as stored"
fi

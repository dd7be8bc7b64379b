#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library's binary interface is the stored one (interface.txt): soname, version of each symbol with the types that the header
# declares, status codes.
#     abi.sh SOURCE LIBRARY           compares
#     abi.sh SOURCE LIBRARY --store   stores it anew, after an addition. A change that breaks raises RWEDGE_ABI first.
set -eu
: "${2:?usage: abi.sh SOURCE LIBRARY [--store]}"
command -v python3 >/dev/null || { echo "SKIPPED: no python3 here, which reads the header"; exit 77; }
stored=$1/tests/package/interface.txt now=$(mktemp)
trap 'rm -f "$now"' EXIT
{
    readelf -d "$2" | sed -n 's/.*SONAME.*\[\(.*\)\]/soname \1/p'
    nm -D --defined-only --with-symbol-versions "$2" | sed -n 's/.* T rwedge_\(.*\)@@\(.*\)/\1 \2/p' | LC_ALL=C sort
    echo
    python3 -B "$1/bindings/interface/header.py" "$1/include/rwedge.h"
} | python3 -c 'import json, re, sys
symbols, _, header = sys.stdin.read().partition("\n\n")
interface = json.loads(header)
types = {}
for function in interface["functions"]:
    parameters = ", ".join(re.sub(r" ?\w+(\[\])?$", r"\1", p["declared"]) for p in function["parameters"])
    types[function["name"]] = f"{function['\''returns'\'']} ({parameters})"
for symbol in symbols.split("\n"):
    print(symbol, types.get(symbol.split()[0], ""))
for name, value in {**interface["statuses"], **interface["bits"]}.items():
    print(name, "=", value)' | sed 's/ $//' >"$now"
if [ "${3:-}" = --store ]; then
    cp "$now" "$stored"
elif diff "$stored" "$now"; then
    echo "ok: soname, $(grep -c ' (' "$now") functions and status codes as stored"
else
    echo "FAILED: < stored, > exported now; after an addition: sh tests/package/abi.sh . build/lib/librwedge.so --store"
    exit 1
fi

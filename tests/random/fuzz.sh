#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the library and fuzz_calls.c with libFuzzer, under the address and undefined-behaviour sanitizers, and runs it.
#
#     fuzz.sh BUILD              a fixed number of runs from fixed random numbers: the same ones every time
#     fuzz.sh BUILD SECONDS      new ones, for SECONDS; BUILD/fuzz/found keeps the interesting inputs, and grows
#
# The status is 77 if no clang has libFuzzer.
set -eu
: "${1:?usage: fuzz.sh BUILD [SECONDS]}"
source=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1/fuzz/found"
cd "$1/fuzz"

echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return d && n > 9; }' >trial.c
for clang in ${CLANG:-clang-19 clang-18 clang-17 clang-16 clang-15 clang clang-14}; do
    "$clang" -fsanitize=fuzzer,address trial.c -o trial 2>/dev/null && break
    clang=
done
[ -n "$clang" ] || { echo "SKIPPED: no clang with libFuzzer here (Debian: clang, libclang-rt-dev)"; exit 77; }
checked='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -DRW_CHECKED'
cmake -S "$source" -B . -DCMAKE_C_COMPILER="$clang" -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS="-gline-tables-only -O1 $checked" \
    -DRWEDGE_FUZZ=ON -DRWEDGE_BUILD_TESTS=ON -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_INSTALL=OFF >log 2>&1 &&
    cmake --build . --parallel "$(nproc 2>/dev/null || echo 2)" --target fuzz_calls >>log 2>&1 || { cat log; exit 1; }

extent='-seed=1 -runs=8000'
[ $# -lt 2 ] || extent="-max_total_time=$2 found"
# shellcheck disable=SC2086
ASAN_OPTIONS=quarantine_size_mb=8 tests/random/fuzz_calls -max_len=512 -timeout=120 $extent >log 2>&1 || { tail -n 40 log; exit 1; }
tail -n 1 log

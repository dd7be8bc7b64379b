#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds all targets with libFuzzer, under the address and undefined-behaviour sanitizers, library and tool included, and runs them.
#
#     long.sh [FOLDER]                      a fixed number of runs of each, from fixed random numbers: the same ones every time
#     long.sh --explore SECONDS [FOLDER]    new ones, for SECONDS in all on one core; FOLDER keeps the interesting inputs, and grows
#
# FOLDER is build/fuzz if it is not given. The status is 77 if no clang has libFuzzer.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
seconds=
[ "${1:-}" != --explore ] || { seconds=${2:?--explore SECONDS: the SECONDS are missing}; shift 2; }
case ${1:-} in -*) echo "long.sh: $1: unknown option; usage: long.sh [--explore SECONDS] [FOLDER]" >&2; exit 2 ;; esac
folder=${1:-$source/build/fuzz}
mkdir -p "$folder"
cd "$folder"
processors=$(nproc 2>/dev/null || echo 2)

echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return d && n > 9; }' >trial.c
for clang in ${CLANG:-clang-19 clang-18 clang-17 clang-16 clang-15 clang clang-14}; do
    "$clang" -fsanitize=fuzzer,address trial.c -o trial 2>/dev/null && break
    clang=
done
[ -n "$clang" ] || { echo "SKIPPED: no clang with libFuzzer here (Debian: clang, libclang-rt-dev)"; exit 77; }
checked='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -DRW_CHECKED'
cmake -S "$source" -B . -DCMAKE_C_COMPILER="$clang" -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS="-gline-tables-only -O1 $checked" \
    -DRWEDGE_FUZZ=ON -DRWEDGE_BUILD_CLI=ON -DRWEDGE_BUILD_TESTS=ON -DRWEDGE_INSTALL=OFF >log 2>&1 &&
    cmake --build . --parallel "$processors" --target targets_of_any_bytes >>log 2>&1 || { cat log; exit 1; }

[ -n "$seconds" ] || exec ctest --tests-regex '^fuzz_' --parallel "$processors" --output-on-failure --no-tests=error

# explore TARGET SHARE - short texts run 50 times faster than contacts
explore()
{
    mkdir -p "long/$1"
    case $1 in number | range) length=64 ;; *) length=512 ;; esac
    ASAN_OPTIONS=detect_leaks=0:quarantine_size_mb=8 "tests/random/fuzz_$1" -max_total_time="$((seconds * $2 / 100 + 1))" -max_len="$length" -timeout=20 \
        -print_final_stats=1 -artifact_prefix="found_$1_" "long/$1" "seeds/$1" >"long_$1.log" 2>&1 || {
        status=1
        echo "$1: FOUND"
        tail -n 40 "long_$1.log"
    }
    echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "long_$1.log") runs"
}
status=0
for share in 'number 10' 'range 10' 'csv 8' 'batch 12' 'series 10' 'contact 20' 'any_history 10' 'formulas 20'; do
    # shellcheck disable=SC2086
    explore $share
done
exit "$status"

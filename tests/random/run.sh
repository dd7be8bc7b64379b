#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs one target of build.sh RUNS times: first on the seeds, then on changes of them. The random numbers are fixed.
#
#     run.sh SOURCE FOLDER TARGET RUNS
set -eu
source=$(cd "$1" && pwd) target=$3 runs=$4
cd "$2"
[ -x "fuzz_$target" ] || { echo "SKIPPED: no clang with libFuzzer here"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ASAN_OPTIONS=quarantine_size_mb=8
export ASAN_OPTIONS
status=0
"./fuzz_$target" -seed=1 -runs="$runs" -max_len=512 -timeout=120 -print_final_stats=1 -artifact_prefix="found_${target}_" \
    "$work" "seeds/$target" >"$work.log" 2>&1 || status=1 # it ends a crash with 77, which would count as a skip
[ "$status" -eq 0 ] || tail -n 40 "$work.log"
executed=$(sed -n 's/^stat::number_of_executed_units: *//p' "$work.log")
[ "${executed:-0}" -ge "$runs" ] || { echo "FAILED: ${executed:-0} of $runs runs"; status=1; }
echo "$target: ${executed:-0} runs, $(sed -n 's/^stat::average_exec_per_sec: *//p' "$work.log") per second"
rm -f "$work.log"
exit "$status"

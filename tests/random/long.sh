#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs all targets, one after another on one core, for SECONDS in all. Interesting inputs are kept in FOLDER, which grows from run to
# run. The last line has the sum.
#
#     long.sh SECONDS [FOLDER]     FOLDER is build/fuzz if it is not given
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
seconds=$1
folder=${2:-$source/build/fuzz}
sh "$source/tests/random/build.sh" "$source" "$folder"
cd "$folder"
ASAN_OPTIONS=quarantine_size_mb=8
export ASAN_OPTIONS
status=0 total=0
# the share of each in per cent: short texts run 50 times faster than contacts
for share in number:10 range:10 csv:8 batch:12 series:10 contact:25 formulas:25; do
    target=${share%:*}
    mkdir -p "long/$target"
    case $target in number | range) length=64 ;; *) length=512 ;; esac
    "./fuzz_$target" -max_total_time="$((seconds * ${share#*:} / 100 + 1))" -max_len="$length" -timeout=20 -print_final_stats=1 \
        -artifact_prefix="found_${target}_" "long/$target" "seeds/$target" >"long_$target.log" 2>&1 || {
        status=1
        echo "$target: FOUND"
        grep -E 'does not hold|runtime error|ERROR:|Test unit written|Base64:' "long_$target.log" || tail -n 20 "long_$target.log"
    }
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "long_$target.log")
    rate=$(sed -n 's/^stat::average_exec_per_sec: *//p' "long_$target.log")
    [ "${runs:-0}" -gt 0 ] || status=1
    echo "$target: ${runs:-0} runs, ${rate:-0} per second"
    total=$((total + ${runs:-0}))
done
echo "$total runs in all"
exit "$status"

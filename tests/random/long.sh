#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs all targets with libFuzzer, under the sanitizers.
#
#     long.sh [FOLDER]                      a fixed number of runs of each, from fixed random numbers: the same ones every time
#     long.sh --explore SECONDS [FOLDER]    new ones, for SECONDS in all on one core; FOLDER keeps the interesting inputs, and grows
#
# FOLDER is build/fuzz if it is not given. The last line has the sum of the runs.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
seconds=
[ "${1:-}" != --explore ] || { seconds=${2:?--explore SECONDS: the SECONDS are missing}; shift 2; }
case ${1:-} in -*) echo "long.sh: $1: unknown option; usage: long.sh [--explore SECONDS] [FOLDER]" >&2; exit 2 ;; esac
folder=${1:-$source/build/fuzz}
sh "$here/build.sh" "$source" "$folder"
cd "$folder"
status=0

fixed()
{
    # the longest first
    printf '%s\n' 'any_history 60' 'contact 100000' 'formulas 300000' 'batch 15000' 'csv 150000' 'series 200000' 'number 1000000' 'range 1000000' |
        xargs -P "$(nproc 2>/dev/null || echo 2)" -L 1 sh "$here/run.sh" "$source" . >said || status=1
    cat said
}

# explore TARGET SHARE - short texts run 50 times faster than contacts
explore()
{
    target=$1
    mkdir -p "long/$target"
    case $target in number | range) length=64 ;; *) length=512 ;; esac
    ASAN_OPTIONS=quarantine_size_mb=8 "./fuzz_$target" -max_total_time="$((seconds * $2 / 100 + 1))" -max_len="$length" -timeout=20 \
        -print_final_stats=1 -artifact_prefix="found_${target}_" "long/$target" "seeds/$target" >"long_$target.log" 2>&1 || {
        status=1
        echo "$target: FOUND"
        grep -E 'does not hold|runtime error|ERROR:|Test unit written|Base64:' "long_$target.log" || tail -n 20 "long_$target.log"
    }
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "long_$target.log")
    [ "${runs:-0}" -gt 0 ] || status=1
    echo "$target: ${runs:-0} runs, $(sed -n 's/^stat::average_exec_per_sec: *//p' "long_$target.log") per second" >>said
}

: >said
if [ -z "$seconds" ]; then
    fixed
else
    for share in 'number 10' 'range 10' 'csv 8' 'batch 12' 'series 10' 'contact 20' 'any_history 10' 'formulas 20'; do
        # shellcheck disable=SC2086
        explore $share
    done
    cat said
fi
awk -F': ' '$2 ~ /runs/ { sum += $2 } END { printf "%d runs in all\n", sum }' said
exit "$status"

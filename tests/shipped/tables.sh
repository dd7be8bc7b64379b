#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# tables/ is what the tool writes now: the CSV files by their bytes; the workbook by its unzipped parts, where libxlsxwriter is
# the one that wrote it; the pictures by their bytes, where gnuplot is the one that drew them.
#     tables.sh SOURCE TOOL
set -eu
source=$1 tool=$2
writer=1.1.4 # the libxlsxwriter of Debian 12
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/now"
cp "$source"/tables/*.svg "$work/now"
status=0
skipped=''

# skip FILES WHY
skip()
{
    echo "SKIPPED: $1: $2"
    skipped=$1
}

# same FILE [SHIPPED NOW] - two files, or two folders of parts
same()
{
    diff -rq "${2:-$source/tables/$1}" "${3:-$work/now/$1}" && return
    echo "FAILED: $1 is not what the tool writes now; ./tables/generate.sh writes it"
    status=1
}

sh "$source/tables/generate.sh" "$work/now" "$tool" >"$work/said" 2>&1 || {
    cat "$work/said"
    case $(cat "$work/said") in
    *libxlsxwriter*) skip rounded-wedge.xlsx "this build has no libxlsxwriter" ;;
    *) exit 1 ;;
    esac
}
(cd "$source/tables" && ls ./*.csv ./*.svg ./*.xlsx) >"$work/shipped"
(cd "$work/now" && ls ./*.csv ./*.svg ./*.xlsx) 2>"$work/missing" >"$work/written" || cat "$work/missing"
[ -n "$skipped" ] || diff "$work/shipped" "$work/written" || { echo "FAILED: tables/ does not hold what is written"; exit 1; }

for file in "$source"/tables/*.csv; do
    same "${file##*/}"
done
for file in "$source"/tables/*.svg; do
    name=${file##*/}
    if grep -qx "$name: drawn" "$work/said"; then
        same "$name"
    else
        skip "$name" "another gnuplot drew it, or there is none here"
    fi
done
if [ -f "$work/now/rounded-wedge.xlsx" ]; then
    if [ "$(printf '#include <xlsxwriter.h>\nLXW_VERSION\n' | cc -E - | tail -n 1)" != "\"$writer\"" ]; then
        skip rounded-wedge.xlsx "it was written by libxlsxwriter $writer"
    elif ! command -v python3 >/dev/null; then
        skip rounded-wedge.xlsx "no python3 here to unzip it"
    else
        python3 -m zipfile -e "$source/tables/rounded-wedge.xlsx" "$work/shipped-parts"
        python3 -m zipfile -e "$work/now/rounded-wedge.xlsx" "$work/parts"
        same rounded-wedge.xlsx "$work/shipped-parts" "$work/parts"
    fi
fi
[ $status = 0 ] || exit 1
[ -z "$skipped" ] || exit 77
echo "ok: $(wc -l <"$work/shipped") files"

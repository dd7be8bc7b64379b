#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# tables/ is what the tool writes now. CSV files and pictures are compared by their bytes, spreadsheets by their unzipped parts.
#     shipped_tables.sh SOURCE TOOL
set -eu
source=$1 tool=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/now"
cp "$source"/tables/*.svg "$source"/tables/*.xlsx "$work/now"
ended=0
sh "$source/tables/generate.sh" "$work/now" "$tool" >"$work/said" 2>&1 || ended=$?
[ $ended = 0 ] || [ $ended = 3 ] || { cat "$work/said"; exit 1; }

# The same files, apart from what is no table. generate.sh leaves a spreadsheet of the same parts as it is.
mkdir "$work/shipped"
cp "$source"/tables/*.csv "$source"/tables/*.svg "$source"/tables/*.xlsx "$work/shipped"
diff -rq "$work/shipped" "$work/now" ||
    { echo "FAILED: tables/ is not what the tool writes now; ./tables/generate.sh writes it"; exit 1; }
echo "ok: $(ls "$work/now" | wc -l) files"

# A clone in a folder that CMake does not take is refused at once.
newline='
'
for name in 'a#b' 'a;b' "a${newline}b"; do
    mkdir -p "$work/$name/tables" "$work/$name/tests/support"
    cp "$source/tables/generate.sh" "$work/$name/tables"
    cp "$source/tests/support/install.sh" "$work/$name/tests/support"
    ended_odd=0
    sh "$work/$name/tables/generate.sh" >"$work/said_odd" 2>&1 || ended_odd=$?
    [ $ended_odd = 2 ] && grep -q ': CMake does not take this path: no #' "$work/said_odd" ||
        { echo "FAILED: a clone in $name: status $ended_odd: $(cat "$work/said_odd")"; exit 1; }
done

status=0
if [ $ended = 3 ]; then
    echo "SKIPPED: the spreadsheets: this build has no libxlsxwriter; the other files were compared"
    status=77
fi
command -v gnuplot >/dev/null && why="another gnuplot drew it" || why="no gnuplot here"
for file in "$source"/tables/*.svg; do
    grep -qx "${file##*/}: drawn" "$work/said" && continue
    echo "SKIPPED: ${file##*/}: $why; the other files were compared"
    status=77
done
exit $status

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the tool and writes the lookup tables into this folder:  ./tables/generate.sh [FOLDER [TOOL [FORM]]]
# With FOLDER they are written there instead; with TOOL by that tool, and nothing is built; with FORM, csv or decimal-comma, only the
# CSV files, in that form. What is missing on the machine is installed first, where that is possible. Status 3: all is written but
# a spreadsheet, and what it needs is said.
set -eu
top=$(cd "$(dirname "$0")/.." && pwd)
. "$top/tests/support/install.sh"
accept_path "$top"
case $#${1:-} in
[4-9]* | ?-*) echo "usage: $0 [FOLDER [TOOL [FORM]]]" >&2; exit 2 ;;
esac
target=$(cd "${1:-$top/tables}" && pwd)
tool=${2:-$top/build/cli/rwedge}
case ${3:-csv} in
csv) as='' ;;
decimal-comma) as=--decimal-comma ;;
*) echo "$0: $3: unknown form; allowed: csv, decimal-comma" >&2; exit 2 ;;
esac
case $tool in
/*) ;;
*) tool=$PWD/$tool ;;
esac

if [ $# -lt 2 ]; then
    require_build_tools
    wish header:xlsxwriter.h=libxlsxwriter-dev module:xlsxwriter=python3-xlsxwriter # for the spreadsheets
    echo "Building $tool ..."
    cmake -S "$top" -B "$top/build" -DCMAKE_BUILD_TYPE=Release -DRWEDGE_BUILD_CLI=ON >/dev/null
    cmake --build "$top/build" --parallel "$(processors)" --target rwedge_cli rwedge >/dev/null
fi

# Ten digits: a last bit that differs between math libraries does not show.
table()
{
    name=$1
    shift
    "$tool" table "$@" --digits 10 $as --output "$target/$name.csv"
    echo "$name.csv: $(($(wc -l <"$target/$name.csv") - 1)) rows"
}

fine=0.01:1:0.01
for nu in 0.25 0.30 0.35; do
    table "elastic-limit-nu-$nu" elastic-limit --nu "$nu" # a/b 0.1 ... 1, f 0 ... 0.8: the paper's grid
    table "elastic-limit-fine-nu-$nu" elastic-limit --nu "$nu" --a-over-b "$fine"
done
table max-tension max-tension --a-over-b 0:1:0.01 --friction 0.1:0.8:0.1
table contact-law contact-law --a-over-b 0.01:2:0.01
for nu in 0.25 0.30 0.35; do
    table "flat-elastic-limit-nu-$nu" elastic-limit --pad flat --nu "$nu"
    table "shakedown-limit-nu-$nu" shakedown-limit --nu "$nu"
    table "flat-shakedown-limit-nu-$nu" shakedown-limit --pad flat --nu "$nu"
done
table flat-contact-law contact-law --pad flat --a-over-b 0:0.99:0.01
table critical-friction critical-friction --a-over-b "$fine" --nu 0.2:0.5:0.025

[ $# -lt 3 ] || exit 0

# The README's pictures, where gnuplot is there. Another gnuplot than drew them writes other bytes, and leaves them alone.
picture()
{
    file=$target/$1.svg
    shift
    drawn_by=$(sed -n 's|.*GNUPLOT \([^<]*[^ <]\) *</desc>.*|gnuplot \1|p' "$file" 2>/dev/null || true)
    if command -v gnuplot >/dev/null 2>&1 && { [ -z "$drawn_by" ] || [ "$drawn_by" = "$(gnuplot --version)" ]; }; then
        "$tool" figure "$@" --output "$file"
        echo "${file##*/}: drawn"
    else
        echo "${file##*/}: left as it is; gnuplot is missing, or another version drew it"
    fi
}
picture elastic-limit 4
picture von-mises field --a-over-b 0.25 --friction 0.6 --c-over-b 0.4
picture contact contact --no-title --E1 210000 --nu1 0.3 --theta 0.02 --radius 20 --f 0.3 --load 1200,0 --load 1200,200
picture shakedown shakedown
picture worn-pad wear --E1 1000 --nu1 0.3 --radius 30 --f 0.5 --load 1.2,0.36 --load 1.2,-0.36

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The page, where its compiler and packages can be had. With TOOL nothing is built: the test "page" compares it.
write_page()
{
    new=$scratch/rounded-wedge.html ended=0
    sh "$top/bindings/web/page/build.sh" "$top/build" "$new" >"$scratch/said" || ended=$?
    if [ $ended = 77 ]; then
        echo "rounded-wedge.html: left as it is; $(sed 's/^SKIPPED: //' "$scratch/said")"
    elif [ $ended != 0 ]; then
        exit $ended
    elif [ -f "$target/rounded-wedge.html" ] && ! grep -qxF "$(grep '^<!-- The library inside' "$new")" "$target/rounded-wedge.html"; then
        echo "rounded-wedge.html: left as it is; another clang compiled the library in it" # other bytes
    else
        cp "$new" "$target/rounded-wedge.html"
        echo "rounded-wedge.html: written"
    fi
}
[ $# -ge 2 ] || write_page

# A spreadsheet has other bytes from another zlib or another release of what writes it: it is left as it is where all its parts would
# be the same.
unpack()
{
    mkdir "$scratch/$1"
    (cd "$scratch/$1" && cmake -E tar xf "$2")
}
keep_book()
{
    rm -rf "$scratch/old" "$scratch/new"
    if [ -f "$target/$1" ] && unpack old "$target/$1" && unpack new "$scratch/$1" && diff -r "$scratch/old" "$scratch/new" >/dev/null; then
        echo "$1: left as it is"
    else
        cp "$scratch/$1" "$target/$1"
        echo "$1: written"
    fi
}
missing=0

# The workbook: its numbers are those of the library that was built with the tool.
library=$(ls "$(dirname "$tool")"/../lib/librwedge.so "$(dirname "$tool")"/../lib/librwedge.dylib 2>/dev/null | head -n 1)
if ! python=$(python_with xlsxwriter); then
    echo "rounded-wedge.xlsx: left as it is; Python's module xlsxwriter is missing (on Debian and Ubuntu python3-xlsxwriter)" >&2
    missing=3
elif [ -z "$library" ]; then
    echo "rounded-wedge.xlsx: left as it is; there is no shared library beside $tool" >&2
    missing=3
else
    "$python" -B "$top/tables/workbook.py" "$tool" "$library" "$scratch/rounded-wedge.xlsx"
    keep_book rounded-wedge.xlsx
fi

# The tables as one spreadsheet. The fine ones have the rows of the others.
if (cd "$target" && "$tool" workbook elastic-limit-fine-nu-0.25.csv elastic-limit-fine-nu-0.30.csv elastic-limit-fine-nu-0.35.csv \
        max-tension.csv contact-law.csv critical-friction.csv flat-elastic-limit-nu-0.25.csv flat-elastic-limit-nu-0.30.csv \
        flat-elastic-limit-nu-0.35.csv flat-contact-law.csv --digits 8 --output "$scratch/rounded-wedge-tables.xlsx"); then
    keep_book rounded-wedge-tables.xlsx
else
    missing=3
fi
[ $missing = 0 ] || echo "All files are written but these spreadsheets." >&2
exit $missing

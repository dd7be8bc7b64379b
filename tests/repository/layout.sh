#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The C and C++ sources are laid out as .clang-format says, and no line of theirs is longer than its 100 columns. (clang-format leaves
# comments and strings alone, however long they are.) No line of a Markdown file is longer than 130 columns, except in tables
# and code.
#     layout.sh SOURCE
set -eu
cd "$1"
version=14
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# a released archive has generated files, which are laid out by what writes them
find include lib cli tests bindings packages -path bindings/made -prune -o \( -name '*.[ch]' -o -name '*.[ch]pp' \) -print >"$work/files"
[ "$(wc -l <"$work/files")" -gt 100 ] || { echo "FAILED: the sources were not found"; exit 1; }

status=0
# columns MOST FILES AWK... - lines that are longer; a byte 10xxxxxx continues a character, and is no column
columns()
{
    tr '\n' '\0' <"$2" | LC_ALL=C xargs -0 awk -v most="$1" "$3"'
        { gsub(/[\200-\277]/, "") } length > most && !code { print FILENAME ":" FNR ": longer than " most " columns" }'
}
columns 100 "$work/files" '' >"$work/long"

# Indented code begins after an empty line. Other lines that are indented belong to a list.
find . \( -name 'build*' -o -name node_modules -o -name .git \) -prune -o -name '*.md' -print >"$work/texts"
[ "$(wc -l <"$work/texts")" -gt 50 ] || { echo "FAILED: the texts were not found"; exit 1; }
columns 130 "$work/texts" 'FNR == 1 { fenced = indented = blank = 0 } /^ *```/ { fenced = !fenced; next }
    { indented = /^    / && (indented || blank); blank = /^ *$/; code = fenced || indented || /^ *\|/ }' >>"$work/long"
if [ -s "$work/long" ]; then
    cat "$work/long"
    status=1
fi

clang_format=''
for name in clang-format-$version clang-format; do
    "$name" --version 2>/dev/null | grep -q " version $version\." && clang_format=$name && break
done
if [ -n "$clang_format" ]; then
    tr '\n' '\0' <"$work/files" | xargs -0 "$clang_format" --dry-run --Werror || status=1
fi
[ $status = 0 ] || { echo "FAILED: the layout of the sources and texts"; exit 1; }
[ -n "$clang_format" ] || { echo "SKIPPED: no clang-format-$version here, others lay out otherwise; the length of lines was checked"; exit 77; }
echo "ok: $(wc -l <"$work/files") sources, $(wc -l <"$work/texts") texts"

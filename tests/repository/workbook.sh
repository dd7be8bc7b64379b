#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The workbook, made anew and computed by LibreOffice: workbook_recalculate.py says what is compared. The same bytes in another folder,
# locale, time zone and year.
#     workbook.sh SOURCE TOOL LIBRARY
set -eu
source=$1 tool=$2 library=$3
. "$source/tests/support/install.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
skip() { echo "SKIPPED: $*"; exit 77; }

python=$(python_with xlsxwriter) || skip "Python's module xlsxwriter is missing (package python3-xlsxwriter)"
"$python" -B "$source/tables/workbook.py" "$tool" "$library" "$work/book.xlsx"
mkdir "$work/elsewhere"
(cd "$work/elsewhere" && LC_ALL=C TZ=Pacific/Apia "$python" -B "$source/tables/workbook.py" "$tool" "$library" book.xlsx)
cmp "$work/book.xlsx" "$work/elsewhere/book.xlsx" || { echo "FAILED: the workbook has other bytes in another folder"; exit 1; }
SOURCE_DATE_EPOCH=0 "$python" -B "$source/tables/workbook.py" "$tool" "$library" "$work/old.xlsx"
! cmp -s "$work/book.xlsx" "$work/old.xlsx" || { echo "FAILED: SOURCE_DATE_EPOCH does not set the date"; exit 1; }

command -v soffice >/dev/null 2>&1 || skip "LibreOffice is missing (package libreoffice-calc-nogui)"
python=$(python_with uno) || skip "Python's module uno is missing (package python3-uno)"
HOME=$work
export HOME
"$python" -B "$source/tests/repository/workbook_recalculate.py" "$tool" "$work" "$work/book.xlsx"

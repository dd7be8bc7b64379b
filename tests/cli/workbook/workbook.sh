# SPDX-License-Identifier: GPL-3.0-or-later
# The workbook, as LibreOffice computes it: workbook_recalculate.py says what is compared.
. "$(dirname "$0")/../claims.sh"

# Nothing is called, and nothing written, for a mistake.
refuses "--output: missing; allowed: the name of a file, such as rounded-wedge.xlsx, or -" workbook
refuses "--digits: the workbook has its own; allowed with: CSV files" workbook --digits 8 -o book.xlsx

run workbook -o book.xlsx
skip_without_xlsx 1 "rwedge workbook: book.xlsx"
ended 0 ""
output_is ""

# An old file stays where the new one cannot be written.
echo old >kept.xlsx
shell '(ulimit -f 64; trap "" XFSZ; "$rwedge" workbook -o kept.xlsx)'
status_is 1
same "the old file" old "$(cat kept.xlsx)"
rm kept.xlsx

[ "$failures" -eq 0 ] || finish
command -v soffice >/dev/null 2>&1 || skip "LibreOffice is missing (package libreoffice-calc-nogui)"
for python in python3 /usr/bin/python3 ""; do
    [ -z "$python" ] || ! "$python" -c 'import uno' >/dev/null 2>&1 || break
done
[ -n "$python" ] || skip "Python's module uno is missing (package python3-uno)"

HOME=$scratch
export HOME
called="LibreOffice"
"$python" -B "$here/workbook_recalculate.py" "$rwedge" "$scratch" book.xlsx
same "recalculated" 0 $?

finish

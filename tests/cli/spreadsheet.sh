# SPDX-License-Identifier: GPL-3.0-or-later
# --format xlsx: the same rows as CSV, in cells.
#
#     spreadsheet.sh PROGRAM REFERENCES [all]    all: also a table of more rows than fit
extent=${3:-}
. "$(dirname "$0")/claims.sh"

run table contact-law -o law.xlsx
if [ "$status" -eq 2 ]; then
    message_is "rwedge table: --format xlsx: this build cannot write XLSX: it was made without libxlsxwriter (on Debian \
and Ubuntu the package libxlsxwriter-dev)"
    same "no file" "" "$(ls ./*.xlsx 2>&1 | grep -v "No such file")"
    [ "$failures" -eq 0 ] || finish
    skip "this build has no libxlsxwriter"
fi
status_is 0
message_is ""

refuses "rwedge table: --decimal-comma: not in XLSX, whose numbers have a point; allowed with: csv, tsv" \
    table contact-law --format xlsx --decimal-comma -o law.xlsx
if [ "$extent" = all ]; then
    run table max-tension --a-over-b 0:2:0.000001 --friction 0.3 --format xlsx -o long.xlsx
    status_is 1
    message_is "rwedge table: long.xlsx: more than 1048575 rows, which XLSX cannot hold; allowed: csv, tsv, json"
    same "no file" "law.xlsx" "$(ls ./*.xlsx | sed 's,./,,')"
fi

# Elsewhere, to standard output, and in a comma locale: the same bytes.
run table contact-law --format xlsx --output=law.xlsx
mkdir folder
(cd folder && "$rwedge" table contact-law --format xlsx --output=law.xlsx)
same "the same again" "" "$(cmp law.xlsx folder/law.xlsx 2>&1)"
run table contact-law --format xlsx
same "a file on standard output" PK "$(head -c 2 out)"
mkdir locales
if localedef -i de_DE -f UTF-8 "$scratch/locales/de_DE.UTF-8" >/dev/null 2>&1; then
    called="LC_ALL=de_DE.UTF-8 rwedge table contact-law --format xlsx"
    LOCPATH=$scratch/locales LC_ALL=de_DE.UTF-8 "$rwedge" table contact-law --format xlsx --output=folder/law.xlsx
    same "in a comma locale" "" "$(cmp law.xlsx folder/law.xlsx 2>&1)"
fi

[ "$failures" -eq 0 ] || finish
command -v python3 >/dev/null 2>&1 || skip "Python, which reads the cells here, is missing (package python3)"
cat >cells.py <<'EOF'
# Prints the first sheet's cells as CSV, numbers as they are read.
import csv, re, sys, zipfile
import xml.etree.ElementTree as ET
M = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
archive = zipfile.ZipFile(sys.argv[1])
def column(name):
    number = 0
    for letter in re.match("[A-Z]+", name).group():
        number = 26 * number + ord(letter) - 64
    return number - 1
out = csv.writer(sys.stdout, lineterminator="\n")
wide = 0
for row in ET.fromstring(archive.read("xl/worksheets/sheet1.xml")).iter(M + "row"):
    cells = {}
    for cell in row.iter(M + "c"):
        value = cell.find(M + "v")
        if cell.get("t") == "inlineStr":
            cells[column(cell.get("r"))] = "".join(cell.find(M + "is").itertext())
        elif value is not None:
            cells[column(cell.get("r"))] = repr(float(value.text))
    wide = max(wide, 1 + max(cells))
    out.writerow([cells.get(i, "") for i in range(wide)])
EOF
compare() { # the cells with CSV; XLSX has 16 digits
    run "$@" --format xlsx -o book.xlsx
    status_is 0
    python3 cells.py book.xlsx >cells
    run "$@"
    same "cells" close "$(awk -F, 'NR == FNR { row[NR] = $0; rows = NR; next }
        { n = split(row[FNR], cell, ","); if (n != NF) { print "row " FNR ": " n " cells, not " NF; bad = 1; exit } }
        { for (i = 1; i <= NF; i++) { d = cell[i] - $i; if (cell[i] != $i && !($i + 0 == $i && d * d <= 1e-30 * $i * $i)) {
            print "row " FNR ": " cell[i] ", not " $i; bad = 1; exit } } }
        END { if (!bad) print (rows == FNR ? "close" : rows " rows, not " FNR) }' cells out)"
}
compare table elastic-limit
compare table elastic-limit --layout grid --digits 6
compare table elastic-limit --a-over-b 0,1 --friction 0,0.8 --layout grid --quantity branch
compare table contact-law --a-over-b 0:1.5:0.5
compare table critical-friction --nu 0.3,0.35 --layout grid
compare table stick-zone --digits 4

# The header stays, a page is as wide as the table, another sheet says how it was made.
text() { python3 -c 'import sys, zipfile; print(zipfile.ZipFile(sys.argv[1]).read(sys.argv[2]).decode())' book.xlsx "$1"; }
run table elastic-limit --format xlsx --digits 6 -o "$scratch/book.xlsx"
same "frozen header" 1 "$(text xl/worksheets/sheet1.xml | grep -c 'state="frozen"')"
same "fit to the page" 1 "$(text xl/worksheets/sheet1.xml | grep -c 'fitToHeight="0"')"
same "column widths" 1 "$(text xl/worksheets/sheet1.xml | grep -c '<cols>')"
same "the command, without folders" 1 \
    "$(text xl/worksheets/sheet2.xml | grep -c 'rwedge table elastic-limit --format xlsx --digits 6 -o book.xlsx')"

finish

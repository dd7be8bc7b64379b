# SPDX-License-Identifier: GPL-3.0-or-later
# --format xlsx: the same rows as CSV, in cells.
#
#     spreadsheet.sh PROGRAM REFERENCES [all]    all: also a table of more rows than fit
extent=${3:-}
. "$(dirname "$0")/../claims.sh"

run table contact-law -o law.xlsx
skip_without_xlsx 2 "rwedge table: --format xlsx"
status_is 0
message_is ""

refuses "--decimal-comma: not in XLSX, whose numbers have a point; allowed with: csv, tsv" \
    table contact-law --format xlsx --decimal-comma -o law.xlsx
if [ "$extent" = all ]; then
    cannot "long.xlsx: more than 1048575 rows, which XLSX cannot hold; allowed: csv, tsv, json" \
        table max-tension --a-over-b 0:2:0.000001 --friction 0.3 --format xlsx -o long.xlsx
    same "no file" "law.xlsx" "$(ls ./*.xlsx | sed 's,./,,')"
fi

# Elsewhere, in another locale and to standard output: the same bytes.
run table contact-law --format xlsx --output=law.xlsx
mkdir folder
(use_decimal_comma && cd folder && "$rwedge" table contact-law --format xlsx --output=law.xlsx)
same "the same again" "" "$(cmp law.xlsx folder/law.xlsx 2>&1)"
run table contact-law --format xlsx
same "a file on standard output" PK "$(head -c 2 out)"

[ "$failures" -eq 0 ] || finish
command -v python3 >/dev/null 2>&1 || skip "Python, which reads the cells here, is missing (package python3)"
python=$(python3 -c 'import sys; print(sys.executable)') # not a shim that looks for it at each call
cat >book.py <<'EOF'
# Of a spreadsheet file: "part SHEET", its XML; "names" of the sheets; "cells SHEET" as CSV, numbers as they are read; "shown
# COLUMN-OF-THE-FILE...", one line: columns without meaning or unit; numbers of which fewer than six digits show; what does not fit
# its column.
import csv, re, sys, zipfile
import xml.etree.ElementTree as ET
M = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
archive = zipfile.ZipFile(sys.argv[1])
command, more = sys.argv[2], sys.argv[3:]
part = lambda name: ET.fromstring(archive.read("xl/" + name))
rows = lambda number: list(part("worksheets/sheet%s.xml" % number).iter(M + "row"))
texts = lambda row: ["".join(c.itertext()) for c in row.iter(M + "c")]
def column(name):
    number = 0
    for letter in re.match("[A-Z]+", name).group():
        number = 26 * number + ord(letter) - 64
    return number - 1
def print_cells():
    out = csv.writer(sys.stdout, lineterminator="\n")
    wide = 0
    for row in rows(more[0]):
        cells = {}
        for cell, text in zip(row.iter(M + "c"), texts(row)):
            if text:
                cells[column(cell.get("r"))] = text if cell.get("t") == "inlineStr" else repr(float(text))
        wide = max(wide, 1 + max(cells))
        out.writerow([cells.get(i, "") for i in range(wide)])
def print_shown():
    described = {t[0]: t[1:] for t in map(texts, rows(2)[1:]) if len(t) == 3 and all(t)}
    unknown = [name for name in texts(rows(1)[0]) if name not in described and name not in more]
    styles = part("styles.xml")
    code = {f.get("numFmtId"): f.get("formatCode") for f in styles.iter(M + "numFmt")}
    style = [code.get(x.get("numFmtId"), "") for x in styles.find(M + "cellXfs")]
    widths = [float(c.get("width")) for c in part("worksheets/sheet1.xml").iter(M + "col")]
    blurred, cut = [], []
    for cell in (cell for row in rows(1)[1:] for cell in row.iter(M + "c") if cell.find(M + "v") is not None):
        value, form = float(cell.find(M + "v").text), style[int(cell.get("s", 0))]
        decimals = len(form.split("E")[0].partition(".")[2])
        shown = "%.*E" % (decimals, value) if "E" in form else "%.*f" % (decimals, value) if form else "%.15g" % value
        if abs(float(shown) - value) > 5e-6 * abs(value):
            blurred.append(shown)
        if len(shown) > min(widths):
            cut.append(shown)
    print(unknown, blurred, cut)
if command == "part":
    print(archive.read("xl/worksheets/sheet%s.xml" % more[0]).decode())
elif command == "names":
    print(*(each.get("name") for each in part("workbook.xml").iter(M + "sheet")))
else:
    print_cells() if command == "cells" else print_shown()
EOF
same_cells() { # SHEET CSV: XLSX has 16 digits
    "$python" book.py book.xlsx cells "$1" >cells
    same "cells of sheet $1" close "$(awk -F, 'NR == FNR { row[NR] = $0; rows = NR; next }
        { n = split(row[FNR], cell, ","); if (n != NF) { print "row " FNR ": " n " cells, not " NF; bad = 1; exit } }
        { for (i = 1; i <= NF; i++) { d = cell[i] - $i; if (cell[i] != $i && !($i + 0 == $i && d * d <= 1e-30 * $i * $i)) {
            print "row " FNR ": " cell[i] ", not " $i; bad = 1; exit } } }
        END { if (!bad) print (rows == FNR ? "close" : rows " rows, not " FNR) }' cells "$2")"
}
compare() {
    does "$@" --format xlsx -o book.xlsx
    run "$@"
    same_cells 1 out
}
compare table elastic-limit --a-over-b 0.1:1:0.1
compare table elastic-limit --a-over-b 0,1 --friction 0,0.8 --layout grid --quantity branch --digits 6
compare table contact-law --a-over-b 0:1.5:0.5

# CSV files as sheets: numbers are numbers, what is none stays a text.
"$rwedge" table contact-law --a-over-b 0:1.5:0.5 -o law.csv
"$rwedge" table elastic-limit --a-over-b 0.1,1 -o limits.csv
printf 'name,P\n007,1000\n0.10,1E5\n,x\n' >"a[1].csv"
does workbook law.csv ./limits.csv "a[1].csv" -o book.xlsx
message_is "rwedge workbook: a[1].csv: its sheet is called a_1_"
same_cells 1 law.csv
same_cells 2 limits.csv
same "another sheet" 'name,P;007,1000.0;0.10,1E5;,x;' "$("$python" book.py book.xlsx cells 3 | tr '\n' ';')"
same "names of sheets" "law limits a_1_ Columns About" "$("$python" book.py book.xlsx names)"
run workbook law.csv --digits 3 -o book.xlsx
same "three digits" 0.5,1.91,3.83,1.51,1.02 "$("$python" book.py book.xlsx cells 1 | sed -n 3p)"
fails() { # MESSAGE FILE...
    expected=$1
    shift
    cannot "$expected" workbook "$@" -o new.xlsx
    same "no file" "" "$(ls new.xlsx 2>/dev/null)"
}
: >empty.csv
printf 'a,b\n1,"2\n' >quote.csv
fails "rwedge workbook: nowhere.csv: No such file or directory" nowhere.csv
fails "rwedge workbook: empty.csv: no rows" law.csv empty.csv
fails "rwedge workbook: quote.csv: line 2: a quote that is not closed" quote.csv
printf 'a,b\n1,2\n\n3\n' >ragged.csv
fails "rwedge workbook: ragged.csv: line 4: 1 cells in this row, 2 in the header" ragged.csv

# Where memory ends, anywhere on the way, the command says so, and no signal ends it. The tool alone takes $base kB.
base=500000
while [ "$base" -gt 4000 ] && (ulimit -v $((base - 2000)) && "$rwedge" --version) >/dev/null 2>&1; do
    base=$((base - 2000))
done
if (ulimit -v 500000 && "$rwedge" --version) >/dev/null 2>&1; then # an address sanitizer reserves more
    for more in $(seq 0 250 12000); do
        shell "(ulimit -v $((base + more)) && exec \"\$rwedge\" workbook law.csv limits.csv -o short.xlsx)"
        same "status with $more kB" "$status" "$(echo "0 1 127" | tr ' ' '\n' | grep -x "$status")" # 127: not even loaded
    done
    same "enough at last" 0 "$status"
fi

# The tool's own files with a decimal comma: read by the option, and refused without it.
"$rwedge" table contact-law --a-over-b 0:1.5:0.5 --decimal-comma -o comma.csv
"$rwedge" table contact-law --a-over-b 0:1.5:0.5 --decimal-comma -o comma.tsv
does workbook comma.csv --decimal-comma -o book.xlsx
same_cells 1 law.csv
fails "rwedge workbook: comma.csv: one column; the columns seem to be separated by ';': $semicolons" comma.csv
fails "rwedge workbook: law.csv: one column; the columns seem to be separated by ',': leave out --decimal-comma, and blanks within numbers" law.csv --decimal-comma
fails "rwedge workbook: comma.tsv: line 3: 0,5: a decimal comma; --decimal-comma reads it" comma.tsv
printf 'a;b\n1,5;2.5\n' >point.csv
fails "rwedge workbook: point.csv: line 2: 2.5: a decimal point; without --decimal-comma it is a number" point.csv --decimal-comma
refuses "--output: missing; allowed: the name of a file, such as tables.xlsx, or -" workbook law.csv
refuses "FILE.csv: missing; allowed: up to 10 CSV files. The spreadsheet that computes is a file of its own, rounded-wedge.xlsx" \
    workbook -o new.xlsx

# An old file stays where the new one cannot be written.
echo old >kept.xlsx
for i in 1 2 3 4 5 6 7 8 9 10; do cat law.csv; done | awk 'NR == 1 { print; next } { for (i = 0; i < 4000; i++) print }' >long.csv
shell '(ulimit -f 64; trap "" XFSZ; "$rwedge" workbook long.csv -o kept.xlsx)'
status_is 1
same "the old file" old "$(cat kept.xlsx)"

# Names that no sheet can have, or that are taken, whatever their capitals: what they are instead is said.
sheets() { # NAMES MESSAGE FILE...
    names=$1 expected=$2
    shift 2
    for file in "$@"; do
        [ -e "$file" ] || cp law.csv "$file"
    done
    does workbook "$@" -o book.xlsx
    message_is "$expected"
    same "names" "$names Columns About" "$("$python" book.py book.xlsx names)"
}
mkdir capitals
sheets "law LAW_2 about_2" "rwedge workbook: capitals/LAW.csv: its sheet is called LAW_2
rwedge workbook: about.csv: its sheet is called about_2" law.csv capitals/LAW.csv about.csv
sheets "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa" "rwedge workbook: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa.csv: its sheet is called \
aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa" aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa.csv
refuses "k: unexpected; allowed: up to 10 files" workbook a b c d e f g h i j k -o new.xlsx

# The header stays, a page is as wide as the table, another sheet says how it was made.
has() { # SHEET TEXT
    same "$2" 1 "$("$python" book.py book.xlsx part "$1" | grep -c "$2")"
}
run table elastic-limit --format xlsx --digits 6 -o "$scratch/book.xlsx"
has 1 'state="frozen"'
has 1 'fitToHeight="0"'
has 2 'fitToPage="1"'
has 1 '<cols>'
has 3 'rwedge table elastic-limit --format xlsx --digits 6 -o book.xlsx'

# What the columns mean, and their units, on a sheet of its own; at least six digits show, in cells that are wide enough.
shows() { # COLUMNS-OF-THE-FILE COMMAND...
    own=$1
    shift
    does "$@" --format xlsx -o book.xlsx
    same "columns and digits of $*" "[] [] []" "$("$python" book.py book.xlsx shown $own)"
}
shows "" table elastic-limit --a-over-b 0.001,0.5
shows "" table contact-law --a-over-b 1e-7,0.01,0.5,3e5
shows "" table stick-zone
printf 'E1,nu1,theta,a,P,M,f,k\n210000,0.3,0.03,0.3,300,10,0.3,500\n21e9,0.31,0.003,0.3e-5,123456.789,0,0.3,5e8\n' >cases.csv
shows "E1 nu1 theta P M f k error" solve --input cases.csv --yield-factor
shows "" solve --E1 210000 --nu1 0.3 --theta 0.03 --a 0.3 --P 300 --M 1 --f 0.3 --k 500 --layout row

finish

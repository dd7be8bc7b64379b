# SPDX-License-Identifier: GPL-3.0-or-later
# In a locale with a decimal comma every command gives the same bytes. (The library calls nothing that knows of a locale:
# tests/package/symbols.sh.)
#
#     locale.sh PROGRAM
command -v localedef >/dev/null 2>&1 || { echo "SKIPPED: no localedef here"; exit 77; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
if ! localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" 2>/dev/null; then
    echo "SKIPPED: localedef cannot make de_DE.UTF-8 here"
    exit 77
fi
LOCPATH=$work
export LOCPATH
status=0
printf 'E1,nu1,theta,a,P,Q,f,k\n2.5,0.3,0.01,2,1.5e-3,1e-4,0.3,0.5\n' >"$work/in.csv"
same()
{
    LC_ALL=C "$program" "$@" >"$work/c" || status=1
    LC_ALL=de_DE.UTF-8 "$program" "$@" >"$work/de" || status=1
    [ -s "$work/c" ] && cmp -s "$work/c" "$work/de" || { echo "FAILED: rwedge $* differs in de_DE.UTF-8"; status=1; }
}
program=$1
same solve --input "$work/in.csv"
same solve --input "$work/in.csv" --format json
same table elastic-limit --a-over-b 0.1,0.25 --friction 0:0.3:0.1
same field --a-over-b 0.3 --f 0.3 --x 0,0.5 --y 0.5 --format vtk
# The file names the command that wrote it. It has the same bytes later, and wherever it is called from.
mkdir "$work/later"
if (cd "$work" && "$program" workbook -o book.xlsx) 2>"$work/said"; then
    (cd "$work/later" && LC_ALL=de_DE.UTF-8 "$program" workbook -o book.xlsx) || status=1
    cmp -s "$work/book.xlsx" "$work/later/book.xlsx" || { echo "FAILED: the workbook differs in de_DE.UTF-8"; status=1; }
elif ! grep -q libxlsxwriter "$work/said"; then
    cat "$work/said"
    status=1
fi
exit $status

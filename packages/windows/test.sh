# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the zip as it is unpacked, under Wine: in a folder with a space and letters beyond ASCII.
work=$build/windows
rm -rf "$work"
mkdir -p "$work/the größe folder"
. "$here/wine.sh"
if [ -z "$wine" ] || [ -z "$server" ]; then
    echo "not tested: $name.zip, for lack of wine64" | tee -a "$tested"
    exit 77
fi
(cd "$work/the größe folder" && cmake -E tar xf "$packages/$name.zip")
folder="$work/the größe folder/$name"
cd "$folder"
trap end_wine EXIT
start_wine

# It needs nothing that Windows lacks, no mathematics of Windows' own, and is the same whatever folder it was made in.
for file in rwedge.exe rwedge.dll; do
    x86_64-w64-mingw32-objdump -p $file >"$work/$file.tables"
    others=$(sed -n 's/.*DLL Name: //p' "$work/$file.tables" | grep -vixE 'kernel32.dll|msvcrt.dll|shell32.dll' || true)
    [ -z "$others" ] || fail "$file needs $others"
    ! grep -aqF "$build" $file || fail "$file names $build"
done
sed -n '/DLL Name: msvcrt/,/^$/s/^.*[0-9]  *_*\([a-z0-9]*\)$/\1/p' "$work/rwedge.exe.tables" | sort >"$work/imported"
x86_64-w64-mingw32-nm "$build/excel/dependencies/libm.a" | sed -n 's/.* T //p' | sort >"$work/mathematics"
[ -s "$work/imported" ] && [ -s "$work/mathematics" ] || fail "the names of functions cannot be read"
[ -z "$(comm -12 "$work/imported" "$work/mathematics")" ] || fail "mathematics of Windows: $(comm -12 "$work/imported" "$work/mathematics")"

# Every command once.
rwedge() { on_windows "$folder/rwedge.exe" "$@" 2>"$work/said" || { cat "$work/said"; fail "rwedge.exe $*"; }; }
bodies='--E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --f 0.3'
rwedge --version >"$work/out"
grep -q '^rwedge [0-9]' "$work/out" || fail "no version"
rwedge help solve >/dev/null
rwedge --completion bash >/dev/null
# shellcheck disable=SC2086
{
    rwedge solve $bodies --P 2000 --Q 300 --k 300 -o "Größe 1.csv"
    rwedge profile $bodies --load 2000,0 --load 2000,300 -o "profile.json"
    rwedge field $bodies --load 2000,300 -o "Größe 2.xlsx"
    "$build/cli/rwedge" solve $bodies --P 2000 --Q 300 --k 300 | diff -q - "Größe 1.csv" || fail "solve writes something else"
}
# shellcheck disable=SC2086
{
    rwedge history $bodies --load 2000,0,0,0 --load 2000,0,300,0 -o "history.csv"
    printf 'P,Q\n2000,0\n2000,300\n2000,-300\n' >cycle.csv
    rwedge fretting cycle.csv $bodies --x -1,0,1 -o "fretting.csv"
}
rwedge figure 4 --data -o "figure 4.csv"
rwedge workbook history.csv fretting.csv -o "tables.xlsx"
! on_windows "$folder/rwedge.exe" figure 4 -o figure.svg 2>"$work/said" || fail "a figure without gnuplot"
grep -q 'gnuplot: not found on PATH' "$work/said" || fail "what a figure needs is not said: $(cat "$work/said")"
[ -z "$(find . -name '.rwedge-*')" ] || fail "unfinished files are left"

# The tables: the same bytes as on Linux. Then the tool's own tests, without those that need POSIX.
cat >"$work/rwedge" <<EOF
#!/bin/sh
work='$work'
. '$here/wine.sh'
on_windows '$folder/rwedge.exe' "\$@"
EOF
chmod +x "$work/rwedge"
mkdir "$work/tables"
sh "$top/tables/generate.sh" "$work/tables" "$work/rwedge" csv >"$work/log" 2>&1 || { tail -n 4 "$work/log"; fail "generate.sh"; }
for table in "$top"/tables/*.csv; do
    cmp "$table" "$work/tables/$(basename "$table")" || fail "another table"
done
run=''
for test in command_line/completion command_line/ranges figures/figure_data files/formats files/spreadsheet results/batch \
    results/field results/fretting results/off_centre results/profile results/solve results/tables system/threads; do
    sh "$top/tests/cli/$test.sh" "$work/rwedge" "$top/tests/data" >"$work/log" 2>&1 ||
        { grep -a -A 4 FAILED "$work/log" | head -n 40; fail "tests/cli/$test.sh"; }
    run="$run $test"
done

# The DLL with its import library and header, from C.
sed -n '/^```c main.c$/,/^```$/p' "$top/README.md" | sed '1d;$d' >"$work/main.c"
x86_64-w64-mingw32-gcc "$work/main.c" -Ic -Lc -lrwedge -o main.exe
on_windows main.exe | grep '^yields at P = 3.406876 b k' || fail "the example in C"
rm main.exe
{
    echo "tested: $name.zip, under Wine, in a folder with a space and an umlaut: every command; the tables of Linux to the byte;"
    echo "    the tool's tests$run; the README's example in C"
    echo "not tested: $name.zip: Windows itself; Ctrl-C; the console; figures through gnuplot for Windows; the other tests of the tool:"
    echo "    packages/README.md says why"
} >>"$tested"

# The module for Excel, with this DLL.
sh "$top/bindings/excel/test.sh" "$build" >"$work/log" 2>&1 && status=0 || status=$?
cmp "$folder/rwedge.dll" "$build/excel/windows/bin/rwedge.dll" || fail "the module was tested with another DLL"
case $status in
0) echo "tested: rwedge.bas with the DLL of the zip: $(tail -n 1 "$work/log")" >>"$tested" ;;
77) echo "not tested: rwedge.bas: $(tail -n 1 "$work/log")" >>"$tested" ;;
*) tail -n 20 "$work/log"; fail "bindings/excel/test.sh" ;;
esac

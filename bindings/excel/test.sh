#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The module for Excel and the DLL, as far as they can be tested without Excel: the module against the header and the DLL; the
# DLL under Wine against the library of this machine.    test.sh FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
mkdir -p "$1/excel"
folder=$(cd "$1" && pwd)
work=$folder/excel

skip() { echo "SKIPPED: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }

for command in x86_64-w64-mingw32-gcc x86_64-w64-mingw32-gfortran apt-get dpkg-source cmake python3 timeout; do
    command -v "$command" >/dev/null || skip "$command is not here"
done
sh "$top/packages/sources.sh" "$work/sources" gsl lapack musl >"$work/log" 2>&1 ||
    skip "the sources of GSL, LAPACK and musl cannot be fetched: $(grep '^E: ' "$work/log" | head -n 1)"
sh "$top/packages/windows/build.sh" "$work"
sh "$top/tests/answers/answers.sh" "$folder"
made=$folder/private/made
cd "$work"
dll=windows/bin/rwedge.dll

# The module fits the header and the DLL. (That it is what the generator writes is the test interface.)
cp "$made/excel/rwedge.bas" rwedge.bas
echo '#include <rwedge.h>' >header.c
x86_64-w64-mingw32-gcc -Iwindows/include -aux-info prototypes -c header.c -o header.o
x86_64-w64-mingw32-objdump -p $dll >tables
python3 -B "$here/check.py" rwedge.bas "$top/include/rwedge.h" prototypes tables
# A reader of Basic: no other is to be had without Office.
. "$top/tests/support/venv.sh"
checker=$work/vbalidator
if reason=$(venv "$here/test/requirements.txt" "$checker"); then
    "$checker/bin/vbalidator" --host excel --strict --define 'Win64=True,VBA7=True' \
        --output vbalidator.json rwedge.bas >log || { cat log; fail "vbalidator finds fault"; }
    grep '^Errors' log
else
    echo "SKIPPED: vbalidator, which reads the module: ${reason#SKIPPED: }"
fi
# Its own code, run in the only Basic here.
python_with_uno=''
for python in python3 /usr/bin/python3; do
    if $python -c 'import uno' 2>/dev/null; then python_with_uno=$python; fi
done
if command -v soffice >/dev/null && [ -n "$python_with_uno" ]; then
    "$python_with_uno" -B "$here/test/run_cells.py" rwedge.bas "$here/test/cells.bas" "$work"
else
    echo "SKIPPED: the module's own code, for lack of LibreOffice with Python's uno"
fi

# It needs nothing that Windows lacks, and no mathematics of Windows' own.
[ "$(sed -n 's/.*DLL Name: //p' tables | sort | tr '\n' ' ')" = "KERNEL32.dll msvcrt.dll " ] || fail "the DLL needs other DLLs"
sed -n '/DLL Name: msvcrt/,/^$/s/^.*[0-9]  *_*\([a-z0-9]*\)$/\1/p' tables | sort >imported
x86_64-w64-mingw32-nm dependencies/libm.a | sed -n 's/.* T //p' | sort >mathematics
[ -s imported ] || fail "the imports cannot be read"
[ -s mathematics ] || fail "the names of libm cannot be read"
[ -z "$(comm -12 imported mathematics)" ] || fail "taken from msvcrt.dll:" "$(comm -12 imported mathematics)"
# Nor may Excel's mode of the x87 (53 bits) matter: it is not used. (fninit is in the start-up of programs, not of a DLL.)
# A list of addresses stands behind the code. It begins with -1, which is no instruction; what follows may look like any.
x86_64-w64-mingw32-objdump -d --no-show-raw-insn $dll >section
sed '/(bad)/,$d' section >code
grep -q addsd code && [ "$(wc -l <section)" -lt "$(($(wc -l <code) + 100))" ] || fail "the code cannot be read"
x87=$(awk -F '\t' '$2 ~ /^f[a-z]/ { split($2, word, " "); print word[1] }' code | grep -v '^fninit$' | sort -u)
[ -z "$x87" ] || fail "the DLL uses the x87:" "$x87"

. "$top/packages/windows/wine.sh"
[ -n "$wine" ] && [ -n "$server" ] || skip "wine64 is not here; the module and the DLL's code were checked"
trap end_wine EXIT
start_wine
answers=$folder/private/answers
x86_64-w64-mingw32-gcc -std=c99 -Iwindows/include "$answers/answer.c" -o windows/bin/answer.exe -Lwindows/lib -lrwedge
on_windows windows/bin/answer.exe | tr -d '\r' >answers-windows

# The library of this machine, with its own libm and with that of the DLL.
sh "$top/packages/libm.sh" sources linux
prefix=$folder/private/prefix
cc -std=c99 -I"$prefix/include" "$answers/answer.c" -o linux/answer-same "$prefix/lib/librwedge.a" linux/libm.a -lm
linux/answer-same >answers-same
cmp answers-same answers-windows || fail "Windows and Linux differ, with the same libm"
echo "$(wc -l <answers-windows) calls: the same bits on Windows and here with the same libm"
echo "with this machine's libm, $(python3 -B "$top/tests/answers/compare.py" "$answers/answers.csv" answers-windows 1e-12)"

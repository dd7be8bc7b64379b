#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The Fortran module, linked with the private build.    test.sh BUILD-FOLDER
set -eu
: "${1:?usage: test.sh BUILD-FOLDER}"
here=$(cd "$(dirname "$0")" && pwd)
top=$here/../..
for tool in gfortran python3; do
    command -v $tool >/dev/null 2>&1 || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
sh "$top/tests/answers/answers.sh" "$1"
prefix=$(cd "$1/private/prefix" && pwd)
answers=$prefix/../answers
mkdir -p "$1/fortran"
cd "$1/fortran"

fail()
{
    echo "FAILED: $1"
    exit 1
}

# The module alone is Fortran 2008 (tests/package/installed.sh). In programs gfortran 14 then warns wherever a contact goes out of
# scope, of a rule of 2008 about other objects. That an allocatable array may be used uninitialised is a false alarm of gfortran.
strict='-std=f2018 -Wall -Wextra -pedantic -Werror -Wno-maybe-uninitialized'

# fortran FOLDER/PROGRAM OPTIONS... - builds it with the module
fortran()
{
    program=$1
    shift
    # shellcheck disable=SC2086
    gfortran $strict "$@" "$program.f90" rwedge.o "$prefix/lib/librwedge.a" -lm -o "${program##*/}"
}

# shellcheck disable=SC2086
gfortran $strict -O2 -fopenmp -c "$prefix/include/rwedge.f90"
fortran "$answers/answer" -O0
./answer | tr A-F a-f >answers.csv
cmp answers.csv "$answers/answers.csv" || fail "the answers differ from those in C"
echo "$(wc -l <answers.csv) calls answered as in C, to the last bit"

fortran "$here/example_fretting" -O2
./example_fretting >example.txt
sed '$d; s/E\([-+]\)/e\1/' example.txt | diff - "$top/tests/data/example_fretting.txt" ||
    fail "the example differs from that in C"
echo "the example prints what it does in C; $(tail -n 1 example.txt)"

# where equality is asserted, it is meant
# shellcheck disable=SC2086
gfortran $strict -g -fopenmp -fsanitize=address -c "$prefix/include/rwedge.f90"
fortran "$here/test_module" -g -fopenmp -fsanitize=address -Wno-compare-reals
./test_module
ASAN_OPTIONS=detect_leaks=0 ./test_module threads
if ./test_module stop 2>stopped.txt; then
    fail "an error without stat does not end the program"
fi
grep -q '^rwedge_stress(alpha, f, c, x, y): an argument is outside its domain: ' stopped.txt ||
    fail "it does not say why it ends"

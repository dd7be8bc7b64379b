#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library raises no floating-point exception but inexact and underflow. This is tried with every compiler that is here, at
# every level of optimisation, and with every width of vectors that this processor has.
#     exceptions.sh SOURCE BUILD [COMPILER...]
set -eu
build=$(cd "$2" && pwd)
cd "$1"
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
. tests/support/compilers.sh

processor_has()
{
    grep -q "^flags.*[[:space:]]$1\b" /proc/cpuinfo 2>/dev/null
}
vectors=''
processor_has avx2 && vectors="$vectors -mavx2" || echo "SKIPPED: this processor has no AVX2"
processor_has avx512dq && processor_has avx512vl && vectors="$vectors -mavx512f,-mavx512dq,-mavx512vl" ||
    echo "SKIPPED: this processor has no AVX-512"

# The tests are compiled without optimisation, so that their own comparisons raise nothing.
build_tests()
{
    for test in host/test_calls host/calls/calls host/calls/draw host/calls/edges host/calls/sequences lib/potential/test_batches support/claims support/main support/quadrature; do
        "$1" -std=c99 -D_XOPEN_SOURCE=700 -DTEST_DATA='"tests/data"' -Iinclude -I"$build/made/c" -Itests/host/calls -Itests/support -Ilib -c "tests/$test.c" \
            -o "$work/$(basename "$test").o"
    done
}

# try COMPILER OPTIONS... - the library, and two tests with it.
try()
{
    rm -rf "$work/lib"
    mkdir "$work/lib"
    for file in lib/*/*.c; do
        # shellcheck disable=SC2046
        "$@" $(options_of "$1" "$file") -Iinclude -Ilib -c "$file" -o "$work/lib/$(basename "$file").o"
    done
    for test in "test_calls calls draw edges sequences" "test_batches main"; do
        objects=$(printf "$work/%s.o " $test claims quadrature)
        "$1" $objects "$work"/lib/*.o -o "$work/program" -lcmocka -lgsl -lgslcblas -llapack -lpthread -lm
        filter=''
        case $test in test_calls*) filter='2000 answers_follow*' ;; esac
        # shellcheck disable=SC2086
        "$work/program" $filter >"$work/log" 2>&1 || { cat "$work/log"; echo "FAILED: $*, ${test%% *}"; failed=yes; return; }
    done
    echo "ok: $*"
}

failed=no
for compiler in ${*:-$(compilers_here)}; do
    build_tests "$compiler"
    for level in -O0 -O1 -O2 -O3; do
        try "$compiler" $level
    done
    for wide in $vectors; do
        try "$compiler" -O3 $(echo "$wide" | tr , ' ')
    done
done
[ $failed = no ]

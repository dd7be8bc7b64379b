#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The library raises no floating-point exception but inexact and underflow. This is tried with every compiler that is here, at
# every level of optimisation, and with every width of vectors that this processor has.
#     exceptions.sh SOURCE BUILD [COMPILER...]
set -eu
build=$(cd "$2" && pwd)/exceptions
cd "$1"
shift 2
. tests/support/compilers.sh

processor_has()
{
    grep -q "^flags.*[[:space:]]$1\b" /proc/cpuinfo 2>/dev/null
}
vectors=''
processor_has avx2 && vectors="$vectors -mavx2" || echo "SKIPPED: this processor has no AVX2"
processor_has avx512dq && processor_has avx512vl && vectors="$vectors -mavx512f,-mavx512dq,-mavx512vl" ||
    echo "SKIPPED: this processor has no AVX-512"

# try COMPILER OPTIONS - the library, and two tests with it.
try()
{
    rm -rf "$build"
    mkdir "$build"
    if cmake -S . -B "$build" -DCMAKE_C_COMPILER="$1" -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS="$2" -DRWEDGE_BUILD_CLI=OFF \
        -DRWEDGE_BUILD_TESTS=ON -DRWEDGE_INSTALL=OFF >"$build/log" 2>&1 &&
        cmake --build "$build" --target test_calls test_batches >"$build/log" 2>&1 &&
        "$build/tests/embedding/test_calls" 2000 'answers_follow*' >"$build/log" 2>&1 &&
        "$build/tests/lib/test_batches" >"$build/log" 2>&1; then
        echo "ok: $*"
    else
        cat "$build/log"
        echo "FAILED: $*"
        failed=yes
    fi
}

failed=no
for compiler in ${*:-$(compilers_here)}; do
    for level in -O0 -O1 -O2 -O3; do
        try "$compiler" $level
    done
    for wide in $vectors; do
        try "$compiler" "-O3 $(echo "$wide" | tr , ' ')"
    done
done
[ $failed = no ]

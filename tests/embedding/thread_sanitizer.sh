#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs under the thread sanitizer: eight threads with shared handles give the same bits without a data race. So do the threads of
# the tool.    thread_sanitizer.sh SOURCE BUILD
set -eu
build=$(cd "$2" && pwd)/threads
cd "$1"
mkdir -p "$build"
echo 'int main(void) { return 0; }' >"$build/probe.c"
for compiler in gcc clang none; do
    "$compiler" -fsanitize=thread "$build/probe.c" -o "$build/probe" 2>/dev/null && "$build/probe" 2>/dev/null && break
done
[ $compiler != none ] || { echo "SKIPPED: no compiler here whose thread sanitizer runs"; exit 77; }

cmake -S . -B "$build" -DCMAKE_C_COMPILER=$compiler -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS='-O1 -g -fsanitize=thread' \
    -DRWEDGE_BUILD_CLI=ON -DRWEDGE_INSTALL=OFF >"$build/log" 2>&1 &&
    cmake --build "$build" --target test_threads rwedge_cli >>"$build/log" 2>&1 || { cat "$build/log"; exit 1; }
for program in "tests/embedding/test_threads 4" "cli/rwedge table elastic-limit --a-over-b 0:1.2:0.01 --threads 8" \
    "cli/rwedge fretting --E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.3 --load 100,0 --load 100,20 --threads 8"; do
    if ! TSAN_OPTIONS=halt_on_error=1 "$build"/$program >"$build/log" 2>&1; then
        tail -n 40 "$build/log"
        echo "FAILED: $program under the thread sanitizer of $compiler"
        exit 1
    fi
done
echo "ok: no data race among 2 and 8 threads of the library's callers and of the tool, $compiler"

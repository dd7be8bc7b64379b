#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs under the thread sanitizer: eight threads with shared handles give the same bits without a data race. So do the threads of
# the tool.    threads.sh SOURCE BUILD
set -eu
build=$(cd "$2" && pwd)
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A compiler whose thread sanitizer finds a planted race, on this machine.
cat >"$work/race.c" <<'END'
#include <pthread.h>
static int shared;
static void *add(void *unused)
{
    for (int i = 0; i < 100000; i++)
        shared++;
    return unused;
}
int main(void)
{
    pthread_t thread[2];
    for (int i = 0; i < 2; i++)
        pthread_create(&thread[i], 0, add, 0);
    for (int i = 0; i < 2; i++)
        pthread_join(thread[i], 0);
    return shared == 0;
}
END
finds_races()
{
    command -v "$1" >/dev/null || return 1
    "$1" -g -fsanitize=thread "$work/race.c" -o "$work/race" -lpthread 2>/dev/null || return 1
    "$work/race" >"$work/log" 2>&1 && return 1
    grep -q 'WARNING: ThreadSanitizer: data race' "$work/log"
}
for compiler in gcc clang; do
    finds_races $compiler && break
    compiler=''
done
[ -n "$compiler" ] || { echo "SKIPPED: no compiler here whose thread sanitizer finds a race"; exit 77; }

$compiler -std=c99 -O1 -g -fsanitize=thread -ffp-contract=off -DTEST_DATA='""' -Iinclude -Ilib -I"$build/made/c" -Itests/support -Itests/host/calls lib/*/*.c \
    tests/host/test_threads.c tests/host/calls/*.c tests/support/claims.c -o "$work/threads" \
    -lgsl -lgslcblas -llapack -lcmocka -lpthread -lm
$compiler -std=c99 -D_XOPEN_SOURCE=700 -O1 -g -fsanitize=thread -DTEST_DATA='""' -Icli -Itests/support tests/support/claims.c tests/support/main.c \
    tests/cli/system/test_ahead.c cli/system/ahead.c cli/text/memory.c cli/text/message.c cli/text/utf8.c cli/system/progress.c \
    cli/system/posix/processors.c cli/system/posix/signals.c cli/system/posix/streams.c -o "$work/ahead" -lgsl -lgslcblas -lcmocka -lpthread -lm
for program in "$work/threads 4" "$work/ahead"; do
    if ! TSAN_OPTIONS=halt_on_error=1 $program >"$work/log" 2>&1; then
        cat "$work/log"
        echo "FAILED: ${program##*/} under the thread sanitizer of $compiler"
        exit 1
    fi
done
echo "ok: no data race among 2 and 8 threads of the library's callers and of the tool, $compiler"

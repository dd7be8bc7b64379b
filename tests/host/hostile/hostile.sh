#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The private build among foreign libraries. Other functions under GSL's and LAPACK's names are preloaded, or a LAPACK whose integers
# have 64 bits. The private build gives the same bits, and leaves the host's GSL error handler alone.
#     hostile.sh SOURCE BUILD
set -eu
source=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
here=$source/tests/host/hostile

sh "$source/bindings/private.sh" "$build"
private=$build/private/prefix/lib
cc -std=c99 -I"$source/include" "$here/host.c" -o "$work/host" -L"$private" -lrwedge -lgsl -lgslcblas -lm
cc -shared -fPIC "$here/foreign.c" -o "$work/foreign.so"

# run LIBRARY-FOLDER PRELOADED - the host's output
run()
{
    LD_LIBRARY_PATH=$1 LD_PRELOAD=$2 "$work/host"
}

run "$private" '' >"$work/alone"
[ "$(wc -l <"$work/alone")" -gt 50 ] || { echo "FAILED: the host printed too little"; exit 1; }

needed=$(readelf -d "$private/librwedge.so" | sed -n 's/.*NEEDED.*\[\(.*\)\.so.*/\1/p' | sort | tr '\n' ' ')
[ "$needed" = "libc libm " ] || { echo "FAILED: the private build needs $needed"; exit 1; }

# The check itself: the foreign functions do change what a build with the system's GSL and LAPACK computes.
if [ -e "$build/lib/librwedge.so" ] && run "$build/lib" "$work/foreign.so" >"$work/hijacked" 2>&1 &&
        cmp -s "$work/alone" "$work/hijacked"; then
    echo "FAILED: the foreign functions change nothing in the ordinary build: this test shows nothing"
    exit 1
fi

# same NAME PRELOADED
same()
{
    run "$private" "$2" >"$work/preloaded" && cmp "$work/alone" "$work/preloaded" || { echo "FAILED: $1 preloaded"; exit 1; }
    echo "ok: the same bits with $1 preloaded"
}

same "foreign functions" "$work/foreign.so"
found=no
for name in libopenblas64.so.0 liblapack64.so.3; do
    library=$(ldconfig -p | sed -n "s/.*$name .*=> //p" | head -n 1)
    [ -n "$library" ] || continue
    found=yes
    same "$name" "$library"
done
[ $found = yes ] || { echo "SKIPPED: no LAPACK with 64-bit integers here; the rest passed"; exit 77; }

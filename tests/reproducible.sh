#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The same bytes in tables/ from every compiler, level of optimisation and math library; the same bits from the library for
# every compiler and level.    reproducible.sh SOURCE BUILD
set -eu
source=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$source"

# The committed tables, written again by the tool as it was built, and on a processor without fused multiply-add.
mkdir "$work/here" "$work/plain"
compare()
{
    count=0
    for file in tables/*.csv; do
        if ! cmp "$file" "$2/$(basename "$file")"; then
            echo "FAILED: $file is not what $1 writes"
            exit 1
        fi
        count=$((count + 1))
    done
    [ "$count" -gt 0 ] && [ "$count" -eq "$(find "$2" -name '*.csv' | wc -l)" ] ||
        { echo "FAILED: tables/ does not hold what $1 writes"; exit 1; }
    echo "ok: $count tables, $1"
}
./tables/generate.sh "$work/here" "$build/cli/rwedge" >/dev/null
compare "this build" "$work/here"
GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable ./tables/generate.sh "$work/plain" \
    "$build/cli/rwedge" >/dev/null
compare "a processor without fused multiply-add" "$work/plain"

# Another math library, by its own build of the tool.
mkdir "$work/other"
CFLAGS="-include $source/tests/other_libm.h" cmake -S "$source" -B "$work/other-build" -DCMAKE_BUILD_TYPE=Release \
    -DRWEDGE_BUILD_TESTS=OFF -DRWEDGE_BUILD_CLI=ON >"$work/log" 2>&1 &&
    cmake --build "$work/other-build" --parallel 2 --target rwedge_cli >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
./tables/generate.sh "$work/other" "$work/other-build/cli/rwedge" >/dev/null
compare "another math library" "$work/other"
"$build/cli/rwedge" table elastic-limit >"$work/a"
"$work/other-build/cli/rwedge" table elastic-limit >"$work/b"
if cmp -s "$work/a" "$work/b"; then
    echo "FAILED: the other math library is the same one: with all digits nothing differs"
    exit 1
fi

# Bit for bit: a program that prints the bits of many results.
first=''
for compiler in "gcc -O0" "gcc -O3" "clang -O2"; do
    command -v "${compiler%% *}" >/dev/null || { echo "not here: ${compiler%% *}"; continue; }
    $compiler -std=c99 -ffp-contract=off -Iinclude lib/*.c tests/print_bits.c -o "$work/bits" -lgsl -lgslcblas -llapack -lm
    "$work/bits" >"$work/bits-now"
    [ -s "$work/bits-now" ] || { echo "FAILED: nothing printed"; exit 1; }
    if [ -z "$first" ]; then
        first=$compiler
        mv "$work/bits-now" "$work/bits-first"
    elif ! cmp "$work/bits-first" "$work/bits-now"; then
        echo "FAILED: $compiler and $first differ"
        diff "$work/bits-first" "$work/bits-now" | head -n 4
        exit 1
    else
        echo "ok: $(wc -l <"$work/bits-first") results, $compiler as $first"
    fi
done

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every compiler, level of optimisation and math library gives the same bytes in tables/. Every compiler, level and processor gives
# the same bits of the library's results. The bits of pressures and stresses are also the same from every math library.
#     reproducible.sh SOURCE BUILD [all]     all: levels 1 and 2 of optimisation too
set -eu
source=$(realpath "$1") build=$(realpath "$2") levels=${3:-ends}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$source"
. tests/support/compilers.sh

# The committed tables, written again on a processor without fused multiply-add. (tests/shipped compares what this one writes.)
mkdir "$work/plain"
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
# generate FOLDER TOOL - its status 3 says that the tool cannot write the workbook.
generate()
{
    ended=0
    ./tables/generate.sh "$1" "$2" >"$work/said" 2>&1 || ended=$?
    [ $ended = 0 ] || [ $ended = 3 ] || { cat "$work/said"; exit 1; }
}
(export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable
    generate "$work/plain" "$build/cli/rwedge")
compare "a processor without fused multiply-add" "$work/plain"

# Another math library, by a build of the tool that has no libxlsxwriter either. It stands in for all that the library calls but
# what IEEE or C define to the last bit; sincos() is what a compiler makes of a sin() and a cos().
exact='sqrt|fmin|fmax|frexp|ilogb|ldexp|floor|ceil|fabs'
nm -D --undefined-only "$build"/lib/librwedge.so | sed -n 's/.* U \([a-z0-9]*\)@.*/\1/p' | sort >"$work/called"
nm -D --defined-only "$(ldd "$build"/lib/librwedge.so | sed -n 's/.*libm\.so.*=> \([^ ]*\).*/\1/p')" |
    sed -n 's/.* [WTi] \([a-z0-9]*\)@.*/\1/p' | sort -u | comm -12 - "$work/called" | grep -vxE "$exact" | sed 's/^sincos$/sin\ncos/' >"$work/inexact"
[ -s "$work/inexact" ] || { echo "FAILED: no function of the math library found in the library"; exit 1; }
while read -r name; do
    grep -q "^#define $name(" tests/package/other_libm.h || { echo "FAILED: tests/package/other_libm.h does not have $name()"; exit 1; }
done <"$work/inexact"
mkdir "$work/other"
cp tests/package/other_libm.h "$work" # flags are a list of words: no space in the path
CFLAGS="-include $work/other_libm.h" cmake -S "$source" -B "$work/other-build" -DCMAKE_BUILD_TYPE=Release \
    -DXLSXWRITER_LIBRARY=m -DRWEDGE_BUILD_TESTS=OFF -DRWEDGE_BUILD_CLI=ON >"$work/log" 2>&1 &&
    cmake --build "$work/other-build" --parallel 2 --target rwedge_cli >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
generate "$work/other" "$work/other-build/cli/rwedge"
[ $ended = 3 ] && grep -q 'libxlsxwriter-dev' "$work/said" ||
    { echo "FAILED: without libxlsxwriter, generate.sh ends with status $ended and says:"; cat "$work/said"; exit 1; }
compare "another math library" "$work/other"

# Bit for bit: a program that prints the bits of results of every function, from both compilers at every level, without the
# vectors that only some processors have, and with all that this one has, fused multiply-add among it.
# print_bits_of NAME COMPILER OPTIONS... - leaves the bits, or nothing where they could not be had.
print_bits_of()
{
    name=$1
    shift
    "$@" $library_options -Iinclude -Ilib -Ibindings/interface -Itests/support lib/*/*.c tests/support/every_function.c tests/package/print_bits.c -o "$work/$name-program" \
        -lgsl -lgslcblas -llapack -lm && "$work/$name-program" >"$work/$name-now" && mv "$work/$name-now" "$work/$name"
}
compare_bits()
{
    name=$1
    shift
    [ -s "$work/$name" ] || { echo "FAILED: $*: nothing printed"; exit 1; }
    if ! cmp "$work/gcc-O0" "$work/$name"; then
        echo "FAILED: $* and gcc -O0 differ"
        diff "$work/gcc-O0" "$work/$name" | head -n 4
        exit 1
    fi
    echo "ok: $(wc -l <"$work/$name") results of $(cut -d' ' -f1 "$work/$name" | sort -u | wc -l) functions, $*"
}
here=''
for compiler in gcc clang; do
    command -v $compiler >/dev/null && here="$here $compiler" || echo "SKIPPED: no $compiler here"
done
case $here in *gcc*) ;; *) echo "SKIPPED: the bits between compilers, no gcc here"; exit 77 ;; esac
for compiler in $here; do # one after the other, so that two processors are enough
    print_bits_of $compiler-O0 $compiler -O0 &
    print_bits_of $compiler-O3 $compiler -O3
    wait
    compared='-O0 -O3'
    if [ "$levels" = all ]; then
        print_bits_of $compiler-O1 $compiler -O1 &
        print_bits_of $compiler-O2 $compiler -O2
        wait
        compared='-O0 -O1 -O2 -O3'
    fi
    print_bits_of $compiler-baseline $compiler -O3 -DRW_BASELINE &
    print_bits_of $compiler-native $compiler -O3 -march=native
    wait
    for level in $compared; do
        compare_bits $compiler$level $compiler $level
    done
    compare_bits $compiler-baseline $compiler -O3, vectors of every such processor
    compare_bits $compiler-native $compiler -O3, all that this processor has
done

# With another math library pressures and stresses keep every bit, as they call nothing but sqrt(); something else differs, or
# it would be the same library.
print_bits_of foreign gcc -O2 -include tests/package/other_libm.h
grep -E '^(pressure|stress|stresses) ' "$work/gcc-O0" >"$work/without-library"
grep -E '^(pressure|stress|stresses) ' "$work/foreign" >"$work/without-library-foreign"
cmp "$work/without-library" "$work/without-library-foreign" ||
    { echo "FAILED: pressures and stresses depend on the math library"; exit 1; }
if cmp -s "$work/gcc-O0" "$work/foreign"; then
    echo "FAILED: the other math library is the same one: nothing differs"
    exit 1
fi
echo "ok: $(wc -l <"$work/without-library") pressures and stresses, another math library"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The bits of the library's results are the same as built, and with the vectors of every processor.
#     reproducible.sh SOURCE BUILD [all]
# all: so they are from each compiler that is here, at every level of optimisation, and with all that this processor has; nor does
# the library then raise exceptions but inexact and underflow. So are the bytes of tables/ without fused multiply-add and with
# another math library, and with that the bits of pressures and stresses.
set -eu
: "${2:?usage: reproducible.sh SOURCE BUILD [all]}"
source=$(realpath "$1") build=$(realpath "$2") extent=${3:-ordinary}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$source"
. tests/support/compilers.sh

# Bit for bit: a program that prints the bits of results of every function.
calls="-Iinclude -Ilib -Itests/embedding/calls -I$build/made/c tests/embedding/calls/calls.c tests/embedding/calls/draw.c"
printer="$calls tests/package/print_bits.c"
libraries='-lgsl -lgslcblas -llapack -lm'
# print_bits_of NAME COMMAND... - compiles the program, and leaves the bits, or nothing where they could not be had
print_bits_of()
{
    name=$1
    shift
    "$@" $libraries -o "$work/$name-program" && "$work/$name-program" >"$work/$name-now" && mv "$work/$name-now" "$work/$name"
}
# of_all_files NAME COMPILER OPTIONS... - of the library compiled with these options, which stays in lib.o
# shellcheck disable=SC2086
of_all_files()
{
    name=$1
    shift
    "$@" $library_options -Iinclude -Ilib -r -nostdlib lib/*/*.c -o "$work/lib.o" &&
        print_bits_of "$name" "$1" $library_options $printer "$work/lib.o"
}
# of_this_build NAME OPTIONS... - of the build that all other tests are about, but for files that are given with the options
# shellcheck disable=SC2086
of_this_build()
{
    name=$1
    shift
    print_bits_of "$name" gcc $library_options $printer "$@" "$build/lib/librwedge_inside.a"
}
compare_bits()
{
    name=$1
    shift
    [ -s "$work/$name" ] || { echo "FAILED: $*: nothing printed"; exit 1; }
    if ! cmp "$work/reference" "$work/$name"; then
        echo "FAILED: $* and the ordinary build differ"
        diff "$work/reference" "$work/$name" | head -n 4
        exit 1
    fi
    echo "ok: $(wc -l <"$work/$name") results of $(cut -d' ' -f1 "$work/$name" | sort -u | wc -l) functions, $*"
}
# raises_nothing COMPILER - the library in lib.o raises no exception but inexact and underflow, whatever it is called with
# shellcheck disable=SC2086
raises_nothing()
{
    "$1" -std=c99 -D_XOPEN_SOURCE=700 -DTEST_DATA='""' -Itests/support $calls tests/embedding/test_calls.c tests/support/claims.c \
        tests/support/run_claims.c "$work/lib.o" -lcmocka $libraries -pthread -o "$work/calls" || return 1
    "$work/calls" 500 'answers_follow*' >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
}
command -v gcc >/dev/null || { echo "SKIPPED: the bits between compilers, no gcc here"; exit 77; }

of_this_build reference
# shellcheck disable=SC2046
of_this_build baseline -O3 -DRW_BASELINE $(grep -lE '"(base/processor|potential/lanes)\.h"' lib/*/*.c)
compare_bits baseline vectors of every such processor
[ "$extent" = all ] || exit 0

for compiler in $(compilers_here); do
    # clang raises exceptions that the source does not, unless it is told, as in lib/CMakeLists.txt
    trap_option=-ffp-exception-behavior=maytrap
    "$compiler" -Werror $trap_option -x c -c /dev/null -o "$work/empty.o" 2>/dev/null || trap_option=
    for options in -O0 -O1 -O2 '-O3 -DRW_BASELINE' '-O3 -march=native'; do
        # shellcheck disable=SC2086
        of_all_files tried $compiler $options $trap_option
        compare_bits tried $compiler $options
        raises_nothing $compiler || { echo "FAILED: exceptions, $compiler $options"; exit 1; }
    done
done

# The committed tables, written again on a processor without fused multiply-add. (tests/repository compares what this one writes.)
mkdir "$work/plain"
compare()
{
    for file in tables/*.csv; do
        cmp "$file" "$2/${file##*/}" || { echo "FAILED: $file is not what $1 writes"; exit 1; }
    done
    echo "ok: $(ls tables/*.csv | wc -l) tables, $1"
}
# generate FOLDER TOOL - its status 3 says that a spreadsheet cannot be written.
generate()
{
    ended=0
    ./tables/generate.sh "$1" "$2" >"$work/said" 2>&1 || ended=$?
    [ $ended = 0 ] || [ $ended = 3 ] || { cat "$work/said"; exit 1; }
}
(export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable
    generate "$work/plain" "$build/cli/rwedge")
compare "a processor without fused multiply-add" "$work/plain"

# Another math library: other_libm.h stands in for all that the library calls but what IEEE or C define to the last bit. sincos() is
# what a compiler makes of a sin() and a cos().
exact='sqrt|fmin|fmax|frexp|ilogb|ldexp|floor|ceil|fabs'
nm -D --undefined-only "$build"/lib/librwedge.so | sed -n 's/.* U \([a-z0-9]*\)@.*/\1/p' | sort >"$work/called"
nm -D --defined-only "$(ldd "$build"/lib/librwedge.so | sed -n 's/.*libm\.so.*=> \([^ ]*\).*/\1/p')" |
    sed -n 's/.* [WTi] \([a-z0-9]*\)@.*/\1/p' | sort -u | comm -12 - "$work/called" | grep -vxE "$exact" | sed 's/^sincos$/sin\ncos/' >"$work/inexact"
[ -s "$work/inexact" ] || { echo "FAILED: no function of the math library found in the library"; exit 1; }
while read -r name; do
    grep -q "^#define $name(" tests/package/other_libm.h || { echo "FAILED: tests/package/other_libm.h does not have $name()"; exit 1; }
done <"$work/inexact"

of_all_files foreign gcc -O0 -include tests/package/other_libm.h
# With another math library pressures and stresses keep every bit, as they call nothing but sqrt(); something else differs, or
# it would be the same library.
grep -E '^(pressure|stress|stresses) ' "$work/reference" >"$work/without-library"
grep -E '^(pressure|stress|stresses) ' "$work/foreign" >"$work/without-library-foreign"
cmp "$work/without-library" "$work/without-library-foreign" ||
    { echo "FAILED: pressures and stresses depend on the math library"; exit 1; }
if cmp -s "$work/reference" "$work/foreign"; then
    echo "FAILED: the other math library is the same one: nothing differs"
    exit 1
fi
echo "ok: $(wc -l <"$work/without-library") pressures and stresses, another math library"

# The tables from another math library, by a build of the tool that has no libxlsxwriter either.
mkdir "$work/other"
cp tests/package/other_libm.h "$work" # flags are a list of words: no space in the path
CFLAGS="-include $work/other_libm.h" cmake -S "$source" -B "$work/other-build" -DCMAKE_BUILD_TYPE=Release \
    -DXLSXWRITER_LIBRARY=m -DRWEDGE_BUILD_TESTS=OFF -DRWEDGE_BUILD_CLI=ON >"$work/log" 2>&1 &&
    cmake --build "$work/other-build" --parallel 2 --target rwedge_cli >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
generate "$work/other" "$work/other-build/cli/rwedge"
[ $ended = 3 ] && grep -q 'libxlsxwriter-dev' "$work/said" ||
    { echo "FAILED: without libxlsxwriter, generate.sh ends with status $ended and says:"; cat "$work/said"; exit 1; }
compare "another math library" "$work/other"

# What such a build says when it is asked for a spreadsheet file, and that it writes none.
sh tests/cli/files/spreadsheet.sh "$work/other-build/cli/rwedge" tests/data >"$work/said" 2>&1 && ended=0 || ended=$?
[ $ended = 77 ] && grep -q 'this build has no libxlsxwriter' "$work/said" ||
    { echo "FAILED: without libxlsxwriter, tests/cli/files/spreadsheet.sh ends with status $ended and says:"; cat "$work/said"; exit 1; }

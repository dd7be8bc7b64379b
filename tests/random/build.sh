#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the targets with libFuzzer and the address and undefined-behaviour sanitizers, library and tool included.
#
#     build.sh SOURCE FOLDER        SOURCE: the project; FOLDER: where the programs fuzz_TARGET and the folders seeds/TARGET go
#
# The status is 77 if no clang has libFuzzer.
set -eu
source=$(cd "$1" && pwd)
mkdir -p "$2"
cd "$2"
echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return d && n > 9; }' >trial.c
for clang in ${CLANG:-clang-19 clang-18 clang-17 clang-16 clang-15 clang clang-14}; do
    "$clang" -fsanitize=fuzzer,address trial.c -o trial 2>/dev/null && break
    clang=
done
[ -n "$clang" ] || { echo "SKIPPED: no clang with libFuzzer here (Debian: clang, libclang-rt-dev)"; exit 77; }
# The project under a short name: lists of flags and commands then need no quotes, even where its path has a space.
ln -sfn "$source" source
python3 -B source/bindings/interface/generate.py made c
flags="-std=c99 -gline-tables-only -O1 -ffp-contract=off -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined"
flags="$flags -fno-sanitize-recover=all -D_XOPEN_SOURCE=700 -DRW_CHECKED -Isource/include -Isource/lib -Isource/cli"
flags="$flags -Isource/tests/host/calls -Isource/tests/random -Imade/c"
flags="$flags $(pkg-config --cflags popt jansson gsl)"
libraries="$(pkg-config --libs popt jansson gsl) -lcsv -llapack -lm"

# compile FILE.c ... - notes the commands, and the objects.
compile()
{
    for file; do
        name=$(echo "${file#source/}" | tr / _)
        echo "$clang $flags -c $file -o ${name%.c}.o" >>commands
        objects="$objects ${name%.c}.o"
    done
}
: >commands
objects=
compile source/lib/*/*.c
library=$objects
objects=
for file in source/cli/*.c source/cli/*/*.c source/cli/system/posix/*.c; do
    case $file in
    */main.c | */message.c | */sheet/* | */spreadsheet.c | */workbook/*) ;; # the messages are our own; spreadsheets are none of the inputs
    *) compile "$file" ;;
    esac
done
compile "source/tests/random/messages.c" "source/tests/random/file.c"
tool=$objects
objects=
compile "source/tests/random/until_exit.c"
until_exit=$objects
objects=
compile source/tests/host/calls/*.c
calls=$objects
# seeds TARGET - a file of seeds/TARGET/ for every line of the target's seeds.
seeds()
{
    rm -rf "seeds/$1"
    mkdir -p "seeds/$1"
    sed '/^#/d' "source/tests/random/targets/$1.seeds" | while read -r name bytes; do
        printf %b "$bytes" >"seeds/$1/$name"
    done
}
targets='formulas contact any_history series number range csv batch'
for target in $targets; do
    seeds "$target"
    echo "$clang $flags -c source/tests/random/targets/$target.c -o fuzz_$target.o" >>commands
done
xargs -P "${JOBS:-2}" -I{} sh -c '{}' <commands
rm -f tool.a
ar rc tool.a $tool
wraps=
for call in malloc calloc realloc free strdup csv_init iconv_open iconv_close file_to_read file_to_write atexit exit; do
    wraps="$wraps -Wl,--wrap=$call"
done
for target in $targets; do
    ends=
    case $target in csv | batch) ends="$until_exit $wraps" ;; esac
    "$clang" -fsanitize=fuzzer,address,undefined "fuzz_$target.o" $calls $ends tool.a $library $libraries -o "fuzz_$target"
done
echo "$clang: $targets"

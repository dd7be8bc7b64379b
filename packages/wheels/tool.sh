#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The tool for Linux in one file, which asks nothing of the system but Linux: all is inside, the C library (musl) too. It writes no XLSX.
#     tool.sh SOURCES SOURCE FOLDER COMPILER CMAKE-ARGUMENT...
# of sources.sh's folder and rwedge's sources, by a compiler with musl -> FOLDER/rwedge. The arguments are CMake's, for GSL and LAPACK.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
sources=$(cd "$1" && pwd) source=$(cd "$2" && pwd)
mkdir -p "$3/objects" "$3/include" "$3/lib/pkgconfig"
cd "$3"
compiler=$4
shift 4
sh "$here/../sources.sh" "$sources" popt jansson libcsv

# archive NAME [OPTION...] FILES... - lib/libNAME.a
archive()
{
    name=$1 objects='' options="-std=gnu99 -O2 -w -ffile-prefix-map=$sources=. -Iinclude"
    shift
    for word; do
        case $word in
        *.c)
            object=objects/$name-$(basename "$word" .c).o
            # shellcheck disable=SC2086
            "$compiler" $options -c "$word" -o "$object"
            objects="$objects $object"
            ;;
        *) options="$options $word" ;;
        esac
    done
    # shellcheck disable=SC2086
    ar rcsD "lib/lib$name.a" $objects
}
# found NAME VERSION - for pkg-config
found()
{
    printf 'Name: %s\nDescription: %s\nVersion: %s\nLibs: -L%s/lib -l%s\nCflags: -I%s/include\n' \
        "$1" "$1" "$2" "$PWD" "$1" "$PWD" >"lib/pkgconfig/$1.pc"
}

cp "$sources/popt/src/popt.h" include
archive popt -DHAVE_STPCPY -DHAVE_STRERROR -DHAVE_UNISTD_H -DPACKAGE='"popt"' -DPOPT_SYSCONFDIR='""' \
    "$sources"/popt/src/popt.c "$sources"/popt/src/popthelp.c "$sources"/popt/src/poptparse.c "$sources"/popt/src/poptint.c
found popt 1.19
cp "$sources/jansson/src/jansson.h" "$sources/jansson/android/jansson_config.h" include
: >objects/jansson_private_config.h
archive jansson -Iobjects -DHAVE_STDINT_H "$sources"/jansson/src/*.c
found jansson 2.14
cp "$sources/libcsv/csv.h" include
archive csv "$sources/libcsv/libcsv.c"

export PKG_CONFIG_LIBDIR="$PWD/lib/pkgconfig" # nothing of this machine's
cmake -S "$source" -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$compiler" -DCMAKE_EXE_LINKER_FLAGS='-static -s' \
    -DRWEDGE_HARDENING=OFF -DRWEDGE_PRIVATE_DEPS=ON -DRWEDGE_BUILD_CLI=ON -DRWEDGE_BUILD_TESTS=OFF -DRWEDGE_INSTALL=OFF \
    -DLIBCSV_INCLUDE_DIR="$PWD/include" -DLIBCSV_LIBRARY="$PWD/lib/libcsv.a" \
    -DXLSXWRITER_INCLUDE_DIR=XLSXWRITER_INCLUDE_DIR-NOTFOUND "$@"
cmake --build build --parallel 2 --target rwedge_cli
cp build/cli/rwedge rwedge

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles for Windows what the tool needs besides the library: popt, Jansson, libcsv, libxlsxwriter with zlib, and musl's iconv.
#     tool.sh SOURCES FOLDER        sources.sh's folder -> FOLDER/lib/, FOLDER/include/
set -eu
tool=x86_64-w64-mingw32
here=$(cd "$(dirname "$0")" && pwd)
sources=$(cd "$1" && pwd)
mkdir -p "$2/objects" "$2/include" "$2/lib/pkgconfig"
cd "$2"
[ -f lib/libcsv.a ] && exit 0

# archive NAME [OPTION...] FILES... - lib/libNAME.a
archive()
{
    name=$1 objects=''
    shift
    options="-std=gnu99 -O2 -w -D__USE_MINGW_ANSI_STDIO=1 -ffile-prefix-map=$sources=. -Iinclude" # no path of this machine
    for word; do
        case $word in
        *.c)
            object=objects/$name-$(basename "$word" .c).o
            # shellcheck disable=SC2086
            $tool-gcc $options -c "$word" -o "$object"
            objects="$objects $object"
            ;;
        *) options="$options $word" ;;
        esac
    done
    # shellcheck disable=SC2086
    $tool-ar rcsD "lib/lib$name.a" $objects
}

# found NAME VERSION LIBRARIES - for pkg-config
found()
{
    printf 'Name: %s\nDescription: %s\nVersion: %s\nLibs: -L%s/lib -l%s\nCflags: -I%s/include\n' \
        "$1" "$1" "$2" "$PWD" "$1" "$PWD" >"lib/pkgconfig/$1.pc"
}

cp "$sources/zlib/zlib.h" "$sources/zlib/zconf.h" include
archive z "$sources"/zlib/adler32.c "$sources"/zlib/crc32.c "$sources"/zlib/deflate.c "$sources"/zlib/trees.c \
    "$sources"/zlib/zutil.c "$sources"/zlib/compress.c "$sources"/zlib/inflate.c "$sources"/zlib/inftrees.c "$sources"/zlib/inffast.c

# Its temporary files are the tool's: cli/system/windows/windows_files.c.
cp -r "$sources"/libxlsxwriter/include/. include
minizip=$sources/libxlsxwriter/third_party/minizip
archive xlsxwriter -include "$here/for_xlsxwriter.h" -DUSE_STANDARD_TMPFILE -DNOCRYPT -DNOUNCRYPT -I"$minizip" \
    "$sources"/libxlsxwriter/src/*.c "$minizip/ioapi.c" "$minizip/zip.c" "$sources/libxlsxwriter/third_party/md5/md5.c"

cp "$sources/popt/src/popt.h" include
mkdir -p objects/headers/sys
: >objects/headers/features.h
: >objects/headers/sys/ioctl.h # popt includes it, and needs nothing of it
# Popt asks whether a program runs for another user than the one who started it: not in Windows.
archive popt '-Dgetuid()=0' '-Dgeteuid()=0' '-Dgetgid()=0' '-Dgetegid()=0' -Iobjects/headers -DHAVE_STRERROR \
    -DPACKAGE='"popt"' -DPOPT_SYSCONFDIR='""' "$sources"/popt/src/popt.c "$sources"/popt/src/popthelp.c \
    "$sources"/popt/src/poptparse.c "$sources"/popt/src/poptint.c
found popt 1.19

cp "$sources/jansson/src/jansson.h" "$sources/jansson/android/jansson_config.h" include
: >objects/headers/jansson_private_config.h
archive jansson -Iobjects/headers -DHAVE_STDINT_H "$sources"/jansson/src/*.c
found jansson 2.14

sed 's/^#include <features.h>$//; s/<bits\/alltypes.h>/<stddef.h>/' "$sources/musl/include/iconv.h" >include/iconv.h
cp "$here/for_iconv.h" objects/headers/locale_impl.h
multibyte=$sources/musl/src/multibyte
archive iconv -fno-builtin -include "$here/for_iconv.h" -Iobjects/headers "$sources/musl/src/locale/iconv.c" \
    "$sources/musl/src/locale/iconv_close.c" "$multibyte/mbrtowc.c" "$multibyte/wcrtomb.c" "$multibyte/internal.c"

cp "$sources/libcsv/csv.h" include
archive csv "$sources/libcsv/libcsv.c" # last: it stands for all of them

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles for Windows what the library takes from GSL, LAPACK and libm, and no more: seconds where all of theirs takes minutes.
#     dependencies.sh SOURCES FOLDER        sources.sh's folder -> FOLDER/libgsl.a, liblapack.a, libm.a, include/gsl/
set -eu
tool=x86_64-w64-mingw32
here=$(cd "$(dirname "$0")" && pwd)
sources=$(cd "$1" && pwd)
mkdir -p "$2"
cd "$2"
[ -f liblapack.a ] && exit 0

# libm: musl's, so that results are not those of whichever msvcrt.dll a Windows has.
sh "$here/libm.sh" "$sources" . $tool-

# GSL: its root-finders and what they stand on. Its configure asks here only for functions that C99 has.
mkdir -p gsl-objects lapack-objects include/gsl
cp "$sources"/gsl/gsl_*.h "$sources"/gsl/*/gsl_*.h include/gsl
sed 's/^#undef \(HAVE_DECL_[A-Z0-9]*\)$/#define \1 1/' "$sources/gsl/config.h.in" >include/config.h
for file in "$sources"/gsl/roots/*.c "$sources"/gsl/sys/*.c; do
    case ${file##*/} in test*) continue ;; esac
    $tool-gcc -O2 -ffp-contract=off -ffile-prefix-map="$sources"=. -Iinclude -I"$sources/gsl" \
        -c "$file" -o "gsl-objects/$(basename "$(dirname "$file")")-$(basename "$file" .c).o"
done
$tool-ar rcsD libgsl.a gsl-objects/*.o

# LAPACK: dgelsd, then what that calls, and so on; a routine's file has its name. What has no file (Fortran's run-time, libm) is
# for the linker to find. xerbla is the library's own.
compile()
{
    for place in SRC INSTALL BLAS/SRC; do
        for source in "$sources/lapack/$place/$1".[fF] "$sources/lapack/$place/$1".[fF]90; do
            [ -f "$source" ] || continue
            $tool-gfortran -O2 -ffp-contract=off -Jlapack-objects -c "$source" -o "lapack-objects/$1.o"
            return
        done
    done
}
undefined()
{
    $tool-nm -u lapack-objects/*.o | sed -n 's/^ *U \([a-z][a-z0-9]*\)_$/\1/p' | grep -v '^xerbla$' | sort -u
}
compile la_constants # the modules of those routines that are Fortran 90
compile la_xisnan
compile dgelsd
before=0 now=1
while [ "$now" -gt "$before" ]; do
    before=$now
    for routine in $(undefined); do
        [ -f "lapack-objects/$routine.o" ] || compile "$routine"
    done
    now=$(find lapack-objects -name '*.o' | wc -l)
done
$tool-ar rcsD liblapack.tmp lapack-objects/*.o
mv liblapack.tmp liblapack.a # last: it stands for all of them

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles what the library takes from GSL and LAPACK, and no more: seconds where all of theirs takes minutes.
#     dependencies.sh SOURCES FOLDER PREFIX     sources.sh's folder -> FOLDER/libgsl.a, liblapack.a, include/gsl/, by PREFIXgcc,
#                                               PREFIXgfortran, PREFIXar and PREFIXnm
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sources=$(cd "$1" && pwd)
prefix=$3
mkdir -p "$2"
cd "$2"
[ -f liblapack.a ] && exit 0

sh "$here/gsl.sh" "$sources" "${prefix}gcc" -O2 -ffp-contract=off -fPIC -ffile-prefix-map="$sources"=.
"${prefix}ar" rcsD libgsl.a gsl/*.o
mkdir -p lapack-objects

# LAPACK: dgelsd, then what that calls, and so on; a routine's file has its name. What has no file (Fortran's run-time, libm) is
# for the linker to find. xerbla is the library's own.
compile()
{
    for place in SRC INSTALL BLAS/SRC; do
        for source in "$sources/lapack/$place/$1".[fF] "$sources/lapack/$place/$1".[fF]90; do
            [ -f "$source" ] || continue
            "${prefix}gfortran" -O2 -ffp-contract=off -fPIC -Jlapack-objects -c "$source" -o "lapack-objects/$1.o"
            return
        done
    done
}
undefined()
{
    "${prefix}nm" -u lapack-objects/*.o | sed -n 's/^ *U \([a-z][a-z0-9]*\)_$/\1/p' | grep -v '^xerbla$' | sort -u
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
"${prefix}ar" rcsD liblapack.tmp lapack-objects/*.o
mv liblapack.tmp liblapack.a # last: it stands for all of them

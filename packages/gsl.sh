#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles GSL's root-finder and minimiser, and its singular values, on which dgelsd.c stands where no Fortran compiler is here for a
# system. GSL's configure asks here only for functions that C99 has.
#     gsl.sh SOURCES COMPILER OPTIONS...     sources.sh's folder -> gsl/*.o and include/gsl/ where it is called
set -eu
sources=$1
shift
names="roots/brent roots/fsolver roots/convergence min/brent min/fsolver sys/fdiv sys/infnan linalg/svd blas/blas cblas/ddot
    cblas/dnrm2 cblas/dscal cblas/dgemv matrix/matrix matrix/view matrix/rowcol matrix/init vector/vector vector/view vector/oper
    vector/init"
made="$* $names"
[ "$(cat gsl/made 2>/dev/null)" != "$made" ] || exit 0
mkdir -p gsl include/gsl
cp "$sources"/gsl/gsl_*.h "$sources"/gsl/*/gsl_*.h include/gsl
sed 's/^#undef \(HAVE_DECL_[A-Z0-9]*\)$/#define \1 1/' "$sources/gsl/config.h.in" >include/config.h
for name in $names; do
    "$@" -DHAVE_INLINE -ffunction-sections -Iinclude -I"$sources/gsl" -c "$sources/gsl/$name.c" -o "gsl/$(echo "$name" | tr / -).o"
done
echo "$made" >gsl/made # last: it stands for all of them

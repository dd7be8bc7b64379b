#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles musl's functions of double and float, with any compiler's own headers. With them, no version of a system changes a result.
#     libm.sh SOURCES FOLDER [PREFIX]        sources.sh's folder -> FOLDER/libm.a, by PREFIXgcc
set -eu
math=$(cd "$1/musl/src/math" && pwd)
prefix=${3-}
mkdir -p "$2/libm-objects/headers"
cd "$2"
[ ! -f libm.a ] || exit 0
# Three stand-ins: what musl's own headers would define, other names where glibc's header has taken them, and the two headers that
# Windows lacks.
cat >libm-objects/musl.h <<'EOF'
#include <math.h>
#define hidden
#define weak_alias(old, new)
#define __sin musl_sin
#define __cos musl_cos
#define __tan musl_tan
#define __sinl musl_sinl
#define __cosl musl_cosl
#define __tanl musl_tanl
EOF
: >libm-objects/headers/features.h
: >libm-objects/headers/endian.h
# the square root is an instruction: the processor's folder has it
processor=$("${prefix}gcc" -dumpmachine | cut -d - -f 1)
for file in "$math"/*.c "$math/$processor/sqrt.c"; do
    case $file in *l.c | */fma.c) continue ;; esac # long double; needs more of musl
    "${prefix}gcc" -std=gnu99 -O2 -ffp-contract=off -fno-builtin -w -D_GNU_SOURCE -include libm-objects/musl.h \
        -I"$math/../internal" -idirafter "$math/../../arch/generic" -idirafter libm-objects/headers \
        -c "$file" -o "libm-objects/$(basename "$file" .c).o"
done
"${prefix}ar" rcsD libm.tmp libm-objects/*.o
mv libm.tmp libm.a # last: it stands for all of them

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The shared library for macOS, with dgelsd.c in place of LAPACK. It needs the system's C library with its mathematics, no more.
# zig compiles it, as zig has macOS's headers. LLVM's linker links it: zig's own leaves segments that do not end with a page.
#     macos.sh ZIG SOURCES SOURCE FOLDER MACHINE MINIMUM
# of zig's folder, sources.sh's folder and rwedge's sources, for arm64 or x86_64 from macOS MINIMUM on -> FOLDER/_rwedge.so
set -eu
zig=$1 sources=$2 source=$3 folder=$4 machine=$5 minimum=$6
case $machine in arm64) target=aarch64-macos.$minimum ;; *) target=$machine-macos.$minimum ;; esac
mkdir -p "$folder/made"
cd "$folder"
cat >compiler <<END
#!/bin/sh
export ZIG_GLOBAL_CACHE_DIR='$PWD/cache' ZIG_LOCAL_CACHE_DIR='$PWD/cache'
exec '$zig/zig' cc -target $target -ffile-prefix-map='$sources'=. "\$@"
END
chmod +x compiler
options='-O2 -DNDEBUG -ffp-contract=off -fvisibility=hidden'
# shellcheck disable=SC2086
sh "$source/packages/gsl.sh" "$sources" "$PWD/compiler" -std=gnu99 $options
# The library's objects, with the options that it is always built with; CMake's own ways with macOS need Apple's tools.
# RW_BASELINE: a run-time library that is not linked here would tell which vectors a processor has. The results are the same.
# From nothing: every object in the folder is linked, so none may be left of a source that is gone.
rm -rf library
cmake -S "$source" -B library -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER="$PWD/compiler" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_FLAGS=-DRW_BASELINE -DRWEDGE_PRIVATE_DEPS=ON -DRWEDGE_GSL_INCLUDE="$PWD/include" -DRWEDGE_GSL_ARCHIVE=none \
    -DRWEDGE_LAPACK_ARCHIVE=none -DRWEDGE_BLAS_ARCHIVE=none -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_BUILD_TESTS=OFF -DRWEDGE_INSTALL=OFF
cmake --build library --parallel 2 --target rwedge_objects
python3 -B "$source/bindings/interface/generate.py" made python
for file in packages/dgelsd bindings/python/src/loops; do
    # shellcheck disable=SC2086
    ./compiler -std=c99 $options -Iinclude -Imade/python -I"$source/include" -c "$source/$file.c" -o "made/${file##*/}.o"
done
# what Apple's system offers to arm64 is listed under names that this linker may not know
sed 's/arm64e\.x1-/arm64-/g' "$zig/lib/libc/darwin/libSystem.tbd" >libSystem.tbd
# shellcheck disable=SC2046
"$(clang -print-prog-name=ld64.lld)" -dylib -arch "$machine" -platform_version macos "$minimum" "$minimum" -dead_strip -S \
    -install_name @rpath/_rwedge.so -o _rwedge.so made/*.o $(find library/lib -name '*.c.obj' | LC_ALL=C sort) gsl/*.o libSystem.tbd

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the library as WebAssembly, and the npm package with it: FOLDER/web/package/. Quiet, unless it fails. Ends with 77 where
# clang, its parts for wasm32-wasi or GSL's sources cannot be had; these sources are kept.
#     build.sh FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
mkdir -p "$1/web"
cd "$1/web"
# Several tests may ask for it at the same time: the others wait.
exec 9>lock
flock 9
export LC_ALL=C # the same order of files everywhere, and so the same bytes
skip() { echo "SKIPPED: $*"; exit 77; }

. "$here/options.sh"

for command in clang wasm-ld python3 cmake dpkg-source; do
    command -v $command >/dev/null || skip "$command is not here"
done
clang $options -mexec-model=reactor -x c /dev/null -o probe.wasm >log 2>&1 ||
    skip "clang has no libc.a or libclang_rt.builtins-wasm32.a for wasm32-wasi: $(tail -n 1 log)"
sh "$top/packages/sources.sh" sources gsl >log 2>&1 || skip "the sources of GSL cannot be fetched: $(grep '^E: ' log | head -n 1)"

if ! {
    # shellcheck disable=SC2086
    sh "$top/packages/gsl.sh" sources clang $options &&
        # the library, with the options that it is always built with
        cmake -S "$top" -B library -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER=clang -DCMAKE_C_COMPILER_TARGET=wasm32-wasi \
            -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE='-O2 -msimd128 -DNDEBUG' -DRWEDGE_PRIVATE_DEPS=ON -DRWEDGE_HARDENING=OFF \
            -DRWEDGE_GSL_INCLUDE="$PWD/include" -DRWEDGE_GSL_ARCHIVE=none -DRWEDGE_LAPACK_ARCHIVE=none -DRWEDGE_BLAS_ARCHIVE=none \
            -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_BUILD_TESTS=OFF -DRWEDGE_INSTALL=OFF &&
        cmake --build library --target rwedge_inside &&
        exports=$(python3 -B "$top/bindings/interface/header.py" --names "$top/include/rwedge.h" | sed 's/^/-Wl,--export=/') &&
        # shellcheck disable=SC2086
        sh "$here/link.sh" . $exports
} >log 2>&1; then
    cat log >&2
    exit 1
fi

rm -rf made
python3 -B "$top/bindings/interface/generate.py" made web
made=$PWD/made/web
cp wasm.mjs "$here/runtime.mjs" "$here/README.md" "$here/NOTICE" "$top/LICENSE" "$made"
version=$(sed -n 's/^#define RWEDGE_VERSION "\(.*\)"$/\1/p' "$top/include/rwedge.h")
sed "s/@VERSION@/$version/" "$here/package.json.in" >"$made/package.json"
# A package that is the same stays as it is: a test may be reading it.
diff -rq "$made" package >log 2>&1 || {
    rm -rf package
    mv "$made" package
}

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the packages of what is committed here, and tests each as it is installed. The last lines say what was tested, what was not.
#     make.sh [--untested] BUILD            -> BUILD/packages/
# What a step needs and this machine lacks is said; the step is left out then. The status is 0 if nothing failed, 77 if a step was left out.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/.." && pwd)
only_made=no
[ "${1-}" != --untested ] || { only_made=yes; shift; }
[ $# = 1 ] || { echo "usage: $0 [--untested] BUILD" >&2; exit 2; }
mkdir -p "$1/packages"
build=$(cd "$1" && pwd)
. "$top/tests/support/install.sh"

wish command:x86_64-w64-mingw32-gcc=gcc-mingw-w64-x86-64 command:x86_64-w64-mingw32-gfortran=gfortran-mingw-w64-x86-64 \
    command:/usr/lib/wine/wine64=wine64 command:dpkg-source=dpkg-dev command:python3=python3 \
    command:musl-gcc=musl-tools command:aarch64-linux-gnu-gcc=gcc-aarch64-linux-gnu \
    command:aarch64-linux-gnu-gfortran=gfortran-aarch64-linux-gnu \
    command:qemu-aarch64=qemu-user
wish command:node=nodejs command:npm=npm command:clang=clang command:wasm-ld=lld command:llvm-nm=llvm command:llvm-readobj=llvm \
    file:/usr/lib/wasm32-wasi/libc.a=wasi-libc \
    file:/usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a=libclang-rt-dev-wasm32

rm -rf "$build/packages"
mkdir "$build/packages"
tested=$(mktemp)
trap 'rm -f "$tested"' EXIT
ended=0
set -- "$tested"
[ $only_made = no ] || shift
for step in source windows matlab npm debian docs wheels recipes; do
    echo "== $step"
    ! command -v python3 >/dev/null || python3 -B "$here/who.py"
    sh "$here/package.sh" $step "$build" "$build/packages" "$@" && status=0 || status=$?
    case $status in
    0) ;;
    77) [ $ended = 1 ] || ended=77 ;;
    *) echo "== FAILED: $step"; ended=1 ;;
    esac
done
if [ $# = 1 ]; then
    echo "== lists of what is linked in"
    sh "$here/sboms.sh" "$build" "$build/packages" "$tested" || [ $? = 77 ] || ended=1
fi
(cd "$build/packages" && find . -type f ! -name SHA256SUMS | sed 's|^\./||' | LC_ALL=C sort | xargs -d '\n' sha256sum >SHA256SUMS)
echo "== build/packages"
cat "$build/packages/SHA256SUMS"
cat "$tested"
[ $ended != 77 ] || sed -n 's/^not made: /SKIPPED: not made: /p; s/^not tested: the /SKIPPED: not tested: the /p' "$tested"
exit $ended

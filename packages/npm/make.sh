#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The npm package. With TESTED it is the one that the tests of the binding have packed and installed.
#     make.sh BUILD PACKAGES [TESTED]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
build=$1 packages=$2 tested=${3-/dev/null}
version=$(sed -n 's/^project(rwedge VERSION \([0-9.]*\).*/\1/p' "$top/CMakeLists.txt")
log=$build/npm.log
for command in node npm python3; do
    command -v $command >/dev/null || { echo "not made: the npm package, for lack of $command" | tee -a "$tested"; exit 77; }
done
made_and_packed()
(
    sh "$top/bindings/web/build.sh" "$build" && cd "$build/web/package" && mkdir -p ../packed &&
        npm pack --silent --pack-destination ../packed
)
if [ $# = 3 ]; then
    set -- sh "$top/bindings/web/test.sh" "$build"
else
    set -- made_and_packed
fi
"$@" >"$log" 2>&1 && status=0 || status=$?
case $status in
0) ;;
77) echo "not made: the npm package: $(tail -n 1 "$log")" | tee -a "$tested"; exit 77 ;;
*) tail -n 20 "$log"; exit 1 ;;
esac
epoch=$(git -C "$top" log -1 --format=%ct 2>/dev/null || stat -c %Y "$top/CHANGELOG.md")
python3 -B "$top/packages/sbom.py" "$version" "$epoch" "$build/web/sources" wasm32 gsl wasi-libc libclang-rt-dev-wasm32 \
    >"$packages/rwedge-$version-npm.spdx.json"
cp "$build/web/packed/rwedge-$version.tgz" "$packages/rwedge-$version-npm.tgz"
echo "tested: rwedge-$version-npm.tgz: installed in an empty folder, the binding's tests in Node $(node --version)" >>"$tested"
echo "not tested: rwedge-$version-npm.tgz: other versions of Node; browsers" >>"$tested"

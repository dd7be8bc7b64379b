#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The npm package, as the tests of the binding have packed and installed it.
#     make.sh BUILD PACKAGES TESTED
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
build=$1 packages=$2 tested=$3
version=$(sed -n 's/^project(rwedge VERSION \([0-9.]*\).*/\1/p' "$top/CMakeLists.txt")
log=$build/npm.log
sh "$top/bindings/web/test.sh" "$build" >"$log" 2>&1 && status=0 || status=$?
case $status in
0) ;;
77) echo "not made: the npm package: $(tail -n 1 "$log")" | tee -a "$tested"; exit 77 ;;
*) tail -n 20 "$log"; exit 1 ;;
esac
cp "$build/web/packed/rwedge-$version.tgz" "$packages/rwedge-$version-npm.tgz"
echo "tested: rwedge-$version-npm.tgz: installed in an empty folder, the binding's tests in Node $(node --version)" >>"$tested"
echo "not tested: rwedge-$version-npm.tgz: other versions of Node; browsers" >>"$tested"

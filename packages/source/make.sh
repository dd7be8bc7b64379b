#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The source archive of what is committed, and the list of what it is built with: the same bytes for the same commit.
#     make.sh BUILD PACKAGES [TESTED]
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 packages=$2 tested=${3-/dev/null}
version=$(sed -n 's/^project(rwedge VERSION \([0-9.]*\).*/\1/p' "$top/CMakeLists.txt")
if ! git -C "$top" rev-parse HEAD >/dev/null 2>&1; then
    echo "not made: the source archive, as these files are no clone" | tee -a "$tested"
    exit 77
fi
archive=$packages/rwedge-$version.tar.gz
python3 -B "$top/packages/sbom.py" "$version" "$(git -C "$top" log -1 --format=%ct)" >"$packages/rwedge-$version.spdx.json"
git -C "$top" archive --format=tar --prefix="rwedge-$version/" HEAD | gzip -9n >"$archive"

# The licences of what it is linked with, from the sources that other packages are made of too.
linked='gsl lapack popt jansson libcsv libxlsxwriter zlib'
# shellcheck disable=SC2086
if sh "$top/packages/sources.sh" "$build/excel/sources" $linked; then
    sh "$top/packages/licences.sh" "$build/excel/sources" "$packages/licences" $linked
else
    echo "not made: the licences of what it is linked with, as their sources cannot be fetched" | tee -a "$tested"
fi

[ $# = 3 ] || exit 0 # untested
# It builds and passes tests without git.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar -xzf "$archive" -C "$work"
cd "$work/rwedge-$version"
cmake -B build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build build --parallel 2 --target rwedge_cli rwedge >/dev/null
ctest --test-dir build -R '^(shipped_tables|cli_(tables|solve|output_files))$' --no-tests=error --output-on-failure
echo "tested: $(basename "$archive"): unpacked, it builds without git; the tests of the tables, solve and output files pass" >>"$tested"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The pages to look things up in, as a folder that needs no network.
#     make.sh BUILD PACKAGES [TESTED]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../package.sh"
name=rwedge-$version-docs

cmake -S "$top" -B "$build" -DRWEDGE_BUILD_CLI=ON >/dev/null
cmake --build "$build" --parallel "$(getconf _NPROCESSORS_ONLN)" --target rwedge_cli >/dev/null
sh "$top/packages/docs/write.sh" "$build" && status=0 || status=$?
[ $status != 77 ] || echo "not made: $name.zip, for lack of gnuplot or of Sphinx" >>"$tested"
[ $status = 0 ] || exit $status

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -R "$build/docs" "$work/$name"
python3 -B "$top/packages/zip.py" "$packages/$name.zip" "$epoch" "$work/$name"
[ $# = 3 ] || exit 0 # untested
python3 -m zipfile -e "$packages/$name.zip" "$work/unpacked"
diff -r "$work/$name" "$work/unpacked/$name"
echo "tested: $name.zip: unpacked, it has all pages; in these every link leads to a place, and nothing is loaded from elsewhere" >>"$tested"

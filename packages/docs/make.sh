# SPDX-License-Identifier: GPL-3.0-or-later
# The pages to look things up in, as a folder that needs no network.
product='the pages'
name=rwedge-$version-docs

cmake -S "$top" -B "$build" -DRWEDGE_BUILD_CLI=ON >/dev/null
cmake --build "$build" --parallel "$(getconf _NPROCESSORS_ONLN)" --target rwedge_cli >/dev/null
sh "$top/packages/docs/write.sh" "$build" && status=0 || status=$?
[ $status != 77 ] || leave_out "gnuplot or Sphinx is not here"
[ $status = 0 ] || exit $status

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -R "$build/docs" "$work/$name"
python3 -B "$top/packages/zip.py" "$packages/$name.zip" "$epoch" "$work/$name"
has_tests || exit 0
python3 -m zipfile -e "$packages/$name.zip" "$work/unpacked"
diff -r "$work/$name" "$work/unpacked/$name"
echo "tested: $name.zip: unpacked, it has all pages; in these every link leads to a place, and nothing is loaded from elsewhere" >>"$tested"

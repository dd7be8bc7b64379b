# SPDX-License-Identifier: GPL-3.0-or-later
# The source archive of what is committed, and the list of what it is built with: the same bytes for the same commit.
product='the source archive'
git -C "$top" rev-parse HEAD >/dev/null 2>&1 || leave_out "these files are no clone"
archive=$packages/rwedge-$version.tar.gz
python3 -B "$top/packages/sbom.py" "$version" "$epoch" >"$packages/rwedge-$version.spdx.json"
# With what is made of the header: who builds it needs no Python. (git gives these files the time of the commit.)
made=$build/source-made
rm -rf "$made"
python3 -B "$top/bindings/interface/generate.py" "$made" c excel fortran matlab
set --
for file in "$made"/*/*; do
    set -- "$@" --prefix="rwedge-$version/bindings/made/$(basename "$(dirname "$file")")/" --add-file="$file"
done
git -C "$top" archive --format=tar "$@" --prefix="rwedge-$version/" HEAD | gzip -9n >"$archive"

# The licences of what it is linked with, from the sources that other packages are made of too.
linked='gsl lapack popt jansson libcsv libxlsxwriter zlib'
# shellcheck disable=SC2086
if sh "$top/packages/sources.sh" "$build/excel/sources" $linked; then
    sh "$top/packages/licences.sh" "$build/excel/sources" "$packages/licences" $linked
else
    echo "not made: the licences of what it is linked with, as their sources cannot be fetched" | tee -a "$tested"
fi

has_tests || exit 0
# It builds and passes tests without git, and without Python.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar -xzf "$archive" -C "$work"
cd "$work/rwedge-$version"
cmake -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_DISABLE_FIND_PACKAGE_Python3=ON >/dev/null
cmake --build build --parallel 2 --target rwedge_cli rwedge rwedge_told test_threads >/dev/null
cmake --install build --prefix installed >/dev/null
for file in include/rwedge.f90 share/rwedge/matlab/entries.h share/rwedge/matlab/functions/rwedge_contact.m share/man/man1/rwedge.1; do
    [ -s "installed/$file" ] || { echo "FAILED: the source archive without Python: $file is not installed"; exit 1; }
done
ctest --test-dir build -R '^(threads|shipped_tables|cli_(tables|solve|output_files))$' --no-tests=error --output-on-failure
echo "tested: $(basename "$archive"): unpacked, it builds without git and Python, Fortran and MATLAB included; the tests of threads, the tables, solve and output files pass" >>"$tested"

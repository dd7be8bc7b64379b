# SPDX-License-Identifier: GPL-3.0-or-later
# The zip for Windows: tool, DLL, module for Excel, workbook and tables, with the licences and a list of what is linked in.
product='the zip for Windows'
name=rwedge-$version-windows-x64
work=$build/excel # as the test of the module has it: one DLL
need x86_64-w64-mingw32-gcc x86_64-w64-mingw32-gfortran dpkg-source python3

sh "$here/build.sh" --tool "$work"
made=$work/windows
folder=$work/$name
rm -rf "$folder"
mkdir -p "$folder/c" "$folder/licences" "$folder/tables/decimal-comma"
cp "$made/bin/rwedge.exe" "$made/bin/rwedge.dll" "$work/build/made/excel/rwedge.bas" "$top/tables/rounded-wedge.xlsx" \
    "$top/tables/rounded-wedge.html" "$folder"
sed "s/@VERSION@/$version/" "$here/start-here.html" >"$folder/start-here.html"
cp "$top/include/rwedge.h" "$made/lib/librwedge.dll.a" "$folder/c"
cp "$top"/tables/*.csv "$top/tables/rounded-wedge-tables.xlsx" "$folder/tables"
cmake -S "$top" -B "$build" -DRWEDGE_BUILD_CLI=ON >/dev/null
cmake --build "$build" --parallel "$(getconf _NPROCESSORS_ONLN)" --target rwedge_cli >/dev/null
sh "$top/tables/generate.sh" "$folder/tables/decimal-comma" "$build/cli/rwedge" decimal-comma >/dev/null

# The licences of all that is inside, and what it is.
inside='gsl lapack musl popt jansson libcsv libxlsxwriter zlib'
# shellcheck disable=SC2086
sh "$here/../licences.sh" "$work/sources" "$folder/licences" $inside
cp /usr/share/doc/mingw-w64-common/copyright "$folder/licences/mingw-w64.txt"
cp /usr/share/doc/gcc-mingw-w64-base/copyright "$folder/licences/gcc.txt"
# shellcheck disable=SC2086
python3 -B "$here/../sbom.py" "$version" "$epoch" "$work/sources" windows-x64 $inside mingw-w64-x86-64-dev gcc-mingw-w64-x86-64 \
    >"$folder/sbom.spdx.json"
python3 -B "$here/../zip.py" "$packages/$name.zip" "$epoch" "$folder"

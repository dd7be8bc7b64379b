# SPDX-License-Identifier: GPL-3.0-or-later
# The folder for MATLAB and Octave: functions, the source of the MEX file, and the library with its GSL and LAPACK inside, for the
# Linux of this machine and, after windows/make.sh, for Windows.
product='the folder for MATLAB'
name=rwedge-$version-matlab
sources=$build/excel/sources # as those of the zip for Windows
work=$build/for-matlab
folder=$work/$name
rm -rf "$work"
mkdir -p "$folder"

sh "$top/bindings/private.sh" "$build"
cp -r "$build/private/prefix/share/rwedge/matlab/." "$folder"
sed "s/@VERSION@/$version/" "$here/start-here.txt" >"$folder/start-here.txt"

# library SYSTEM LIBRARY... - all its members as one, with the header beside
library()
{
    mkdir -p "$folder/prebuilt/$1/include" "$folder/prebuilt/$1/lib" "$work/members"
    cp "$top/include/rwedge.h" "$folder/prebuilt/$1/include"
    made=$folder/prebuilt/$1/lib/librwedge.a
    shift
    for part; do
        (cd "$work/members" && ar x "$part")
    done
    (cd "$work/members" && LC_ALL=C && ar rcsD "$made" ./*)
    rm -r "$work/members"
}
library "linux-$(uname -m)" "$build/private/prefix/lib/librwedge.a"
inside='gsl lapack'
windows=$build/excel
if [ -f "$windows/windows/lib/librwedge.a" ] && [ -f "$windows/dependencies/libm.a" ]; then
    library windows-x86_64 "$windows/windows/lib/librwedge.a" "$windows/dependencies/libm.a"
    inside="$inside musl"
fi
# shellcheck disable=SC2086
{
    sh "$top/packages/sources.sh" "$sources" $inside >"$work/log" 2>&1 &&
        sh "$top/packages/licences.sh" "$sources" "$folder/licences" $inside
} || leave_out "no licence texts: $(tail -n 1 "$work/log")"
# shellcheck disable=SC2086
python3 -B "$top/packages/sbom.py" "$version" "$epoch" "$sources" matlab $inside >"$folder/sbom.spdx.json"
python3 -B "$top/packages/zip.py" "$packages/$name.zip" "$epoch" "$folder"

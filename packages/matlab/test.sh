# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the zip for MATLAB as it is unpacked, in Octave: in a folder with a space.
work=$build/in-matlab
for command in octave-cli mkoctfile; do
    command -v $command >/dev/null || { echo "not tested: $name.zip, for lack of $command" | tee -a "$tested"; exit 77; }
done
rm -rf "$work"
mkdir -p "$work/a place"
cd "$work/a place"
cmake -E tar xf "$packages/$name.zip"
octave() { octave-cli --no-init-file --no-history "$@"; }

# Built with nothing of this machine but Octave; then the example and the binding's tests.
octave --path "$name" --eval build_rwedge >"$work/log" 2>&1 || { cat "$work/log"; fail "build_rwedge"; }
octave --path rwedge "$name/rwedge_example.m" >example.txt || fail "the example"
grep -q '^ -28.8 *4.0370e-04' example.txt || fail "the example's slip is not that of tests/data/example_fretting.txt"
own="$name/prebuilt/linux-$(uname -m)"
octave --path rwedge "$top/bindings/matlab/test_rwedge.m" >"$work/log" 2>&1 ||
    { cat "$work/log"; fail "bindings/matlab/test_rwedge.m"; }

# On a machine that it has no library for, it says so.
mv "$own" "$name/prebuilt/macos-x86_64"
octave --path "$name" --eval "try, build_rwedge, catch err, disp(err.message), end" >said.txt 2>&1
this=linux-$(uname -m)
grep -q "this folder has a library for macos-x86_64.* and none for this machine, $this: build rwedge from its sources" said.txt ||
    fail "no library for this machine: $(cat said.txt)"
echo "tested: $name.zip: unpacked in a folder with a space, build_rwedge, the example and the binding's tests, in Octave;" \
    "on a machine without a library it says so" >>"$tested"

# For Windows: the MEX file links with MATLAB's functions and those of the C library, and none of Windows' own mathematics.
windows=$name/prebuilt/windows-x86_64
if [ ! -d "$windows" ]; then
    echo "not tested: $name.zip: no library for Windows is in it; MATLAB itself" >>"$tested"
    exit 0
fi
{
    echo LIBRARY libmex.dll
    echo EXPORTS
    grep -o '\bm[ex]x*[A-Z][A-Za-z]*' "$name/rwedge_mex.c" | sort -u
} >mex.def
x86_64-w64-mingw32-dlltool -d mex.def -l libmex.a
x86_64-w64-mingw32-gcc -shared -idirafter "$(mkoctfile -p OCTINCLUDEDIR)" -I"$windows/include" -I"$name" \
    "$name/rwedge_mex.c" "$windows/lib/librwedge.a" libmex.a -o rwedge_mex.mexw64
x86_64-w64-mingw32-objdump -p rwedge_mex.mexw64 | sed -n '/DLL Name: msvcrt/,/^$/s/^.*[0-9]  *_*\([a-z0-9]*\)$/\1/p' | sort >imported
x86_64-w64-mingw32-nm "$windows/lib/librwedge.a" | sed -n 's/.* T //p' | sort >inside
[ -s imported ] && [ -s inside ] || fail "the names of functions cannot be read"
[ -z "$(comm -12 imported inside)" ] || fail "mathematics of Windows: $(comm -12 imported inside)"
echo "not tested: $name.zip: MATLAB itself; for Windows, the MEX file is compiled and linked, and not run" >>"$tested"

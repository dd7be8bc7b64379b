# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the wheels and the source distribution as they are installed.
folder=$packages/python
work=$build/wheels/test
source=$top/bindings/python
tests="$source/tests/test_formulas.py $source/tests/test_contact.py $source/tests/test_stress_history.py $source/tests/test_series.py"
command -v llvm-readobj >/dev/null || { echo "not tested: $product, for lack of llvm-readobj" | tee -a "$tested"; exit 77; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
export PYTHONPYCACHEPREFIX="$work/pycache" MPLCONFIGDIR="$work/matplotlib" PIP_DISABLE_PIP_VERSION_CHECK=1

# What each holds: its records fit, the library is one for that system, and nothing names a folder of this machine.
for wheel in "$folder"/*.whl; do
    rm -rf parts
    "$build/wheels/venv/bin/wheel" unpack --dest parts "$wheel" >log 2>&1 || { cat log; fail "$wheel: its records"; }
    format=$(llvm-readobj --file-headers parts/*/rwedge/_rwedge.* | sed -n 's/^Format: //p')
    case "${wheel##*-} $format" in
    *linux*_x86_64.whl\ elf64-x86-64 | *linux*_aarch64.whl\ elf64-littleaarch64 | win_amd64.whl\ COFF-x86-64) texts=lapack.txt ;;
    macosx*_arm64.whl\ "Mach-O arm64" | macosx*_x86_64.whl\ "Mach-O 64-bit x86-64") texts='' ;;
    *) fail "$wheel has a library for $format" ;;
    esac
    for text in licenses/LICENSE licenses/NOTICE licenses/gsl.txt sboms/rwedge.spdx.json ${texts:+licenses/$texts}; do
        [ -s parts/*/*.dist-info/"$text" ] || fail "$wheel has no $text"
    done
    ! grep -rlF "$build" parts || fail "$wheel names $build"
done
for wheel in "$folder"/*manylinux*.whl; do
    "$build/wheels/venv/bin/auditwheel" show "$wheel" >shown 2>&1 || { cat shown; fail "auditwheel"; }
    grep -qE '"manylinux_2_([0-9]|1[0-7])_' shown || { cat shown; fail "auditwheel finds no manylinux_2_17"; }
done

# On this machine: with nothing else on the path, then the tests of calculations, with the Python that is here and with others.
linux=$(echo "$folder"/*manylinux*_"$(uname -m)".whl)
sh "$top/tests/answers/answers.sh" "$build"
# python_of VERSION - where such a Python is, if it is
python_of()
{
    for python in "python$1" "$HOME/.pyenv/versions/$1".*/bin/python3; do
        "$python" -c 'import ensurepip' 2>/dev/null && echo "$python" && return
    done
}
# suite PYTHON
suite()
{
    rm -rf environment
    "$1" -m venv environment
    environment/bin/pip install --quiet --no-compile --require-hashes -r "$source/tests/packages/everyday.txt"
    env -i HOME="$work" PATH="$work/environment/bin" environment/bin/pip install --quiet --no-index "$linux"
    env -i HOME="$work" PATH="$work/environment/bin" environment/bin/python -c \
        'import rwedge; assert abs(rwedge.elastic_limit(0.25, 0.1, 0.3) / 3.4068757722085774 - 1) < 1e-13'
    # files are read by the tool inside, with no tool on the path
    printf 'P [kN],Q [N]\n1.2,100\n' >rig.csv
    env -i HOME="$work" PATH="$work/environment/bin" environment/bin/python -c \
        'import rwedge; case = rwedge.read_case("rig.csv", units="mm,N,MPa", width=8); assert case.loads["P"] == 150, case' ||
        fail "read_case() of $linux"
    # shellcheck disable=SC2086
    PATH="$work/environment/bin:$PATH" RWEDGE_ANSWERS="$build/private/answers" environment/bin/python -m pytest \
        -c "$source/pyproject.toml" --rootdir "$source" -p no:cacheprovider --quiet --no-header -m 'not long' $tests >log 2>&1 ||
        { tail -n 40 log; fail "the suite of $(environment/bin/python --version)"; }
    said="$(environment/bin/python --version) with NumPy $(environment/bin/python -c 'import numpy; print(numpy.__version__)')"
    echo "tested: $(basename "$linux"): $said, no compiler or GSL on the path; then, with them, $(tail -n 1 log | tr -d =)" >>"$tested"
}
for version in 3.9 3.13; do
    python=$(python_of $version)
    if [ -z "$python" ]; then
        echo "not tested: the wheel for Linux with Python $version, which is not here" | tee -a "$tested"
        continue
    fi
    suite "$python"
done
suite python3
echo "tested: rwedge-*.tar.gz for Python: the package of all wheels was built of it here" >>"$tested"

# A wheel for another machine is refused, and says so.
for wheel in "$folder"/*.whl; do
    [ "$wheel" != "$linux" ] || continue
    ! environment/bin/pip install --no-index --no-deps "$wheel" >log 2>&1 || fail "$wheel is taken here"
    grep -q 'is not a supported wheel on this platform' log || { cat log; fail "$wheel is refused for something else"; }
done

# The libraries for other kinds of Linux answer as that of this machine does, but for the last bits that their mathematics differ in.
answers=$build/private/answers
environment/bin/python -W ignore "$source/tests/answer.py" <"$answers/calls.python" >answers
# alike WHEEL - as answered in answers-there
alike()
{
    compared=$(python3 -B "$top/tests/answers/compare.py" answers answers-there 1e-12) || { echo "$compared"; fail "$1"; }
    echo "tested: $1: $compared" >>"$tested"
}
unpacked() { rm -rf there; mkdir there; (cd there && python3 -m zipfile -e "$1" .); }
arm=$(echo "$folder"/*-manylinux*_aarch64.whl)
if [ ! -f "$arm" ]; then
    : # make.sh has said it
elif ! command -v qemu-aarch64 >/dev/null; then
    echo "not tested: the wheel for Linux on ARM, for lack of qemu-user" | tee -a "$tested"
elif ! sh "$here/arm.sh" "$build/wheels/arm" >log 2>&1; then
    echo "not tested: the wheel for Linux on ARM: its Python cannot be fetched: $(tail -n 1 log)" | tee -a "$tested"
else
    unpacked "$arm"
    PYTHONPATH=$work/there "$build/wheels/arm/python" -W ignore "$source/tests/answer.py" <"$answers/calls.python" >answers-there
    alike "$(basename "$arm"), with a Python for ARM under qemu"
fi
# with_musl MACHINE COMPILER [EMULATOR...] - from C, as no Python with musl is here
with_musl()
{
    musl=$(echo "$folder"/*-musllinux*_"$1".whl) compiler=$2
    shift 2
    [ -f "$musl" ] || return 0 # make.sh has said it
    unpacked "$musl"
    [ "$(readelf -d there/rwedge/_rwedge.so | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')" = libc.so ] || fail "$musl needs more than musl"
    "$compiler" -std=c99 -I"$top/include" "$answers/answer.c" there/rwedge/_rwedge.so \
        -Wl,-rpath,"$work/there/rwedge" -o there/answer
    "$@" there/answer >answers-there
    [ ! -f answers-musl ] || cmp answers-there answers-musl || fail "two machines differ, both with musl's mathematics"
    cp answers-there answers-musl
    alike "$(basename "$musl"), its library from C with musl, not in a Python"
}
with_musl x86_64 musl-gcc
if command -v qemu-aarch64 >/dev/null; then
    with_musl aarch64 "$build/wheels/arm/musl-gcc" qemu-aarch64 -L "$build/wheels/arm/root"
elif [ -f "$(echo "$folder"/*-musllinux*_aarch64.whl)" ]; then
    echo "not tested: the wheel for musl on ARM, for lack of qemu-user" | tee -a "$tested"
fi

nm -D --defined-only "$(environment/bin/python -W ignore -c 'from rwedge._library import library; print(library._name)')" |
    sed 's/.* //' | LC_ALL=C sort >wanted

# The libraries for macOS: what can be read of them. The rest of their promises is said to be untested.
for mac in "$folder"/*-macosx*.whl; do
    [ -f "$mac" ] || continue # make.sh has said it
    unpacked "$mac"
    from=$(basename "$mac" | sed 's/.*-macosx_\([0-9]*\)_\([0-9]*\)_.*/\1.\2/')
    llvm-objdump --macho --private-headers there/rwedge/_rwedge.so | grep -qE "^ *(minos|version) $from\$" || fail "$mac needs another macOS"
    [ "$(llvm-objdump --macho --dylibs-used there/rwedge/_rwedge.so | sed -n 's/^\t\([^ ]*\) .*/\1/p' | tr '\n' ' ')" = \
        "@rpath/_rwedge.so /usr/lib/libSystem.B.dylib " ] || fail "$mac needs other libraries"
    llvm-nm --defined-only --extern-only --format=just-symbols there/rwedge/_rwedge.so | sed 's/^_//' | LC_ALL=C sort | cmp - wanted ||
        fail "the library for macOS offers other functions than that for Linux"
    echo "not tested: $(basename "$mac"): nothing here runs it. It offers the functions of that for Linux, and needs macOS alone" |
        tee -a "$tested"
done

# The library for Windows, under Wine. It holds musl's mathematics.
windows=$(echo "$folder"/*-win_amd64.whl)
. "$top/packages/windows/wine.sh"
if [ ! -f "$windows" ]; then
    : # make.sh has said it
elif [ -z "$wine" ] || [ -z "$server" ]; then
    echo "not tested: the wheel for Windows, for lack of wine64" | tee -a "$tested"
else
    unpacked "$windows"
    x86_64-w64-mingw32-objdump -p there/rwedge/_rwedge.dll >tables
    [ "$(sed -n 's/.*DLL Name: //p' tables | sort | tr '\n' ' ')" = "KERNEL32.dll msvcrt.dll " ] || fail "$windows needs other DLLs"
    grep -o 'rwedge_[a-z_]*' tables | sort -u >offered
    LC_ALL=C sort offered | cmp - wanted || fail "the library for Windows offers other functions than that for Linux"
    x86_64-w64-mingw32-gcc -std=c99 -I"$top/include" "$answers/answer.c" there/rwedge/_rwedge.dll -o there/rwedge/answer.exe
    trap end_wine EXIT
    start_wine
    on_windows there/rwedge/answer.exe | tr -d '\r' >answers-there
    [ ! -f answers-musl ] || cmp answers-there answers-musl || fail "Windows and Linux differ, both with musl's mathematics"
    alike "$(basename "$windows"), its library from C under Wine, not in a Python"
fi

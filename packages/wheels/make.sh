# SPDX-License-Identifier: GPL-3.0-or-later
# Python's source distribution, and of it the wheels: for each system another shared library in the same package.
product='the wheels for Python'
work=$build/wheels
sources=$build/excel/sources # as those of the zip for Windows
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; echo "FAILED: $*" >&2; exit 1; }; }

git -C "$top" rev-parse HEAD >/dev/null 2>&1 || leave_out "these files are no clone"
[ "$(uname -sm)" = "Linux x86_64" ] || leave_out "they need Linux on x86-64"
need dpkg-source python3 cmake gcc
mkdir -p "$work" "$packages/python"
sh "$top/packages/sources.sh" "$sources" gsl lapack musl popt jansson libcsv >"$work/log" 2>&1 || leave_out "sources cannot be fetched: $(tail -n 1 "$work/log")"
. "$top/tests/support/venv.sh"
reason=$(venv "$here/requirements.txt" "$work/venv") || leave_out "their tools cannot be fetched: ${reason#SKIPPED: }"
export SOURCE_DATE_EPOCH="$epoch"

# old_glibc PREFIX VERSION - writes the command PREFIXobjcopy, for one object of the library, which binds it to the oldest versions
# of what glibc has several of. They give the same bits, and differ in what they tell errno.
old_glibc()
{
    {
        echo '#!/bin/sh'
        printf 'exec %sobjcopy' "$1"
        printf " --redefine-sym %s=%s@GLIBC_$2" exp exp log log logf logf pow pow hypot hypot
        echo ' "$@"'
    } >"$work/$1objcopy"
    chmod +x "$work/$1objcopy"
}

# The source distribution of what is committed; and the package that all wheels have, built of it for this machine.
old_glibc '' 2.2.5
rm -rf "$work/source" "$work/base"
mkdir -p "$work/source" "$work/base"
git -C "$top" archive HEAD | tar -x -C "$work/source"
(cd "$work/source/bindings/python" &&
    quietly "$work/venv/bin/python" -c "from scikit_build_core.build import build_sdist; build_sdist('$packages/python')")
CMAKE_ARGS="-DCMAKE_OBJCOPY=$work/objcopy -DCMAKE_MODULE_LINKER_FLAGS=-s" quietly pip_in "$work/venv" wheel \
    --no-build-isolation --no-deps --no-index --wheel-dir "$work/base" "$packages/python/rwedge-$version.tar.gz"
(cd "$work/base" && python3 -m zipfile -e ./*.whl .)

# wheel PLATFORM LIBRARY NAME... - the base with another library and another tag, and what is linked in: NAMEs are Debian's packages,
# also of compilers whose run-time libraries are. With the tool of $tool, which reads files for read_case(), where there is one
tool=
wheel()
{
    platform=$1 library=$2 parts=$work/parts/rwedge-$version
    about=$parts/rwedge-$version.dist-info
    shift 2
    rm -rf "$work/parts"
    quietly "$work/venv/bin/wheel" unpack --dest "$work/parts" "$work"/base/*.whl
    rm "$parts"/rwedge/_rwedge.*
    cp "$library" $tool "$parts/rwedge"
    sed -i '/^Tag: /d; /^$/d' "$about/WHEEL"
    # shellcheck disable=SC2046
    printf 'Tag: py3-none-%s\n' $(echo "$platform" | tr . ' ') >>"$about/WHEEL"
    mkdir -p "$about/sboms" "$about/licenses"
    python3 -B "$top/packages/sbom.py" "$version" "$epoch" "$sources" "$platform" "$@" >"$about/sboms/rwedge.spdx.json"
    for name; do
        case $name in
        mingw-w64-x86-64-dev) cp /usr/share/doc/mingw-w64-common/copyright "$about/licenses/mingw-w64.txt" ;;
        gcc-mingw-w64-x86-64) cp /usr/share/doc/gcc-mingw-w64-base/copyright "$about/licenses/gcc.txt" ;;
        *) sh "$top/packages/licences.sh" "$sources" "$about/licenses" "$name" ;;
        esac
    done
    chmod -R u=rwX,go=rX "$parts" # whatever the umask is: the same bytes
    quietly "$work/venv/bin/wheel" pack --dest-dir "$packages/python" "$parts"
}
# library FOLDER CMAKE-ARGUMENTS... - the shared library alone, into $work/FOLDER
library()
{
    folder=$work/$1
    shift
    quietly cmake -S "$work/source/bindings/python" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_MODULE_LINKER_FLAGS=-s "$@"
    quietly cmake --build "$folder" --parallel 2 --target _rwedge
}
# dependencies FOLDER PREFIX - what it takes, by a compiler for another machine; sets $with to tell CMake
dependencies()
{
    quietly sh "$top/packages/dependencies.sh" "$sources" "$1" "$2"
    with="-DRWEDGE_GSL_INCLUDE=$1/include -DRWEDGE_GSL_ARCHIVE=$1/libgsl.a -DRWEDGE_LAPACK_ARCHIVE=$1/liblapack.a
        -DRWEDGE_BLAS_ARCHIVE=$1/liblapack.a"
}
# lacks "WHAT" COMMAND... - says so
lacks()
{
    what=$1
    shift
    for command; do
        command -v "$command" >/dev/null || { echo "not made: the wheel for $what, for lack of $command" | tee -a "$tested"; return 0; }
    done
    return 1
}

# GSL's headers without those of glibc, and the archives of this machine: they call nothing but C99
mkdir -p "$work/musl-include"
ln -sfn "$(pkg-config --variable=includedir gsl)/gsl" "$work/musl-include/gsl"
inside='gsl lapack'
if ! command -v musl-gcc >/dev/null; then
    echo "not made: the tool in the wheels for Linux, for lack of musl-gcc" | tee -a "$tested"
else
    quietly sh "$here/tool.sh" "$sources" "$work/source" "$work/tool" musl-gcc -DRWEDGE_GSL_INCLUDE="$work/musl-include" \
        -DCMAKE_LIBRARY_ARCHITECTURE="$(gcc -print-multiarch)"
    tool=$work/tool/rwedge
    inside="$inside musl popt jansson libcsv"
fi
# shellcheck disable=SC2086
wheel manylinux_2_17_x86_64.manylinux2014_x86_64 "$work/base/rwedge/_rwedge.so" $inside
if ! lacks musl musl-gcc; then
    library musl -DCMAKE_C_COMPILER=musl-gcc -DRWEDGE_HARDENING=OFF -DRWEDGE_GSL_INCLUDE="$work/musl-include" \
        -DCMAKE_LIBRARY_ARCHITECTURE="$(gcc -print-multiarch)"
    # shellcheck disable=SC2086
    wheel musllinux_1_2_x86_64 "$work/musl/_rwedge.so" $inside
fi
tool=
machine=aarch64-linux-gnu
if ! lacks "Linux on ARM" $machine-gcc $machine-gfortran; then
    old_glibc $machine- 2.17
    dependencies "$work/dependencies" $machine-
    # shellcheck disable=SC2086
    library aarch64 -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_C_COMPILER=$machine-gcc \
        -DCMAKE_LINKER=/usr/bin/$machine-ld -DCMAKE_OBJCOPY="$work/$machine-objcopy" $with
    wheel manylinux_2_17_aarch64.manylinux2014_aarch64 "$work/aarch64/_rwedge.so" gsl lapack
    if sh "$here/arm.sh" "$work/arm" >"$work/log" 2>&1; then
        # shellcheck disable=SC2086
        library musl-aarch64 -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_C_COMPILER="$work/arm/musl-gcc" \
            -DCMAKE_LINKER=/usr/bin/$machine-ld -DCMAKE_OBJCOPY=/usr/bin/$machine-objcopy -DRWEDGE_HARDENING=OFF $with
        wheel musllinux_1_2_aarch64 "$work/musl-aarch64/_rwedge.so" gsl lapack
    else
        echo "not made: the wheel for musl on ARM, as what it needs for ARM cannot be fetched: $(tail -n 1 "$work/log")" | tee -a "$tested"
    fi
fi
machine=x86_64-w64-mingw32
if ! lacks Windows $machine-gcc $machine-gfortran; then
    dependencies "$build/excel/dependencies" $machine- # as those of the DLL for Excel
    quietly sh "$top/packages/libm.sh" "$sources" "$build/excel/dependencies" $machine-
    # shellcheck disable=SC2086
    library windows -DCMAKE_TOOLCHAIN_FILE="$top/packages/windows/mingw.cmake" -DRWEDGE_LIBM_FOLDER="$build/excel/dependencies" $with \
        -DCMAKE_MODULE_LINKER_FLAGS="-static-libgcc -s -Wl,--no-insert-timestamp -L$build/excel/dependencies"
    quietly sh "$top/packages/windows/build.sh" --tool "$build/excel" # as that of the zip for Windows
    tool=$build/excel/windows/bin/rwedge.exe
    wheel win_amd64 "$work/windows/_rwedge.dll" gsl lapack musl popt jansson libcsv libxlsxwriter zlib mingw-w64-x86-64-dev \
        gcc-mingw-w64-x86-64
    tool=
fi
if ! lacks macOS clang "$(clang -print-prog-name=ld64.lld 2>/dev/null)"; then
    for system in 11.0-arm64 10.13-x86_64; do
        quietly sh "$here/macos.sh" "$(echo "$work"/venv/lib/python3*/site-packages/ziglang)" "$sources" "$work/source" \
            "$work/macos-$system" "${system#*-}" "${system%-*}"
        wheel "macosx_$(echo "$system" | tr .- __)" "$work/macos-$system/_rwedge.so" gsl
    done
fi

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds everything into build/ and runs the tests. What is missing on the machine is installed first, if that is possible.
#
#     ./tests/run.sh              the everyday run
#     ./tests/run.sh --compilers  also, with each gcc and clang that is here: no warning, the tests, the tables
#     ./tests/run.sh --sanitize   also: all tests under the address and undefined-behaviour sanitizers
#     ./tests/run.sh --campaign   also: the long runs of accuracy, certificate, threads, random input, coverage, bindings
#     ./tests/run.sh --packages   also: the packages made, and each tested as it is installed
#     ./tests/run.sh --elsewhere  also: both commands on the stable release of Debian, if this machine is another system; and
#                                 the packages made again in another folder, to the same bytes
#     ./tests/run.sh --all        all but --elsewhere: above 45 minutes on two processors
#     ./tests/run.sh --strict     a skip counts as a failure if this machine could have had what is missing; the CI runs with it
#
# Seeds, samples and numbers of runs are fixed: what was green stays green on the same tree. tests/README.md says how to look further.
# The last line says how many tests passed, failed and were skipped. The line before it says how long the run took. Each skipped test
# says why in its own output.
set -eu
began=$(date +%s)
top=$(cd "$(dirname "$0")/.." && pwd)
cd "$top"
. tests/support/install.sh
accept_path "$top"
. tests/support/compilers.sh

sanitize=no strict=no long=
for option; do
    case $option in
    --sanitize) sanitize=yes ;;
    --compilers | --campaign | --packages | --elsewhere) long="${long:+$long|}${option#--}" ;;
    --strict) strict=yes ;;
    --all) sanitize=yes long="compilers|campaign|packages${long:+|$long}" ;;
    -h | --help) sed -n '3,/^set/s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) echo "$0: $option: unknown option; see $0 --help" >&2; exit 2 ;;
    esac
done

require_build_tools
require library:cmocka=libcmocka-dev command:c++=g++
wish command:script=bsdutils command:gnuplot=gnuplot-nox command:xmllint=libxml2-utils \
    command:zsh=zsh command:fish=fish command:mandoc=mandoc header:xlsxwriter.h=libxlsxwriter-dev module:xlsxwriter=python3-xlsxwriter \
    file:/usr/share/i18n/locales/de_DE=locales command:python3=python3 python:ensurepip=python3-venv \
    command:soffice=libreoffice-calc-nogui,python3-uno
# the languages that the library is called from
wish command:gfortran=gfortran command:octave-cli=octave command:mkoctfile=octave-dev \
    command:x86_64-w64-mingw32-gcc=gcc-mingw-w64-x86-64 command:x86_64-w64-mingw32-gfortran=gfortran-mingw-w64-x86-64 \
    command:/usr/lib/wine/wine64=wine64 command:dpkg-source=dpkg-dev
# JavaScript, WebAssembly, the page; clang is below. Browsers and gcovr are for the long run alone
wish command:node=nodejs command:npm=npm command:wasm-ld=lld file:/usr/lib/wasm32-wasi/libc.a=wasi-libc \
    file:/usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a=libclang-rt-dev-wasm32
case $long in *compilers*) wish command:gcc=gcc ;; esac
case $long in *campaign*) wish command:chromium=chromium command:firefox-esr=firefox-esr command:gcovr=gcovr ;; esac
# finite elements, for a worked case in Python
wish command:ccx=calculix-ccx
wish command:clang=clang command:clang-format-14=clang-format-14
# ball arithmetic: in FLINT 3, beside FLINT 2
have header:arb.h || wish file:/usr/include/flint/flint.h=libflint-dev
have header:flint/arb.h || wish header:arb.h=libflint-arb-dev
# what is compiled twice in a run is compiled once: the library for the bindings, for hosts that embed it
wish command:ccache=ccache
if have command:ccache; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_DIR="${CCACHE_DIR:-$top/build/ccache}"
fi

passed=0 failed=0 skipped=0
skips=$(mktemp) output=$(mktemp)
trap 'rm -f "$skips" "$output" "$output.leaks"' EXIT

# count JUNIT-FILE - adds a run's results to the totals.
count()
{
    number() { sed -n "s/.*[^a-z]$1=\"\([0-9]*\)\".*/\1/p" "$2" | head -n 1; }
    all=$(number tests "$1") bad=$(number failures "$1") left=$(($(number skipped "$1") + $(number disabled "$1")))
    failed=$((failed + bad))
    skipped=$((skipped + left))
    passed=$((passed + all - bad - left))
}

# build FOLDER CMAKE-ARGUMENTS...
build()
{
    folder=$1
    shift
    cmake -S . -B "$folder" -DRWEDGE_BUILD_CLI=ON -DRWEDGE_BUILD_TESTS=ON "$@" >/dev/null
    cmake --build "$folder" --parallel "$(processors)"
}

# run_tests FOLDER CTEST-ARGUMENTS... - the tests of a build, two or more at a time.
run_tests()
{
    folder=$1
    shift
    rm -f "$folder/results.xml"
    ctest --test-dir "$folder" --output-on-failure --parallel "$(processors)" --output-junit results.xml "$@" &&
        ended=well || ended=badly
    before=$failed
    count "$folder/results.xml"
    awk -F'"' '/<testcase name=/ { name = $2 } /SKIPPED: / { sub(/.*SKIPPED: /, "SKIPPED: "); print name ": " $0 }' "$folder/results.xml" \
        >>"$skips"
    # ctest itself may fail although no test did
    if [ $ended = badly ] && [ "$failed" -eq "$before" ]; then
        echo "== FAILED: ctest in $folder"
        failed=$((failed + 1))
    fi
}

build build -DCMAKE_BUILD_TYPE=Release
run_tests build
if [ $sanitize = yes ]; then
    echo "== Under the sanitizers"
    # The tool leaves its memory to the system when it ends, and popt's. A trace ends in popt, which is built without frame pointers.
    printf 'leak:%s\n' '/rwedge$' libpopt >"$output.leaks"
    export LSAN_OPTIONS="suppressions='$output.leaks':print_suppressions=0"
    build build/debug --preset debug
    # Python would load the library before the sanitizer's runtime, so shipped_tables, which makes the workbook, is left out.
    run_tests build/debug --exclude-regex "$of_another_compiler|^(example|shipped_tables)\$"
    unset LSAN_OPTIONS
fi
if [ -n "$long" ]; then
    echo "== The long run"
    run_tests build --build-config Long --label-regex "^($long)\$" --test-output-size-passed 100000
    echo "What they said: build/Testing/Temporary/LastTest.log"
fi

# Good reasons to skip: the processor lacks something, this machine does not allow it, or its distribution has no package of it.
beyond_us='long double has no more digits than double|this processor has no|this machine cannot trap|not a release build, or one under a sanitizer'
beyond_us="$beyond_us|the sources of .* cannot be fetched|cannot be tried here|404  *Not Found|another gnuplot drew it|another clang compiled"
beyond_us="$beyond_us|the system does not tell how much memory"
for need in $not_in_distribution; do
    beyond_us="$beyond_us|$(basename "${need#*:}")"
done

cat "$skips"
if [ $strict = yes ] && grep -vE "$beyond_us" "$skips" >"$output"; then
    echo "== FAILED: skipped, where nothing on this machine stands in the way:"
    cat "$output"
    failed=$((failed + 1))
fi
took=$(($(date +%s) - began))
echo "$((took / 60)) min $((took % 60)) s on $(processors) processors"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]

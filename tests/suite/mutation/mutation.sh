#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Do the unit tests notice a fault in lib/? This plants small faults, one at a time: a random sample of all that mutants.py knows. It
# counts those that some test notices, and fails below 90 %; see README.md.
#     mutation.sh SOURCE BUILD [--sample N] [--seed N] [--jobs N] [--only REGEX] [--tests REGEX]
set -eu
: "${2:?usage: mutation.sh SOURCE BUILD [--sample N] [--seed N] [--jobs N] [--only REGEX] [--tests REGEX]}"
source=$(cd "$1" && pwd) build=$2/mutation
. "$source/tests/suite/unit_tests.sh"
shift 2

for tool in cc make python3; do
    command -v $tool >/dev/null || { echo "SKIPPED: no $tool here"; exit 77; }
done

mkdir -p "$build"
build=$(cd "$build" && pwd)
programs=$(unit_tests "$source")
# shellcheck disable=SC2086
cmake -S "$source" -B "$build" -G 'Unix Makefiles' -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS=-O2 \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DRWEDGE_BUILD_CLI=OFF -DRWEDGE_INSTALL=OFF >"$build/log" 2>&1 &&
    cmake --build "$build" --parallel 2 --target $programs >>"$build/log" 2>&1 || { cat "$build/log"; exit 1; }

# shellcheck disable=SC2086
exec python3 -B "$source/tests/suite/mutation/mutation.py" "$@" "$source/lib" "$build" $programs

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the page, one HTML file: build.sh FOLDER OUTPUT. FOLDER keeps what is fetched and built. Quiet, unless it fails. Ends with 77
# where what it needs cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../../.." && pwd)
mkdir -p "$1/page"
folder=$(cd "$1" && pwd)
output=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
skip() { echo "SKIPPED: $*"; exit 77; }

for command in node npm; do
    command -v $command >/dev/null || skip "$command is not here"
done
sh "$here/../build.sh" "$folder"
sh "$here/packages.sh" "$here" "$folder/page" || skip "the packages of the page cannot be fetched"

# The package with another library: it has the model, which is the tool's too.
cd "$folder/web"
cp package/*.mjs ../page
sh "$top/packages/sources.sh" sources libcsv >log 2>&1 || skip "the sources of libcsv cannot be fetched: $(grep '^E: ' log | head -n 1)"
exports=$(sed -n 's/^EXPORTED.* \**\([a-z_]*\)(.*/\1/p' "$here"/model/*.c)
exports="$exports $(python3 -B "$top/bindings/interface/header.py" --names "$top/include/rwedge.h")"
cli=$top/cli
# shellcheck disable=SC2046
sh "$here/../link.sh" ../page -D_XOPEN_SOURCE=700 -I"$top/include" -I"$cli" -Isources/libcsv \
    "$here"/model/*.c "$cli"/model/*.c "$cli"/model/*/*.c "$cli"/pad/*.c "$cli"/input/pairs.c "$cli"/input/profiles.c "$cli"/input/table_input.c "$cli"/text/list.c "$cli"/text/checked_memory.c "$cli"/text/nearest.c "$cli"/number/number.c "$cli"/text/utf8.c \
    "$cli"/input/csv_input.c sources/libcsv/libcsv.c $(printf -- '-Wl,--export=%s ' $exports)
node "$here/make/texts.mjs" "$top" "$folder" >../page/texts.mjs
node "$here/make/page.mjs" "$folder" "$output" "$(clang --version | head -n 1)"

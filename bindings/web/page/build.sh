#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the page, one HTML file: build.sh FOLDER OUTPUT. FOLDER keeps what is fetched and built. Quiet, unless it fails. Ends with 77
# where what it needs cannot be had.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/page"
folder=$(cd "$1" && pwd)
output=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
skip() { echo "SKIPPED: $*"; exit 77; }

for command in node npm; do
    command -v $command >/dev/null || skip "$command is not here"
done
sh "$here/../build.sh" "$folder"
sh "$here/packages.sh" "$here" "$folder/page" || skip "the packages of the page cannot be fetched"
node "$here/make/page.mjs" "$folder/web/package" "$folder/page/node_modules" "$output" "$(clang --version | head -n 1)"

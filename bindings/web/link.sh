#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Links the library of the present folder, which build.sh has made, to FOLDER/rwedge.wasm and FOLDER/wasm.mjs: link.sh FOLDER ARGUMENT...
# The arguments, for clang, are sources and what is exported.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/options.sh"
folder=$1
shift
# shellcheck disable=SC2086
clang $options -Iinclude "$here/../../packages/dgelsd.c" -Wl,--whole-archive library/lib/librwedge_inside.a -Wl,--no-whole-archive gsl/*.o "$@" \
    -mexec-model=reactor -Wl,--export=malloc,--export=free,--gc-sections,--strip-all,-z,stack-size=1048576 -o "$folder/rwedge.wasm"
{
    sed -n 's,^# SPDX,// SPDX,p' "$here/link.sh"
    echo '// Made by link.sh: the library as WebAssembly. It is text here, so that a page or a program needs no other file.'
    echo "const text = \"$(base64 -w 0 "$folder/rwedge.wasm")\";"
    echo 'export const wasm = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));'
} >"$folder/wasm.mjs"

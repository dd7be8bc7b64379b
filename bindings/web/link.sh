#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Links the library's objects of the present folder, which build.sh has made, to a module: link.sh OUTPUT ARGUMENT... The arguments,
# for clang, are sources and what is exported.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/options.sh"
output=$1
shift
# shellcheck disable=SC2046,SC2086
clang $options -Iinclude "$here/../../packages/dgelsd.c" $(find library/lib -name '*.c.obj' | LC_ALL=C sort) gsl/*.o "$@" \
    -mexec-model=reactor -Wl,--export=malloc,--export=free,--gc-sections,--strip-all,-z,stack-size=1048576 -o "$output"

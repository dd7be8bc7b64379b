#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed guards itself: the stack, the C library's calls, the tables of addresses; and programs load anywhere.
#     hardened.sh LIBRARY [PROGRAM]
set -eu
failed=no
fail()
{
    echo "FAILED: $*"
    failed=yes
}
for file; do
    readelf -W -d -l -h "$file" >/dev/null || fail "$file is not read by readelf"
    readelf -W -l "$file" | grep -q GNU_RELRO || fail "$file: tables of addresses stay writable (no RELRO)"
    readelf -W -d "$file" | grep -Eq 'FLAGS.*(BIND_NOW|NOW)' || fail "$file: they are filled as it runs (no BIND_NOW)"
    readelf -W -l "$file" | grep -q 'GNU_STACK.* RW ' || fail "$file: its stack may be run as code"
    readelf -W -h "$file" | grep -q 'Type: *DYN' || fail "$file: it is loaded at one address only (no PIE)"
    readelf -W --dyn-syms "$file" | grep -q __stack_chk_fail || fail "$file: no stack protector"
done
[ $# -lt 2 ] || readelf -W --dyn-syms "$2" | grep -Eq '__[a-z]+_chk@' || fail "$2: calls nothing by _FORTIFY_SOURCE"
[ $failed = no ] && echo "$# files guard themselves"

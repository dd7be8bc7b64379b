#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed to build or test comes in versions that are written down, with their checksums, and runs nothing as it is
# installed. The lists name no server: each machine has its own.
#     pinned.sh SOURCE
set -eu
cd "$1"
status=0
fail() { echo "FAILED: $*"; status=1; }
lists=$(find bindings packages tests -name build -prune -o \( -path '*/packages/*.txt' -o -name requirements.txt -o -name package-lock.json \) -print)
[ "$(echo "$lists" | wc -l)" -ge 8 ] || fail "the lists were not found"
for list in $lists; do
    ! grep -nE '"resolved"|^[^ ]*(-url|://)' "$list" || fail "$list names a server"
    case $list in
    *.json) without=$(grep -c '^    "node_modules/' "$list" || true) sums=$(grep -c '"integrity": "sha512-' "$list" || true) ;;
    *) without=$(grep -c '^[A-Za-z]' "$list" || true) sums=$(grep -c '^[A-Za-z].*==.* \\$' "$list" || true) ;;
    esac
    [ "$without" -gt 0 ] && [ "$without" = "$sums" ] || fail "$list: $without packages, $sums of them with version and checksum"
done
# The lines that install: from a list, or nothing but what is here.
find bindings packages tests -name '*.sh' ! -name pinned.sh -exec grep -nHE '(bin/pip"?|pip_in) [^|]*install|^[^#]*npm (ci|install)' {} + |
    grep -vE 'require-hashes|--no-index|npm ci --ignore-scripts|install --offline' && fail "not from a list"
[ $status != 0 ] || echo "ok: $(echo "$lists" | wc -l) lists"
exit $status

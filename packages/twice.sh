#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# After make.sh: makes the packages again, in a clone in another folder, with another time zone and umask. They are the same bytes.
# Sources and tools that were fetched are shared. What was compiled is not.
#     twice.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/.." && pwd)
[ $# = 1 ] || { echo "usage: $0 BUILD" >&2; exit 2; }
build=$(cd "$1" && pwd)
fail() { echo "FAILED: $*"; exit 1; }
commit=$(git -C "$top" rev-parse HEAD 2>/dev/null) || { echo "SKIPPED: these files are no clone"; exit 77; }
gzip -dc "$build"/packages/rwedge-*.tar.gz | git get-tar-commit-id | grep -qx "$commit" ||
    fail "the packages in $build are not those of this commit: make them first"

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
umask 002
export TZ=Pacific/Auckland CCACHE_DISABLE=1
git clone --quiet "$top" "$work/another"
again=$work/another/build
for fetched in excel/sources web/sources docs-tools/venv docs-tools/fetched wheels/venv wheels/arm zig \
    "debian/clean-$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)"; do
    [ -e "$build/$fetched" ] || continue
    mkdir -p "$(dirname "$again/$fetched")"
    ln -s "$build/$fetched" "$again/$fetched"
done
sh "$work/another/packages/make.sh" --untested "$again" >"$work/log" 2>&1 && status=0 || status=$?
case $status in 0 | 77) ;; *) tail -n 40 "$work/log"; fail "they cannot be made again" ;; esac
(cd "$again/packages" && sha256sum --check --quiet "$build/packages/SHA256SUMS") || fail "made again, they have other bytes"
echo "made again in another folder, they are the same bytes: $(wc -l <"$build/packages/SHA256SUMS") files"

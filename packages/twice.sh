#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the packages again, in a clone in another folder, with another time zone and umask: they are the same bytes. Those of BUILD
# are made first, if they are not of this commit.
# Sources and tools that were fetched are shared. What was compiled is not.
#     twice.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/.." && pwd)
[ $# = 1 ] || { echo "usage: $0 BUILD" >&2; exit 2; }
build=$(cd "$1" && pwd)
fail() { echo "FAILED: $*"; exit 1; }
commit=$(git -C "$top" rev-parse HEAD 2>/dev/null) || { echo "SKIPPED: these files are no clone"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
# make_in CLONE BUILD
make_in()
{
    sh "$1/packages/make.sh" --untested "$2" >"$work/log" 2>&1 && status=0 || status=$?
    case $status in 0 | 77) ;; *) tail -n 40 "$work/log"; fail "they cannot be made in $2" ;; esac
}
gzip -dc "$build"/packages/rwedge-*.tar.gz 2>/dev/null | git get-tar-commit-id 2>/dev/null | grep -qx "$commit" ||
    make_in "$top" "$build"

umask 002
export TZ=Pacific/Auckland CCACHE_DISABLE=1
git clone --quiet "$top" "$work/another"
again=$work/another/build
for fetched in excel/sources web/sources docs-tools/venv wheels/venv wheels/arm \
    "debian/clean-$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)"; do
    [ -e "$build/$fetched" ] || continue
    mkdir -p "$(dirname "$again/$fetched")"
    ln -s "$build/$fetched" "$again/$fetched"
done
mkdir -p "$again"
make_in "$work/another" "$again"
(cd "$again/packages" && sha256sum --check --quiet "$build/packages/SHA256SUMS") || fail "made again, they have other bytes"
echo "made again in another folder, they are the same bytes: $(wc -l <"$build/packages/SHA256SUMS") files"

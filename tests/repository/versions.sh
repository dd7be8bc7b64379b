#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The version in CMakeLists.txt stands everywhere: header, tool, Python's package, README.md, CITATION.cff and what is made of it
# and of packages/who.json, CHANGELOG.md with its date.
#     versions.sh SOURCE TOOL
set -eu
cd "$1"
tool=$2
version=$(sed -n 's/^project(rwedge VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
status=0

# is WHERE FOUND - one of the places.
is()
{
    [ -n "$version" ] && [ "$2" = "$version" ] && return
    echo "FAILED: $1 says '$2', CMakeLists.txt says '$version'"
    status=1
}
is include/rwedge.h "$(sed -n 's/^#define RWEDGE_VERSION "\(.*\)"/\1/p' include/rwedge.h)"
is "$tool --version" "$("$tool" --version | sed -n 's/^rwedge \([0-9.]*\).*/\1/p')"
is CITATION.cff "$(sed -n 's/^version: //p' CITATION.cff)"
is README.md "$(sed -n 's/^  version = {\(.*\)},/\1/p' README.md)"
is CHANGELOG.md "$(sed -n "s/^## \($version\), .*/\1/p" CHANGELOG.md)"

# Python's package reads the header, by the expression in pyproject.toml
pattern=$(sed -n "s/^metadata\.version\.regex = '\(.*\)(?P<value>\.\*)\(.*\)'/\1\\\\(.*\\\\)\2/p" bindings/python/pyproject.toml)
is bindings/python/pyproject.toml "$(sed -n "s/^.*${pattern:-no pattern}.*/\1/p" include/rwedge.h)"

# every version has its date, or is not released yet; the day of the present one is in CITATION.cff, from where the man page has it
dated='^## [0-9]+\.[0-9]+\.[0-9]+, ([0-9]{4}-[0-9]{2}-[0-9]{2}|unreleased)$'
if grep '^## ' CHANGELOG.md | grep -vE "$dated"; then
    echo "FAILED: CHANGELOG.md: a heading that is not '## VERSION, DATE'"
    status=1
fi
date=$(sed -n "s/^## $version, //p" CHANGELOG.md)
[ "$date" = unreleased ] || grep -qx "date-released: ${date:-no date}" CITATION.cff || { echo "FAILED: CITATION.cff does not say $date"; status=1; }
# codemeta.json too, authors, addresses and dates; without Python other versions alone were compared
! command -v python3 >/dev/null || python3 -B packages/who.py --check || status=1
[ $status -ne 0 ] || echo "ok: $version of $date"
exit $status

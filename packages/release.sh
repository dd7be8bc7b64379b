#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# All that a release needs: the version and its date in every place, tables, tests, packages, checksums; then what a person does.
#     release.sh [--numbers-only] VERSION DATE        as 1.2.0 2026-11-22; CHANGELOG.md has its section already
set -eu
cd "$(dirname "$0")/.."
numbers_only=no
[ "${1-}" != --numbers-only ] || { numbers_only=yes; shift; }
[ $# = 2 ] || { echo "usage: $0 [--numbers-only] VERSION DATE" >&2; exit 2; }
version=$1 date=$2
expr "$version $date" : '[0-9][0-9]*\.[0-9][0-9]*\.[0-9][0-9]* [0-9]\{4\}-[0-9][0-9]-[0-9][0-9]$' >/dev/null ||
    { echo "$0: $version $date: not as 1.2.0 2026-11-22" >&2; exit 2; }
grep -qE "^## $version, ($date|unreleased)\$" CHANGELOG.md || { echo "$0: CHANGELOG.md has no section of $version, $date" >&2; exit 1; }

# edit FILE EXPRESSION
edit() { sed "$2" "$1" >"$1.new" && cat "$1.new" >"$1" && rm "$1.new"; }
edit CHANGELOG.md "s/^## $version, unreleased\$/## $version, $date/"
edit CMakeLists.txt "s/^project(rwedge VERSION [0-9.]*/project(rwedge VERSION $version/"
edit include/rwedge.h "s/^\(#define RWEDGE_VERSION \)\".*\"/\1\"$version\"/"
edit CITATION.cff "s/^version: .*/version: $version/; s/^date-released: .*/date-released: $date/"
edit README.md "s/^  version = {.*},/  version = {$version},/; s/^  year    = {.*}/  year    = {${date%%-*}}/"
python3 -B packages/who.py --write
[ $numbers_only = no ] || exit 0

./tables/generate.sh
if ! git diff --quiet; then
    git diff --stat
    echo "The numbers, or what is made of them, have changed: look, commit, and run this again."
    exit 1
fi
./tests/run.sh --all
sh packages/twice.sh build
(cd build/packages && sha256sum --quiet -c SHA256SUMS)
tag=v$version
cat <<END

build/packages/ has what is to be published. $(python3 -B packages/who.py | sed 's/^/  /')

What a person does now, in this order; what cannot be taken back comes last:
 1. fill in packages/who.json where it is empty; python3 packages/who.py --write; commit; this command again
 2. git tag -s $tag -m "rwedge $version"; push the branch and the tag
 3. a release of $tag at the place of the source, with every file of build/packages/, SHA256SUMS too; download one, compare
 4. the archive that gives a DOI, from that release (Zenodo reads CITATION.cff); the DOI into packages/who.json for the next version
 5. python/: twine check, then to the test registry; install it there in an empty environment; then to PyPI
 6. npm publish --dry-run, then npm publish, of rwedge-$version-npm.tgz
 7. recipes/: each as a proposal to its collection (Conan, conda); the URL in them must answer
 8. debian-*/: sign the source package, and ask for a sponsor
 9. packages/paper/: name the authors, and submit it with the DOI
END

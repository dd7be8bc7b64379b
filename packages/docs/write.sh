#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the pages into BUILD/docs. A link that leads to no place fails; so does a page that loads something from elsewhere, or has
# a formula as it is typed. The generator is fetched once, into BUILD/docs-tools.
#     write.sh BUILD
# It ends with 77 where something is missing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
tools=$build/docs-tools
. "$here/../../tests/support/install.sh"
wish command:gnuplot=gnuplot-nox command:python3=python3 python:ensurepip=python3-venv

skip()
{
    echo "SKIPPED: not made: the pages: $*"
    exit 77
}

command -v gnuplot >/dev/null 2>&1 || skip "no gnuplot here"
. "$here/../../tests/support/venv.sh"
reason=$(venv "$here/requirements.txt" "$tools/venv") || skip "${reason#SKIPPED: }"
SKBUILD_BUILD_DIR=$tools/package pip_in "$tools/venv" install --quiet --no-build-isolation --no-deps --no-index --force-reinstall \
    "$here/../../bindings/python" >"$tools/pip.log" 2>&1 || { cat "$tools/pip.log"; exit 1; }
export MPLCONFIGDIR="$tools/matplotlib" PYTHONDONTWRITEBYTECODE=1

rm -rf "$tools/source" "$build/docs"
mkdir "$tools/source"
"$tools/venv/bin/python" -B "$here/pages.py" "$build/cli/rwedge" "$tools/source"
"$tools/venv/bin/python" -B -m sphinx -b html -nWEq --keep-going -c "$here" -d "$tools/doctrees" "$tools/source" "$build/docs"
rm "$build/docs/.buildinfo"
cd "$build/docs"
find . -type d -empty -delete # Sphinx leaves one, which no zip has
if grep -rnoE '<(img|script|link|iframe|source|object)[^>]* (src|href|data)="(https?:)?//[^"]*|url\(.?(https?:)?//[^)]*|\\(frac|varphi).{0,20}' \
    --include='*.html' --include='*.css' .; then
    echo "FAILED: this is loaded from elsewhere, or no formula"
    exit 1
fi
echo "$(find . -name '*.html' | wc -l) pages"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the page: test.sh BUILD. The one that is shipped: its size, its security policy, its licences, that the sources make it so now.
# What it computes, beside the tool, in Node.
#     test.sh --long BUILD    in the browsers of this machine too
set -eu
long=no
[ "$1" != --long ] || { long=yes; shift; }
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../../.." && pwd)
build=$(cd "$1" && pwd)
page=$top/tables/rounded-wedge.html now=$build/page/rounded-wedge.html status=0
fail() { echo "FAILED: $*"; exit 1; }

mkdir -p "$build/page"
sh "$here/build.sh" "$build" "$now" || exit $?
if [ -x "$build/cli/rwedge" ]; then
    python=$build/python/venv/bin/python # bindings/python/test.sh installs the package there
    "$python" -c 'import rwedge' 2>/dev/null || { python='' && echo "programs in Python: not tried, its package is not built"; }
    node "$here/test/model.mjs" "$build" "$build/cli/rwedge" "$python" || fail "the model beside the tool"
fi

size=$(wc -c <"$page")
[ "$size" -lt 1500000 ] || fail "the page has $size bytes; allowed: fewer than 1500000"
policy=$(sed -n 's/.*http-equiv="Content-Security-Policy" content="\([^"]*\)".*/\1/p' "$page" | sed "s/'sha256-[^']*'/HASH/g")
allowed="default-src 'none'; script-src HASH 'wasm-unsafe-eval'; worker-src blob:; style-src HASH"
[ "$policy" = "$allowed; img-src data: blob:; base-uri 'none'; form-action 'none'" ] || fail "the page's policy is: $policy"
! grep -qE '<(script|link|img|iframe)[^>]* (src|href)=' "$page" || fail "the page names another file"
for words in 'GNU GENERAL PUBLIC LICENSE' 'Permission to use, copy, modify' 'd3-contour' 'E10' 'Int. J. Mech. Sci. 40'; do
    grep -q "$words" "$page" || fail "the page does not say: $words"
done
! grep -qF '\frac' "$now" || fail "the page has formulas in TeX"
echo "ok: $size bytes, no connection, licences and words"

# Another clang gives the library other bytes: then all the rest is compared.
made_by() { sed -n 's/^<!-- The library inside was compiled by \(.*\)\. -->$/\1/p' "$1"; }
rest() { sed "s/AGFzbQ[A-Za-z0-9+/=]*//; s/sha256-[^']*//; /^<!-- The library inside/d" "$1"; }
if [ "$(made_by "$page")" = "$(made_by "$now")" ]; then
    cmp "$page" "$now" || fail "the page is not what the sources make now; ./tables/generate.sh writes it"
    echo "ok: it is what the sources make now"
else
    rest "$page" >"$build/page/shipped" && rest "$now" >"$build/page/now"
    cmp "$build/page/shipped" "$build/page/now" || fail "the page, apart from the library in it, is not what the sources make now"
    echo "SKIPPED: another clang compiled the library in the page, $(made_by "$page"); all the rest is what the sources make now"
    status=77
fi
[ $long = yes ] || exit $status

mkdir -p "$build/page/test"
sh "$here/packages.sh" "$here/test" "$build/page/test" || { echo "SKIPPED: the packages of the test cannot be fetched"; exit 77; }
cp "$here"/test/*.mjs "$build/page/test"
node "$build/page/test/browsers.mjs" "$now" "$build/cli/rwedge" "$build/page/test/node_modules/axe-core/axe.min.js"

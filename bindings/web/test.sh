#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The JavaScript package: made, packed by npm, installed in an empty folder and used there; its answers against those
# of C.    test.sh [--long] BUILD        --long: also its types; against C with the same libm, to the last bit; the time that it takes
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
long=no
[ "$1" != --long ] || { long=yes; shift; }
mkdir -p "$1/web"
build=$(cd "$1" && pwd)
skip() { echo "SKIPPED: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }

for command in node npm python3 cc; do
    command -v $command >/dev/null 2>&1 || skip "$command is not here"
done
cd "$build/web"
npm() { command npm --no-audit --no-fund --no-update-notifier --loglevel=error "$@"; }
sh "$here/build.sh" "$build"

# Packed, and installed without a network, where nothing else is.
rm -rf packed installed
mkdir packed installed
(cd package && npm pack --silent --pack-destination ../packed >/dev/null)
(cd installed && echo '{}' >package.json && npm install --offline --silent ../packed/rwedge-*.tgz >/dev/null)
installed=installed/node_modules/rwedge
for file in LICENSE NOTICE README.md rwedge.mjs rwedge.d.mts; do
    [ -s $installed/$file ] || fail "the package has no $file"
done
bytes=$(cat $installed/*.mjs | gzip -9 | wc -c)
[ "$bytes" -lt 375000 ] || fail "$bytes bytes when compressed, which is more than 375 kB"
echo "$bytes bytes when compressed"
! grep -nE '\b(eval|Function|fetch|XMLHttpRequest|require)\(' $installed/*.mjs | cut -c 1-200 | grep . || fail "eval, or a connection"

cp "$here"/test/*.mjs "$here"/test/*.ts installed
cd installed
node --expose-gc --test --test-reporter=tap test.mjs >../test.log 2>&1 || { cat ../test.log; fail "test.mjs"; }
sed -n 's/^# pass/tests passed:/p' ../test.log
# The README's example prints what it shows.
sed -n '/^```js$/,/^```$/p' "$here/README.md" | sed '/^```/d' >example.mjs
sed -n '/^```text$/,/^```$/p' "$here/README.md" | sed '/^```/d' >expected.txt
node example.mjs | diff - expected.txt || fail "the example of README.md"
cd ..

# Equal bits with C, but for what another libm and, in a fit, another LAPACK change.
sh "$top/tests/answers/answers.sh" "$build"
answers=$build/private/answers
node installed/answer.mjs $installed <"$answers/calls.javascript" >answers.csv
python3 -B "$top/tests/answers/compare.py" "$answers/answers.csv" answers.csv 1e-12
[ $long = yes ] || exit 0

mkdir -p tools # kept for the next time
sh "$here/page/packages.sh" "$here/test" tools >npm.log 2>&1 || skip "npm cannot fetch TypeScript: $(tail -n 1 npm.log)"
(cd installed && ../tools/node_modules/.bin/tsc --noEmit --strict --target es2022 --module nodenext types.ts) || fail "the types"
sh "$top/packages/sources.sh" sources musl >log 2>&1 || skip "the sources of musl cannot be fetched: $(grep '^E: ' log | head -n 1)"
sh "$top/packages/libm.sh" sources linux
cc -I"$top/include" "$answers/answer.c" "$build/private/prefix/lib/librwedge.a" linux/libm.a -o answer-same
# what follows a fit is of another LAPACK
without_fits() { awk -F: '$1 == "series_fit" { fitted = 1 } $1 == "series_create" { fitted = 0 } !fitted || $1 !~ /^series_/' "$1"; }
without_fits answers.csv >answers-same.csv
./answer-same >expected-same.csv
without_fits expected-same.csv | cmp - answers-same.csv || fail "other bits than in C, with the same libm"
echo "$(wc -l <answers-same.csv) calls: the same bits as in C with the same libm"
node installed/speed.mjs "$build/tests/speed/bench"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every C file of lib/ has its test in the same room here, or README.md says which file tests it.    rooms.sh SOURCE
set -eu
cd "$1"
bad=no
for file in lib/*/*.c; do
    name=${file#lib/}
    [ ! -f "tests/lib/$(dirname "$name")/test_$(basename "$name")" ] || continue
    grep -q "^|.*\`$name\`.*|" tests/lib/README.md || {
        echo "FAILED: $file has no test: add tests/lib/$(dirname "$name")/test_$(basename "$name"), or name it in tests/lib/README.md"
        bad=yes
    }
done
for test in $(sed -n 's/^|.*| `\([a-z_]*\/test_[a-z_]*\.c\)` |$/\1/p' tests/lib/README.md); do
    [ -f "tests/lib/$test" ] || {
        echo "FAILED: tests/lib/README.md names $test, which is not there"
        bad=yes
    }
done
[ $bad = no ]

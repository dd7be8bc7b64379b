#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What the pages "How to add ..." say, followed: each patch of how_to/ is applied to a copy of the sources, which is then built, run and
# tested. The head of a patch says how many files are changed, what is run, the column and the value that it prints, and which tests
# of tests/cli/ pass then, besides those of the rooms and of the README's examples.
#     how_to.sh SOURCE FOLDER [PATCH...]
set -eu
source=$(cd "$1" && pwd)
work=$2/how_to
shift 2
here=$source/tests/suite/how_to
[ $# -gt 0 ] || set -- "$here"/*.patch
fail() { echo "FAILED: $name: $*"; exit 1; }
# said NAME - what the head of the patch says
said() { sed -n "/^diff/q; s/^$1: //p" "$patch"; }

for patch; do
    name=$(basename "$patch" .patch)
    tree=$work/$name/rwedge
    rm -rf "$work/$name"
    mkdir -p "$tree"
    (cd "$source" && tar cf - --exclude=./build --exclude=./.git --exclude=node_modules .) | tar xf - -C "$tree"
    files=$(grep -c '^+++ ' "$patch")
    [ "$files" = "$(said files | sed 's/ .*//')" ] || fail "it changes $files files"
    (cd "$tree" && patch -p1 --no-backup-if-mismatch) <"$patch" >"$work/log" 2>&1 ||
        { cat "$work/log"; fail "it does not apply: the page or the patch is behind"; }
    cmake -S "$tree" -B "$work/$name/build" -DCMAKE_BUILD_TYPE=Release -DRWEDGE_BUILD_CLI=ON -DRWEDGE_BUILD_TESTS=OFF >"$work/log" 2>&1 &&
        cmake --build "$work/$name/build" --parallel 2 >>"$work/log" 2>&1 || { tail -n 30 "$work/log"; fail "it does not build"; }
    ! grep 'warning: ' "$work/log" || fail "a warning"
    tool=$work/$name/build/cli/rwedge

    (cd "$here" && eval "\"$tool\" $(said run)") >"$work/rows" || fail "status $? of rwedge $(said run)"
    column=$(said column)
    got=$(awk -F, -v name="${column% *}" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
        c && NR == 2 { print $c }' "$work/rows")
    [ "$got" = "${column#* }" ] || fail "${column% *} is '$got', not ${column#* }"

    sh "$tree/tests/cli/command_line/readme.sh" "$tool" "$tree/tests/data" write >/dev/null
    for room in lib cli; do
        sh "$tree/tests/repository/rooms.sh" "$tree/$room" >"$work/log" 2>&1 || { cat "$work/log"; fail "the rooms of $room"; }
    done
    for test in command_line/readme $(said tests); do
        ended=0
        sh "$tree/tests/cli/$test.sh" "$tool" "$tree/tests/data" >"$work/log" 2>&1 || ended=$?
        [ $ended = 0 ] || [ $ended = 77 ] || { head -n 30 "$work/log"; fail "tests/cli/$test.sh"; }
    done
    echo "ok: $name, $files files: $(sed q "$patch")"
    rm -rf "$work/$name"
done

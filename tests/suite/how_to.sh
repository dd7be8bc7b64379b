#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What the pages "How to add ..." say, followed: each patch of how_to/ in turn is applied to a copy of the sources, which is then built,
# run and tested, and gets its files back. The head of a patch says how many files are changed, what is run, the column and the value
# that it prints, which claims in C (claims) and which tests of tests/cli/ (tests) pass then, besides the layout and those of the rooms
# and of the README's examples.
#     how_to.sh SOURCE FOLDER [PATCH...]
set -eu
source=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)/how_to
shift 2
here=$source/tests/suite/how_to
[ $# -gt 0 ] || set -- "$here"/*.patch
tree=$work/rwedge
tool=$work/build/cli/rwedge
log=$work/log
fail() { echo "FAILED: $name: $*"; exit 1; }
# said NAME - what the head of the patch says
said() { sed -n "/^diff/q; s/^$1: //p" "$patch"; }
# passes WHAT COMMAND... - it ends well, or is skipped
passes()
{
    what=$1 ended=0
    shift
    "$@" >"$log" 2>&1 || ended=$?
    [ $ended = 0 ] || [ $ended = 77 ] || { head -n 30 "$log"; fail "$what"; }
}
# build TARGET... - without a warning
build()
{
    cmake --build "$work/build" --parallel 2 --target rwedge_cli "$@" >"$log" 2>&1 || { tail -n 30 "$log"; fail "it does not build"; }
    ! grep 'warning: ' "$log" || fail "a warning"
}

name='without a patch'
rm -rf "$work"
mkdir -p "$tree"
(cd "$source" && tar cf - --exclude='./build*' --exclude=./.git --exclude=node_modules .) | tar xf - -C "$tree"
cmake -S "$tree" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DRWEDGE_BUILD_CLI=ON -DRWEDGE_BUILD_TESTS=ON >"$log" 2>&1 ||
    { tail -n 30 "$log"; fail "it is not configured"; }
build

for patch; do
    name=$(basename "$patch" .patch)
    files=$(grep -c '^+++ ' "$patch")
    [ "$files" = "$(said files | sed 's/ .*//')" ] || fail "it changes $files files"
    (cd "$tree" && patch -p1 --no-backup-if-mismatch) <"$patch" >"$log" 2>&1 ||
        { cat "$log"; fail "it does not apply: the page or the patch is behind"; }
    # shellcheck disable=SC2046
    build $(said claims)

    (cd "$here" && eval "\"$tool\" $(said run)") >"$work/rows" || fail "status $? of rwedge $(said run)"
    column=$(said column)
    got=$(awk -F, -v name="${column% *}" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
        c && NR == 2 { print $c }' "$work/rows")
    [ "$got" = "${column#* }" ] || fail "${column% *} is '$got', not ${column#* }"

    sh "$tree/tests/cli/command_line/readme.sh" "$tool" "$tree/tests/data" write >/dev/null
    passes "the layout" sh "$tree/tests/repository/layout.sh" "$tree"
    for room in lib cli; do
        passes "the rooms of $room" sh "$tree/tests/repository/rooms.sh" "$tree/$room"
    done
    for claims in $(said claims); do
        passes "$claims" "$work/build/tests/lib/$claims"
    done
    for test in command_line/readme $(said tests); do
        passes "tests/cli/$test.sh" sh "$tree/tests/cli/$test.sh" "$tool" "$tree/tests/data"
    done
    echo "ok: $name, $files files: $(sed q "$patch")"

    for file in $(sed -n 's|^+++ b/||p' "$patch") cli/README.md; do
        [ ! -e "$source/$file" ] || { cp "$source/$file" "$tree/$file"; continue; }
        rm "$tree/$file"
        rmdir "$(dirname "$tree/$file")" 2>/dev/null || :
    done
done
rm -rf "$work"

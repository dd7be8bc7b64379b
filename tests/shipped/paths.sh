#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A clone in a path that CMake does not take is refused in the first line, with the path, by both commands, and nothing is built.
# Other paths are accepted; commands.py builds in one with a space, an apostrophe and an accent.
#     paths.sh SOURCE
set -eu
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# clone_in FOLDER - what the two commands read before they begin.
clone_in()
{
    mkdir -p "$1/tables" "$1/tests/support"
    cp "$source/tables/generate.sh" "$1/tables"
    cp "$source/tests/run.sh" "$1/tests"
    cp "$source"/tests/support/*.sh "$1/tests/support"
}

newline='
'
for character in '#' ';' "$newline"; do
    folder="$work/a${character}b"
    clone_in "$folder"
    for command in tables/generate.sh tests/run.sh; do
        ended=0
        "$folder/$command" >"$work/said" 2>&1 || ended=$?
        printf '%s: CMake does not take this path' "$folder" >"$work/expected"
        head -c "$(wc -c <"$work/expected")" "$work/said" | cmp - "$work/expected" && [ $ended = 2 ] && [ ! -e "$folder/build" ] ||
            { echo "FAILED: $command in a path with '$character' ends with status $ended and says:"; cat "$work/said"; exit 1; }
    done
done
# an option that does not exist is what run.sh minds next
folder="$work/it's (a test) = é 100 % & more!"
clone_in "$folder"
if "$folder/tests/run.sh" --none >"$work/said" 2>&1 || ! grep -q 'unknown option' "$work/said"; then
    echo "FAILED: $folder is refused:"
    cat "$work/said"
    exit 1
fi
echo "ok: both commands refuse such paths"

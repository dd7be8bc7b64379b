#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A room of lib/ or of cli/ includes only headers of the rooms that its README names. The README of the whole names these before it.
#     rooms.sh FOLDER
set -eu
cd "$1"
whole=$(basename "$1") bad=0
wrong()
{
    echo "FAILED: $*"
    bad=1
}
# names - of rooms, in the lines of a README
names() { grep -o '`[a-z/]*`' | tr -d '`'; }
# among ROOM ROOMS - is it one of them?
among() { case " $2 " in *" $1 "*) ;; *) return 1 ;; esac }

rooms=$(sed -n '/^A room has one header/,/^$/p; s/^| \[\(`[a-z]*\)\/`.*/\1`/p' README.md | names)
above=nothing
for room in $rooms; do
    # "Uses: text, number." or "This room depends on `base` and `stress`."
    uses=$(sed -n '/^This room depends on/p; /^Uses: /{ s///; s/[a-z/]\{1,\}/`&`/gp; }' "$room/README.md" | names | tr '\n' ' ')
    for other in $uses; do
        among "$other" "$above" || wrong "$room uses $other, which the README of $whole does not name before it"
    done
    # the files of a room but those of the rooms inside it
    files=$(find "$room" -name '*.[ch]' | while read -r file; do
        [ "${file%/*}" != "$room" ] && [ -e "${file%/*}/README.md" ] || echo "$file"
    done)
    for other in $(sed -n 's|^#include "\([a-z/]*\)/[^/]*".*|\1|p' /dev/null $files | sort -u); do
        among "$other" "$uses $room" || wrong "$room includes a header of $other, which its README does not name"
    done
    above="$above $room"
done
for folder in */ $(find . -mindepth 3 -name README.md | sed 's|^./||; s|README.md$||'); do
    among "${folder%/}" "$above" || wrong "$folder is no room of the README of $whole"
done

if [ "$whole" = lib ]; then # each README lists the files of its room
    for file in */*.c; do
        grep -q "^|.*\`$(basename "$file")\`.*|" "$(dirname "$file")/README.md" || wrong "the README of its room does not name $file"
    done
    for file in $(cd ../tests/lib && ls */test_*.c); do
        idea=$(echo "${file%.c}" | sed 's/test_//')
        grep -qE "(^| )$idea( |\)|$)" ../tests/lib/CMakeLists.txt || wrong "tests/lib/CMakeLists.txt does not name $file"
    done
else # other rooms see one header, of the room's name
    for room in $rooms; do
        own=$room/${room##*/}.h
        [ -e "$own" ] || [ -z "$(find "$room" -maxdepth 1 -name '*.h')" ] || wrong "$own is not there"
        for header in $(grep -rhoE "^#include \"$room/[a-z_]+\.h\"" --include='*.[ch]' . | cut -d '"' -f 2 | sort -u); do
            [ "$header" = "$own" ] || wrong "$header is included, which is not its room's one header"
        done
    done
    for file in $(grep -rl '<xlsxwriter\.h>' --include='*.[ch]' . | grep -v '^\./sheet/'); do
        wrong "${file#./} sees libxlsxwriter"
    done
    for file in $(grep -rl '<jansson\.h>' --include='*.[ch]' . | grep -v '^\./document/'); do
        wrong "${file#./} sees Jansson"
    done
fi
[ "$bad" -eq 0 ] && echo "ok: $(echo $rooms | wc -w) rooms of $whole, each named before those that use it"

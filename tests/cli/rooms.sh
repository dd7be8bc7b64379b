#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A room of cli/ uses only the rooms that its README allows. Its README allows only rooms that cli/README.md names before it.
#     rooms.sh PROGRAM DATA
set -eu
cd "$(dirname "$0")/../../cli"
rooms=$(sed -n '/^A room has one header/,/^$/p' README.md | grep -o '`[a-z/]*`' | tr -d '`')
bad=0
wrong()
{
    echo "FAILED: $*"
    bad=1
}
above=nothing
for room in $rooms; do
    uses=$(sed -n 's/^Uses: \(.*\)\.$/\1/p' "$room/README.md" | tr -d ,)
    [ -n "$uses" ] || wrong "cli/$room/README.md does not say which rooms it uses"
    for other in $uses; do
        case " $above " in
        *" $other "*) ;;
        *) wrong "cli/$room uses $other, which cli/README.md does not name before it" ;;
        esac
    done
    # the files of a room but those of the rooms inside it
    files=$(find "$room" -name '*.[ch]' | while read -r file; do
        [ "${file%/*}" != "$room" ] && [ -e "${file%/*}/README.md" ] || echo "$file"
    done)
    for other in $(sed -n 's|^#include "\([a-z/]*\)/[^/]*".*|\1|p' $files | sort -u); do
        case " $uses $room " in
        *" $other "*) ;;
        *) wrong "cli/$room includes a header of $other, which its README does not allow" ;;
        esac
    done
    # other rooms see one header, of the room's name
    own=$room/${room##*/}.h
    [ -e "$own" ] || wrong "cli/$own is not there"
    for header in $(grep -rhoE "^#include \"$room/[a-z_]+\.h\"" --include='*.[ch]' . | cut -d '"' -f 2 | sort -u); do
        [ "$header" = "$own" ] || wrong "cli/$header is included, which is not its room's one header"
    done
    above="$above $room"
done
for folder in */ $(find . -mindepth 3 -name README.md | sed 's|^./||; s|README.md$||'); do
    case " $above " in
    *" ${folder%/} "*) ;;
    *) wrong "cli/$folder is no room of cli/README.md" ;;
    esac
done
for file in $(grep -rl '<xlsxwriter\.h>' --include='*.[ch]' . | grep -v '^\./sheet/'); do
    wrong "cli/${file#./} sees libxlsxwriter"
done
[ "$bad" -eq 0 ] && echo "ok: $(echo $rooms | wc -w) rooms, each named before those that use it"

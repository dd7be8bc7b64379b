#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A room of cli/ uses only the rooms that its README allows. Its README allows only rooms that cli/README.md names before it.
#     rooms.sh PROGRAM DATA
set -eu
cd "$(dirname "$0")/../../cli"
rooms=$(sed -n '/^Includes name the room/,/^$/p' README.md | grep -o '`[a-z/]*`' | tr -d '`')
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
    for header in "$room"/*.h; do
        [ $header = options/command.h ] || [ -e "${header%.h}.c" ] || [ -e "$room/posix/$(basename "$header" .h).c" ] ||
            ! grep -v '^static inline' "$header" | grep -q '^extern\|^[a-z][a-z_0-9 *]*(' ||
            wrong "cli/$header declares what another file defines"
    done
    above="$above $room"
done
for folder in */ $(find . -mindepth 3 -name README.md | sed 's|^./||; s|README.md$||'); do
    case " $above " in
    *" ${folder%/} "*) ;;
    *) wrong "cli/$folder is no room of cli/README.md" ;;
    esac
done
for file in $(grep -rlE '"sheet/parts\.h"|<xlsxwriter\.h>' --include='*.[ch]' . | grep -v '^\./sheet/'); do
    wrong "cli/${file#./} sees libxlsxwriter"
done
[ "$bad" -eq 0 ] && echo "ok: $(echo $rooms | wc -w) rooms, each named before those that use it"

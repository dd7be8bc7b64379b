#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The README of its room names every C file of lib/. A room of lib/ includes only headers of the rooms that its README names, and
# lib/README.md lists these above it.    rooms.sh SOURCE
set -eu
cd "$1"
bad=no

wrong()
{
    echo "FAILED: $*"
    bad=yes
}

for file in lib/*/*.c; do
    grep -q "^|.*\`$(basename "$file")\`.*|" "$(dirname "$file")/README.md" || wrong "the README of its room does not name $file"
done

above=''
for room in $(sed -n 's/^| \[`\([a-z]*\)\/`.*/\1/p' lib/README.md); do
    uses=$(grep '^This room depends on' "lib/$room/README.md" | grep -o '`[a-z]*`' | tr -d '`' | tr '\n' ' ')
    for other in $(find "lib/$room" -maxdepth 1 -name '*.[ch]' -exec sed -n 's|^#include "\([a-z]*\)/.*|\1|p' {} + | sort -u); do
        case " $uses $room " in
        *" $other "*) ;;
        *) wrong "lib/$room includes a header of $other, which its README does not name" ;;
        esac
    done
    for other in $uses; do
        case " $above " in
        *" $other "*) ;;
        *) wrong "lib/$room uses $other, which lib/README.md does not list above it" ;;
        esac
    done
    above="$above $room"
done
for folder in lib/*/; do
    case " $above " in
    *" $(basename "$folder") "*) ;;
    *) wrong "$folder is no room of lib/README.md" ;;
    esac
done
[ $bad = no ]

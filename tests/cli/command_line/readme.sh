# SPDX-License-Identifier: GPL-3.0-or-later
# What the README shows is what the program prints, whatever the locale.
#     readme.sh PROGRAM REFERENCES [write]    write: the README then shows what the program prints
write=${3:-}
. "$(dirname "$0")/../claims.sh"

readme=$here/../../../cli/README.md
# Each example into files of its own: N.command, N.expected; and the files that examples read.
awk '
    /^```(csv|json) [a-z.]*$/ { file = $2; next }
    /^```$/ { file = "" }
    file { print > file; next }
    /^```console$/ { inside = 1; next }
    /^```$/ { inside = 0; next }
    !inside { next }
    /^\$ / { n++; print substr($0, 3) > (n ".command"); printf "" > (n ".expected"); next }
    { print > (n ".expected") }' "$readme"

use_decimal_comma
for file in *.command; do
    called=$(cat "$file")
    arguments=${called#rwedge }
    "$rwedge" $arguments >out 2>&1
    same "output" "$(cat "${file%.command}.expected")" "$(cat out)"
done
[ "$write" != write ] || {
    for file in *.command; do
        arguments=$(sed 's/^rwedge //' "$file")
        "$rwedge" $arguments >"${file%.command}.expected" 2>&1
    done
    awk '/^```console$/ { inside = 1 }
        /^```$/ { inside = 0 }
        !inside || /^```console$/ { print; next }
        /^\$ / { print; n++; while ((getline line < (n ".expected")) > 0) print line }' "$readme" >README.md
    cp README.md "$readme"
    exit 0
}
# The first result of the README at the top.
top=$here/../../../README.md
called=$(sed -n 's/^`\(rwedge solve .* --verdict\)` says:$/\1/p' "$top")
"$rwedge" ${called#rwedge } -o first.csv 2>err
same "the first result" "$(sed -n 's/^> //p' "$top")" "$(sed 's/^rwedge solve: //; s/surface\. .*/surface./' err)"
same "there are examples" yes "$([ "$checks" -ge 10 ] && echo yes)"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# What the README shows is what the program prints, whatever the locale.
. "$(dirname "$0")/../claims.sh"

# Each example into files of its own: N.command, N.expected; and the files that examples read.
awk '
    /^```csv [a-z.]*$/ { file = $2; next }
    /^```$/ { file = "" }
    file { print > file; next }
    /^```console$/ { inside = 1; next }
    /^```$/ { inside = 0; next }
    !inside { next }
    /^\$ / { n++; print substr($0, 3) > (n ".command"); printf "" > (n ".expected"); next }
    { print > (n ".expected") }' "$here/../../../cli/README.md"

use_decimal_comma
for file in *.command; do
    called=$(cat "$file")
    arguments=${called#rwedge }
    "$rwedge" $arguments >out 2>&1
    same "output" "$(cat "${file%.command}.expected")" "$(cat out)"
done
same "there are examples" yes "$([ "$checks" -ge 10 ] && echo yes)"

finish

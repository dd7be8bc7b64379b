# SPDX-License-Identifier: GPL-3.0-or-later
# Progress is shown on a terminal only, and only after half a second.
. "$(dirname "$0")/../claims.sh"

script -qec true /dev/null >/dev/null 2>&1 </dev/null || skip "script(1) is not here to lend a terminal"
command -v timeout >/dev/null || skip "timeout(1) is not here"
export rwedge # for the shell on the terminal, whatever is in the path
long="table elastic-limit --friction 0:0.8:0.0000001"

# on_terminal COMMAND: runs it on a terminal; what that got is in the file "screen".
on_terminal() {
    called=$1
    script -qec "$1" /dev/null </dev/null >screen 2>/dev/null
}
shown() {
    tr '\r' '\n' <screen | grep -c 'rwedge table: [0-9]* of 80000010 rows'
}
ends_by_erasing() {
    same "the line is erased" 1 "$(tr '\r' '\n' <screen | grep -c "^$(printf '\033')\[K")"
}

# Long enough on any machine: it is stopped after a second or two.
on_terminal "timeout -s TERM 2 \"\$rwedge\" $long -o long.csv"
same "shows progress" yes "$([ "$(shown)" -gt 2 ] && echo yes)"
ends_by_erasing
on_terminal "timeout -s TERM 1 \"\$rwedge\" $long --quiet -o long.csv"
same "--quiet shows none" 0 "$(shown)"
on_terminal "timeout -s TERM 1 \"\$rwedge\" $long 2>messages -o long.csv"
same "none in a file" 0 "$(grep -c 'of 80000010 rows' messages)"
on_terminal "timeout -s TERM 2 \"\$rwedge\" $long | tail -n 1"
same "shows progress when rows go into a pipe" yes "$([ "$(shown)" -gt 2 ] && echo yes)"
on_terminal "timeout -s TERM 1 \"\$rwedge\" $long"
same "none among rows on the terminal" 0 "$(shown)"

# Done within half a second: not a byte.
on_terminal "\"\$rwedge\" table contact-law -o short.csv"
same "short work shows none" "" "$(cat screen)"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# Progress is shown on a terminal only, and only after half a second.
. "$(dirname "$0")/../claims.sh"

script -qec true /dev/null >/dev/null 2>&1 </dev/null || skip "script(1) is not here to lend a terminal"
command -v timeout >/dev/null || skip "timeout(1) is not here"
export rwedge # for the shell on the terminal, whatever is in the path
long="table elastic-limit --threads 1 --friction 0:0.8:0.0000001"

# on_terminal NAME COMMAND: runs it on a terminal; what that gets is in the file of that name.
on_terminal() {
    script -qec "$2" /dev/null </dev/null >"$1" 2>/dev/null
}
shown() {
    tr '\r' '\n' <"$1" | grep -c 'rwedge table: [0-9]* of 80000010 rows'
}

# Long enough on any machine: each is stopped after two seconds.
stopped="timeout -s TERM 2 \"\$rwedge\" $long"
on_terminal usual "$stopped -o long.csv" &
on_terminal quiet "$stopped --quiet -o quiet.csv" &
on_terminal file "$stopped 2>messages -o file.csv" &
on_terminal pipe "$stopped | tail -n 1" &
on_terminal rows "$stopped" &
wait
called=$stopped
same "shows progress" yes "$([ "$(shown usual)" -gt 2 ] && echo yes)"
same "the line is erased" 1 "$(tr '\r' '\n' <usual | grep -c "^$(printf '\033')\[K")"
same "--quiet shows none" 0 "$(shown quiet)"
same "none in a file" 0 "$(shown messages)"
same "shows progress when rows go into a pipe" yes "$([ "$(shown pipe)" -gt 2 ] && echo yes)"
same "none among rows on the terminal" 0 "$(shown rows)"

# Done within half a second: not a byte.
on_terminal short "\"\$rwedge\" table contact-law -o short.csv"
same "short work shows none" "" "$(cat short)"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# System calls on the file that is written fail in turn, or a signal arrives with them. What must hold:
#   - Either the old file is there, or the whole new one.
#   - If it is the old one, the status is not 0, and a line says why.
#   - No unfinished file is left, except after SIGKILL.
. "$(dirname "$0")/../claims.sh"

command -v strace >/dev/null || skip "strace is not here"
strace -o /dev/null true 2>/dev/null || skip "this machine does not let strace trace"
ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0 # which cannot be done under strace
export ASAN_OPTIONS
table="table max-tension --a-over-b 1 --friction 0:1:0.0003"
bodies="--E1 200e3 --nu1 0.3 --theta 0.01"
echo old >old
mkdir files
printf 'a,P,f,note\n2,2000,0.3,"x, y"\n1,100,0.1,b\n' >in.csv
"$rwedge" $table >new

# fail CALL FAULT WHEN COMMAND...: the call fails as strace has it.
fail() {
    call=$1 fault=$2 when=$3
    shift 3
    called="rwedge $* -o files/t, $call number $when: $fault"
    cp old files/t
    status=0
    strace -o trace -e "trace=$call" -e "inject=$call:$fault:when=$when" "$rwedge" "$@" -o files/t >out 2>err || status=$?
    same "the call was reached" yes "$(grep -q -e INJECTED -e '+++ killed' -e '--- SIG' trace && echo yes)"
}
file_is() { # old or new
    same "the file is the $1 one" "" "$(cmp files/t "$1" 2>&1)"
    same "no unfinished file" 0 "$(find files -name '.rwedge-*' | wc -l | tr -d ' ')"
}

# says CALL ERROR WHEN TEXT STATE: what is said of the file, and what it is.
says() {
    fail "$1" "error=$2" "$3" $table
    status_is 1
    message_is "rwedge table: files/t: $4"
    file_is "$5"
}
for number in 1 2 3; do
    says write ENOSPC $number "No space left on device" old
    says write EIO $number "Input/output error" old
done
says fsync EIO 1 "Input/output error" old
says rename EACCES 1 "Permission denied" old
says fchmod EPERM 1 "Operation not permitted" old

# An interrupted write is no failure.
for harmless in write:EINTR:1 write:EINTR:2; do
    rest=${harmless#*:}
    fail "${harmless%%:*}" "error=${rest%:*}" "${rest#*:}" $table
    status_is 0
    message_is ""
    file_is new
done

# A signal at each step: the call is made, and the signal is there when it returns.
for signal in INT:130 TERM:143 HUP:129 KILL:137; do
    for step in write:1 write:3 fsync:1 rename:1; do
        fail "${step%:*}" "signal=${signal%:*}" "${step#*:}" $table
        status_is "${signal#*:}"
        [ "${signal%:*}" != KILL ] || rm -f files/.rwedge-*
        grep -q 'as it was before' err && same "as it was before" "" "$(cmp files/t old 2>&1)"
        cmp -s files/t old && file_is old || file_is new
    done
done

# A disk that is full and stays so, also for libxlsxwriter's temporary files.
if "$rwedge" table contact-law -o law.xlsx 2>/dev/null; then
    for number in 1 6 11; do
        fail write error=ENOSPC "$number+" solve $bodies --k 300 --input in.csv --format xlsx
        status_is 1
        file_is old
    done
fi
finish

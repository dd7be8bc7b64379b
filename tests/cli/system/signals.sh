# SPDX-License-Identifier: GPL-3.0-or-later
# A signal arrives while a table is written. The program ends by the signal, the old file stays, and no unfinished file is left.
. "$(dirname "$0")/../claims.sh"

env --default-signal=INT true 2>/dev/null || skip "env cannot reset signals"
long="table elastic-limit --friction 0:0.8:0.0000001"
mkdir files

# The shell would start a background program with SIGINT ignored; env sets it to its default. Waits, at most ten seconds, until the
# unfinished file is there, or rows.
start() { # signal disposition, output...
    disposition=$1
    shift
    called="rwedge $long $*, $disposition"
    echo old >files/old.csv
    rm -f err out
    env "--$disposition" "$rwedge" $long "$@" >out 2>err &
    process=$!
    for _ in $(seq 200); do
        [ -s out ] || [ -n "$(find files -name '.rwedge-*')" ] && return
        sleep 0.05
    done
}
ends_by() { # SIGNAL STATUS
    kill -s "$1" "$process"
    status=0
    wait "$process" 2>/dev/null || status=$?
    status_is "$2"
    same "old file" old "$(cat files/old.csv)"
    same "files" old.csv "$(ls -A files)"
}

for signal in INT:130 TERM:143 HUP:129 XCPU:152; do
    name=${signal%:*}
    start "default-signal=$name" -o files/old.csv
    same "unfinished files on the way" 1 "$(find files -name '.rwedge-*' | wc -l | tr -d ' ')"
    ends_by "$name" "${signal#*:}"
    message_is "rwedge table: stopped by SIG$name; the output file is as it was before"
done

# A signal that is ignored from the start, as nohup does with SIGHUP, stays so.
start ignore-signal=HUP -o files/old.csv
kill -s HUP "$process"
sleep 0.2
same "still running" yes "$(kill -0 "$process" 2>/dev/null && echo yes)"
ends_by TERM 143

# On standard output.
start default-signal=TERM
ends_by TERM 143
message_is "rwedge table: stopped by SIGTERM; the output is not complete"

finish

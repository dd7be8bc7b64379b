# SPDX-License-Identifier: GPL-3.0-or-later
# A signal arrives while a table is written. The program ends by the signal, the old file stays, and no unfinished file is left.
. "$(dirname "$0")/../claims.sh"

env --default-signal=INT true 2>/dev/null || skip "env cannot reset signals"
long="table elastic-limit --friction 0:0.8:0.0000001"

# The shell would start a background program with SIGINT ignored; env sets it to its default.
start() { # signal disposition, output...
    disposition=$1
    shift
    rm -f err
    env "--$disposition" "$rwedge" $long "$@" >out 2>err &
    process=$!
}

# Waits until the unfinished file is there, at most ten seconds.
wait_for_start() {
    for _ in $(seq 200); do
        [ -n "$(find files -name '.rwedge-*')" ] && return
        sleep 0.05
    done
}

# ends_by SIGNAL STATUS
ends_by() {
    kill -s "$1" "$process"
    status=0
    wait "$process" 2>/dev/null || status=$?
    status_is "$2"
}
# goes_on SIGNAL...: they end nothing.
goes_on() {
    for signal; do
        kill -s "$signal" "$process"
    done
    sleep 0.2
    same "still running" yes "$(kill -0 "$process" 2>/dev/null && echo yes)"
}

mkdir files
for signal in INT:130 TERM:143 HUP:129; do
    name=${signal%:*}
    called="rwedge $long -o files/old.csv, SIG$name"
    echo old >files/old.csv
    start "default-signal=$name" -o files/old.csv
    wait_for_start
    same "unfinished files on the way" 1 "$(find files -name '.rwedge-*' | wc -l | tr -d ' ')"
    ends_by "$name" "${signal#*:}"
    message_is "rwedge table: stopped by SIG$name; the output file is as it was before"
    same "old file" old "$(cat files/old.csv)"
    same "files" old.csv "$(ls -A files)"
done

# SIGPIPE and SIGXFSZ come with an error of write(), which is reported: by themselves they end nothing.
called="rwedge $long -o files/old.csv, SIGPIPE and SIGXFSZ"
start default-signal=TERM -o files/old.csv
wait_for_start
goes_on PIPE XFSZ
ends_by TERM 143
same "old file" old "$(cat files/old.csv)"

# A signal that is ignored from the start, as nohup does with SIGHUP, stays so.
called="rwedge $long -o files/old.csv, SIGHUP ignored"
start ignore-signal=HUP -o files/old.csv
wait_for_start
goes_on HUP
ends_by TERM 143

# SIGKILL cannot be answered: the unfinished file stays, and the old one too.
called="rwedge $long -o files/old.csv, SIGKILL"
start default-signal=TERM -o files/old.csv
wait_for_start
ends_by KILL 137
same "old file" old "$(cat files/old.csv)"
rm -f files/.rwedge-*

# A standard stream that is closed from the start is not mistaken for the file.
if [ -d /proc/self/fd ]; then
    called="rwedge $long -o files/old.csv >&- 2>&-"
    "$rwedge" $long -o files/old.csv >&- 2>&- &
    process=$!
    wait_for_start
    same "stdout" /dev/null "$(readlink "/proc/$process/fd/1")"
    same "stderr" /dev/null "$(readlink "/proc/$process/fd/2")"
    ends_by TERM 143
fi

# On standard output.
called="rwedge $long, SIGTERM"
start default-signal=TERM
for _ in $(seq 200); do
    [ -s out ] && break
    sleep 0.05
done
ends_by TERM 143
message_is "rwedge table: stopped by SIGTERM; the output is not complete"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# Every system call on the files of a run fails in turn, or a signal arrives with it. What must hold:
#   - Either the old file is there, or the whole new one.
#   - If it is the old one, the status is not 0, and a line says why.
#   - No unfinished file is left, except after SIGKILL.
# libxlsxwriter writes its parts to temporary files, and does not check whether that worked. A single failure there may lose cells.
# A disk that stays full does not.
#
#     faults.sh PROGRAM REFERENCES [MOST]    MOST: how many calls of one kind in a command are tried (default 2; 0: all). From 6 on
#                                            a figure and a field are tried too.
most=${3:-2}
. "$(dirname "$0")/../claims.sh"

command -v strace >/dev/null || skip "strace is not here"
strace -o /dev/null true 2>/dev/null || skip "this machine does not let strace trace"
ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0 # which cannot be done under strace
export ASAN_OPTIONS
echo old >old
mkdir files
printf 'a,P,f,note\n2,2000,0.3,"x, y"\n1,100,0.1,b\n' >in.csv
runs=0 excuse= lost=0 varies= missed=0
trace() { # how to inject, or nothing; the command follows
    calls=openat,read,pread64,write,pwrite64,writev,lseek,fsync,fdatasync,ftruncate,rename,renameat,unlink,close,fchmod
    timeout 60 strace -o trace -e "trace=$calls,readlink,access,fcntl,pipe2" "$@"
}

# Calls before this one are the loader's: main() looks at the standard streams first.
first_of_main() { # call: how many of them the loader made
    awk -v call="$1(" '/^fcntl\(0, F_GETFD/ { exit } index($0, call) == 1 { n++ } END { print n + 0 }' plain
}

# The file is the old one or the new one; what else holds depends on the status.
judge() { # kind of fault
    left=$(find files -name '.rwedge-*' | wc -l | tr -d ' ')
    [ "$1" = KILL ] && rm -f files/.rwedge-*
    [ "$1" = KILL ] || same "no unfinished file" 0 "$left"
    state=neither
    cmp -s files/t new && state=new
    cmp -s files/t old && state=old
    case $1.$status$excuse in
    *.0.excused) [ $state = new ] || lost=$((lost + 1)) ;;
    KILL.137* | TERM.143* | INT.130* | HUP.129*) same "the file is whole" yes "$([ $state != neither ] && echo yes)" ;;
    *.0) same "done: the file is the new one" new "$state" ;;
    *.1*)
        same "not done: the file is whole" yes "$([ $state != neither ] && echo yes)"
        same "a line says why" "1 line" "$(grep -c '^rwedge' err) line"
        ;;
    *) same "status" "0, 1 or that of the signal" "$status" ;;
    esac
    grep -q 'as it was before' err && same "as it was before" old "$state"
    return 0
}

inject() { # call, fault as strace has it, its kind, number; the command follows
    call=$1 fault=$2 kind=$3 number=$4
    shift 4
    called="rwedge $* -o files/t, $call number $number: $fault"
    cp old files/t
    status=0
    trace -e "inject=$call:$fault:when=$number" "$rwedge" "$@" -o files/t >out 2>err || status=$?
    reached=$(grep -q -e INJECTED -e '+++ killed' -e "--- SIG$kind" trace && echo yes || echo no)
    case $varies$reached in
    yesno) missed=$((missed + 1)) ;;
    *) same "the call was reached" yes "$reached" ;;
    esac
    judge "$kind"
    runs=$((runs + 1))
}

# Each call of main(), or some of them in equal steps, the first and the last among them.
numbers() { # first last
    awk -v a="$1" -v b="$2" -v most="$most" 'BEGIN {
        n = b - a + 1; m = most == 0 || n < most ? n : most
        for (i = 0; i < m; i++) print a + (m > 1 ? int(i * (n - 1) / (m - 1)) : 0) }'
}

every() { # the command
    rm -f files/t
    trace "$rwedge" "$@" -o files/t >out 2>err
    cp files/t new
    mv trace plain
    before=$runs
    for call in openat read pread64 write pwrite64 writev lseek fsync fdatasync ftruncate rename renameat unlink close fchmod \
        readlink access pipe2; do
        loaders=$(first_of_main "$call")
        all=$(grep -c "^$call(" plain)
        [ "$all" -gt "$loaders" ] || continue
        # of a pipe whose end stays open, as injected, no reader sees the end; no kernel does that
        [ "$call$varies" != closeyes ] || continue
        case $call in
        read | write | pwrite64 | writev) faults="error=EIO error=ENOSPC error=EINTR signal=KILL signal=TERM" ;;
        fsync | rename | close | openat)
            faults="error=EIO error=ENOSPC error=EINTR signal=KILL signal=TERM signal=INT signal=HUP"
            ;;
        *) faults="error=EIO signal=TERM" ;;
        esac
        for number in $(numbers $((loaders + 1)) "$all"); do
            for fault in $faults; do
                kind=${fault#*=}
                inject "$call" "$fault" "$kind" "$number" "$@"
            done
        done
    done
    echo "$((runs - before)) runs of rwedge $*"
}

bodies="--E1 200e3 --nu1 0.3 --theta 0.01"
every table max-tension --a-over-b 1 --friction 0:1:0.0003
every solve $bodies --k 300 --input in.csv
every solve $bodies --k 300 --input in.csv --format json
[ "$most" -gt 0 ] && [ "$most" -lt 6 ] || every field --a-over-b 0.3 --f 0.3 --format vtk
if "$rwedge" workbook -o book.xlsx 2>/dev/null; then
    excuse=.excused # libxlsxwriter does not look at what becomes of its temporary files
    every solve $bodies --k 300 --input in.csv --format xlsx
    excuse=
    echo "$lost losses of libxlsxwriter where one write of its own failed and the next did not"
fi
if command -v gnuplot >/dev/null 2>&1 && { [ "$most" -eq 0 ] || [ "$most" -ge 6 ]; }; then
    varies=yes # in how many pieces gnuplot's picture arrives
    every figure 4
    varies=
    same "most of the calls of a figure were reached" yes "$([ "$missed" -lt $(((runs - before) / 2)) ] && echo yes)"
fi
echo "$runs runs in all"

# A disk that is full and stays so.
if [ -f book.xlsx ]; then
    for number in $(seq 1 4 40); do
        called="rwedge solve ... --format xlsx, full from write number $number on"
        cp old files/t
        status=0
        strace -o trace -e trace=write -e "inject=write:error=ENOSPC:when=$number+" \
            "$rwedge" solve $bodies --k 300 --input in.csv --format xlsx -o files/t >out 2>err || status=$?
        grep -q INJECTED trace || break
        status_is 1
        same "the file is the old one" "" "$(cmp files/t old 2>&1)"
    done
fi

# What is said of the file.
table="table max-tension --a-over-b 1 --friction 0:1:0.0003"
says() { # call error number text state
    cp old files/t
    "$rwedge" $table >new
    called="rwedge $table -o files/t, $1 number $3 fails with $2"
    status=0
    strace -o trace -e "trace=$1" -e "inject=$1:error=$2:when=$3" "$rwedge" $table -o files/t >out 2>err || status=$?
    status_is 1
    message_is "rwedge table: files/t: $4"
    same "the file is the $5 one" "" "$(cmp files/t "$5" 2>&1)"
}
says write ENOSPC 1 "No space left on device" old
says write EIO 2 "Input/output error" old
says fsync EIO 1 "Input/output error" old
says fsync EIO 2 "Input/output error" new
says rename EACCES 1 "Permission denied" old
says fchmod EPERM 1 "Operation not permitted" old

# Neither an interrupted write nor a folder that cannot be synced is a failure.
for harmless in write:EINTR:1 write:EINTR:2 fsync:EINVAL:2; do
    cp old files/t
    called="rwedge $table -o files/t, $harmless"
    rest=${harmless#*:}
    status=0
    strace -o trace -e "trace=${harmless%%:*}" -e "inject=${harmless%%:*}:error=${rest%:*}:when=${rest#*:}" \
        "$rwedge" $table -o files/t >out 2>err || status=$?
    status_is 0
    message_is ""
    same "the file is the new one" "" "$(cmp files/t new 2>&1)"
done
finish

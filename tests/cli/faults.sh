# SPDX-License-Identifier: GPL-3.0-or-later
# Every system call that writes a file fails once, each time it is made: the old file or the new one is there, whole,
# the status is not 0, a line says why, and no unfinished file is left.
. "$(dirname "$0")/claims.sh"

strace -o /dev/null true 2>/dev/null || skip "strace cannot trace here"
ASAN_OPTIONS=detect_leaks=0 # which cannot be done under strace
export ASAN_OPTIONS
table="table max-tension --a-over-b 1 --friction 0:1:0.0003"
"$rwedge" $table >new || exit 1
echo old >old
mkdir files

# inject CALL ERROR N: a run in which the Nth such call, counted from the first on the unfinished file, fails.
inject() {
    called="rwedge $table -o files/t.csv, $1 number $3 fails with $2"
    cp old files/t.csv
    status=0
    strace -o trace -e "trace=$1" -e "inject=$1:error=$2:when=$3" "$rwedge" $table -o files/t.csv >out 2>err ||
        status=$?
    same "the call was reached" 1 "$(grep -c INJECTED trace)"
    same "files" t.csv "$(ls -A files)"
}

# fails CALL ERROR N TEXT STATE: what it says, and which file is there after it, "old" or "new".
fails() {
    inject "$1" "$2" "$3"
    status_is 1
    message_is "rwedge table: files/t.csv: $4"
    same "the file is the $5 one" "" "$(cmp files/t.csv "$5" 2>&1)"
}

harmless() {
    inject "$1" "$2" "$3"
    status_is 0
    message_is ""
    same "the file is the new one" "" "$(cmp files/t.csv new 2>&1)"
}

strace -o trace -e trace=write "$rwedge" $table -o files/t.csv
writes=$(grep -c '^write(' trace)
same "there are several writes" yes "$([ "$writes" -gt 1 ] && echo yes)"
for n in $(seq "$writes"); do
    fails write ENOSPC "$n" "No space left on device" old
    fails write EIO "$n" "Input/output error" old
done
fails fsync EIO 1 "Input/output error" old
fails fsync EIO 2 "Input/output error" new
fails rename EACCES 1 "Permission denied" old
fails fchmod EPERM 1 "Operation not permitted" old

# An interrupted write goes on; a folder that cannot be synced is no failure.
harmless write EINTR 1
harmless write EINTR "$writes"
harmless fsync EINVAL 2

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# -o FILE: it is written whole or not at all. What happens to the output when something is in the way.
. "$(dirname "$0")/../claims.sh"

small="table contact-law --a-over-b 1 --digits 3"
text="a_over_b,AP_over_theta_b,AP_over_theta_a,peak_pressure,transition_pressure
1,1.57,1.57,1,0"
large="table max-tension --a-over-b 1 --friction 0:1:0.0001"
mkdir files
files_are() {
    same "files" "$1" "$(ls -A files | paste -s -d ' ' -)"
}

# Writes what standard output would have got, over an old file or none.
prints "$text" $small
prints "" $small -o files/new.csv
same "new file" "$text" "$(cat files/new.csv)"
echo old >files/new.csv
prints "" $small --output=files/new.csv
same "replaced file" "$text" "$(cat files/new.csv)"
prints "$text" $small -o -
files_are new.csv
(cd files && "$rwedge" $small -o here.csv)
files_are "here.csv new.csv"
rm files/here.csv

# Any name will do, of what is written and of what is read; a message stays one line.
odd="a #b;c${newline}d.csv"
prints "" $small -o "files/$odd"
same "the odd name" "$text" "$(cat "files/$odd")"
printf 'P,f\n100,0.1\n' >"$odd"
does solve --input "$odd" --E1 2e5 --nu1 0.3 --theta 0.1 --a 1 -o "files/$odd"
same "its row" 100,0.1, "$(sed -n 2p "files/$odd" | cut -c 1-8)"
cannot "none/a #b;c?d.csv: No such file or directory" solve --input "none/$odd" --E1 2e5
rm "files/$odd"

# Permissions: those of open(), or the old file's.
rm files/new.csv
shell '(umask 027 && "$rwedge" $small -o files/new.csv)'
same "permissions of a new file" "-rw-r-----" "$(ls -l files/new.csv | cut -c 1-10)"
chmod 604 files/new.csv
run $small -o files/new.csv
same "permissions of a replaced file" "-rw----r--" "$(ls -l files/new.csv | cut -c 1-10)"

# A link stays, and what it leads to is replaced.
mkdir elsewhere
echo old >elsewhere/real.csv
ln -s ../elsewhere/real.csv files/link.csv
does $small -o files/link.csv
same "link" "../elsewhere/real.csv" "$(readlink files/link.csv)"
same "file behind the link" "$text" "$(cat elsewhere/real.csv)"
ln -s loop.csv files/loop.csv
cannot "files/loop.csv: Too many levels of symbolic links" $small -o files/loop.csv
rm files/link.csv files/loop.csv

# A pipe or a device is written to, not replaced.
prints "" $small -o /dev/null
prints "$text" $small -o /dev/stdout

# What cannot be written to: status 1, one line, nothing left behind.
cannot "files: Is a directory" $small -o files
cannot "nowhere/new.csv: No such file or directory" $small -o nowhere/new.csv
cannot "files/new.csv/more.csv: Not a directory" $small -o files/new.csv/more.csv
files_are new.csv

# A full disk.
if [ -c /dev/full ]; then
    cannot "/dev/full: No space left on device" $small -o /dev/full
    shell '"$rwedge" $large >/dev/full'
    ended 1 "rwedge table: standard output: No space left on device"
fi

# A limit on the size of files, with the signal that comes with it.
echo old >files/new.csv
shell '(ulimit -f 8 && "$rwedge" $large -o files/new.csv)'
ended 1 "rwedge table: files/new.csv: File too large"
same "old file" old "$(cat files/new.csv)"
files_are new.csv

# A closed pipe, a closed standard output.
shell '{ "$rwedge" $large; echo $? >status; } | head -n 1'
status=$(cat status)
ended 1 "rwedge table: standard output: Broken pipe"
output_is "a_over_b,f,b_sigma_over_P,b_sigma_over_fP"

# With stderr closed, no message ends up in the file.
shell '"$rwedge" $small -o files/new.csv <&- >&- 2>&-'
status_is 0
same "file written without standard streams" "$text" "$(cat files/new.csv)"

# An output that is the input is refused before anything is written, whatever it is called.
contact="--E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --f 0.3"
printf 'P,Q\n2000,300\n' >input.csv
cp input.csv before.csv
ln -s input.csv symbolic.csv
ln input.csv hard.csv
input_stays() { # how the message calls it and its option
    status_is 2
    same "message" "--output $1: it is the file of --$2; allowed: another file" "$(sed 's/^rwedge [a-z]*: //' err)"
    same "the input" "" "$(cmp input.csv before.csv 2>&1)"
    same "no other file" "" "$(find . -name '.rwedge-*')"
}
for input in "solve --input" "profile --history" "field --history"; do
    run $input input.csv $contact -o input.csv
    input_stays input.csv "${input#* --}"
done
for name in "$PWD/input.csv" symbolic.csv hard.csv; do
    run solve --input input.csv $contact -o "$name"
    input_stays "$name" input
done
shell '"$rwedge" solve --input - $contact -o input.csv <input.csv'
input_stays input.csv input
shell '"$rwedge" solve --input input.csv $contact >>input.csv'
input_stays - input
does solve --input input.csv $contact -o beside.csv

# Protected files and folders; for root they are no obstacle, so another user is borrowed.
as_user=
if [ "$(id -u)" = 0 ]; then
    command -v setpriv >/dev/null 2>&1 && as_user="setpriv --reuid=65534 --regid=65534 --clear-groups"
    chmod 755 "$scratch"
    cp "$rwedge" "$scratch/rwedge" && chmod 755 "$scratch/rwedge"
    rwedge=$scratch/rwedge
fi
mkdir closed open
if { [ -n "$as_user" ] || [ "$(id -u)" != 0 ]; } && $as_user "$rwedge" --version >/dev/null 2>&1; then
    echo old | tee closed/old.csv >open/old.csv
    chmod 777 open
    chmod 444 open/old.csv
    chmod 666 closed/old.csv
    chmod 555 closed
    for file in closed/old.csv closed/new.csv open/old.csv; do
        shell '$as_user "$rwedge" $small -o $file'
        ended 1 "rwedge table: $file: Permission denied"
    done
    same "files in the closed folder" old.csv "$(ls -A closed)"
    same "files in the open folder" old.csv "$(ls -A open)"
    same "old files" "old old" "$(cat closed/old.csv open/old.csv | paste -s -d ' ' -)"
    chmod 755 closed
fi

# As root: a file of another user and group. Whoever could not read it before cannot afterwards.
if [ "$(id -u)" = 0 ] && setpriv --reuid=65534 --regid=65534 --clear-groups true 2>/dev/null; then
    rm -f open/theirs.csv
    echo old >open/theirs.csv
    chown 1234:2000 open/theirs.csv
    chmod 646 open/theirs.csv
    shell 'setpriv --reuid=1235 --regid=1235 --groups 3000 "$rwedge" $small -o open/theirs.csv'
    same "what it becomes" "0 1235:1235 604" "$status $(stat -c '%u:%g %a' open/theirs.csv)"
fi

finish

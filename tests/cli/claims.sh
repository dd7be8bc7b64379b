# SPDX-License-Identifier: GPL-3.0-or-later
# What every script shares: assertions that print the expected and the actual value, a scratch folder, comparison of numbers with
# a tolerance. A script is called with the program and the folder of reference values, and ends with "finish".
# shellcheck shell=sh disable=SC2034

if [ $# -lt 2 ]; then
    echo "usage: $0 PROGRAM REFERENCE_FOLDER" >&2
    exit 1
fi
rwedge=$(realpath "$1")
data=$(realpath "$2")
here=$(cd "$(dirname "$0")" && pwd)
LC_ALL=C
export LC_ALL
checks=0
failures=0
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
tab=$(printf '\t')
newline='
'

# run ARGUMENTS...: the program; its output in the files out and err, its exit status in $status.
run() {
    called="rwedge $*"
    status=0
    "$rwedge" "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
}

# shell TEXT: the same, of a command line.
shell() {
    called=$1
    status=0
    eval "$1" >"$scratch/out" 2>"$scratch/err" || status=$?
}

# memory_of KILOBYTES: sets $limit for ulimit -v, where that can be (an address sanitizer reserves more than any limit).
memory_of() {
    limit=$1
    (ulimit -v "$limit" && "$rwedge" --version) >/dev/null 2>&1 || limit=unlimited
}

# use_decimal_comma: the locale has one from here on, where that can be made. No number may change by it.
use_decimal_comma() {
    if localedef -i de_DE -f UTF-8 "$scratch/de_DE.UTF-8" 2>/dev/null; then
        LOCPATH=$scratch LC_ALL=de_DE.UTF-8
        export LOCPATH
    else
        echo "SKIPPED: a locale with a decimal comma, for lack of localedef or its de_DE"
    fi
}

# does ARGUMENTS...: the same, with status 0; and with nothing on stderr.
does() {
    run "$@"
    status_is 0
}
does_quietly() {
    does "$@"
    message_is ""
}

# kept FILE ARGUMENTS...: the same, and the output stays in a file. prints_kept WHAT FILE ARGUMENTS...: the output is that file.
kept() {
    file=$1
    shift
    does "$@"
    cp out "$file"
}
prints_kept() {
    what=$1 file=$2
    shift 2
    does "$@"
    same "$what" "" "$(cmp "$file" out 2>&1)"
}

# Every assertion comes down to this: whether the two texts are the same.
same() { # what expected got
    checks=$((checks + 1))
    [ "$2" = "$3" ] && return
    failures=$((failures + 1))
    printf 'FAILED: %.160s: %s\n  expected: %s\n  got:      %s\n' "$called" "$1" "$2" "$3"
}

status_is() {
    same "exit status" "$1" "$status"
}

output_is() {
    same "output" "$1" "$(cat "$scratch/out")"
}

# The whole of stderr: one line, or nothing.
message_is() {
    same "message" "$1" "$(cat "$scratch/err")"
}

message_has() {
    case $(cat "$scratch/err") in
    *"$1"*) same "message has '$1'" yes yes ;;
    *) same "message" "...$1..." "$(cat "$scratch/err")" ;;
    esac
}

# prints EXPECTED ARGUMENTS...: the output, nothing on stderr, status 0.
prints() {
    expected=$1
    shift
    does_quietly "$@"
    output_is "$expected"
}

# refuses MESSAGE ARGUMENTS...: a mistake on the command line is one line, no output, status 2. The line begins with the command, if
# the message does not begin with "rwedge" itself.
refuses() {
    fails_with_status 2 "$@"
    output_is ""
}
fails_with_status() {
    status_expected=$1
    case $2 in
    rwedge*) expected=$2 ;;
    *) expected="rwedge $3: $2" ;;
    esac
    shift 2
    run "$@"
    ended "$status_expected" "$expected"
}

# ended STATUS MESSAGE
ended() {
    status_is "$1"
    message_is "$2"
}

# close_rows WHAT RELATIVE ABSOLUTE: whether the two columns of the file "both", expected and got, agree row by row. Without
# rows, what the program said last tells why.
close_rows() {
    worst=$(awk -v relative="$2" -v absolute="$3" '
        function abs(v) { return v < 0 ? -v : v }
        NF != 2 || $1 == "-" || $2 == "-" { print "row " NR ": not two numbers: " $0; bad = 1; exit }
        !(abs($2 - $1) <= relative * abs($1) + absolute) { print "row " NR ": expected " $1 ", got " $2; bad = 1; exit }
        END { if (!bad) print (NR > 0 ? "close" : "no rows") }' "$scratch/both")
    [ "$worst" != "no rows" ] || worst="no rows; exit status ${status-}, stderr: $(head -n 1 "$scratch/err")"
    same "$1" close "$worst"
}

# close_to WHAT EXPECTED GOT RELATIVE: two numbers.
close_to() {
    echo "${2:--} ${3:--}" >"$scratch/both"
    close_rows "$1" "$4" 0
}

# value NAME: of one contact's list of quantities in the file out.
value() {
    awk -F, -v name="$1" '$1 == name { print $2 }' "$scratch/out"
}

# cannot MESSAGE ARGUMENTS...: what cannot be done is the same with status 1.
cannot() {
    fails_with_status 1 "$@"
}

# A cylinder that several scripts press, as Nowell and Hills did: off_centre.sh has its sizes.
specimen="--E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.3"

# What reads a file whose columns ';' separates.
semicolons='--decimal-comma reads that, or, where numbers have a point, a first line "sep=;"'

# column NAME FILE: the cells of a CSV file below that name; empty ones as "-".
column() {
    awk -F, -v name="$1" '
        NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; if (!c) exit; next }
        { print $c == "" ? "-" : $c }' "$2"
}

# by_name PROGRAM FILE [AWK-OPTION...]: awk on CSV, with a variable of the name of each column: $sxx is its cell.
by_name() {
    program=$1 table=$2
    shift 2
    # shellcheck disable=SC2046
    awk -F, $(sed q "$table" | tr , '\n' | awk '/^[A-Za-z_][A-Za-z_0-9]*$/ && $0 != "length" { print "-v", $0 "=" NR }') "$@" \
        "$program" "$table"
}

# cell NAME ROW: of the CSV file out; the rows below the header are 1, 2 and so on, the last is $.
cell() {
    column "$1" out | sed -n "$2p"
}

# part_of FILE NAME...: the rows of these columns of a CSV file, in this order, without the header.
part_of() {
    table=$1
    shift
    awk -F, -v names="$*" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; n = split(names, name, " "); next }
        { for (k = 1; k <= n; k++) printf "%s%s", $at[name[k]], k < n ? "," : "\n" }' "$table"
}

# skip_without_xlsx STATUS MESSAGE: after a run that would have written XLSX.
skip_without_xlsx() {
    [ "$status" -eq "$1" ] || return 0
    message_is "$2: this build cannot write XLSX: it was made without libxlsxwriter (on Debian and Ubuntu the package libxlsxwriter-dev)"
    same "no file" "" "$(ls ./*.xlsx 2>&1 | grep -v "No such file")"
    [ "$failures" -eq 0 ] || finish
    skip "this build has no libxlsxwriter"
}

skip() {
    echo "SKIPPED: $1"
    exit 77
}

finish() {
    echo "$checks checks, $failures failed"
    [ "$failures" -eq 0 ] && [ "$checks" -gt 0 ]
    exit $?
}

# SPDX-License-Identifier: GPL-3.0-or-later
# Every allocation of the tool fails in turn: only once, or from then on. Then one of two things must hold:
#   - The tool ends by itself with status 1. One line says why, and the old file is there.
#   - The tool can do without the memory, and the whole new file is there.
# No unfinished file is left. libxlsxwriter does not survive lack of memory; its failures are counted here.
#
#     allocations.sh PROGRAM REFERENCES PRELOADED [MOST]     MOST: how many allocations of a command are tried (default 40; 0: all)
preloaded=$(realpath "$3") most=${4:-40}
. "$(dirname "$0")/../cli/claims.sh"

[ -f "$preloaded" ] || skip "failing allocations cannot be tried here: not glibc, or under a sanitizer"
LD_PRELOAD=$preloaded FAIL_COUNT=$scratch/count "$rwedge" --version >/dev/null 2>&1
[ -s count ] || skip "the allocations of this program cannot be made to fail: not glibc, or sanitized"
mkdir files
printf 'a,P,f,note\n2,2000,0.3,"x, y"\n1,100,0.1,b\n-1,2,3,c\n' >in.csv
printf 'P,Q\n1,0\n1,0.2\n0.5,0\n' >history.csv
echo old >old
survived=0 crashes= varies= missed=0

# fail WHICH ALL-AFTER: one run of "$@" that was counted before.
fail() { # k all command...
    which=$1 all=$2
    shift 2
    called="rwedge $* -o files/t, allocation $which fails${all:+ and all after it}"
    cp old files/t
    rm -f mark
    status=0
    env LD_PRELOAD="$preloaded" FAIL_AT="$which" FAIL_MARK="$scratch/mark" ${all:+FAIL_ALL=1} "$rwedge" "$@" -o files/t \
        >out 2>err || status=$?
    if [ -n "$varies" ] && [ ! -f mark ]; then
        missed=$((missed + 1))
    else
        same "the allocation was refused" yes "$([ -f mark ] && echo yes)"
    fi
    [ "$status" -eq 0 ] || refused=$((refused + 1))
    # libxlsxwriter itself may crash: the unfinished file stays
    if [ -n "$crashes" ] && [ "$status" -eq 139 ]; then
        rm -f files/.rwedge-*
        crashed=$((crashed + 1)) status=1
        echo "rwedge: crash" >err
    fi
    same "files" t "$(ls -A files)"
    if [ "$status" -eq 0 ] && [ -n "$crashes" ] && ! cmp -s files/t new; then
        lost=$((lost + 1)) # libxlsxwriter leaves out what it has no memory for, and does not always say so
    elif [ "$status" -eq 0 ]; then
        same "the file is the whole new one" "" "$(cmp files/t new 2>&1)"
    else
        lines=$(grep -c -e '^rwedge' -e '^virtual memory exhausted' err) # popt's own words
        # the text of an option that could not be held counts as an option's
        grep -q '^rwedge.*: out of memory$' err && [ "$status" -eq 2 ] && status=1
        same "exit status" 1 "$status"
        same "the file is the old one, or the whole new one" whole "$(cmp -s files/t old || cmp -s files/t new && echo whole)"
        same "a line says why" "1 line" "$lines line"
    fi
    survived=$((survived + 1))
}

# every ARGUMENTS...: of one command.
every() {
    called="rwedge $* -o files/t"
    rm -f count files/t
    "$rwedge" "$@" -o files/t >/dev/null 2>&1
    mv files/t new || { same "output" there missing; return; }
    env LD_PRELOAD="$preloaded" FAIL_COUNT="$scratch/count" "$rwedge" "$@" -o files/t >/dev/null 2>&1
    allocations=$(cat count)
    same "it allocates" yes "$([ "${allocations:-0}" -gt 0 ] && echo yes)"
    before=$survived failed=$failures crashed=0 lost=0 refused=0
    # the first ones, at which programs differ, and then in growing steps
    for which in $(awk -v n="$allocations" -v most="$most" 'BEGIN {
        for (k = 1; k <= n; k += most == 0 || k < most / 2 ? 1 : 1 + int((n - most / 2) / (most / 2))) print k }'); do
        fail "$which" "" "$@"
        fail "$which" all "$@"
    done
    called="rwedge $* -o files/t"
    same "some runs end for lack of memory" yes "$([ "$refused" -gt 0 ] && echo yes)"
    echo "$((survived - before)) runs, $((failures - failed)) complaints: $allocations allocations of rwedge $*"
    [ -z "$crashes" ] || echo "    in them $crashed crashes and $lost losses of libxlsxwriter"
}

bodies="--E1 200e3 --nu1 0.3 --theta 0.01"
every solve $bodies --a 2 --P 2000 --Q 300 --f 0.3 --k 300
every solve $bodies --k 300 --input in.csv
every solve $bodies --k 300 --input in.csv --format json
if iconv -f UTF-8 -t UTF-16 in.csv >wide.csv 2>/dev/null; then
    every solve $bodies --k 300 --input wide.csv
fi
every table elastic-limit --a-over-b 0.1,0.2 --friction 0:0.3:0.1
every table stick-zone --a-over-b 0.1,0.2 --layout grid
every profile --a-over-b 0.3 --f 0.3 --q-over-fp 0.5
every profile $bodies --a 2 --f 0.3 --history history.csv
every field --a-over-b 0.3 --f 0.3 --x=-1:1:0.5 --y 0:1:0.5 --format vtk
every figure 4 --data
if "$rwedge" workbook -o book.xlsx 2>/dev/null; then
    crashes=allowed
    every solve $bodies --k 300 --input in.csv --format xlsx
    others=$most most=$((most > 64 ? 64 : most)) # of fifty thousand
    every workbook
    most=$others crashes=
fi
if command -v gnuplot >/dev/null 2>&1; then
    varies=yes # in how many pieces gnuplot's picture arrives
    every figure 4
    every figure field --a-over-b 0.3
    same "but for a few, the allocations of a figure were refused" yes "$([ "$missed" -lt 10 ] && echo yes)"
fi
finish

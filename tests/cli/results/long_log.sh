# SPDX-License-Identifier: GPL-3.0-or-later
# A long log with noise, of which the turning points are kept: in a time and a memory that grow as its rows do. A third argument is
# how many rows; a million, as of a day, is the long run, with a tension in phase too, whose loads are computed.
. "$(dirname "$0")/../claims.sh"

rows=${3:-20000}
pad="--E1 115000 --nu1 0.32 --radius 50 --f 0.6 --turning-points 0.02"
# log COLUMNS: cycles of a hundred rows, whose size changes slowly, with half a per cent of noise.
log() {
    awk -v n="$rows" -v with_sigma="$1" '
    function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand()) }
    BEGIN { srand(1); print "P,Q" (with_sigma ? ",sigma" : "")
        for (i = 0; i < n; i++) { s = sin(6.283185307179586 * i / 100) * (1 + 0.1 * sin(i / 50000))
            printf "%.6g,%.6g", 400 + 0.4 * normal(), 150 * s + 0.75 * normal()
            print with_sigma ? sprintf(",%.6g", 80 * s + 0.4 * normal()) : "" } }' >log.csv
}

# in_time MINUTES COMMAND...: with as much memory as the tool takes anyway, and 500 bytes a row.
in_time() {
    minutes=$1; shift
    memory_of $((rows * 500 / 1024 + 131072))
    began=$(date +%s)
    shell '(ulimit -v $limit; "$rwedge" '"$*"' log.csv $pad)'
    took=$(($(date +%s) - began))
    echo "$* of $rows rows: $took s"
    status_is 0
    same "$*: within $minutes minutes" yes "$([ $took -lt $((60 * minutes)) ] && echo yes || echo no)"
}

# A cycle has two turns.
log 0
in_time 2 history
left=$(sed -n 's/.*--turning-points: \([0-9]*\) of .*/\1/p' err)
close_to "turns" $((rows / 50)) "$left" 0.01
same "a row for each load that is left" "$left" "$(($(wc -l <out) - 1))"
in_time 2 fretting --at-worst

finish

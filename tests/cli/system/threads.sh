# SPDX-License-Identifier: GPL-3.0-or-later
# Tables computed by threads: the bytes do not depend on the number of threads, and memory does not grow with the rows.
. "$(dirname "$0")/../claims.sh"

# alike ARGUMENTS...: one thread, two, more than there is work for, and the usual number.
alike() {
    does_quietly table "$@" --threads 1
    mv out expected
    for threads in "--threads 2" "--threads 256" ""; do
        does_quietly table "$@" $threads
        same "bytes" "" "$(cmp expected out 2>&1)"
    done
}

# From a single row to many rounds, of which the last is full or not.
for last in 0.01 0.31 0.32 0.33 0.64; do
    alike elastic-limit --a-over-b 0.01:$last:0.01 --friction 0.1
done
alike elastic-limit --a-over-b 0:1.2:0.05 --friction 0:0.8:0.05 --layout grid
alike elastic-limit --a-over-b 0.1:1:0.1 --friction 0:0.8:0.05 --format json --digits 6
alike contact-law --a-over-b 0:1:0.0001

# Files of contacts: bad rows, misplaced quotes and all; the rows come in their order.
awk 'BEGIN { print "case,P,Q,note"; for (i = 1; i <= 1500; i++)
    printf "%d,%.6g,%.6g,%s\n", i, 50 + i / 10, i % 17 == 0 ? 500 : i / 100, i % 101 == 0 ? "a\"b" : i % 103 == 0 ? "x,y" : "n" }' >cases.csv
contact="--E1 210000 --nu1 0.3 --theta-deg 2 --radius 10 --f 0.3 --k 300"
does solve -i cases.csv $contact --threads 1
cp out expected
cp err said
same "rows" "$(seq 1500 | cksum)" "$(tail -n +2 out | cut -d , -f 1 | cksum)"
for threads in 3 64; do
    run solve -i cases.csv $contact --threads $threads
    same "bytes" "" "$(cmp expected out 2>&1)"
    same "messages" "" "$(cmp said err 2>&1)"
done
run solve -i - $contact --threads 2 <cases.csv
same "bytes from standard input" "" "$(cmp expected out 2>&1)"
refuses "--threads 0: must be a whole number from 1 to 256" solve -i cases.csv $contact --threads 0
refuses "--threads 2: needs --input" solve $contact --P 1 --threads 2
refuses "--threads 257: must be a whole number from 1 to 256" table contact-law --threads 257

# A series of tests: rows of every kind, and a log that several share.
printf 'P,Q\n300,60\n300,-60\n' >log.csv
awk 'BEGIN { print "P,Q_max,loads"; for (i = 1; i <= 150; i++)
    print i % 17 == 0 ? "300,,log.csv" : i % 19 == 0 ? "abc,1," : i % 23 == 0 ? 300 ",900," : 300 + i "," 20 + i % 50 "," }' >tests.csv
for threads in 1 3 64; do
    run fretting -i tests.csv --E1 210000 --nu1 0.3 --radius 50 --f 0.6 --threads $threads
    status_is 0
    [ $threads -gt 1 ] || { cp out expected; cp err said; }
    same "bytes of a series" "" "$(cmp expected out 2>&1)"
    same "messages of a series" "" "$(cmp said err 2>&1)"
done
same "rows of a series" 151 "$(wc -l <out)"

# Rows that nobody takes are not kept, and threads end with the table.
shell '"$rwedge" table elastic-limit --friction 0:0.8:0.0000001 --threads 8 | head -n 1'
output_is "a_over_b,f,nu,P_over_bk,x_over_b,y_over_b,branch,P_over_bk_subsurface,P_over_bk_surface"

# watch FIELD: the largest value of a field of its status while $process runs, in $most.
watch()
{
    most=0
    while now=$(sed -n "s/^$1:[^0-9]*\([0-9]*\).*/\1/p" "/proc/$process/status" 2>/dev/null) && [ -n "$now" ]; do
        [ "$now" -gt "$most" ] && most=$now
        sleep 0.01
    done
    wait "$process"
}

# The places of a cycle are shared out too: one thread once had them all. A script that calls the tool has one itself.
if [ -r /proc/self/status ] && [ "$(head -c 2 "$rwedge")" != '#!' ]; then
    awk 'BEGIN { print "P,Q"; for (i = 0; i < 24; i++) printf "135.75,%.6g\n", 38 * sin(0.9 * i) }' >loads.csv
    "$rwedge" fretting loads.csv --E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.3 --depth 0:0.1:0.002 --kappa 100 --lambda 100 --threads 3 \
        -o places.csv 2>/dev/null &
    process=$!
    watch Threads
    called="rwedge fretting, $(wc -l <places.csv) places by $most threads"
    same "threads" 3 "$most"
fi

# The most memory in kB while 500,000 rows are written, which would take more if they were kept. An address sanitizer adds its own.
if [ -r /proc/self/status ] && ! grep -q __asan_init "$rwedge"; then
    "$rwedge" table stick-zone --a-over-b 0.5 --q-over-fp 0:1:0.000002 --threads 4 >rows &
    process=$!
    watch VmHWM
    called="rwedge table stick-zone, 5 10^5 rows in $most kB"
    same "memory stays small" yes "$([ "$most" -gt 1000 ] && [ "$most" -lt 16000 ] && echo yes)"
fi

finish

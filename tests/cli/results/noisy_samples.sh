# SPDX-License-Identifier: GPL-3.0-or-later
# A measured log: each sample of a smooth cycle has the noise of an instrument, 0.5 % of P. Loads are gone through once by history,
# once more by fretting. A third argument is how many samples; 20000 are the long run.
. "$(dirname "$0")/../claims.sh"

samples=${3:-300}
pad="--E1 72100 --nu1 0.33 --flat 0.5 --radius 25 --f 0.5 --tolerance 1e-3"
awk -v n="$samples" 'BEGIN { srand(1); print "P,Q,sigma"
    for (i = 0; i < n; i++) { phase = 2 * 3.14159265358979 * i / 500
        printf "%.17g,%.17g,%.17g\n", 200 + 3.4 * (rand() - 0.5), 50 * sin(phase) + 0.8 * (rand() - 0.5), 30 * sin(phase - 0.3) + 0.5 * (rand() - 0.5) } }' >log.csv

# timed NAME ARGUMENTS...: sets NAME to the processor's seconds that it took. In less than 1 GB, all of which a limit counts.
memory_of 1000000
timed() {
    name=$1
    shift
    called="rwedge $*"
    status=0
    times >before
    (ulimit -v "$limit" && "$rwedge" "$@") >"$scratch/out" 2>"$scratch/err" || status=$?
    times >after
    status_is 0
    eval "$name=\$(awk 'FNR == 2 { split(\$1, part, /[ms]/); now = 60 * part[1] + part[2] - now } END { print now }' before after)"
}

timed applied solve $pad --history log.csv
timed told history log.csv $pad
same "a row for each sample" "$samples" "$(tail -n +2 out | wc -l | tr -d ' ')"
timed asked fretting log.csv $pad --cycles 1 --x=-0.8:0.8:0.0888888888888888
same "19 places" 19 "$(tail -n +2 out | wc -l | tr -d ' ')"
echo "$samples samples: applied in $applied s, told in $told s, asked in $asked s"
# To go through them twice would take 2; what the contact is after each takes time, too.
same "history goes through them once" yes "$(awk -v a="$applied" -v b="$told" 'BEGIN { print b < 1.8 * a ? "yes" : "no" }')"
# Of few samples the search for the worst places is a larger share.
most=$([ "$samples" -ge 2000 ] && echo 4 || echo 5)
same "fretting takes less than $most times as long" yes "$(awk -v a="$applied" -v b="$asked" -v most="$most" 'BEGIN { print b < most * a ? "yes" : "no" }')"

# A profile: many places, each with its stresses and its slip after each sample.
timed asked fretting log.csv $pad --cycles 1 --x=-0.8:0.8:0.00535
same "300 places" 300 "$(tail -n +2 out | wc -l | tr -d ' ')"
echo "300 places: asked in $asked s"
same "fretting of 300 places takes less than 6 times as long" yes "$(awk -v a="$applied" -v b="$asked" 'BEGIN { print b < 6 * a ? "yes" : "no" }')"

finish

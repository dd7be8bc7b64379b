# SPDX-License-Identifier: GPL-3.0-or-later
# A scan of many places, with the noise of an instrument: fitted in seconds, in little memory. A third argument is how many places; a
# million is the long run.
. "$(dirname "$0")/../claims.sh"

places=${3:-20000}
bodies="--E1 210000 --nu1 0.3 --P 300 --units mm,N,MPa"
awk -v n="$places" 'BEGIN { srand(1); print "x [mm],height [um]"
    for (i = 0; i < n; i++) { x = -1.5 + 3 * i / (n - 1); d = (x < 0 ? -x : x) - 1
        r = sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand())
        printf "%.7f,%.5f\n", x, (d > 0 ? 100 * d * d : 0) + 0.05 * r } }' >scan.csv
run solve $bodies --flat 1 --radius 5
right=$(value p0)

# 220 bytes a place: cli/README.md, and what the tool and the C library take anyway.
memory_of $((places * 220 / 1024 + 65536))
began=$(date +%s)
shell '(ulimit -v $limit; "$rwedge" solve --profile scan.csv --fit $bodies)'
took=$(($(date +%s) - began))
echo "$places places: $took s"
status_is 0
close_to "the largest pressure of the pad, from so many places" "$right" "$(value p0)" 0.005
same "within a minute" yes "$([ $took -lt 60 ] && echo yes || echo no)"
finish

# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge profile: tractions along the surface, under one load and after many. In natural units they are those of the figures:
# ../figures/figure_data.sh.
. "$(dirname "$0")/../claims.sh"

pi=3.14159265358979323846
contact="--E1 210000 --nu1 0.3 --theta 0.05 --f 0.3"
hertz="$contact --a 2"   # a/b = 4.5 under P = 300
wedge="$contact --a 0.1" # a/b = 0.7 under P = 300

does profile $wedge --P 300 --Q 40 --points 2001
same "zones" "free slip stick slip free" \
    "$(column zone out | uniq | paste -s -d ' ' -)"
same "ends and middle" "0 0" "$(by_name 'NR == 2 { a = $x } NR == 1002 { m = $x } END { print a + $x, m }' out)"
kept listed profile $wedge --load 300,0 --load 300,60 --load 300,-30 --load 200,10 --points 2001
printf 'step,P,Q\n1,300,0\n2,300,60\n3,300,-30\n4,200,10\n' >history.csv
prints_kept "history from a file" listed profile $wedge --history history.csv --points 2001
tr ',' ';' <history.csv >comma.csv
run profile $wedge --history - --points 2001 --decimal-comma <comma.csv
same "history from standard input, with commas" "" "$(tr ';,' ',.' <out | diff listed -)"
kept twice profile $wedge --load 300,0 --load 300,40 --points 2001
prints_kept "--P and --Q are Q under constant P" twice profile $wedge --P 300 --Q 40 --points 2001

# Mindlin: loading to Q1 = 45, and back to Q2 = -9, f P = 90. In b: c = sqrt(1 - Q1/(fP)), and the reversal reaches
# c' = sqrt(1 - (Q1 - Q2)/(2 f P)); q(0) = -f p0 ((1 - c) - 2 (1 - c')).
run profile $hertz --load 300,0 --load 300,45 --load 300,-9 --points 2001
p0=$(column p out | sed -n 1001p)
awk -v p0="$p0" 'BEGIN { printf "%.17g", 0.3 * p0 * ((1 - sqrt(0.5)) - 2 * (1 - sqrt(0.7))) }' >expected
close_to "q(0) after unloading" "$(cat expected)" "$(column q out | sed -n 1001p)" 1e-12
b=$(column x out | tail -n 1)
c=$(by_name '$zone == "stick" { last = $x } END { print last }' out)
awk -v b="$b" -v c="$c" 'BEGIN { print sqrt(0.7), c / b }' >both
close_rows "stick zone after unloading" 0.002 0
same "signs of q from the middle outwards: friction resists the last motion" "+" \
    "$(by_name '$zone == "slip" { print ($q > 0 ? "+" : "-") }' out | uniq | paste -s -d ' ' -)"

# Natural and dimensional are one: x in b, p and q in theta/A, slip in theta b.
kept dimensional profile $wedge --P 300 --Q 40 --points 21
run solve $wedge --P 300 --Q 40
b=$(value b) A=$(value A) alpha=$(value a_over_b) c=$(value c_over_b)
for natural in "--q-over-fp 0.44444444444444442" "--c-over-b $c"; do
    run profile --a-over-b "$alpha" --f 0.3 $natural --points 21
    awk -F, -v b="$b" -v unit="$(awk "BEGIN { printf \"%.17g\", 0.05 / $A }")" '
        FNR == 1 { next }
        NR == FNR { x[FNR] = $1; p[FNR] = $2; q[FNR] = $3; s[FNR] = $5; g[FNR] = $6; next }
        { print x[FNR], $1 * b; print p[FNR], $2 * unit; print q[FNR], $3 * unit; print s[FNR], $5 * unit
          printf "%.12g %.12g\n", g[FNR] * 1e4, $6 * 0.05 * b * 1e4 }' dimensional out >both
    close_rows "natural units, $natural" 2e-5 1e-8
done
same "edges in natural units" "-1 1" "$(by_name 'NR == 2 { print $x } END { print $x }' out | paste -s -d ' ' -)"

# Where: a range, a list; outside there is nothing but stress. Hertz in full sliding: p = -sqrt(1 - x^2), sxx = p - 2 f x
# and slip = -f x^2/2 inside, sxx = 2 f (|x| - sqrt(x^2 - 1)) outside.
prints "x,p,q,zone,sxx,slip
-2,0,0,free,0.1608,
0,-1,-0.3,slip,-1,0
0.5,-0.866,-0.2598,slip,-1.166,-0.0375" profile --a-over-b 1 --f 0.3 --q-over-fp 1 --x -2,0,0.5 --digits 4
prints "x,p,q,zone,sxx,slip
-0.5,-0.8384,0,stick,-0.8384,0
0,,,stick,,0
0.5,-0.8384,0,stick,-0.8384,0" profile --a-over-b 0 --x -0.5:0.5:0.5 --digits 4
prints "x,p,q,zone,sxx,slip
0,0,0,free,0," profile $wedge --load 300,20 --load 0,0 --x 0
run profile --a-over-b 0.5
same "points by default" 202 "$(wc -l <out | tr -d ' ')"

# A history that cannot be.
refuses "--load 300,100: Q 100: must not exceed f P = 90: there is no equilibrium" profile $wedge --load 300,0 --load 300,100
refuses "--load -1,0: P -1: must not be below 0, and Q must be 0 where P is" profile $wedge --load -1,0
for text in 300 300, ,1 nan,0 300,x 300,1,2 300,1,2,3,4 300:1 "300, 1" "" a,b; do
    refuses "--load $text: must be numbers P,Q or P,M,Q,sigma" profile $wedge --load 300,0 --load "$text"
done
history_fails() { # MESSAGE TEXT
    printf '%b' "$2" >bad.csv
    cannot "bad.csv: $1" profile $wedge --history bad.csv
    output_is ""
}
history_fails "line 3: Q 100: must not exceed f P = 90: there is no equilibrium" 'P,Q\n300,0\n300,100\n'
history_fails "line 3: Q x: must be a number, with a decimal point" 'P,Q\n300,0\n300,x\n'
history_fails "line 3: P 1,5: must be a number, with a decimal point; --decimal-comma reads a comma" 'sep=;\nP;Q\n1,5;0\n'
history_fails "line 2: 1 cells in this row, 2 in the header" 'P,Q\n300\n'
history_fails "line 3: 3 cells in this row, 2 in the header; with decimal commas, separate the cells by ';' and give --decimal-comma" \
    'P,Q\n135.75,0\n135,75,0\n'
history_fails "column Q: missing; a history needs P and Q; the names there: 'P', 'T'; --column NAME='THEIR NAME' takes one" 'P,T\n300,0\n'
history_fails "column 'q': allowed: Q; --column Q='q' takes it" 'P,q\n300,0\n'
history_fails "no loads; needed: rows of P and Q" 'P,Q\n'

# Doubts are said once, on stderr, as "solve" says them; the rows are as ever.
for command in profile field; do
    does $command --E1 200000 --nu1 0.3 --E2 70000 --nu2 0.33 --theta 1.15 --a 1 --P 500 --f 0.6 --k 100 --x 0.5 --similar \
        $([ $command = field ] && echo --y 0.5)
    same "what $command doubts" "rwedge $command: theta is above 0.1 rad: the wedge is hardly a half-plane
rwedge $command: Dundurs' beta is not 0: with friction its coupling is neglected
rwedge $command: P is above P_yield: the contact yields in full sliding" "$(cat err)"
    same "rows of $command" 2 "$(wc -l <out)"
    does_quietly $command $hertz --P 300 --k 1000 --x 0.5 $([ $command = field ] && echo --y 0.5)
    run $command $hertz --load 300,0 --load 3000,0 --k 400 --x 0.5 $([ $command = field ] && echo --y 0.5)
    message_is "rwedge $command: P is above P_yield: the contact yields in full sliding"

    # By what the loads reach: a tension yields at a P that would not, and a P that full sliding alone makes yield is elastic.
    run $command $hertz --load 0,0,0,900 --load 300,0,0,900 --k 500 --x 0.5 $([ $command = field ] && echo --y 0.5)
    message_is "rwedge $command: a load yields the body: its stresses exceed the yield stress"
    run $command $hertz --load 800,0 --k 300 --x 0.5 $([ $command = field ] && echo --y 0.5)
    message_is ""
done

finish

# Several zones may stick. A place at the limit of friction lies in none of them.
zones="--E1 72100 --nu1 .33 --theta .05 --a .5 --f .3 --tolerance 1e-3 --load 100,0,0,0 --load 123.01,0,-25.03,-86.14 \
--load 139.27,0,-14.89,-114.33 --load 104.74,0,16.59,-144.07 --load 76.86,0,18.49,84.65"
does profile $zones --points 2001
same "several zones stick" "free slip stick slip stick slip free" "$(column zone out | uniq | paste -s -d ' ' -)"
same "no place at the limit of friction sticks, and every place that slips is there" "0 0" "$(by_name '
    function size(v) { return v < 0 ? -v : v }
    NR > 1 && $zone == "stick" && size($q) > 0.3 * size($p) * (1 - 1e-7) { sticking++ }
    NR > 1 && $zone == "slip" && size($q) < 0.3 * size($p) * (1 - 1e-3) { slipping++ }
    END { print sticking + 0, slipping + 0 }' out)"
same "profile says that several zones stick" 1 "$(grep -c "several zones stick" err)"
run solve $zones
same "solve says it" 1 "$(cat out err | grep -c "several zones stick")"

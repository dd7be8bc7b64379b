# SPDX-License-Identifier: GPL-3.0-or-later
# Moment and bulk tension: solve, files, profile, field, histories, the figure; loads that cannot be.
. "$(dirname "$0")/../claims.sh"

# A cylinder on a specimen under bulk tension (Nowell and Hills), N and mm: 4 mm wide, E = 72.1 GPa, nu = 0.33, 543 N, 155 N,
# R = 10, f = 0.3, 100 MPa. The stick zone has the half-width c = b sqrt(1 - Q/(fP)) = 0.045519 and the middle e = b sigma/(4 f
# p0) = 0.041197. The tension at the trailing edge is 2 f p0 (1 - (d - sqrt(d^2 - c^2))/b) + sigma, d = b + e.
does_quietly solve $specimen --P 135.75 --Q 38.75 --sigma 100
close_to b 0.206698 "$(value b)" 3e-6
close_to p0 418.104 "$(value p0)" 2e-6
close_to c 0.045519 "$(value c)" 2e-5
close_to left -0.206698 "$(value left)" 3e-6
close_to right 0.206698 "$(value right)" 3e-6
close_to "middle of the stick zone" 0.041197 "$(echo "$(value stick_left) $(value stick_right)" | awk '{ print ($1 + $2) / 2 }')" 2e-5
close_to "its half-width" 0.045519 "$(echo "$(value stick_left) $(value stick_right)" | awk '{ print ($2 - $1) / 2 }')" 2e-5
close_to max_tension 345.747 "$(value max_tension)" 2e-6
same tilt 0 "$(value tilt)"
for name in max_tension_sliding von_mises_sliding f_critical P_over_bk P_yield safety yield_x yield_y yield_branch; do
    same "$name, which is without tension" "" "$(value $name)"
done

# After a history: as under the same loads, where they come in the order that options have them in.
cp out once
printf 'time,P,Q,sigma\n0,135.75,0,0\n1,135.75,38.75,100\n' >loads.csv
prints "$(cat once)" solve $specimen --history loads.csv
# Otherwise as "history" has it; what takes the contact to slide does not depend on the way.
turned="--load 135.75,0 --load 135.75,38.75 --load 135.75,-10"
kept slides solve $specimen --yield-stress 500 --P 135.75 --Q -10
run history $specimen --yield-stress 500 $turned
cp out steps
does_quietly solve $specimen --yield-stress 500 $turned --yield-factor
same "contact, stick zone, tension and yield factor of a history" "$(by_name 'END { print $left, $right, $stick_left, $stick_right,
    ($tension_left > $tension_right ? $tension_left : $tension_right), $yield_factor }' steps)" \
    "$(value left) $(value right) $(value stick_left) $(value stick_right) $(value max_tension) $(value yield_factor)"
for name in p0 Q_over_fP max_tension_sliding von_mises_sliding f_critical load_over_bk P_over_bk P_yield safety yield_x yield_y yield_branch; do
    same "$name, after a history" "$(awk -F, -v name=$name '$1 == name { print $2 }' slides)" "$(value $name)"
done
cannot "--load: the last load has P = 0, which separates the bodies; allowed: a last P above 0" \
    solve $specimen --load 100,0 --load 0,0
cannot "loads.csv: line 3: Q 38.75: must not exceed f P = 27.15: there is no equilibrium" \
    solve --E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.2 --history loads.csv
refuses "--history: given together with --input; allowed: one of the two" solve $specimen --history loads.csv -i loads.csv
refuses "--encoding latin1: needs --input, --history or --profile" solve $specimen --load 100,0 --encoding latin1

# A tension stretches body 1 by (1 - nu1^2)/E1: A/2 on a rigid cylinder, not A/4. Then e = b sigma/(2 f p0), with b^2 = 2 A P R/pi,
# p0 = 2 P/(pi b), A = 0.15.
unlike="--E1 10 --nu1 .5 --E2 inf --theta .1 --radius 100 --f .5"
run solve $unlike --P 1 --Q .2 --sigma .04
close_to "middle of the stick zone under a rigid body" 0.6 "$(echo "$(value stick_left) $(value stick_right)" | awk '{ print ($1 + $2) / 2 }')" 1e-6
cp out rigid
# With 0.05 the right edge slips the other way; the left one does as if nothing had happened: 0.75 - c, where A/4 has 0.375 - c.
run solve $unlike --P 1 --Q .2 --sigma .05
close_to "left edge of the stick zone" "$(awk 'BEGIN { b = sqrt(30 / 3.14159265358979); print 0.75 - b * sqrt(0.6) }')" "$(value stick_left)" 5e-4
run solve $unlike --load 1,0,0,0 --load 1,0,.2,.04
same "the same after a history" "$(grep stick_ rigid)" "$(grep stick_ out)"
run profile $unlike --P 1 --Q .2 --sigma .04
close_to "and of the profile, whose slip is 0 there" 0.6 \
    "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 1 && $at["slip"] == 0 { if (!n++) a = $at["x"]; b = $at["x"] } END { print (a + b) / 2 }' out)" 0.05

# What is there only with moment or tension comes after c_over_b. Zero is as good as none.
plain="--E1 210000 --nu1 0.3 --theta 0.05 --a 0.1 --f 0.3 --P 300 --Q 40 --k 300 --yield-factor --layout row"
kept without solve $plain
run solve $plain --M 0 --sigma 0
same "columns" left,right,stick_left,stick_right,tilt "$(head -n 1 out | cut -d , -f 13-17)"
same "the others" "" "$(cut -d , -f 1-12,18- out | diff without - 2>&1)"
same "edges and tilt" "1 1 0" "$(by_name 'NR == 2 { print ($left == -$b && $right == $b), ($stick_left == -$c && $stick_right == $c), $tilt }' out)"

# A moment on Hertz' contact moves its middle to M/P, and tilts by M/(P R).
run solve --E1 210000 --nu1 0.3 --theta 0.05 --radius 100 --P 100 --M 20 --f 0.3 --k 300 --yield-factor
close_to "middle" 0.2 "$(echo "$(value left) $(value right)" | awk '{ printf "%.17g", ($1 + $2) / 2 }')" 1e-12
close_to tilt 0.002 "$(value tilt)" 1e-12
close_to p0_x 0.2 "$(value p0_x)" 1e-12
same p_transition "" "$(value p_transition)"
factor=$(value yield_factor) p0=$(value p0)
run solve --E1 210000 --nu1 0.3 --theta 0.05 --radius 100 --P 100 --f 0.3 --k 300 --yield-factor
close_to "yield factor, the same" "$(value yield_factor)" "$factor" 1e-12
close_to "p0, the same" "$(value p0)" "$p0" 1e-12
same "p0_x in the middle" 0 "$(value p0_x)"

# A cylinder that is held at a tilt is the same one beside, by R times the tilt; the moment that holds it is P times that.
guided="--E1 210000 --nu1 0.3 --radius 100 --f 0.5"
run solve $guided --P 200 --Q 40 --k 300 --yield-factor
centred="$(value p0) $(value c) $(value max_tension) $(value yield_factor)"
run solve $guided --P 200 --Q 40 --k 300 --yield-factor --tilt 0.02
close_to "moment that holds it" 400 "$(value moment)" 1e-12
close_to "the tilt" 0.02 "$(value tilt)" 1e-15
close_to "where it is pressed most" 2 "$(value p0_x)" 1e-12
i=0
for name in p0 c max_tension yield_factor; do
    i=$((i + 1))
    close_to "$name of a held cylinder" "$(echo "$centred" | cut -d ' ' -f $i)" "$(value $name)" 1e-12
done
printf 'P,Q\n200,0\n200,60\n300,-20\n200,60\n' >rig.csv
run history rig.csv $guided
cp out level
run history rig.csv $guided --tilt 0.02
same "M of each load" "400 400 600 400" "$(by_name 'NR > 1 { printf "%s%.10g", s, $M; s = " " }' out)"
same "edges that stick, less 2" "$(by_name 'NR > 1 { printf "%.9f %.9f,", $stick_left, $stick_right }' level)" \
    "$(by_name 'NR > 1 { printf "%.9f %.9f,", $stick_left - 2, $stick_right - 2 }' out)"
run field $guided --P 200 --Q 40 --x 0.3 --y 0.1
stress=$(by_name 'NR == 2 { print $von_mises }' out)
run field $guided --P 200 --Q 40 --x 2.3 --y 0.1 --tilt 0.02
close_to "stress beside" "$stress" "$(by_name 'NR == 2 { print $von_mises }' out)" 1e-11
run fretting rig.csv $guided --x 0.3 --depth 0.1
range=$(by_name 'NR == 2 { print $stress_range }' out)
run fretting rig.csv $guided --x 2.3 --depth 0.1 --tilt 0.02
close_to "stress range beside" "$range" "$(by_name 'NR == 2 { print $stress_range }' out)" 1e-11

# Tilts as a column: one tilt is that of the option; the middle of a cylinder is R times its tilt, its moment P times that.
printf 'P,Q,tilt\n200,0,0.02\n200,60,0.02\n300,-20,0.02\n200,60,0.02\n' >held.csv
run history rig.csv $guided --tilt 0.02
cp out by_option
does_quietly history held.csv $guided
same "one tilt in a column" "$(cat by_option)" "$(cat out)"
run fretting rig.csv $guided --tilt 0.02 --at-worst
cp out by_option
run fretting held.csv $guided --at-worst
same "one tilt in a column, in a cycle" "$(cat by_option)" "$(cat out)"
printf 'P,Q,Pad tilt [mrad]\n200,0,20\n300,0,10\n0,0,5\n100,0,-30\n' >turns.csv
does_quietly history turns.csv $guided --units mm,N,MPa --column 'tilt=Pad tilt'
same "middles, in a column of mrad" "2 1  -3" "$(by_name 'NR > 1 { printf "%s%s", s, $left == "" ? "" : sprintf("%.9g", ($left + $right) / 2); s = " " }' out)"
same "moments that hold it" "400 300 0 -300" "$(by_name 'NR > 1 { printf "%s%.9g", s, $M; s = " " }' out)"
cp out kept
does_quietly history turns.csv $guided --units mm,N,MPa --column 'tilt=Pad tilt' --save-case turns.json
does_quietly history --case turns.json
same "tilts in a case" "$(cut -d , -f 1-10 kept)" "$(cut -d , -f 1-10 out)"
run solve --case turns.json
close_to "the last moment, of solve" -300 "$(value moment)" 1e-12
printf 'P,tilt\n200,0.02\n300,-0.01\n' | run solve --input - $guided
same "moments of cases" "400 -300" "$(by_name 'NR > 1 { printf "%s%.9g", s, $moment; s = " " }' out)"
same "tilt is there once" 1 "$(head -n 1 out | tr , '\n' | grep -c '^tilt$')"
refuses_rows() { # MESSAGE ROWS OPTION...: of a history
    printf "$2" >rows.csv
    message=$1
    shift 2
    fails_with_status 1 "rows.csv: $message" history rows.csv $guided "$@"
}
refuses_rows "column tilt: given together with column M; allowed: one of the two, or another name" 'P,Q,M,tilt\n1,0,0,0\n'
refuses_rows "line 2: tilt 0.01: given together with --tilt; allowed: one of the two" 'P,Q,tilt\n1,0,0.01\n' --tilt 0.01
refuses_rows "line 3: tilt 1.4: so large a tilt lays a flank on the surface" 'P,Q,tilt\n1,0,0\n1,0,1.4\n'
# A cycle of tilts is, in small steps, one of the moments that hold the pad: of a flat one that rocks while Q goes to and fro.
rocking="--E1 210000 --nu1 0.3 --flat 1 --radius 20 --f 0.3"
awk 'BEGIN { print "P,tilt,Q"; n = 60; split("0.001 0.0003 -0.001 -0.0002", t, " "); split("40 -100 -20 100", q, " ")
    for (i = 1; i <= 4; i++) print 400 + 20 * (i % 2) "," t[i] "," q[i] >"rocks.csv"
    for (i = 1; i <= 4; i++) { j = i > 1 ? i - 1 : 4
        for (k = 1; k <= n; k++) { s = k / n
            printf "%.17g,%.17g,%.17g\n", (1 - s) * (400 + 20 * (j % 2)) + s * (400 + 20 * (i % 2)), (1 - s) * t[j] + s * t[i], (1 - s) * q[j] + s * q[i] } } }' >fine.csv
sed -i '1i P,tilt,Q' rocks.csv
run history fine.csv $rocking --cycles 3
by_name 'NR == 1 { print "P,M,Q" } NR > 481 { print $P "," $M "," $Q }' out >moments.csv
same "the last cycle of moments" 241 "$(wc -l <moments.csv | tr -d ' ')"
run fretting rocks.csv $rocking --cycles 4 --x=-1.13
of_tilts=$(by_name 'NR == 2 { printf "%.4g %.4g %.4g", $slip_range, $stress_range, $energy_per_area }' out)
slip=$(by_name 'NR == 2 { print $slip_range }' out) energy=$(by_name 'NR == 2 { print $energy_per_area }' out)
run fretting moments.csv $rocking --cycles 4 --x=-1.13
close_to "slip of a pad that rocks: $of_tilts" "$(by_name 'NR == 2 { print $slip_range }' out)" "$slip" 2e-3
close_to "energy of a pad that rocks" "$(by_name 'NR == 2 { print $energy_per_area }' out)" "$energy" 2e-3
same "it slips" 1 "$(awk -v s="$slip" 'BEGIN { print (s > 1e-6) }')"

refuses "--tilt 0.1: given together with --M; allowed: one of the two" solve $guided --P 200 --M 1 --tilt 0.1
refuses "--tilt 1.2: so large a tilt lays a flank on the surface" solve $guided --P 200 --tilt 1.2
refuses "--tilt 2: the tilt must be a number below pi/2 in magnitude, in radians" solve $guided --P 200 --tilt 2
refuses "--load 200,1,0,0: M 1: given together with --tilt; allowed: one of the two" history $guided --tilt 0.1 --load 200,1,0,0

# The ends of the profile are the edges that solve gives.
kept solved solve $specimen --P 135.75 --M 10 --Q 38.75 --sigma 50
does_quietly profile $specimen --P 135.75 --M 10 --Q 38.75 --sigma 50 --points 2001
same "edges" "$(awk -F, '$1 == "left" || $1 == "right" { print $2 }' solved | paste -s -d ' ' -)" "$(column x out | sed -n '1p;$p' | paste -s -d ' ' -)"
same "zones" "free slip stick slip free" "$(column zone out | uniq | paste -s -d ' ' -)"

# A field has its columns about the middle of the contact, and the same numbers as the profile.
run field $specimen --P 135.75 --M 10 --Q 38.75 --sigma 50 --y 0
awk -F, 'NR == FNR { v[$1] = $2; next } FNR == 2 { first = $1 } { last = $1 }
    END { print (v["left"] + v["right"]) / 2, (first + last) / 2; print 4 * v["b"], last - first }' solved out >both
close_rows "columns of the field" 1e-12 0
run field $specimen --P 135.75 --M 10 --Q 38.75 --sigma 50 --y 0 --x 0.1
sxx=$(column sxx out)
run profile $specimen --P 135.75 --M 10 --Q 38.75 --sigma 50 --x 0.1
close_to "field and profile" "$(column sxx out)" "$sxx" 1e-12

# Natural units with a moment and tension: the same contact in units of its own, b = 0.2 without the moment.
kept natural profile --a-over-b 0.5 --f 0.3 --nu1 0.33 --q-over-fp 0.5 --M 0.3 --sigma 0.1 --points 41
run table contact-law --a-over-b 0.5
set -- $(by_name 'NR == 2 { A = 4 * (1 - 0.33 ^ 2) / 72100; u = 0.05 / A; P = $AP_over_theta_b * u * 0.2
    printf "%.17g %.17g %.17g %.17g", P, 0.3 * 0.5 * P, 0.3 * u * 0.04, 0.1 * u }' out)
run profile --E1 72100 --nu1 0.33 --theta 0.05 --a 0.1 --f 0.3 --P "$1" --Q "$2" --M "$3" --sigma "$4" --points 41
paste -d , natural out | awk -F, 'NR > 1 { u = 0.05 * 72100 / (4 * (1 - 0.33 ^ 2)); printf "%s %.17g\n%s %.17g\n%s %.17g\n%s %.17g\n%s %.17g\n",
    $1, $7 / 0.2, $2, $8 / u, $3, $9 / u, $5, $11 / u, $6, $12 / (0.05 * 0.2) }' >both
close_rows "natural units" 1e-9 1e-9

# A history by options and from a file; two numbers keep moment and tension, a file without their columns has none.
kept listed profile $specimen --load 100,5,0,0 --load 100,5,20,40 --load 100,-10 --points 21
prints_kept "P,Q keeps M and sigma" listed profile $specimen --load 100,5,0,0 --load 100,5,20,40 --load 100,5,-10,40 --points 21
printf 'Q,sigma,P,M\n0,0,100,5\n20,40,100,5\n-10,40,100,5\n' >history.csv
does_quietly profile $specimen --history history.csv --points 21
same "from a file" "" "$(diff listed out)"
printf 'Q,sigma,P,M\n0,0,100,5\n20,,100,5\n' >gap.csv
cannot "gap.csv: 1 row without a number, the first in line 3, column sigma: ''; --drop leaves such rows out" profile $specimen --history gap.csv

# What slips while the contact moves has no closed form of the slip, which is computed; all else has.
moves="--load 200,0 --load 220,0,60,50 --load 180,0,-20,10 --load 220,0,60,50 --points 5"
cylinder="--E1 72100 --nu1 0.33 --radius 25 --f 0.5"
does profile $cylinder $moves --exact
message_has "the slip has no closed form after these loads"
part_of out x p q zone sxx >exact
same "without a closed form no slip" 5 "$(column slip out | grep -cx -)"
does_quietly profile $cylinder $moves
same "all but the slip is exact" "" "$(part_of out x p q zone sxx | diff exact -)"
same "the slip is computed" 0 "$(column slip out | grep -cx -)"
does profile $specimen --load 100,5,0,0 --load 100,5,30,0 --load 120,6,36,0 --points 5
message_is "rwedge profile: the slip has no closed form after these loads: the column slip is empty"
same "slip" "- - - - -" "$(column slip out | paste -s -d ' ' -)"

# A file of contacts: columns M and sigma; a bad row says why.
cat >cases.csv <<'CASES'
case,P,M,Q,sigma
1,135.75,0,38.75,100
2,135.75,10,38.75,50
3,135.75,10,38.75,1000
4,135.75,10,50,10
5,135.75,1e30,10,10
CASES
does solve -i cases.csv $specimen --exact
same "left edges" "-0.206698 -0.133033 - - -" \
    "$(column left out | awk '$1 == "-" { print; next } { printf "%.6f\n", $1 }' | paste -s -d ' ' -)"
same "errors" "--
--
sigma 1000: no closed form: the two edges would slip in opposite directions; change sigma by less; sigma may change by 238.697 with this Q; without --exact it is computed
Q 50: must not exceed f P = 40.725: there is no equilibrium
M 1e30: must be below 6.4e+10 in magnitude: more lays a flank on the surface" \
    "$(tail -n +2 out | sed 's/.*,"\{0,1\}\([sQM][^,"]*[^"]*\)"\{0,1\}$/\1/; /^[0-9]/s/.*/--/; s/below [0-9.e+]* in/below 6.4e+10 in/')"

# Loads that cannot be name the argument, and what is allowed.
# (the search for the largest moment did not end where none is allowed)
refuses "--M 2e39: must be 0: any other lays a flank on the surface" \
    solve --E1 1e-10 --nu1 0.3 --theta 0.01 --a 0 --P 2e-60 --f 0.5 --M 2e39
cannot "the loads: an iteration did not converge: smaller loads may go" solve $specimen --P 100 --sigma 1e30
refuses "--M 1x: the moment must be a number" solve $specimen --P 100 --M 1x
refuses "--sigma inf: the bulk tension must be a number" solve $specimen --P 100 --sigma inf
refuses "missing: --f; friction has no default where Q, sigma or a yield stress is given" \
    solve --E1 1 --nu1 0 --theta 0.1 --a 1 --P 1 --sigma 1
refuses "--Q 38.75: must not exceed f P = 30: there is no equilibrium" solve $specimen --P 100 --Q 38.75 --sigma 1
refuses "--load 0,0,1e70,0: Q 1e+70: must be 0, or 1e-60 to 1e60 in magnitude" profile $specimen --load 0,0,1e70,0
refuses "--load 1e-70,0: P 1e-70: must be 0, or 1e-60 to 1e60 in magnitude" profile $specimen --load 1e-70,0
refuses "--load 100,0,0,1e200: sigma 1e+200: must be 0, or 1e-60 to 1e60 in magnitude" profile $specimen --load 100,0,0,1e200
refuses "--load 1e-07,0: P 1e-07 is below 1e-8 of the last P, 100; allowed: a load between them" profile $specimen --load 100,0 --load 1e-07,0
refuses "--load 1e30,0: the contact would reach farther than the radius, or results leave 1e-60 to 1e60; allowed: smaller loads, or \
larger ones" profile --E1 1 --nu1 0.3 --radius 1 --f 0.3 --load 1e30,0
refuses "--load 0,1,0,0: M 1: must be 0 where P is" profile $specimen --load 100,0 --load 0,1,0,0
refuses "--load 100,40,20,0: no closed form: one edge of the contact would advance while the other recedes; separate the bodies, which forgets the history, then apply sigma with P = 0, then P and M, then Q; without --exact it is computed" \
    profile $specimen --load 100,5,20,0 --load 100,40,20,0 --exact
refuses "--sigma 3: given together with --load, which has the loads; allowed: one of the two" \
    profile $specimen --sigma 3 --load 100,0
refuses "--c-over-b 0.5: not with --M or --sigma, which move the stick zone; allowed: --q-over-fp" \
    field --a-over-b 0.5 --f 0.3 --c-over-b 0.5 --M 3
refuses "--sigma 3: no closed form: the two edges would slip in opposite directions; change sigma by less; sigma may change by 0.365399 with this Q; without --exact it is computed" \
    field --a-over-b 0.5 --f 0.3 --q-over-fp 0.5 --sigma 3 --exact
# The limit that the message names is the limit.
run profile $specimen --load 10,1e20,0,0
limit=$(sed -n 's/.*M 1e+20: must be below \([0-9.e+]*\) in magnitude: more lays a flank on the surface$/\1/p' err)
does profile $specimen --load "10,$(awk "BEGIN { print $limit * 0.999 }"),0,0" --x 0
run profile $specimen --load "10,$(awk "BEGIN { print $limit * 1.001 }"),0,0" --x 0
status_is 2
sigma_at() { # FACTOR: of the largest that goes with Q, 4 Q/(pi b) = 238.697
    run solve $specimen --P 135.75 --Q 38.75 --exact --sigma "$(awk "BEGIN { print 4 * 38.75 / (3.14159265358979 * 0.20669766) * $1 }")"
}
sigma_at 0.9999
status_is 0
sigma_at 1.0001
status_is 2

# The figure: opposite tensions have mirrored stick zones; without one it is Fig. 7.
does figure eccentric --data --sigma-over-max=-1,0,0.5,1
same "columns" "sigma_over_max,x_over_b,minus_pi_A_q_over_f_theta,stick_left_over_b,stick_right_over_b" "$(head -n 1 out)"
cp out eccentric
by_name '$sigma_over_max == -1 && !n++ { left = $stick_left_over_b; right = $stick_right_over_b }
    $sigma_over_max == 1 { printf "%.17g %s\n%.17g %s\n", -right, $stick_left_over_b, -left, $stick_right_over_b; exit }' eccentric >both
close_rows "stick zones of -1 and 1 are mirrored" 1e-13 0
run table stick-zone --a-over-b 0.25 --q-over-fp 0.5
width=$(cell c_over_b '$')
by_name 'NR > 1 && $sigma_over_max == 0 { print "-" c, $stick_left_over_b; print c, $stick_right_over_b; exit }' eccentric -v c="$width" >both
close_rows "without tension: the stick zone" 1e-13 0
run figure 7 --data --c-over-b "$width" --a-over-b 0.25
awk -F, 'NR == FNR { q[$2] = $3; next } $1 == 0 && ($2 in q) { print q[$2], $3 }' out eccentric >both
close_rows "without tension: Fig. 7" 1e-12 1e-12
refuses "--sigma-over-max 1.5: the bulk tension must be a number from -1 to 1" figure eccentric --sigma-over-max 1.5
refuses "--sigma-over-max 1: figure 7 does not depend on it; allowed: --a-over-b, --c-over-b" figure 7 --sigma-over-max 1

finish

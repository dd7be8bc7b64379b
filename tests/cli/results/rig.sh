# SPDX-License-Identifier: GPL-3.0-or-later
# A rig: loads by the displacement that it prescribes, in partial and in gross slip.
. "$(dirname "$0")/../claims.sh"

cylinder="--radius 50 --E1 115000 --nu1 0.32 --f 0.6"
compliance="--compliance 1.5e-5"

# ---- Partial slip in closed form ----
# Mindlin and Cattaneo: remote points move by A/(2 pi) ((f P - Q) ln(1 - Q/(f P)) + Q) further than bonded ones, the rig by C Q.
awk 'BEGIN { A = 4 * (1 - 0.32 * 0.32) / 115000; limit = 0.6 * 400; pi = 3.14159265358979324
    print "P,displacement\n400,0" >"partial.csv"
    for (Q = 24; Q < limit; Q += 24) {
        printf "%.17g\n", Q >"expected"
        printf "400,%.17g\n", A / (2 * pi) * ((limit - Q) * log(1 - Q / limit) + Q) + 1.5e-5 * Q >"partial.csv"
    }
    printf "0,0\n" >"partial.csv" }'
does_quietly history partial.csv $cylinder $compliance
column Q out | sed '1d;$d' | paste -d ' ' expected - >both
close_rows "Q in partial slip" 1e-10 0
same "apart" 0 "$(column Q out | tail -n 1)"

# ---- Gross slip ----
# Five cycles of a rig with 0.5 % of noise in P and Q: the energy is force times displacement, as the rig's Q has it too.
gross=$data/instruments/gross.csv
area='NR > 401 { area += ($Q + q) / 2 * ($displacement - d) } NR > 400 { q = $Q; d = $displacement } END { printf "%.17g", area }'
does history "$gross" $cylinder $compliance
message_is "rwedge history: $gross: column Q is not used: the displacement stands in its place"
energy=$(by_name 'NR == 401 { before = $energy } NR == 501 { printf "%.17g", $energy - before }' out)
close_to "energy of the last cycle" "$(by_name "$area" out)" "$energy" 2e-3
close_to "that of the measured loop" "$(by_name "$area" "$gross")" "$energy" 5e-3
same "largest Q over f P" 1 "$(by_name 'NR > 1 && $Q / (0.6 * $P) > m { m = $Q / (0.6 * $P) } END { printf "%.6g", m }' out)"
same "the displacement passes through, what was measured of Q does not" time,displacement,load,P,M,Q "$(head -n 1 out | cut -d , -f 1-6)"
does history "$gross" $cylinder $compliance --cycles 2
message_has "dissipated in the last cycle"
# What is not used need not be there.
printf 'P,Q,displacement\n300,,0\n300,?,0.001\n' >lost.csv
does history lost.csv $cylinder $compliance
same "rows without a measured Q" 3 "$(wc -l <out | tr -d ' ')"

# By place: the integral of energy_per_area over the surface is the energy; each place slips what the rig leaves.
sed '1p;402,$!d' "$gross" >cycle.csv
head -n 401 "$gross" >before.csv
does fretting cycle.csv $cylinder $compliance --cycles 2
by_place=$(by_name 'NR > 2 { sum += ($energy_per_area + last) / 2 * ($x - at) } NR > 1 { at = $x; last = $energy_per_area }
    END { printf "%.17g", sum }' out)
does history cycle.csv $cylinder $compliance --cycles 2
said=$(sed -n 's/.*last cycle: //p' err)
close_to "energy by place" "$said" "$by_place" 5e-3

# ---- Noise ----
# Clipped, the loads are carried; what was done is counted here once more.
said=$(by_name 'NR > 1 { e = ($Q < 0 ? -$Q : $Q) - 0.6 * $P; if (e > 0) { n++; if (e > m) m = e } }
    END { printf "|Q| above f P, by %.4g at most, slides: %d of %d rows", m, n, NR - 1 }' "$gross")
does history "$gross" $cylinder --clip
message_has "--clip: $said"
message_has "the loads do not tell how far nor what that dissipates"
by_name 'NR > 1 && $Q * $Q <= 0.36 * $P * $P * (1 + 1e-12) { n++ } END { print n }' out >carried
same "every load is carried" 500 "$(cat carried)"
printf 'P,Q\n400,100\n-2,3\n400,-300\n' >touch.csv
does history touch.csv $cylinder --clip
same "separated, and slid" "100 0 -240" "$(column Q out | paste -s -d ' ' -)"
same "what was done" "rwedge history: --clip: P below 0, by 2 at most, is separated: 1 of 3 rows
rwedge history: --clip: |Q| above f P, by 60 at most, slides: 1 of 3 rows" "$(head -n 2 err)"
fails_with_status 1 "touch.csv: line 3: P -2: must not be below 0, and Q must be 0 where P is; --clip separates the bodies there" history touch.csv $cylinder
does history touch.csv $cylinder --clip --save-case clipped.json
kept first history touch.csv $cylinder --clip
does history --case clipped.json
same "a case clips too" "$(column energy first)" "$(column energy out)"

# Turning points: of a ramp to and fro from -100 to 100 with ripples of 8, those of the ramp alone; with a finer threshold those of
# the ripples too.
awk 'BEGIN { print "P,Q"; for (i = 0; i <= 80; i++) { t = i % 40; print 400 "," (t < 20 ? t : 40 - t) * 10 - 100 + (i % 2 ? 8 : -8) } }' >ripple.csv
does history ripple.csv $cylinder --turning-points 0.1
message_is "rwedge history: --turning-points: 5 of 81 rows are left; what is left out turns by 0.0291 of the range of Q at most"
same "the turns" "-108 98 -108 98 -108" "$(column Q out | paste -s -d ' ' -)"
does history ripple.csv $cylinder --turning-points 0.02
same "each ripple" 81 "$(column Q out | wc -l)"
refuses "--turning-points 1: must be a number between 0 and 1, of the range" history ripple.csv $cylinder --turning-points 1
# Energy of partial slip is that of the turns: with ripples it is more, by what is told to be left out.
awk 'BEGIN { print "P,Q"; for (i = 0; i <= 400; i++) print 400 "," 150 * sin(i * 0.0628318530717959) }' >smooth.csv
kept first history smooth.csv $cylinder
does history smooth.csv $cylinder --turning-points 0.01
message_has "10 of 401 rows are left; nothing turns in between"
close_to "the energy" "$(column energy first | tail -n 1)" "$(column energy out | tail -n 1)" 1e-9

# ---- Cycle by cycle ----
# A cycle of the log is what the loads before and in it make of the contact: of the last one, "fretting" tells the same.
does history "$gross" $cylinder $compliance --per-cycle
same "columns" "cycle,first_load,loads,energy_per_cycle,never_left,never_right,slip_range,Q_min,Q_max" "$(head -n 1 out)"
same "cycles" "1 101 100|2 201 100|3 301 100|4 401 100|mean - 100" "$(awk -F, 'NR > 1 { print $1, $2 == "" ? "-" : $2, $3 }' out | paste -s -d '|' -)"
per_cycle=$(by_name '$cycle == 4 { print $energy_per_cycle }' out)
close_to "energy of the last but one, by the area" "$(by_name "NR > 302 && NR <= 402 { area += (\$Q + q) / 2 * (\$displacement - d) }
    { q = \$Q; d = \$displacement } END { printf \"%.17g\", area }" "$gross")" "$(by_name '$cycle == 3 { print $energy_per_cycle }' out)" 6e-3
close_to "mean" "$(by_name '$cycle ~ /^[0-9]/ && $cycle < 5 { sum += $energy_per_cycle / 4 } END { printf "%.17g", sum }' out)" \
    "$(by_name '$cycle == "mean" { print $energy_per_cycle }' out)" 1e-12
# To and fro under constant P: what never slips, Mindlin's b sqrt(1 - Q/(f P)).
awk 'BEGIN { print "P,Q"; for (i = 0; i <= 200; i++) print 400 "," 150 * sin(i * 0.0628318530717959) }' >smooth.csv
does_quietly history smooth.csv $cylinder --per-cycle
never=$(by_name '$cycle == "mean" { print $never_right }' out)
run history smooth.csv $cylinder
close_to "the zone that never slips" "$(by_name 'NR == 2 { printf "%.17g", $right * sqrt(1 - 150 / 240) }' out)" "$never" 1e-6
refuses "--per-cycle: the cycles are those of the log; allowed: --cycles 1" history smooth.csv $cylinder --per-cycle --cycles 2
refuses "--per-cycle: not with points" history smooth.csv $cylinder --per-cycle --at 0,0
head -n 40 smooth.csv >part.csv
fails_with_status 1 "part.csv: no whole cycle: Q does not rise twice through the middle of its range, nor ends where it began" \
    history part.csv $cylinder --per-cycle

# ---- Columns and words ----
printf 'P [kN],displacement [um],Q\n4,10,1\n4,-10,1\n' >units.csv
printf 'P,displacement\n400,0.01\n400,-0.01\n' >plain.csv
kept first history plain.csv $cylinder $compliance --no-formulas
does history units.csv $cylinder --units mm,N,MPa --width 10 --compliance '1.5e-3 um/N'
same "units, and the rig's compliance under the whole force" "$(column Q first)" "$(column Q out)"
does history units.csv $cylinder --units mm,N,MPa --width 10 --compliance '1.5e-2 um^2/mN'
same "or per unit length" "$(column Q first)" "$(column Q out)"
printf 'P,LVDT 1\n400,-0.01\n400,0.01\n' >named.csv
does_quietly history named.csv $cylinder $compliance --column 'displacement=-LVDT 1'
same "a name of its own, and a sign" "$(column Q first)" "$(column Q out)"
does_quietly history plain.csv $cylinder $compliance --save-case rig.json
does history --case rig.json
same "a case" "$(column Q first) $(column energy first)" "$(column Q out) $(column energy out)"
does history --case rig.json --save-case again.json
same "a case, saved again" "" "$(cmp rig.json again.json 2>&1)"
does_quietly figure loop --history plain.csv $cylinder $compliance --data
close_to "the loop of the figure" "$(column Q first | tail -n 1)" "$(column Q out | tail -n 1)" 1e-12
refuses "--compliance 1: needs loads from a file with the column displacement" history $cylinder --load 1,0 --compliance 1
refuses "--compliance -1: must be a number not below 0" history plain.csv $cylinder --compliance=-1
fails_with_status 1 "plain.csv: column Q: missing; a displacement in its place needs the compliance of the rig, --compliance, 0 where it is stiff" \
    history plain.csv $cylinder
printf 'P,Q\n400,1\n' >forces.csv
fails_with_status 1 "forces.csv: column displacement: missing; with a compliance loads have it in place of Q; the names there: 'P', 'Q'; --column NAME='THEIR NAME' takes one" \
    history forces.csv $cylinder $compliance

# Micrometres in the place of millimetres, or an offset of the sensor.
far="it slides by more than its half-width, so that places leave it: is the displacement in the unit of the other lengths, and from the middle?"
printf 'P,displacement\n400,0\n400,2\n400,-2\n' >far.csv
does history far.csv $cylinder $compliance
message_is "rwedge history: far.csv, in some rows: $far"
same "in its rows" 2 "$(grep -c "it slides by more than its half-width" out)"
does fretting far.csv $cylinder $compliance --x 0
message_has "$far"

# ---- Gross slip with a tension ----
# The work of Q over the way, and that of the tension at int q x dx: in full sliding that is 0 without a moment.
awk 'BEGIN { print "P,displacement,sigma"; print "400,0,0"
    for (i = 1; i <= 200; i++) { s = sin(i * 0.0628318530717959); printf "400,%.17g,%.17g\n", 0.02 * s, 20 * s } }' >tension.csv
does_quietly history tension.csv $cylinder $compliance
same "Q reaches f P" "240 -240" "$(by_name 'NR > 101 { if ($Q > m) m = $Q; if ($Q < n) n = $Q } END { print m, n }' out)"
close_to "energy of the last cycle" "$(by_name 'NR > 102 { area += ($Q + q) / 2 * ($displacement - d) } { q = $Q; d = $displacement }
    END { printf "%.17g", area }' out)" "$(by_name 'NR == 102 { before = $energy } NR == 202 { printf "%.17g", $energy - before }' out)" 5e-3
does fretting tension.csv $cylinder $compliance --x 0
same "the middle slips" 1 "$(by_name 'NR == 2 { print ($slip_range > 0.02) }' out)"
fails_with_status 1 "tension.csv: line 29: the displacement is not known: no closed form; without --exact it is computed" history tension.csv $cylinder $compliance --exact

for command in "solve --P 300" "profile --P 300" "field --P 300"; do
    refuses "--compliance 1e-5: needs loads from a file with the column displacement" $command $cylinder --compliance 1e-5
done
refuses "--compliance 1e-5: is of one contact, not with --input" solve -i cases.csv --compliance 1e-5

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge history: what a contact is after each load of a table; stresses at points; loads that cannot be.
. "$(dirname "$0")/../claims.sh"

# cells NAME: that column of the CSV file out, in one line.
cells() {
    column "$1" out | paste -s -d ' ' -
}

# The tests of Nowell and Hills: a cylinder on a specimen under bulk tension in phase with Q. Those of solve, below, are theirs (off_centre.sh).
printf 'time,P,Q,sigma,name\n0,135.75,0,0,press\n0.5,135.75,38.75,100,pull\n1,135.75,-38.75,-100,push\n1.5,135.75,38.75,100,"pull, again"\n' >loads.csv
does_quietly history loads.csv $specimen
same "columns" "time,name,load,P,M,Q,sigma,left,right,stick_left,stick_right,tilt,peak_pressure,tension_left,tension_right,largest_slip,energy,yield_factor,yield_x,yield_y,warnings,error,p0_x" \
    "$(head -n 1 out)"
same "columns that pass through" '0,press,1,|0.5,pull,2,|1,push,3,|1.5,"pull, again",4,' "$(tail -n +2 out | sed 's/135.*//' | paste -s -d '|' -)"
sed -i 's/"pull, again"/again/' out
same "no yield stress" "- - - -" "$(cells yield_factor)"

# Rounding beside the depth is no place: without friction it yields in the middle, to the last bit.
run history --load 135.75,0 $specimen --k 300
same "place of yield under P alone" 0 "$(column yield_x out)"

# The same as solve, load by load from the virgin contact, and as profile for the whole history.
same_as_solve() { # NAME COLUMN
    history=$(cells "$2" | cut -d ' ' -f 2)
    cp out kept
    run solve $specimen --P 135.75 --Q 38.75 --sigma 100 --k 300 --yield-factor
    close_to "$1 of solve" "$(value "$1")" "$history" 1e-12
    cp kept out
}
run history loads.csv $specimen --k 300
for name in left right stick_left stick_right yield_factor; do
    same_as_solve $name $name
done
same_as_solve p0 peak_pressure
same_as_solve max_tension tension_left
printf 'P,Q\n300,0\n300,80\n300,-30\n250,20\n' >center.csv
run history center.csv $specimen
slip=$(cells largest_slip | cut -d ' ' -f 4)
run profile $specimen --history center.csv --points 4001
close_to "largest slip of profile" "$(column slip out | awk '{ s = $1 < 0 ? -$1 : $1; if (s > m) m = s } END { print m }')" "$slip" 1e-4

# Under a moment the largest pressure has no closed form: it is found, between the points of profile.
run history $specimen --load 100,5,0,0
peak=$(cells peak_pressure)
run profile $specimen --load 100,5,0,0 --points 4001
close_to "peak pressure" "$(column p out | awk '{ if (-$1 > m) m = -$1 } END { print m }')" "$peak" 1e-6
place=$(by_name 'NR > 1 && -$p > m { m = -$p; at = $x } END { print at }' out)
run solve $specimen --P 100 --M 5
close_to "peak pressure of solve" "$(value p0)" "$peak" 1e-12
close_to "its place, to the points of profile" "$(value p0_x)" "$place" 0.01

# Energy of a cycle of Q under Hertz' pressure, from the loop of Q over the displacement by slip, r/2 + (1 - r) ln(1 - r)/2
# times A f P/pi with r = Q/(fP), which unloading and reloading follow twice (Mindlin, Masing).
printf 'P,Q\n135.75,30\n135.75,-30\n' >cycle.csv
does history cycle.csv $specimen --cycles 3
energies=$(cells energy)
close_to "energy of a cycle" "$(awk 'BEGIN { nu = 0.33; A = 4 * (1 - nu * nu) / 72100; f = 0.3; P = 135.75; r = 30 / (f * P); l = log(1 - r)
    d = r / 2 + (1 - r) * l / 2; I = r * r / 4 + (-(1 - r) ^ 2 / 2 * l + (1 - r) ^ 2 / 4 - 1 / 4) / 2
    printf "%.17g", 8 * A * f * f * P * P / 3.14159265358979324 * (r * d / 2 - I) }')" \
    "$(echo "$energies" | awk '{ printf "%.17g", $6 - $4 }')" 1e-11
message_is "rwedge history: dissipated in the last cycle: $(echo "$energies" | awk '{ printf "%.6g", $6 - $4 }')"
same "loads are counted" "1 2 3 4 5 6" "$(cells load)"
awk -F, 'NR == 4 || NR == 5 { for (i = 2; i <= 14; i++) old[NR + 2, i] = $i } NR > 5 { for (i = 2; i <= 14; i++) print old[NR, i], $i }' out >both
close_rows "the second cycle is the third" 1e-12 1e-15

# Stresses at points: those of field after the same loads, to the last digit; the file of points, and the grid.
run field $specimen --history loads.csv --x -0.2,0.1 --y 0,0.05
stresses='NR > 1 { print $sxx, $syy, $txy, $von_mises, $s1, $szz, $s2, $tau_max }'
by_name "$stresses" out >expected
does history loads.csv $specimen --at '-0.2,0;0.1,0;-0.2,0.05;0.1,0.05'
same "columns" "time,name,load,x,y,sxx,syy,szz,txy,s1,s2,von_mises,tau_max" "$(head -n 1 out)"
same "field" "$(cat expected)" "$(sed 's/"pull, again"/again/' out >plain && by_name "$stresses" plain | tail -n 4)"
cp out listed
printf 'name,x,y\na,-0.2,0\nb,0.1,0\nc,-0.2,0.05\nd,0.1,0.05\n' >points.csv
prints_kept "a file of points" listed history loads.csv $specimen --points points.csv
prints_kept "a grid" listed history loads.csv $specimen --x -0.2,0.1 --depth 0,0.05
run history --E1 72100 --nu1 0.33 --theta 0.05 --a 0 --f 0.3 --load 100,0 --at 0,0
same "the sharp apex" "1,0,0,,,,,,,," "$(tail -n 1 out)"

# A history that leaves the closed form, or cannot be: the line, why, and nothing written; with --until, what was before.
fails() { # MESSAGE TEXT
    printf "$2" >bad.csv
    rm -f x.csv
    cannot "bad.csv: $1" history bad.csv $specimen --exact -o x.csv
    same "nothing is written" no "$([ -e x.csv ] && echo yes || echo no)"
}
fails "line 3: no closed form: one edge of the contact would advance while the other recedes; separate the bodies, which forgets the history, then apply sigma with P = 0, then P and M, then Q; without --exact it is computed" \
    'P,M,Q\n100,5,20\n100,40,20\n'
fails "line 2: no closed form: the contact would grow under a shear that does not grow in proportion to it; apply it as two loads: first P and M, then Q and sigma; without --exact it is computed" \
    'P,Q,sigma\n100,20,30\n100,-20,-30\n'
printf 'P,M,Q\n100,5,20\n100,40,20\n' >bad.csv
does history bad.csv $specimen --exact --until
message_has "bad.csv: line 3: no closed form: one edge"
message_has "; the results end before it"
same "rows" 2 "$(wc -l <out | tr -d ' ')"
# A load that is not computed to ten times its tolerance, a tension of 1e14 under a pressure of hundreds, is named as well.
printf 'P,Q,sigma\n300,0,0\n300,20,10\n300,20,1e14\n' >hard.csv
flat="--E1 72100 --nu1 0.33 --flat 0.5 --radius 25 --f 0.5"
rm -f x.csv
cannot "hard.csv: line 4: an iteration did not converge: smaller loads may go" history hard.csv $flat -o x.csv
same "nothing is written" no "$([ -e x.csv ] && echo yes || echo no)"
refuses "--load 300,0,20,1e14: an iteration did not converge: smaller loads may go" history $flat --load 300,0 --load 300,0,20,1e14
does history hard.csv $flat --until
message_has "hard.csv: line 4: an iteration did not converge: smaller loads may go; the results end before it"
same "rows" 3 "$(wc -l <out | tr -d ' ')"
printf 'P,Q,T\n100,10,5\n100,-10,x\n' >unused.csv
run history unused.csv $specimen
message_is "rwedge history: unused.csv: columns with numbers that are not used: 'T'"
same "said once, not in the rows" 0 "$(grep -c 'not used' out)"
fails "column left: a result has that name; allowed: any other" 'P,Q,left\n1,0,0\n'
refuses "--load 100,31: Q 31: must not exceed f P = 30: there is no equilibrium; --clip lets it slide" history $specimen --load 100,0 --load 100,31
refuses "a file of loads must follow, with the columns P and Q, perhaps M or tilt, sigma; or --load P,Q for each" history $specimen

# Loads before those of a file: as if they stood in front of them, but for their rows and the numbers of the loads.
printf 'P,Q\n135.75,38\n135.75,-20\n' >rest.csv
run history rest.csv $specimen --load 135.75,0
sed 1d out | cut -d , -f 2- >apart
printf 'P,Q\n135.75,0\n135.75,38\n135.75,-20\n' >all.csv
run history all.csv $specimen
same "loads before the file" "" "$(sed 1,2d out | cut -d , -f 2- | diff apart -)"

# A tension that yields is said as such: P is far below P_yield = 986.
run history --E1 74100 --nu1 0.33 --theta 0.1 --radius 178 --f 0.65 --yield-stress 324 --load 0,0,0,100 --load 488,0,0,100 --load 488,0,195,180
message_has "a load yields the body: its stresses exceed the yield stress"
same "no word of P_yield" "" "$(grep P_yield err)"

refuses "--P 3: given together with loads.csv, which has the loads; allowed: one of the two" history loads.csv $specimen --P 3
refuses "missing: --f; friction has no default here" history loads.csv --E1 1 --nu1 0 --theta 0.1 --a 1
refuses "--at 1,-1: y is a depth, and must not be below 0" history loads.csv $specimen --at 1,-1
refuses "--at 1;2: must be points x,y separated by semicolons" history loads.csv $specimen --at '1;2'
refuses "--depth 1: needs --x" history loads.csv $specimen --depth 1
refuses "--output loads.csv: it is the input; allowed: another file" history loads.csv $specimen -o loads.csv
printf '1000,0\n1000,100\n' >bad.csv
cannot "bad.csv: column P: missing; a history needs P and Q; the first row has numbers, where the names of the columns must be" \
    history bad.csv $specimen
printf 'x,z\n1,2\n' >bad.csv
cannot "bad.csv: column y: missing; needed: x and y, the depth; the names there: 'x', 'z'; --column NAME='THEIR NAME' takes one" history loads.csv $specimen --points bad.csv
# Nothing of a file of points is dropped or guessed.
printf 'x,y,x\n1,2,3\n' >bad.csv
cannot "bad.csv: column x: there twice; allowed: once" history loads.csv $specimen --points bad.csv
printf 'node,x,y,S11\n1,0,0,-5.3\n' >stress.csv
run history loads.csv $specimen --points stress.csv
message_is "rwedge history: stress.csv: columns with numbers that are not used: 'S11'"
refuses "--output points.csv: it is the file of --points; allowed: another file" \
    history loads.csv $specimen --points points.csv -o points.csv
run history loads.csv $specimen --at '1,5;0,1;0,2'
message_is "rwedge history: --at 1,5;0,1;0,2: two values, 0 and 1; a decimal is written 0.1"
run history loads.csv $specimen --at '0,0;0,.1;0.5,0'
message_is ""
run history $specimen --load 135,02,0,0
message_is "rwedge history: --load 135,02,0,0: P 135 and M 02; a decimal is written 135.02"
run history $specimen --load 135,2,0,0 --load 135,0
message_is ""

# A step of P, Q and sigma together: the energy of the last cycle by boundary elements.
printf 'P,Q,sigma\n220,60,50\n180,-20,10\n' >dovetail.csv
run history dovetail.csv --load 200,0 --cycles 3 --radius 25 --E1 72100 --nu1 .33 --f .5
same "tractions have a closed form" "0 0 0 0 0 0" "$(column error out | paste -s -d ' ' -)"
same "slip and energy are known" "0 0" "$(column largest_slip out | grep -cx -) $(column energy out | grep -cx -)"
close_to "energy of the last cycle" 0.004234 "$(column energy out | awk 'NR == 4 { a = $1 } END { printf "%.17g", $1 - a }')" 1e-3

# A log that slides fully does not tell how far: its energy is that without this way.
printf 'P,Q\n100,30\n100,-30\n100,20\n' >slides.csv
run history slides.csv $specimen
same "rows that slide say so" "1 1 0" \
    "$(column warnings out | awk '{ print /it slides fully: the loads do not tell how far/ + 0 }' | paste -s -d ' ' -)"
same "and standard error" 1 "$(grep -c "it slides fully" err)"

# A specimen of finite thickness: under a constant P as if the cylinder had a parabola more, 1/R larger by
# 1.0420749/pi A1 P/t^2. The curvature of two opposite pads is that of half the thickness.
steel="--E1 72000 --nu1 0.33 --f 0.6"
run history $steel --radius 60 --load 120,0 --load 120,30 --specimen-thickness 5 --opposite
cp out opposite
message_has "a layer of 5.273 half-widths"
message_has "P stretches body 1 as a sigma of 23.49 does"
run history $steel --radius 60 --load 120,0 --load 120,30 --specimen-thickness 2.5
same "half of it on a base" "$(cat opposite)" "$(cat out)"
R=$(awk 'BEGIN { A1 = 2 * (1 - 0.33 * 0.33) / 72000; printf "%.17g", 1 / (1 / 60 + 1.0420749174684513 / 3.14159265358979324 * A1 * 120 / 2.5 ^ 2) }')
width=$(cells right)
run history $steel --radius "$R" --load 120,0 --load 120,30
close_to "half-width" "$(cells right | cut -d ' ' -f 2)" "$(echo "$width" | cut -d ' ' -f 2)" 1e-12
# Unlike bodies whose pad is free: a thick layer is the half-plane, and a thin one narrows the contact as one of similar bodies.
unlike="$steel --E2 210000 --nu2 0.3 --radius 60 --load 120,0 --load 120,36"
half_widths() { by_name 'NR == 2 { printf "%.17g", $right } END { printf " %.17g %.17g", $left, $right }' out; }
run history $unlike --rotation free && half_widths >free
run history $unlike --rotation free --specimen-thickness 2000 && half_widths >thick
run history $unlike --rotation free --specimen-thickness 2.5 && half_widths >thin
run history $unlike --similar && half_widths >similar_half
run history $unlike --similar --specimen-thickness 2.5 && half_widths >similar_thin
for i in 1 2 3; do
    close_to "edge $i of a thick layer" "$(cut -d ' ' -f $i free)" "$(cut -d ' ' -f $i thick)" 1e-5
done
close_to "a thin layer" "$(cut -d ' ' -f 1 similar_half similar_thin | paste -s -d ' ' - | awk '{ printf "%.17g", $2 / $1 }')" \
    "$(cut -d ' ' -f 1 free thin | paste -s -d ' ' - | awk '{ printf "%.17g", $2 / $1 }')" 1e-4

refuses "--specimen-thickness 1: must be at least 1.90543, twice the width of the contact" \
    history $steel --radius 60 --load 120,0 --specimen-thickness 1 --opposite
refuses "--load 100,30: P 100: must stay that of the first load, 120, with --specimen-thickness" \
    history $steel --radius 60 --load 120,0 --load 100,30 --specimen-thickness 5
refuses "--opposite: needs --specimen-thickness" history $steel --radius 60 --load 120,0 --opposite
refuses "--specimen-thickness 5: not of a pad that is held at a tilt" \
    history $steel --radius 60 --load 120,0 --tilt 0.001 --specimen-thickness 5
refuses "--specimen-thickness thin: must be a number above 0, in the working units" \
    history $steel --radius 60 --load 120,0 --specimen-thickness thin
run history $steel --radius 60 --load 120,0 --load 120,30 --specimen-thickness '5000 um' --opposite --units mm,N,MPa
same "with its unit" "$(cat opposite)" "$(cat out)"
for command in "fretting --at 0,0" "crack --edge left --lengths 0.1"; do
    # shellcheck disable=SC2086
    run $command $steel --radius 60 --load 120,30 --load 120,-30 --specimen-thickness 5 --opposite --digits 8
    cp out layer
    message_has "a layer of 5.273 half-widths"
    # shellcheck disable=SC2086
    run $command $steel --radius "$R" --load 120,30 --load 120,-30 --digits 8
    same "the same by $command" "$(cat layer)" "$(cat out)"
done

finish

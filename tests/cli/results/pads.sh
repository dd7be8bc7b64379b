# SPDX-License-Identifier: GPL-3.0-or-later
# Other pads than the wedge: cylinder, flat pad, profile; each against a contact that is the same, or a formula.
. "$(dirname "$0")/../claims.sh"

pi=3.14159265358979323846
steel="--E1 210000 --nu1 0.3"
loads="--P 300 --Q 40 --f 0.3"
same_results() { # WHAT RELATIVE FILE FILE: numbers of both lists, and what is empty; p0_x, a place that is looked for, is not exact
    awk -F, 'NR == FNR { one[$1] = $2; next } $2 ~ /^-?[0-9]/ && $1 in one && $1 != "p0_x" { print $2, one[$1] }' "$4" "$3" >both
    close_rows "$1" "$2" 1e-15
}

# A cylinder is a wedge of which only the rounding touches.
kept wedge solve $steel --theta 0.1 --radius 10 $loads --k 500 --yield-factor
does_quietly solve $steel --radius 10 $loads --k 500 --yield-factor
same_results "cylinder" 1e-13 out wedge
same "what only a wedge has" "a a_over_b AP_over_theta_b p_transition" \
    "$(awk -F, 'NR == FNR { wedge[$1] = $2; next } $2 == "" && wedge[$1] != "" { print $1 }' wedge out | paste -s -d ' ' -)"
printf 'P,M,Q,sigma\n300,0,0,0\n300,0,50,20\n300,0,-40,-10\n' >loads.csv
for command in "profile --history loads.csv --points 9" "field --history loads.csv --x -0.1,0.2 --y 0,0.1" \
    "history loads.csv --k 500" "fretting loads.csv --x -0.1:0.1:0.05" "figure fretting --data --history loads.csv" \
    "figure loop --data --history loads.csv --load 100,0"; do
    kept wedge $command $steel --f 0.3 --theta 0.1 --radius 10 --digits 5
    prints_kept "$command" wedge $command $steel --f 0.3 --radius 10 --digits 5
done
kept wedge solve $steel --theta 0.1 --P 300 --f 0.3 --k 500 --for radius --safety 2
run solve $steel --P 300 --f 0.3 --k 500 --for radius --safety 2
same_results "radius that is looked for" 1e-13 out wedge

# A flat pad of half the contact's width: load and tension by Ciavarella, Hills and Monno (1998).
A=$(awk 'BEGIN { printf "%.17g", 4 * (1 - 0.09) / 210000 }')
P=$(awk -v A="$A" -v pi=$pi 'BEGIN { c = sqrt(0.75); printf "%.17g", 4 / (A * 100) * (pi / 3 - 0.5 * c) }')
run solve $steel --flat 1 --radius 100 --P "$P" --Q 0 --f 0.3 --k 500
close_to "b" 2 "$(value b)" 1e-14
same "the pressure is largest beyond a corner" 1 "$(value p0_x | awk '{ x = $1 < 0 ? -$1 : $1; print (x > 1 && x < 2) }')"
close_to "max_tension_sliding" "$(awk -v P="$P" -v pi=$pi 'BEGIN { printf "%.17g", 0.3 * P / 2 / (pi / 3 - sqrt(3) / 4) }')" \
    "$(value max_tension_sliding)" 1e-13
close_to "P_over_bk" "$(value P_over_bk)" "$(awk -v P="$P" -v v="$(value von_mises_sliding)" \
    'BEGIN { printf "%.17g", P / 2 / (v / sqrt(3)) }')" 1e-13
P_yield=$(value P_yield)
run solve $steel --flat 1 --radius 100 --P "$P_yield" --Q "$(awk -v P="$P_yield" 'BEGIN { printf "%.17g", 0.3 * P }')" \
    --f 0.3 --k 500 --yield-factor
close_to "yield factor at P_yield" 1 "$(value yield_factor)" 1e-11
close_to "safety at P_yield" 1 "$(value safety)" 1e-11
run solve $steel --flat 1 --radius 100 --P "$P" --f 0.3 --k 500
P_shakedown=$(value P_shakedown)
run solve $steel --flat 1 --radius 100 --P "$P_shakedown" --f 0.3 --k 500
close_to "safety_shakedown at P_shakedown" 1 "$(value safety_shakedown)" 1e-9
b=$(value b)
run table shakedown-limit --pad flat --a-over-b "$(awk -v b="$b" 'BEGIN { printf "%.17g", 1 / b }')" --friction 0.3 --nu 0.3
close_to "P_shakedown of the table" "$(cell P_over_bk 1)" "$(awk -v P="$P_shakedown" -v b="$b" \
    'BEGIN { printf "%.17g", P / b / 500 }')" 1e-9

# The same pad by its slopes, and by heights of its arcs: parabolas, whose slopes half-way are exact.
printf 'x;slope\n-101;-1\n-1;0\n1;0\n101;1\n' >slopes.csv
awk 'BEGIN { print "x,height"; for (i = -100; i <= 100; i++) { x = i / 10; print x "," x * x / 200 } }' >heights.csv
kept first solve $steel --flat 1 --radius 100 $loads --k 500 --yield-factor
run solve $steel --profile slopes.csv $loads --k 500 --yield-factor --decimal-comma
sed 's/,/./g; s/;/,/g' out >second
mv second out
same_results "flat pad by its slopes" 1e-10 out first
kept first solve $steel --radius 100 $loads
does solve $steel --profile heights.csv $loads
same_results "cylinder by heights" 1e-10 out first

printf 'x,slope\n-1,-0.1\n-0.4,-0.02\n0.1,-0.02\n0.5,0.05\n0.8,0.12\n' >worn.csv
printf 'x,slope\n-1,-0.1\n0,-0.1\n0,0\n1,0.1\n' >edge.csv
run profile $steel --profile edge.csv $loads --x -0.01,0,0.01
same "p at a sharp edge" "yes - yes" "$(column p out | sed 's/^-[0-9].*/yes/' | paste -s -d ' ' -)"
run fretting loads.csv $steel --f 0.3 --profile edge.csv --x 0,0.05
same "measures at a sharp edge" "0,0,,,,,,,,," "$(sed -n 2p out)"

# The convex hull of heights.
printf 'x,height,note\n-1,0.1,1\n-0.5,0.02,2\n0,0.03,3\n0.3,0.001,4\n0.5,0.02,5\n1,0.1,6\n' >dent.csv
printf 'x,height\n-1,0.1\n-0.5,0.02\n0,0.008125\n0.3,0.001\n0.5,0.02\n1,0.1\n' >filled.csv
kept first solve $steel --profile filled.csv $loads
run solve $steel --profile dent.csv --hull $loads
message_has "rwedge solve: dent.csv: line 4: height 0.03: not convex at 1 place, x = 0; the convex hull that is taken is lower by up to \
0.021875, at x = 0; dent.csv: columns with numbers that are not used: 'note'"
same_results "hull" 1e-11 out first

# What it changes in the contact is compared with the rise of the pad there: of a cylinder, b^2/(2 R) at the edge, and a bump that
# is 40 % of that above the chord of its neighbours, dx^2/(2 R) above it. Outside of the contact it does not matter.
with_bump() { # PLACE
    awk -v at="$1" 'BEGIN { R = 50; dx = 0.01; b = 0.52523; print "x,height"
        for (i = -200; i <= 200; i++) { x = i * dx; h = x * x / (2 * R)
            printf "%.9g,%.12g\n", x, h + (i * dx > at - dx / 2 && i * dx < at + dx / 2 ? (0.4 * b * b + dx * dx) / (2 * R) : 0) } }' >bump.csv
    run solve --E1 210000 --nu1 0.3 --P 500 --profile bump.csv --hull
}
with_bump 0.2
same "the hull in the contact" "in the contact the hull lowers the pad by up to 40 % of its rise there: p0 may be far too high; --fit is for noise" \
    "$(value warnings)"
message_has "rwedge solve: in the contact the hull lowers the pad by up to 40 % of its rise there"
with_bump 0.9
same "the hull outside of it" "" "$(value warnings)"

# Many pads.
printf 'case,flat,radius,P\n1,1,100,300\n2,0,100,300\n' >cases.csv
run solve -i cases.csv $steel --Q 40 --f 0.3
run_error=$(column error out | paste -s -d '|' -)
same "errors" "-|flat 0: the half-width of the flat must be a number above 0" "$run_error"
close_to "b in a file" "$(value_b=$("$rwedge" solve $steel --flat 1 --radius 100 --P 300 --f 0); echo "$value_b" | awk -F, '$1 == "b" { print $2 }')" \
    "$(column b out | head -n 1)" 1e-14
printf 'profile,P\ndent.csv,300\nworn.csv,300\nnone.csv,300\n' >cases.csv
run solve -i cases.csv $steel --threads 2
same "errors" "profile dent.csv: line 4: height 0.03: not convex at 1 place|-|profile none.csv: No such file or directory" \
    "$(awk -F, 'NR > 1' out | sed 's/.*,"\{0,1\}\(profile [^,"]*\).*/\1/; s/^worn.*/-/' | paste -s -d '|' -)"
run solve -i cases.csv $steel --hull
message_has "dent.csv: line 4: height 0.03: not convex at 1 place"
same "rows that are solved" 2 "$(column b out | grep -c '^[0-9]')"

# A file of contacts does not have the tool wait for a pipe, or read its own standard input.
mkfifo pipe.csv
printf 'profile,P\npipe.csv,300\n-,300\nworn.csv,300\n' >cases.csv
shell 'timeout 20 "$rwedge" solve -i cases.csv $steel'
status_is 0
same "errors" "profile pipe.csv: a cell may name a regular file alone|profile -: a cell may name a regular file alone|-" \
    "$(column error out | paste -s -d '|' -)"
printf 'profile,P\nworn.csv,300\n' >cases.csv
refuses "--output worn.csv: it is the file of a cell in column profile; allowed: another file" solve -i cases.csv $steel -o worn.csv

# What is no pad.
refuses "missing: --radius" solve $steel $loads --flat 1
refuses "--flat -1: the half-width of the flat must be a number above 0" solve $steel $loads --flat -1 --radius 1
refuses "--radius 0: the radius must be a number above 0" solve $steel $loads --flat 1 --radius 0
refuses "--radius 0: the radius must be a number above 0, or an angle is missing" solve $steel $loads --radius 0
refuses "--flat 1: given together with --theta; allowed: one of the two" solve $steel $loads --theta 0.1 --radius 1 --flat 1
refuses "--profile worn.csv: given together with --radius; allowed: one of the two" \
    solve $steel $loads --radius 1 --profile worn.csv
refuses "--hull: needs --profile" history loads.csv $steel --f 0.3 --radius 1 --hull
printf 'P\n1\n' >cases.csv
refuses "--hull: needs --profile, or a column profile" solve -i cases.csv $steel --hull --radius 1
refuses "--output worn.csv: it is the file of --profile; allowed: another file" solve $steel $loads --profile worn.csv -o worn.csv
does solve $steel --profile worn.csv --P 300 --k 900 --for f --safety 1.1
close_to "safety of a profile" 1.1 "$(value safety)" 1e-10
cannot "no solution: none is found, as far as the pad is known" \
    solve $steel --flat 1 --radius 100 --P 300 --k 500 --for f --safety 900

cannot "b: the contact would reach farther than the radius, or results leave 1e-60 to 1e60" \
    solve $steel --P 1e9 --flat 1 --radius 1
bad() { # MESSAGE LINES
    printf "$2" >bad.csv
    cannot "profile bad.csv: $1" solve $steel $loads --profile bad.csv
}
bad "line 2: slope 0: less than the slope before it: the profile is not convex there; allowed: slopes that do not fall" \
    'x,slope\n-1,0\n-2,1\n'
bad "line 3: height 0.1: the heights point down; --heights down turns them" 'x,height\n-1,0\n0,0.1\n1,0\n'
bad "line 4: height 0.2: not convex at 1 place, x = 0; the convex hull is lower by up to 0.1, at x = 0; of noise, --fit; --hull \
takes it" 'x,height\n-2,1\n-1,0.1\n0,0.2\n1,0.1\n2,1\n'
bad "line 3: slope -0.2: less than the slope before it: the profile is not convex there; allowed: slopes that do not fall" \
    'x,slope\n-1,-0.1\n0,-0.2\n1,0\n'
bad "line 3: slope b: must be a number, with a decimal point" 'x,slope\n-1,0\n0,b\n'
bad "1 row without a number, the first in line 3, column x: ''; --drop leaves such rows out" 'x,slope\n-1,0\n,1\n'
bad "line 3: slope 1.6: must be below pi/2 in magnitude" 'x,slope\n-1,0\n0,1.6\n'
bad "line 2: 1 place; allowed: 2 to 1000" 'x,height\n0,0\n0,1\n'
bad "line 3: slope 0.1: all slopes are equal: a plane" 'x,slope\n-1,0.1\n0,0.1\n'
bad "line 2: 1 place; allowed: 2 to 1000" 'x,slope\n-1,0.1\n'
bad "column slope: missing; needed: x, and slope or height; the names there: 'x', 'z'; --column NAME='THEIR NAME' takes one" 'x,z\n-1,0.1\n'
bad "column height: given together with slope; allowed: one of the two" 'x,height,slope\n-1,0.1,0\n'

finish

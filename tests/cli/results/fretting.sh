# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge fretting: what a cycle of loads does to each place. The measures themselves are tested in tests/lib/cycle, measures and
# life; here it is that the right ones stand in the right columns, by closed forms and other commands.
. "$(dirname "$0")/../claims.sh"

# worst NAME: the place and the value of a measure in the last line of stderr, "x value".
worst() {
    sed -n "s/.*worst: \(.*; \)\{0,1\}$1 \([^ ]*\) at x = \([^;]*\).*/\3 \2/p" err
}
# at X NAME: of the row at that place, to 1e-9.
at() {
    awk -F, -v x="$1" -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
        ($1 - x) ^ 2 < 1e-18 { print $c; exit }' out
}

# The test of Nowell and Hills through a whole cycle, Q and the bulk tension in phase.
printf 'P,Q,sigma\n135.75,0,0\n135.75,38.75,100\n135.75,-38.75,-100\n' >hills.csv
does fretting hills.csv $specimen --yield-stress 500
same "columns" "x,y,stress_range,swt,swt_angle,fatemi_socie,fs_angle,slip_range,ruiz_f1,ruiz_f2,energy_per_area" "$(head -n 1 out)"
same "places ascend" "" "$(column x out | awk 'NR > 1 && !($1 > last) { print } { last = $1 }')"
cp out whole
cp err said

# The edges of contact and stick zone after each load are places.
run history hills.csv $specimen --cycles 2
part_of out left right stick_left stick_right | tail -n 3 | tr , '\n' | sort -u >edges
cp out states
cp whole out
same "edges" "" "$(while read -r x; do [ -n "$(at "$x" x)" ] || echo "$x"; done <edges)"
left=$(column left states | tail -n 1)

# The worst of SWT is at the trailing edge: sxx alone acts there, from -345.747 to 345.747 (see off_centre.sh), and so
# SWT = 345.747 (1 - nu^2)/E 345.747 on the plane across the surface; its range is that of sxx.
cp said err
close_to "place of the worst SWT" "$left" "$(worst swt | cut -d ' ' -f 1)" 1e-5
close_to "the worst SWT" "$(awk 'BEGIN { printf "%.17g", 345.747 ^ 2 * (1 - 0.33 ^ 2) / 72100 }')" "$(at "$left" swt)" 5e-6
same "its plane" 90 "$(at "$left" swt_angle)"
close_to "the worst stress range" 691.494 "$(at "$left" stress_range)" 2e-6
for name in stress_range swt fatemi_socie slip_range ruiz_f1 ruiz_f2 energy_per_area; do
    close_to "the line names the largest row of $name" "$(column $name out | awk '$1 > m { m = $1 } END { printf "%.6g", m }')" "$(worst $name | cut -d ' ' -f 2)" 0
done

# Slip of a cylinder under a cycle of Q: the range is 2 f/R times the integral of sqrt(t^2 - c^2) from c to x (Cattaneo, Mindlin).
# At each place the shear is f p where it slips, so the energy is 2 f p times the range, and Ruiz' F1 is f p times it.
printf 'P,Q\n135.75,0\n135.75,30\n135.75,-30\n' >cycle.csv
run fretting cycle.csv $specimen
by_name 'BEGIN { nu = 0.33; pi = 3.14159265358979324; f = 0.3; R = 10; P = 135.75; A = 4 * (1 - nu * nu) / 72100
        b = sqrt(2 * A * P * R / pi); c = b * sqrt(1 - 30 / (f * P)); p0 = 2 * P / (pi * b) }
    NR > 1 && $slip_range != "" { at = $x < 0 ? -$x : $x; if (at > b) at = b; s = 0; p = p0 * sqrt(1 - at * at / (b * b))
        if (at > c) { w = sqrt(at * at - c * c); s = f / R * (at * w - c * c * log((at + w) / c)) }
        printf "%.17g %s\n%.17g %s\n", s, $slip_range, 2 * f * p * s, $energy_per_area
        if (at > c) printf "%.17g %s\n", f * p * s, $ruiz_f1 }' out >both
close_rows "slip range, energy, F1" 1e-6 1e-10
same "places in contact" yes "$(by_name 'NR > 1 && $slip_range != "" { n++ } END { if (n > 200) print "yes" }' out)"

# Where it sticks and stays compressed, shear alone changes: only Fatemi and Socie's sees it, and the line does not say that nothing changes.
run history cycle.csv $specimen --cycles 1 --at 0,0
same "txy changes" 3 "$(column txy out | sort -u | wc -l | tr -d ' ')"
run fretting cycle.csv $specimen --at 0,0
message_is "rwedge fretting: worst: none; every measure is 0 or empty at these places"
run fretting cycle.csv $specimen --at 0,0 --yield-stress 500
message_has "rwedge fretting: worst: fatemi_socie "

# F2 is F1 times the largest tension, 0 where there is none.
run history cycle.csv $specimen --cycles 2 --at -0.2,0
tension=$(column sxx out | tail -n 3 | sort -g | tail -n 1)
run fretting cycle.csv $specimen --at '-0.2,0;0,0'
close_to "F2" "$(by_name 'NR == 2 { printf "%.17g", s * $ruiz_f1 }' out -v s="$tension")" "$(cell ruiz_f2 1)" 1e-12
same "F2 in compression" 0 "$(cell ruiz_f2 2)"

# Under constant P the second cycle is like the third, the first is not; there are two unless P changes.
printf 'P,Q\n135.75,10\n135.75,30\n135.75,-20\n' >cycle.csv
for cycles in 1 2 3; do
    kept after_$cycles fretting cycle.csv $specimen --x=-0.25:0.25:0.01 --cycles $cycles
done
paste -d , after_2 after_3 | awk -F, 'NR > 1 { for (i = 3; i <= 11; i++) if ($i != "" && i != 5 && i != 7) print $i, $(i + 11) }' >both
close_rows "the second cycle and the third" 1e-9 1e-12
same "the first cycle" differs "$(cmp -s after_1 after_2 || echo differs)"
prints_kept "two cycles by default" after_2 fretting cycle.csv $specimen --x=-0.25:0.25:0.01
printf 'P,Q\n100,10\n150,40\n110,-20\n' >cycle.csv
kept after_3 fretting cycle.csv $specimen --x=-0.25:0.25:0.01 --cycles 3
prints_kept "three by default where P changes" after_3 fretting cycle.csv $specimen --x=-0.25:0.25:0.01

# Loads before the first cycle, once. A tangential force of 38 leaves its mark: the stresses and the slip are those of history and
# profile, where the loads and five cycles stand in one file; the parameter outside the contact, where sxx acts alone, from them.
printf 'P,Q,sigma\n135.75,20,100\n135.75,5,40\n' >cycle.csv
once="--load 135.75,0 --load 135.75,0,38,60"
{
    printf 'P,Q,sigma\n135.75,0,0\n135.75,38,60\n'
    for cycle in 1 2 3 4 5; do tail -n 2 cycle.csv; done
} >all.csv
sed '$d' all.csv >but_one.csv
places="-0.25,-0.21,-0.2,0.1,0.2"
run history all.csv $specimen --x=$places --depth 0
column sxx out | tail -n 10 | head -n 5 >high
column sxx out | tail -n 5 | paste -d , high - >tensions
for file in but_one all; do
    run profile $specimen --history $file.csv --x=$places
    column slip out | tail -n 5 >slip_$file
done
paste -d , tensions slip_but_one slip_all >other_route
kept marked fretting cycle.csv $specimen $once --x=$places
tail -n 5 out | paste -d , other_route - | awk -F, 'function size(v) { return v < 0 ? -v : v }
    { printf "%.17g %s\n", size($1 - $2), $7
      if ($12 != "") printf "%.17g %s\n", size($3 - $4), $12
      else printf "%.17g %s\n", $1 * ($1 - $2) / 2 * (1 - 0.33 ^ 2) / 72100, $8 }' >both
same "numbers to compare" 10 "$(wc -l <both | tr -d ' ')"
close_rows "the same by history and profile" 1e-9 1e-12
run fretting cycle.csv $specimen --load 135.75,0 --x=$places
same "without that force" differs "$(cmp -s out marked || echo differs)"
# The file by either way, any number of threads; and a first row that is the last of these loads.
run fretting $specimen $once --history - --x=$places --threads 3 <cycle.csv
same "the file by --history" "" "$(cmp out marked 2>&1)"
run fretting cycle.csv $specimen $once --load 135.75,0,20,100 --x=$places
paste -d , marked out | awk -F, 'NR > 1 { for (i = 3; i <= 11; i++) if ($i != "" && i != 5) print $i, $(i + 11) }' >both
close_rows "a first row that is there already" 1e-9 1e-12
printf 'P,Q,sigma\n135.75,38.75,100\n135.75,-38.75,-100\n' >cycle.csv
# Yield under one of them alone is said.
run fretting cycle.csv $specimen --load 135.75,0 --yield-stress 500 --at 0,0
same "within its strength" 1 "$(wc -l <err | tr -d ' ')"
run fretting cycle.csv $specimen --load 2000,0 --load 135.75,0 --yield-stress 500 --at 0,0
message_has "rwedge fretting: P is above P_yield: the contact yields in full sliding"
refuses "--load 135.75,41: Q 41: must not exceed f P = 40.725: there is no equilibrium" \
    fretting cycle.csv $specimen --until --load 135.75,0 --load 135.75,41
printf 'P,Q\n135.75,20\n135.75,-20\n135.75,41\n' >ends.csv
run fretting ends.csv $specimen --until
status_is 2
message_has "rwedge fretting: --until: the loads end before the last one; a cycle needs all of them: leave it out, and mend or remove the line that is named"
refuses "cycle.csv: given together with --history; allowed: one of the two" \
    fretting cycle.csv $specimen --history all.csv --load 135.75,0
cannot "cycle.csv: line 2: no closed form: the contact would grow under a shear that does not grow in proportion to it; apply it as two loads: first P and M, then Q and sigma; without --exact it is computed" \
    fretting cycle.csv $specimen --load 135.75,0 --load 0,0 --exact

# Any number of threads.
printf 'P,M,Q,sigma\n100,5,0,0\n100,5,20,40\n100,5,-15,-20\n' >one.csv
for threads in 1 2 64; do
    run fretting one.csv $specimen --k 300 --x=-0.4:0.4:0.002 --depth 0,0.01 --threads $threads
    [ $threads != 1 ] || cp out one
    same "bytes with $threads threads" "" "$(cmp one out 2>&1)"
done

# A coarse grid of the user's stays as it is, and the last line still finds the edge.
run fretting hills.csv $specimen --x=-0.3:0.3:0.1
same "rows" "-0.3 -0.2 -0.1 0 0.1 0.2 0.3" "$(column x out | paste -s -d ' ' -)"
close_to "the worst SWT of the line" "$(awk 'BEGIN { printf "%.17g", 345.747 ^ 2 * (1 - 0.33 ^ 2) / 72100 }')" "$(worst swt | cut -d ' ' -f 2)" 1e-5
same "no slip below the surface, or outside" "- -" "$(column slip_range out | sed -n '1p;$p' | paste -s -d ' ' -)"
same "no yield stress" "- -" "$(column fatemi_socie out | sed -n '1p;$p' | paste -s -d ' ' -)"

# What has no closed form is empty, and a line says so; the apex of the sharp wedge is empty.
printf 'P,M,Q\n100,5,0\n100,5,30\n120,6,36\n' >grow.csv
does fretting grow.csv $specimen --cycles 1 --at 0,0
message_has "the slip has no closed form after these loads: slip_range, ruiz_f1, ruiz_f2 and energy_per_area are empty"
same "slip" "-" "$(column slip_range out)"
printf 'P,Q\n100,0\n100,20\n' >sharp.csv
run fretting sharp.csv --E1 72100 --nu1 0.33 --theta 0.05 --a 0 --f 0.3 --at '0,0;0.01,0'
same "apex" "0,0,,,,,,,,," "$(sed -n 2p out)"

# Removal under a tension that changes has no closed form on the way: what slips then is not left out, but empty.
does fretting --E1 74100 --nu1 0.33 --theta 0.1 --radius 178 --f 0.65 --load 488,0,0,0 --load 488,0,195,100 --load 488,0,-195,-100 \
    --load 0,0,0,0 --cycles 1 --at 0.5,0 --exact
message_has "the slip has no closed form after these loads"
same "slip of a removal" "-" "$(column slip_range out)"

# Time like n: 60 loads of random P and Q on many places. It was minutes.
awk 'BEGIN { srand(5); print "P,Q"; for (i = 0; i < 60; i++) { P = 60 + 100 * rand(); printf "%.9g,%.9g\n", P, (1.9 * rand() - 0.95) * 0.3 * P } }' >many.csv
begun=$(date +%s)
run fretting many.csv $specimen
same "60 loads take seconds" yes "$([ $(($(date +%s) - begun)) -lt 20 ] && echo yes)"
same "a few hundred places" yes "$([ "$(wc -l <out)" -lt 700 ] && echo yes)"

# Plane stress by the constants of plane strain: the shear strain of Fatemi and Socie has 1 + nu, which nu = 0 leaves out.
printf 'P,Q\n135.75,0\n135.75,38\n135.75,-38\n' >shear.csv
shape="--theta 0.05 --radius 10 --f 0.3 --yield-stress 500 --at -0.21,0"
run fretting shear.csv --E1 72100 --nu1 0 $shape
wrong=$(column fatemi_socie out)
run fretting shear.csv --E1 72100 --nu1 0.33 --plane-stress $shape
close_to "Fatemi-Socie in plane stress" "$(awk -v w="$wrong" 'BEGIN { printf "%.17g", 1.33 * w }')" "$(column fatemi_socie out)" 1e-9

# Criteria: only columns that are asked for. At the trailing edge sxx alone acts, from -345.747 to 345.747, in plane strain:
# s1, szz = nu s1 and 0. So the largest shear amplitude is half of 345.747, on planes with the normal stress of its half;
# Findley's is (k + sqrt(1 + k^2))/2 of it; the deviator swings by sqrt((1 - nu + nu^2)/3) of it.
usual=$(head -n 1 whole)
run fretting hills.csv $specimen --at 0,0 --criteria crossland,swt --crossland-alpha 0.3
same "columns that are asked for" "$usual,swt_out_of_plane,crossland" "$(head -n 1 out)"
run fretting hills.csv $specimen --findley-k 0.3 --kappa 30 --lambda 100 --t-a 160 --su 500 --crossland-alpha 0.3 --dang-van-alpha 0.2 --worst worst.csv
same "columns whose constants are given" "findley,findley_angle,findley_out_of_plane,modified_wohler,modified_wohler_angle,modified_wohler_out_of_plane,mcdiarmid,mcdiarmid_angle,mcdiarmid_out_of_plane,crossland,dang_van" \
    "$(head -n 1 out | cut -d , -f 12-)"
expect="findley modified_wohler mcdiarmid crossland dang_van"
awk 'BEGIN { s = 345.747; nu = 0.33; print s / 2 * (0.3 + sqrt(1.09)); print s / 2 + 30; print s / 2 / 160 + s / 4 / 500 * 1
    H = s * (1 + nu) / 3; print s * sqrt((1 - nu + nu * nu) / 3) + 0.3 * H; print s / 2 + 0.2 * H }' >expected
for name in $expect; do
    column "$name" out | awk '$1 > m { m = $1 } END { printf "%.17g\n", m }'
done | paste -d ' ' expected - >both
close_rows "criteria in tension" 5e-6 0
part_of worst.csv measure value x | tr , ' ' | while read -r name value x; do
    echo "$(worst "$name") $x $value"
done | awk '{ print $1, $3; print $2, $4 }' >both
same "measures in the table of the worst" 11 "$(sed 1d worst.csv | wc -l | tr -d ' ')"
close_rows "the table of the worst is the line" 1e-5 0
same "the angles of Findley's plane" yes "$(by_name '$measure == "findley" && ($angle < 0 ? -$angle : $angle) > 45 && $out_of_plane == 0 { print "yes" }' worst.csv)"
# P and Q in phase: the worst plane does not contain z, and planes that do have 6 % less.
printf 'P,Q\n2000,600\n400,120\n' >phase.csv
run fretting phase.csv --E1 200e3 --nu1 0.3 --theta 0.01 --a 2 --f 0.6 --yield-stress 500 --criteria fatemi-socie
same "off z" yes "$(by_name 'NR > 1 && $fatemi_socie > m { m = $fatemi_socie; o = $fs_out_of_plane }
    END { if (o > 20 && o < 70) print "yes"; else print o }' out)"
# Verdicts: at the worst place of the surface, at half of a length below it, as the mean over twice of it.
printf 'name,value\nE,72100\nnu,0.33\ncrossland_alpha,0.3\ncrossland_limit,100\nsf,475.4\nb,-0.078\nef,0.612\nc,-0.62\nswt_limit,0.6\ndK_th,60\nds0,250\n' >metal.csv
printf '{"source": "none", "E": 72100, "nu": 0.33, "crossland_alpha": 0.3, "crossland_limit": 100, "dK_th": 60, "ds0": 250}' >metal.json
shape="--theta 0.05 --radius 10 --f 0.3 --load 135.75,0 --K-in mm"
verdict() { awk -F, -v name="$2" -v row="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } $1 == row { print $c }' out; }
does fretting cycle.csv $shape --material metal.csv --at-worst
same "the columns of a verdict" "measure,value,x,y,length,at_length,angle,out_of_plane,allowable,safety,life,cycles,shakedown_lower,shakedown_upper,load_factor" "$(head -n 1 out)"
same "criteria alone" "swt crossland swt_damage" "$(column measure out | paste -s -d ' ' -)"
close_to "safety" "$(awk -v v="$(verdict crossland value)" 'BEGIN { printf "%.17g", 100 / v }')" "$(verdict crossland safety)" 1e-14
close_to "its factor on the loads" "$(verdict crossland safety)" "$(verdict crossland load_factor)" 0
close_to "SWT goes with the square of the stresses" "$(awk -v s="$(verdict swt safety)" 'BEGIN { printf "%.17g", sqrt(s) }')" "$(verdict swt load_factor)" 1e-15
same "damage has no factor" "" "$(verdict swt_damage load_factor)"
close_to "the life has the parameter" "$(verdict swt value)" "$(awk -v N="$(verdict swt life)" 'BEGIN {
    printf "%.17g", 475.4 ^ 2 / 72100 * (2 * N) ^ -0.156 + 475.4 * 0.612 * (2 * N) ^ -0.698 }')" 1e-12
# The modified Woehler curve at the edge of contact; nothing cycles far from it under a mean tension, where it was worst.
printf 'P,Q,sigma\n93.2489395167137,41.96202278252117,110\n93.2489395167137,-41.96202278252117,-70\n' >rig.csv
printf 'E,74000\nnu,0.33\nkappa,40\nlambda,71\ndK_th,4.2 MPa sqrt(m)\nds0,248\n' >al4cu.csv
does fretting rig.csv --radius 50 --f 0.75 --units mm,N,MPa --material al4cu.csv --at-worst --method point --criteria modified-wohler
close_to "the worst place" -0.378 "$(verdict modified_wohler x)" 1e-3
close_to "the modified Woehler curve below it" 125.06 "$(verdict modified_wohler at_length)" 1e-4
close_to "its safety" 0.568 "$(verdict modified_wohler safety)" 1e-3
# Its ratio of stresses is at rho_lim = lambda/(2 kappa) there: tau_a = 125.06 - 71/2, of which (71 - 71/2) is allowed.
close_to "its factor on the loads" 0.3964 "$(verdict modified_wohler load_factor)" 2e-4
printf 'P,Q,sigma\n93.2489395167137,41.96202278252117,100\n93.2489395167137,0,10\n' >rig.csv
does fretting rig.csv --radius 50 --f 0.75 --units mm,N,MPa --material al4cu.csv --at-worst --method point --criteria modified-wohler
close_to "the worst place at another ratio" -0.378 "$(verdict modified_wohler x)" 1e-3
does fretting cycle.csv $shape --material metal.csv --at-worst
x=$(verdict crossland x)
run fretting cycle.csv $shape --material metal.csv --at-worst --length 0.02 --criteria crossland
same "one row" 2 "$(wc -l <out | tr -d ' ')"
at_length=$(verdict crossland at_length)
run fretting cycle.csv --E1 72100 --nu1 0.33 $shape --criteria crossland --crossland-alpha 0.3 --at "$x,0.01"
close_to "Crossland at half of the length" "$(column crossland out)" "$at_length" 1e-8
run fretting cycle.csv $shape --material metal.json --at-worst --method line --criteria crossland
close_to "the length of the material" "$(awk 'BEGIN { printf "%.17g", (60 / 250) ^ 2 / 3.14159265358979324 }')" "$(verdict crossland length)" 1e-15
run fretting cycle.csv $shape --material metal.csv --at-worst --criteria swt --length 1
same "a run-out" "inf" "$(verdict swt life)"
run fretting cycle.csv --E1 72100 --nu1 0.33 $shape --at-worst --length 0.02
same "no life and no cycles without its constants" "" "$(verdict swt life)$(verdict swt cycles)"
# A block of loads: at the trailing edge sxx alone acts, from its first to its second load, and in it from the third to the fourth.
printf 'P,Q,sigma\n135.75,38.75,100\n135.75,-38.75,-100\n135.75,20,50\n135.75,-10,-50\n' >block.csv
sed '/^swt_limit/d' metal.csv >no_limit.csv
run fretting block.csv $shape --material no_limit.csv --criteria swt --at-worst
message_has "(2 cycles)"
same "cycles of the block" 2 "$(verdict swt_damage cycles)"
same "its plane" "90 0" "$(verdict swt_damage angle) $(verdict swt_damage out_of_plane)"
close_to "its life" "$(awk -v d="$(verdict swt_damage value)" 'BEGIN { printf "%.17g", 1 / d }')" "$(verdict swt life)" 1e-9
run fretting block.csv $shape --material no_limit.csv --criteria swt
same "columns of damage" "swt_out_of_plane,swt_damage,swt_damage_angle,swt_damage_out_of_plane,swt_cycles" "$(head -n 1 out | cut -d , -f 12-)"
# The shipped sets are read, and each life is that of its own constants.
for metal in "$here"/../../../tables/materials/*.json; do
    name=$(basename "$metal" .json)
    grep -q '"E"' "$metal" || does solve --E1 206800 --nu1 0.3 --radius 10 --P 100 --f 0.3 --units mm,N,MPa --material "$name"
    kept as_name materials
    for constant in E nu sf b ef c yield_stress su; do
        number=$(sed -n "s/^ *\"$constant\": \([-0-9.]*\),*$/\1/p" "$metal")
        same "$constant of $name" "$number" "$(awk -F, -v name="$name" -v constant=$constant '$1 == name && $2 == constant { print $3 }' as_name)"
    done
    grep -q '"sf"' "$metal" || continue
    does fretting cycle.csv $shape --material "$name" --criteria swt --at-worst
    message_has "$name: its numbers are in mm,N,MPa, which are taken as the units of all"
    kept as_name fretting cycle.csv $shape --material "$name" --criteria swt --at-worst
    does fretting cycle.csv $shape --material "$metal" --criteria swt --at-worst
    same "$name by its name" "" "$(cmp as_name out 2>&1)"
    number() { sed -n "s/^ *\"$1\": \([-0-9.]*\),*$/\1/p" "$metal"; }
    close_to "the life by $(basename "$metal")" "$(verdict swt value)" "$(awk -v N="$(verdict swt life)" -v E="$(number E)" -v s="$(number sf)" \
        -v b="$(number b)" -v e="$(number ef)" -v c="$(number c)" 'BEGIN { printf "%.17g", s * s / E * (2 * N) ^ (2 * b) + s * e * (2 * N) ^ (b + c) }')" 1e-9
done
cannot "sae-1045-500: neither a file nor a material that is shipped; the nearest is sae-1045-500-hb" fretting cycle.csv $shape --material sae-1045-500
cannot 'copper: neither a file nor a material that is shipped; "rwedge materials" lists them' fretting cycle.csv $shape --material copper
# In other units the constants are converted: 206800 MPa are 29993804 psi.
run solve --radius 1 --P 100 --nu1 0.3 --units in,lbf,psi --material sae-1015-normalized
close_to "A by its E in psi" "$(awk 'BEGIN { printf "%.17g", 4 * (1 - 0.09) / (206800 / 0.006894757293168361) }')" "$(awk -F, '$1 == "A" { print $2 }' out)" 1e-14
# A K without its unit is refused: 31.6 times as large or as small.
refused="dK_th 60: needs its unit, such as \"4.2 MPa sqrt(m)\", beside --units; or --K-in m or mm"
cannot "metal.csv: $refused" fretting cycle.csv $specimen --material metal.csv
cannot "metal.json: $refused" fretting cycle.csv $specimen --material metal.json
# The message names the option that reads the file, and the one that would replace it.
refuses "--output metal.csv: it is the file of --material; allowed: another file" fretting cycle.csv $shape --material metal.csv -o metal.csv
refuses "--worst metal.csv: it is the file of --material; allowed: another file" fretting cycle.csv $shape --material metal.csv --worst metal.csv
refuses "--worst cycle.csv: it is the input; allowed: another file" fretting cycle.csv $specimen --worst cycle.csv
refuses "--output metal.csv: it is the file of --worst; allowed: another file" fretting cycle.csv $shape -o metal.csv --worst ./metal.csv
refuses "--output none.csv: it is the file of --worst; allowed: another file" fretting cycle.csv $specimen -o none.csv --worst none.csv
cannot "nowhere/worst.csv: No such file or directory" fretting cycle.csv $specimen -o early.csv --worst nowhere/worst.csv
same "rows before it" "" "$(cat early.csv 2>&1 | grep -v "No such file")"
refuses "--worst worst.vtk: the ending .vtk belongs to no format here; allowed: .csv, .tsv, .json, .xlsx" fretting cycle.csv $specimen --worst worst.vtk
refuses "swt-damage: needs sf, b, ef, c of --material" fretting cycle.csv $shape --E1 72100 --nu1 0.33 --criteria swt-damage
refuses "--method line: needs --length, or dK_th and ds0 of --material" fretting cycle.csv $specimen --at-worst --method line
refuses "--length 1: needs --at-worst or --worst" fretting cycle.csv $specimen --length 1
refuses "--method area: must be point or line" fretting cycle.csv $specimen --at-worst --method area
printf 'name,value\nsf,475\nb,-0.08\nef,0.6\n' >short.csv
cannot "short.csv: c: missing; needed beside ef" fretting cycle.csv $specimen --material short.csv
# Nothing of a material is dropped or guessed.
printf 'E,72100\nE,72000\n' >bad.csv
cannot "bad.csv: E: there twice; allowed: once" fretting cycle.csv $shape --material bad.csv
printf 'E,72100,MPa\nnu,0,33\n' >bad.csv
cannot "bad.csv: line 2: nu: two numbers; a decimal is written 0.1" fretting cycle.csv $shape --material bad.csv
printf 'E;72100\n' >bad.csv
cannot "bad.csv: line 1: must be a name and a number, with a comma between" fretting cycle.csv $shape --material bad.csv
printf 'name,value\n' >bad.csv
cannot "bad.csv: no constants; needed: names and numbers" fretting cycle.csv $specimen --material bad.csv
printf '\357\273\277{"E": 72100, "nu": 0.33}\r\n' >marked.json
does fretting cycle.csv $shape --material marked.json
cannot "nowhere.json: No such file or directory" fretting cycle.csv $specimen --material nowhere.json
printf '{"sy": 475}' >short.json
printf '{"swt_limt": 1}' >typo.json
cannot "typo.json: swt_limt: no constant that is known here; the nearest is swt_limit; see rwedge fretting in its manual" \
    fretting cycle.csv $specimen --material typo.json
cannot "short.json: sy: no constant that is known here; see rwedge fretting in its manual" fretting cycle.csv $specimen --material short.json

# What is often given in another unit, or with another sign; another body than that of the file.
printf 'E,72.1\nsf,475.4\nb,-0.078\nef,0.612\nc,-0.62\n' >bad.csv
cannot "bad.csv: E 72.1: less than ten times sf 475.4; is it in GPa? needed: one unit for both" fretting cycle.csv $shape --material bad.csv
printf 'sf,475.4\nb,0.078\nef,0.612\nc,-0.62\n' >bad.csv
cannot "bad.csv: b 0.078: must be a number, -2 to -0.01" fretting cycle.csv $specimen --material bad.csv
printf 'swt_limit,-1\n' >bad.csv
cannot "bad.csv: swt_limit -1: must be a number, 0, or 1e-60 to 1e60" fretting cycle.csv $specimen --material bad.csv
refuses "--E1 70000: metal.csv has E 72100; allowed: one of the two" fretting cycle.csv $shape --E1 70000 --material metal.csv
does fretting cycle.csv $shape --E1 72100 --material metal.csv
# A modulus with a unit is compared as the number that it is.
does fretting cycle.csv $shape --E1 72.1GPa --units mm,N,MPa --material metal.csv
refuses "--E1 72GPa: metal.csv has E 72100; allowed: one of the two" fretting cycle.csv $shape --E1 72GPa --units mm,N,MPa --material metal.csv
# An input that plane stress sets is named with its number.
refuses "--nu2 0.3: needs --E2; allowed: both, or neither for two bodies of one material" fretting cycle.csv $shape --material metal.csv --nu2 0.3 --plane-stress

refuses "findley: needs --findley-k, or findley_k of --material" fretting hills.csv $specimen --criteria findley
refuses "mcdiarmid: needs --t-a, or t_A of --material" fretting hills.csv $specimen --su 500
refuses "modified-wohler: needs --lambda, or lambda of --material" fretting hills.csv $specimen --kappa 40
refuses "modified-wohler: needs --kappa, or kappa of --material" fretting hills.csv $specimen --lambda 71
printf 'lambda,71\n' >half.csv
refuses "modified-wohler: needs --kappa, or kappa of --material" fretting hills.csv $specimen --material half.csv
refuses "fatemi-socie: needs --yield-stress" fretting hills.csv $specimen --criteria swt,fatemi-socie
refuses "--kappa -1: must be a number, 0, or 1e-60 to 1e60" fretting hills.csv $specimen --kappa=-1
refuses "--criteria swt,fs: must be a list of: swt, fatemi-socie, findley, modified-wohler, mcdiarmid, crossland, dang-van, swt-in-plane, fatemi-socie-in-plane, swt-damage, fatemi-socie-damage" \
    fretting hills.csv $specimen --criteria swt,fs

# Wear is K times the energy, at the places and in the last line; the angle of a critical distance is to the normal.
run fretting hills.csv $specimen --archard 1e-5
column wear_depth out >worn
column energy_per_area out | paste -d ' ' worn - | awk '$1 != "-" { printf "%.17g %s\n", $2 * 1e-5, $1 }' >both
close_rows "wear" 1e-14 0
close_to "worst wear" "$(awk -v e="$(worst energy_per_area | cut -d ' ' -f 2)" 'BEGIN { printf "%.17g", e * 1e-5 }')" "$(worst wear_depth | cut -d ' ' -f 2)" 1e-5
run fretting hills.csv $specimen --at-worst --length 0.02 --angle 30
x=$(verdict swt x)
at_length=$(verdict swt at_length)
run fretting hills.csv $specimen --at "$(awk -v x="$x" 'BEGIN { pi = 3.14159265358979324; printf "%.17g,%.17g", x + 0.01 * sin(pi / 6), 0.01 * cos(pi / 6) }')"
close_to "the point at an angle" "$(column swt out)" "$at_length" 1e-10
refuses "--angle 86: must be a number from -85 to 85" fretting hills.csv $specimen --at-worst --length 1 --angle 86
refuses "--angle 8: needs --length, or dK_th and ds0 of --material" fretting hills.csv $specimen --at-worst --angle 8

# For ParaView: a grid of the places of the rows, with each column; points otherwise.
kept rows fretting hills.csv $specimen --x=-0.3:0.3:0.1 --depth 0,0.05 --criteria swt
run fretting hills.csv $specimen --x=-0.3:0.3:0.1 --depth 0,0.05 --criteria swt --format vtk
same "the grid" "DIMENSIONS 7 2 1 POINT_DATA 14" "$(grep -E '^(DIMENSIONS|POINT_DATA)' out | paste -s -d ' ' -)"
same "its columns" "$(head -n 1 rows | tr , '\n' | sed '1,2d' | paste -s -d ' ' -)" "$(awk '/^SCALARS/ { print $2 }' out | paste -s -d ' ' -)"
awk '/^SCALARS/ { on = $2 == "swt"; next } on && !/^LOOKUP/ { for (i = 1; i <= NF; i++) print $i }' out >swt
cp rows out
same "its numbers" "$(column swt out)" "$(cat swt)"
run fretting hills.csv $specimen --at '0.1,0;0.2,0.1' --format vtk
same "points" "POINTS 2 double 0.1 0 0 0.2 0.1 0" "$(grep -A 2 '^POINTS' out | paste -s -d ' ' -)"
same "what has no value" "nan" "$(awk '/^SCALARS slip_range/ { on = 1; next } on && !/^LOOKUP/ { print $2; exit }' out)"
refuses "--at-worst: a verdict has no format vtk; allowed: csv, tsv, json, xlsx" fretting hills.csv $specimen --at-worst --format vtk

# The end of wear of a cylinder under P: the zone sticks with P - Q_a/f, b sqrt(1 - Q_a/(f P)), and beside it
# (A Q_a/(pi f)) L - (x X - L)/(2 R) c^2 is worn off, x = c cosh L, X = sinh L.
printf 'P,Q\n135.75,30\n135.75,-30\n' >shaken.csv
run fretting shaken.csv $specimen --load 135.75,0 --full-wear --x 0,0.18,-0.18,0.5
awk 'BEGIN { pi = 3.14159265358979324; A = 4 * (1 - 0.33 ^ 2) / 72100; R = 10; c = sqrt(2 * A * (135.75 - 100) * R / pi)
    u = 0.18 / c; X = sqrt(u * u - 1); L = log(u + X); d = A * 100 / pi * L - (u * X - L) * c * c / (2 * R)
    printf "%.17g\n0\n%.17g\n0\n", d, d }' >expected
column worn_depth out | paste -d ' ' - expected >both
close_rows "what is worn off" 1e-9 1e-18
same "as far on both sides" "yes" "$(column worn_to out | awk '{ x[NR] = $1 } END { print (x[3] == -x[1] && x[3] > 0.18) ? "yes" : "no" }')"
same "one area" 1 "$(column worn_area out | sort -u | wc -l | tr -d ' ')"
run fretting cycle.csv $specimen --full-wear
message_has "--full-wear: load"
status_is 1
refuses "--full-wear: adds columns to the rows, not with --at-worst" fretting shaken.csv $specimen --load 135.75,0 --full-wear --at-worst

# Mistakes.
printf 'P,Q\n100,0\n100,31\n' >bad.csv
cannot "bad.csv: line 3: Q 31: must not exceed f P = 30: there is no equilibrium; --clip lets it slide" fretting bad.csv $specimen
refuses "--fs-k 1: needs --k or --yield-stress" fretting sharp.csv $specimen --fs-k 1
refuses "--depth -1: depths must not be below 0" fretting sharp.csv $specimen --depth=-1
refuses "--x: missing; there is no contact in the cycle to take places from" fretting $specimen --load 0,0

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# The numbers behind the figures, against those of other commands and formulas that the figures do not use; gnuplot is not needed.
. "$(dirname "$0")/../claims.sh"
pi=3.14159265358979324
exact() { # awk with all digits
    awk -F, -v OFMT=%.17g -v CONVFMT=%.17g "$@"
}
load_of() { # a/b: A P/(theta b)
    awk -v t="$1" 'BEGIN { c = sqrt(1 - t * t); printf "%.17g", (t > 0 ? (atan2(t, c) + t * c) / t : 2) }'
}
draws() { # COLUMNS ARGUMENTS...: the numbers, in the file drawn
    columns=$1
    shift
    does_quietly figure "$@" --data
    same "columns" "$columns" "$(head -n 1 out)"
    cp out drawn
}
list_of() { # COLUMN of the figure, each number once
    column "$1" drawn | sort -gu | paste -s -d , -
}
is() { # COLUMN FACTOR COLUMN: that of the figure is so many times that of the last command, row by row
    column "$1" drawn >got
    column "$3" out | exact -v factor="$2" '{ print factor * $1 }' | paste -d ' ' - got >both
    close_rows "$1 of the figure" 1e-12 1e-12
}

# Figs. 3, 4 and 5 are the table.
tenths="0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1"
draws a_over_b,nu,P_over_bk,y_over_b,branch 3
exact 'NR == 1 || $1 > 0.02' out >drawn # yield jumps at 0.0176, which is there twice
run table elastic-limit --a-over-b "$(list_of a_over_b)" --friction 0
is P_over_bk 1 P_over_bk
is y_over_b 1 y_over_b
same "Fig. 3: branches" "$(column branch out)" "$(column branch drawn)"
draws a_over_b,f,nu,P_over_bk,branch 4
cp drawn fig4
same "Fig. 4: curves" "$tenths" "$(column a_over_b drawn | uniq | paste -s -d ' ' -)"
draws a_over_b,f,nu,P_over_bk,branch 4 --a-over-b 0.3
run table elastic-limit --a-over-b 0.3 --friction "$(column f drawn | paste -s -d , -)"
is P_over_bk 1 P_over_bk
column branch out >branches
same "Fig. 4: another branch than in the table: once, at the cusp" 1 "$(column branch drawn | diff branches - | grep -c '^>')"
draws a_over_b,f,nu,x_over_b,y_over_b,point 5
cp drawn fig5
same "Fig. 5: curves" "$tenths" "$(column a_over_b drawn | uniq | paste -s -d ' ' -)"
same "steps of f" 0 "$(exact '$6 == "step" { if ($1 == last && ($2 - f - 0.0125) ^ 2 > 1e-20) bad++
    last = $1; f = $2 } END { print bad + 0 }' fig5)"
exact 'NR == 1 || $1 == 0.3 && $6 == "step"' fig5 >drawn
run table elastic-limit --a-over-b 0.3 --friction "$(list_of f)"
is x_over_b 1 x_over_b
is y_over_b 1 y_over_b

# Figs. 4 and 5: the cusp is a row of both branches, at the critical friction.
run table critical-friction --a-over-b 0.1:1:0.1
exact 'NR == FNR { if (FNR > 1) { f[$1] = $3; limit[$1] = $4 } next }
    FNR > 1 && ($1 in f) && $2 == f[$1] { print limit[$1], $4; n[$5]++ }
    END { print 10, n["surface"] + 0; print 10, n["subsurface"] + 0 }' out fig4 >both
close_rows "Fig. 4: cusps" 1e-10 0
exact 'NR == FNR { if (FNR > 1) f[$1] = $3; next } $6 == "jump" { print f[$1], $2; n++ } END { print 10, n + 0 }' out fig5 >both
close_rows "Fig. 5: jumps" 0 0


# Figs. 2 and 7 and the field are the profile and the field of a contact in natural units, Fig. 6 is a table.
draws a_over_b,x_over_b,minus_pi_A_p_over_theta 2
same "Fig. 2: curves" "0 $tenths" "$(column a_over_b out | uniq | paste -s -d ' ' -)"
same "Fig. 2: empty at the sharp apex" "0,0," "$(grep '^0,0,' out)"
draws a_over_b,x_over_b,minus_pi_A_p_over_theta 2 --a-over-b 0.25
run profile --a-over-b 0.25 --x="$(list_of x_over_b)"
is minus_pi_A_p_over_theta -$pi p
draws a_over_b,b_sigma_over_fP 6
run table max-tension --a-over-b "$(list_of a_over_b)" --friction 1
is b_sigma_over_fP 1 b_sigma_over_fP
draws c_over_b,x_over_b,minus_pi_A_q_over_f_theta 7
same "Fig. 7: rows at the edges of the stick zones" 4 \
    "$(exact 'FNR > 1 && $1 > 0 && $2 * $2 == $1 * $1' out | wc -l | tr -d ' ')"
draws c_over_b,x_over_b,minus_pi_A_q_over_f_theta 7 --c-over-b 0.4
run profile --a-over-b 0.25 --f 1 --c-over-b 0.4 --x="$(list_of x_over_b)"
is minus_pi_A_q_over_f_theta -$pi q
draws x_over_b,y_over_b,A_sxx_over_theta,A_syy_over_theta,A_txy_over_theta,A_sqrt_J2_over_theta field --c-over-b 0.37
run field --a-over-b 0.5 --f 0.3 --c-over-b 0.37 --x="$(list_of x_over_b)" --y "$(list_of y_over_b)"
is A_sxx_over_theta 1 sxx
is A_syy_over_theta 1 syy
is A_txy_over_theta 1 txy
is A_sqrt_J2_over_theta "$(awk 'BEGIN { printf "%.17g", 1 / sqrt(3) }')" von_mises
run table stick-zone --a-over-b 0.25 --q-over-fp 0.5
run figure field --data --c-over-b "$(column c_over_b out)" --a-over-b 0.25
cp out field
run figure field --data --q-over-fp 0.5 --a-over-b 0.25
same "field by c/b and by Q/(fP)" "" "$(cmp out field 2>&1)"
run figure field --data --a-over-b 0
same "field: empty at the sharp apex" "0,0,,,," "$(grep '^0,0,' out)"

# The loop: its area is the energy dissipated; the displacement grows by (A/pi) ln(b/c) dQ; it closes, and is symmetric.
for alpha in 0 0.25; do
    does figure loop --data --a-over-b $alpha --q-over-fp 0.9
    exact -v load="$(load_of $alpha)" 'FNR == 1 { next } $7 == "first loading" { start = $6; Q = $3; d = $4; next }
        { area += ($3 + Q) / 2 * ($4 - d); Q = $3; d = $4; end = $6 }
        END { print end - start, area * load }' out >both
    close_rows "loop: area for a/b = $alpha" 1e-3 0
    exact -v load="$(load_of $alpha)" '
        $7 == "first loading" { if (n++) sum += load / 3.14159265 * log(1 / sqrt($5 * c)) * ($3 - Q); Q = $3; c = $5; d = $4 }
        END { print sum, d }' out >both
    close_rows "loop: first loading for a/b = $alpha" 2e-3 0
    exact '$7 == "first loading" { d = $4 } $7 == "unloading" { low = $4 } { high = $4 }
        END { print d, -low; print d, high }' out >both
    close_rows "loop: it closes for a/b = $alpha" 1e-12 0
done
same "columns" \
    "a_over_b,amplitude_over_fP,Q_over_fP,displacement_over_f_theta_b,c_over_b,A_energy_over_f2_theta2_b2,part" \
    "$(head -n 1 out)"

# The other formats of rows, and whole or not at all.
run figure 6 --data --format json --digits 3
same "JSON" '{"a_over_b": 0, "b_sigma_over_fP": 1},' "$(sed -n 2p out)"
run figure 6 --data --decimal-comma --digits 3
same "decimal comma" "0,005;1" "$(sed -n 3p out)"
# Mistakes.
all="2, 3, 4, 5, 6, 7, field, loop, eccentric, history, fretting, measure, crack, wear, shakedown, unlike-limit, unlike-tension, contact, tractions, stress, tests, measured"
refuses "which figure must follow; allowed: $all" figure
refuses "1: unknown figure; allowed: $all" figure 1
refuses "log.csv: unexpected; allowed: one figure, and options; --history gives a file of loads" figure fretting log.csv
refuses "--friction 0.1: figure 4 does not depend on it; allowed: --a-over-b, --nu" figure 4 --friction 0.1
refuses "--nu 0.3: figure 6 does not depend on it; allowed: none of the variables" figure 6 --nu 0.3
refuses "--nu 0.2,0.3: must be one number" figure 3 --nu 0.2,0.3
refuses "--a-over-b 0:1:0.05: must not have more than 12 values, a curve each" figure 2 --a-over-b 0:1:0.05
refuses "--c-over-b 0.5: not with --q-over-fp, which says the same; allowed: one of the two" \
    figure field --c-over-b 0.5 --q-over-fp 0.5
refuses "--format gif: unknown format; allowed: svg, png, pdf; with --data: csv, tsv, json, xlsx" figure 2 --format gif
refuses "--digits 5: not for a picture; allowed with: --data" figure 2 --digits 5

# Figures of a contact and its loads. The loop: its area is the energy of the cycle, it closes, and its end on first loading is that
# of a cylinder, A f P/pi (r + (1 - r) ln(1 - r))/2, r = Q/(fP).
printf 'P,Q\n135.75,0\n135.75,30\n135.75,-30\n135.75,30\n' >loads.csv
does figure loop --history loads.csv $specimen --data
by_name 'BEGIN { nu = 0.33; r = 30 / (0.3 * 135.75); end = 4 * (1 - nu * nu) / 72100 * 0.3 * 135.75 / 3.14159265358979324 * (r + (1 - r) * log(1 - r)) / 2 }
    $load == 2 { print end, $displacement } $load == 3 { print -end, $displacement } $load == 4 { print end, $displacement }
    NR > 1 && $load >= 2 { if (n++) area += ($Q + q) / 2 * ($displacement - d); else first = $energy
        q = $Q; d = $displacement; last = $energy }
    END { print last - first, area }' out >both
close_rows "loop of a history" 3e-3 0
does figure history --history loads.csv $specimen --at -0.2,0.01 --data
part_of out load x y sxx syy szz txy | awk -F, '$1 == int($1)' | cut -d , -f 2- >drawn
run history loads.csv $specimen --at -0.2,0.01
same "stresses of history" "$(part_of out x y sxx syy szz txy)" "$(cat drawn)"
does figure fretting --history loads.csv $specimen --data --cycles 2
part_of out x swt >drawn
same "places of fretting" many "$([ "$(wc -l <drawn)" -gt 200 ] && echo many)"
run fretting loads.csv $specimen --cycles 2
same "SWT of fretting" "" "$(part_of out x swt | awk -F, 'NR == FNR { seen[$0] = 1; next } !($0 in seen)' - drawn)"
# The ranges of a crack's K are those of its command.
crack="--load 135.75,0 --edge left --dK-th 2.1 --ds0 248 --K-in m"
does figure crack --history loads.csv $specimen $crack --from 0.01 --to 1 --data
same "columns of crack" "length,dK_none,dK_locked,dK_free,threshold" "$(head -n 1 out)"
sed -n '1p;$p' out >drawn
does crack loads.csv $specimen $crack --lengths 1
column dK out >ranges
{ part_of drawn dK_none dK_locked dK_free | tail -n 1 | tr , '\n' | paste -d ' ' ranges - && echo "$(cell threshold 1) $(column threshold drawn | tail -n 1)"; } >both
close_rows "ranges of K" 1e-12 0
refuses "figure fretting: a crack is for figure crack" figure fretting --history loads.csv $specimen --edge left
refuses "--angle-range 0,1: figure crack has one angle; allowed: --angle" figure crack --history loads.csv $specimen $crack --from 0.01 --to 1 --angle-range 0,1
# A measured loop: the rows of "rwedge loop".
gross=$data/instruments/gross.csv
does figure measured --history "$gross" --radius 50 --E1 115000 --nu1 0.32 --data
cp out drawn
run loop "$gross" --radius 50 --E1 115000 --nu1 0.32 --fitted
same "columns of a loop" "displacement,Q,Q_fitted" "$(head -n 1 drawn)"
same "a measured loop" "$(cut -d , -f 2-4 out)" "$(cat drawn)"
refuses "--history: missing; figure measured needs a log with P, Q and displacement" figure measured --radius 50 --E1 115000 --nu1 0.32
refuses "--f 0.6: the log tells the friction" figure measured --history "$gross" --radius 50 --E1 115000 --nu1 0.32 --f 0.6

# Lives of a series of tests: those of fretting; a run-out is marked, a bad row and one without a life are left out.
printf 'test,radius,P,Q_max,sigma_max,life_tested\n1,50,300,100,100,12000\n2,50,300,140,110,>1e6\n3,50,300,999,110,3000\n4,50,300,140,140,\n5,50,300,60,60,2e5\n' >tests.csv
does figure tests --input tests.csv --f 0.6 --material sae-1015-normalized --data
cp out drawn
run fretting --input tests.csv --f 0.6 --material sae-1015-normalized
same "columns of tests" "row,life,life_tested,is_run_out" "$(head -n 1 drawn)"
same "lives of tests" "$(part_of out test life | grep -E '^[125],')" "$(sed 1d drawn | cut -d , -f 1,2)"
same "their measured ones" "12000,0 1000000,1 200000,0" "$(sed 1d drawn | cut -d , -f 3,4 | paste -s -d ' ' -)"
refuses "--input: missing; figure tests needs a series of tests" figure tests
refuses "figure wear: a series is for figure tests" figure wear --input tests.csv

# Where wear ends: the deepest place, and the zone that sticks, are those of fretting.
printf 'P,Q\n135.75,30\n135.75,-30\n' >shaken.csv
does figure wear --history shaken.csv $specimen --data
same "columns of wear" "x,worn_depth,p_before,p_after" "$(head -n 1 out)"
deepest=$(awk -F, 'NR > 1 && $2 > most { most = $2 } END { printf "%.17g", most }' out)
zone=$(awk -F, 'NR > 1 && $4 < 0 { x = $1 } END { printf "%.17g", x }' out)
run fretting shaken.csv $specimen --full-wear
close_to "the deepest place" "$(column depth_max out | sed -n 1p)" "$deepest" 1e-3
run profile $specimen --load 135.75,0 --load 135.75,30 --points 5
close_to "the zone that sticks" "$(awk 'BEGIN { printf "%.17g", 0.20671 * sqrt(1 - 30 / (0.3 * 135.75)) }')" "$zone" 1e-3
# The map of shakedown, with the cusps: its limits are those of the tables.
does figure shakedown --a-over-b 0.5 --data
awk -F, '$2 == 0.4 { print $4, $5 }' out >drawn
for limit in elastic shakedown; do
    run table $limit-limit --a-over-b 0.5 --friction 0.4 --nu 0.3
    column P_over_bk out
done | paste -d ' ' - - | tr ' ' '\n' | paste -d ' ' - - >tabulated
same "limits of the map" "$(cat tabulated)" "$(cat drawn)"
same "cusps of the map" 67 "$(figure_rows=$(run figure shakedown --a-over-b 0.5 --data; tail -n +2 out | wc -l); echo $figure_rows)"
# Unlike bodies beside Figs. 4 and 6: the tables, which are held; the paper's curves where beta is 0.
does figure unlike-limit --a-over-b 0.5 --beta-f=-0.05,0,0.1 --data
same "columns of unlike limits" "a_over_b,beta_f,f,nu,P_over_bk,P_over_bk_held,P_over_bk_free" "$(head -n 1 out)"
exact 'NR > 1 && $3 == 0.4 { print $6 } NR > 1 && $2 == 0 && $3 == 0.4 { print $5, $6 > "similar"; print $5, $7 > "similar" }
    NR > 1 && $2 > 0 && $3 < 2 * $2 { print "beta is above a half" }' out >drawn
run table elastic-limit --a-over-b 0.5 --friction 0.4 --nu 0.3 --beta-f=-0.05,0,0.1
same "limits of unlike bodies" "$(column P_over_bk out)" "$(cat drawn)"
mv similar both
close_rows "limits of similar bodies" 1e-11 0
does figure unlike-tension --beta-f=-0.05,0,0.1 --data
same "columns of unlike tensions" "a_over_b,beta_f,b_sigma_over_fP_held,b_sigma_over_fP_free" "$(head -n 1 out)"
awk -F, '$1 == 0.5 { print $3 }' out >drawn
awk -F, '$1 == 0.1 && $2 == -0.05 { print $4 }' out >free
run table max-tension --a-over-b 0.5 --friction 1 --beta-f=-0.05,0,0.1
same "tensions of unlike bodies" "$(column b_sigma_over_fP out)" "$(cat drawn)"
# by another program: 6.0 % above similar bodies
run table max-tension --a-over-b 0.1 --friction 1
close_to "the tension of a free wedge" "$(column b_sigma_over_fP out | awk '{ print $1 * 1.06 }')" "$(cat free)" 1e-3
refuses "--beta-f 0.1: figure 6 does not depend on it; allowed: none of the variables" figure 6 --beta-f 0.1
# Any measure: along the surface as fretting has it, below its worst place, on a grid.
does figure measure --history loads.csv $specimen --cycles 2 --measure crossland --crossland-alpha 0.3 --data
same "columns of measure" "x,y,value" "$(head -n 1 out)"
tail -n +2 out >drawn
run fretting loads.csv $specimen --cycles 2 --crossland-alpha 0.3
same "Crossland along the surface" "" "$(part_of out x y crossland |
    awk 'NR == FNR { seen[$0] = 1; next } !($0 in seen)' - drawn)"
for over in depth field; do
    run figure measure --history loads.csv $specimen --cycles 2 --measure crossland --crossland-alpha 0.3 --over $over --data
    sed -n '2p;50p;$p' out >drawn
    run fretting loads.csv $specimen --cycles 2 --crossland-alpha 0.3 --at "$(cut -d , -f 1,2 drawn | paste -s -d ';' -)"
    column crossland out | paste -d ' ' - drawn | sed 's/ .*,/ /' >both
    close_rows "Crossland over the $over" 1e-12 0
done
refuses "--measure none: must be one of: stress_range, swt, fatemi_socie, slip_range, ruiz_f1, ruiz_f2, energy_per_area; or a criterion whose \
constants are given" \
    figure measure --history loads.csv $specimen --measure none
# A scan with noise, fitted as other commands fit it.
awk 'BEGIN { print "x,height"; for (i = -100; i <= 100; i++) print i / 100 + 3 "," i * i / 1e6 + (i % 2 ? 1e-5 : -1e-5) }' >scan.csv
scan="--E1 210000 --nu1 0.3 --f 0.3 --profile scan.csv --fit --origin lowest"
does solve $scan --load 100,0 --layout row
left=$(cell left 1)
does figure contact $scan --load 100,0 --data
close_to "the contact of a scan that is fitted" "$left" "$(awk -F, 'NR > 1 && $2 == 0 { print $1; exit }' out)" 0.05
refuses "figure contact: loads are missing; needed: --history, a file with the columns P and Q, perhaps M or tilt, sigma; or --load \
P,Q for each" figure contact $specimen
refuses "--over field: slip_range is of the surface alone" figure measure --history loads.csv $specimen --measure slip_range --over field
refuses "figure fretting: criteria and measures are for figure measure" figure fretting --history loads.csv $specimen --kappa 3
# Loads before the first cycle: those of fretting; for history and the loop, rows that stand before the cycle in one file.
once="--load 135.75,0 --load 135.75,38"
does figure fretting --history loads.csv $once $specimen --data
part_of out x swt swt_angle slip_range ruiz_f1 ruiz_f2 energy_per_area >drawn
same "places of fretting after loads" many "$([ "$(wc -l <drawn)" -gt 200 ] && echo many)"
run fretting loads.csv $once $specimen
same "fretting after loads" "" "$(part_of out x swt swt_angle slip_range ruiz_f1 ruiz_f2 energy_per_area | awk 'NR == FNR { seen[$0] = 1; next } !($0 in seen)' - drawn)"
{
    printf 'P,Q\n135.75,0\n135.75,38\n'
    tail -n +2 loads.csv
} >all.csv
for kind in "history --at -0.2,0.01" loop; do
    run figure $kind --history all.csv $specimen --data --cycles 1
    awk -F, -v OFS=, 'NR > 1 && $1 == int($1) && $1 > 2 { $1 -= 2; print }' out >in_one
    does figure $kind --history loads.csv $once $specimen --data --cycles 1
    same "$kind after loads" "$(cat in_one)" "$(awk -F, 'NR > 1 && $1 == int($1)' out)"
    same "rows to compare" 4 "$(wc -l <in_one | tr -d ' ')"
done
# Two loads are a cycle to and fro: the loop is closed, and not half of one.
printf 'P,Q\n135.75,30\n135.75,-30\n' >two.csv
run figure loop --history two.csv $specimen --data
same "last load" 4 "$(cell load '$')"
close_to "the loop closes" "$(by_name '$load == 2 { print $displacement }' out)" "$(by_name '$load == 4 { print $displacement }' out)" 1e-12
run figure history --at -0.2,0.01 --history two.csv $specimen --data
same "the whole cycle" "2 4" "$(column load out | sed -n '1p;$p' | paste -s -d ' ' -)"
refuses "--at: missing; figure history needs a point x,y" figure history --history loads.csv $specimen
refuses "figure 4: a contact and its loads are for history, fretting, measure, crack, wear, contact, tractions, stress, tests, measured, and loop with --history or --load" figure 4 --E1 3
cannot "loads.csv: line 3: Q 30: must not exceed f P = 27.15: there is no equilibrium; --clip lets it slide" \
    figure loop --history loads.csv --E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.2

finish

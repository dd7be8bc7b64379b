# SPDX-License-Identifier: GPL-3.0-or-later
# Tables whose columns have reference values or a formula. (That elastic-limit, contact-law and max-tension have the right numbers in
# the right columns is shown by the shipped tables: tests/repository/ compares them with what the tool writes, and interpolates in
# them; proof/certificate/ proves limits, places and branches.)
. "$(dirname "$0")/../claims.sh"

run table elastic-limit --a-over-b 0.1:1:0.1 --friction 0:0.8:0.05

# The limit is that of the branch which is named.
by_name 'NR > 1 { print $P_over_bk, ($branch == "subsurface" ? $P_over_bk_subsurface : $P_over_bk_surface) }' out >both
close_rows "P_over_bk is that of its branch" 0 0
same "rows where the other branch has the smaller limit" "" \
    "$(by_name 'NR > 1 && $P_over_bk_subsurface != "" && $P_over_bk_surface != "" &&
        $P_over_bk != ($P_over_bk_subsurface < $P_over_bk_surface ? $P_over_bk_subsurface : $P_over_bk_surface)' out)"

run table critical-friction --a-over-b "$(column a_over_b "$data/critical_friction.csv" | paste -s -d , -)" --nu 0.3
awk -F, 'NR == FNR { f[$1, $2] = $3; next } ($1, $2) in f { print f[$1, $2], $3 }' "$data/critical_friction.csv" out >both
close_rows "f_critical" 1e-8 1e-9
run table stick-zone --a-over-b 1 --q-over-fp 0.1,0.75
by_name 'NR > 1 { print sqrt(1 - $Q_over_fP), $c_over_b }' out -v OFMT=%.17g >both # Cattaneo and Mindlin
close_rows "c_over_b" 1e-14 0

# The sharp wedge yields at its apex, and has no branches.
prints "a_over_b,f,nu,P_over_bk,x_over_b,y_over_b,branch,P_over_bk_subsurface,P_over_bk_surface
0,0.1,0.3,0,0,0,surface,," table elastic-limit --a-over-b 0 --friction 0.1
prints "a_over_b,nu,f_critical,P_over_bk
0,0.3,," table critical-friction --a-over-b 0

# A branch that does not exist is empty: below the surface for a small tip with friction; on it for nu = 0.5, f = 0.
run table elastic-limit --a-over-b 0.01 --friction 0.3 --nu 0.3
same "subsurface branch" - "$(column P_over_bk_subsurface out)"
run table elastic-limit --a-over-b 0.01 --friction 0 --nu 0.5
same "surface branch" - "$(column P_over_bk_surface out)"
same "branch" subsurface "$(column branch out)"

# A flat pad with rounded edges: Hertz less a rounded wedge; Hertz itself for a = 0; one of its contacts.
run table contact-law --a-over-b 0.5
p0=$(column peak_pressure out)
run table contact-law --pad flat --a-over-b 0,0.5,0.99
column APR_over_b2 out >got
awk 'BEGIN { pi = 3.141592653589793
    for (i = 0; i < 3; i++) { a = i == 0 ? 0 : i == 1 ? 0.5 : 0.99; s = sqrt(1 - a * a); printf "%.17g\n", atan2(s, a) - a * s } }' |
    paste -d ' ' - got >both
close_rows "load of a flat pad" 1e-12 0
echo "1 $(cell largest_pressure 1)
1 $(cell middle_pressure 1)
$(awk -v p="$p0" 'BEGIN { printf "%.17g", 1 - 0.5 * p }') $(cell middle_pressure 2)" >both
close_rows "pressures of a flat pad" 1e-13 0
run table elastic-limit --pad flat --a-over-b 0.5 --friction 0,0.3 --digits 9
same "without friction on the right" yes "$(by_name 'NR == 2 && $x_over_b > 0.8 && $y_over_b > 0.2 { print "yes" }' out)"
limit=$(cell P_over_bk 2)
run solve --E1 4e5 --nu1 0.3 --flat 1 --radius 100 --P "$(awk 'BEGIN { printf "%.17g", 4e5 / 91 * (atan2(sqrt(0.75), 0.5) - sqrt(0.75) / 2) }')" --f 0.3 --Q 0
close_to "limit of one contact" "$(value P_over_bk)" "$limit" 1e-8
# Of tests/data/shakedown.csv; a cylinder has the limit of a/b = 1.
run table shakedown-limit --a-over-b 0.5,1 --friction 0.1,0.4 --nu 0.3
column P_over_bk out | sed -n 2,3p >limits
close_to "shakedown at the surface" "$(sed -n 1p limits)" 3.174490712 1e-9
close_to "shakedown below the surface" "$(sed -n 2p limits)" 5.598645857 1e-9
run table shakedown-limit --pad flat --a-over-b 0 --friction 0.1 --nu 0.3
close_to "shakedown of a cylinder" "$(cell P_over_bk 1)" 5.598645857 1e-9
cannot "shakedown-limit at nu = 0.3, a_over_b = 0.0005, f = 0.3: allowed: an a_over_b of 0, or of 0.001 and more" \
    table shakedown-limit --a-over-b 0.0005 --friction 0.3 --nu 0.3

# Unlike bodies: a cylinder, a/b = 3, in closed form with lambda = atan(-beta_f)/pi; limits by how much another program finds that they
# change, in percent; no limit where |beta f| is above f/2.
run table max-tension --beta-f 0.3,-0.2 --a-over-b 3 --friction 0.7
awk -F, -v OFMT=%.17g 'NR > 1 { pi = 3.141592653589793; l = atan2(-$3, 1) / pi
    print pi / 6 * (1 - 4 * l * l), $6; print -2 * l, $7; print $5 * $2, $4 }' out >both
close_rows "load, middle and tension of a cylinder" 1e-12 0
run table elastic-limit --beta-f -0.05,0 --a-over-b 0.5 --friction 0.5,0.8
awk -F, 'NR > 1 { limit[$2, $4] = $5 } END { print 0.13, 100 * (limit[0.5, "-0.05"] / limit[0.5, 0] - 1)
    print 0.13, 100 * (limit[0.8, "-0.05"] / limit[0.8, 0] - 1) }' out >both
close_rows "P_over_bk of unlike bodies" 0 0.006
prints "a_over_b,f,nu,beta_f,P_over_bk,x_over_b,y_over_b,branch
0.5,0.1,0.3,0.06,,,," table elastic-limit --beta-f 0.06 --a-over-b 0.5 --friction 0.1
refuses "--beta-f 0.1: not for stick-zone; allowed: elastic-limit, max-tension" table stick-zone --beta-f 0.1
refuses "--beta-f 0.1: not for elastic-limit --pad flat; allowed: elastic-limit, max-tension" \
    table elastic-limit --pad flat --beta-f 0.1
refuses "--beta-f 0,0.1: a grid has one of it; allowed: one number, or --layout long" \
    table max-tension --beta-f 0,0.1 --friction 0.3 --layout grid
refuses "--pad flat: not for max-tension; allowed: elastic-limit, contact-law, shakedown-limit" table max-tension --pad flat
refuses "--pad square: unknown pad; allowed: wedge, flat" table contact-law --pad square
refuses "--a-over-b 1: a/b of a flat pad must be a number from 0 to 0.999" table contact-law --pad flat --a-over-b 1

finish

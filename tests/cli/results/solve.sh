# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge solve, one contact: what yields, defaults, warnings. All numbers of 200 contacts, among them Hertz' and sharp wedges, are held
# in ../workbook/ against the sheet Batch, whose cells have formulas of their own.
. "$(dirname "$0")/../claims.sh"

pi=3.14159265358979323846
steel="--E1 210000 --nu1 0.3"
A=$(awk 'BEGIN { printf "%.17g", 4 * (1 - 0.09) / 210000 }')
formula() {
    awk -v pi=$pi -v A="$A" "BEGIN { printf \"%.17g\", $1 }"
}
is() { # NAME FORMULA RELATIVE
    close_to "$1" "$(formula "$2")" "$(value "$1")" "$3"
}

# Without friction, b in P/(bk) = 4.880036 grows with P: P_yield = 4.880036^2 k^2 2 A R/pi; it yields at 0.7043 b.
run solve $steel --theta 0.02 --radius 100 --P 100 --f 0 --k 100
is P_over_bk 4.880036 1e-6
is P_yield "4.880036 ^ 2 * 100 ^ 2 * 2 * A * 100 / pi" 1e-6
is safety "4.880036 ^ 2 * 100 * 2 * A * 100 / pi" 1e-6
is von_mises_sliding "sqrt(3) * 100 / sqrt(2 * A * 100 * 100 / pi) / 4.880036" 1e-6
same yield_x 0 "$(value yield_x)"
is yield_y "0.7043 * 4.880036 * 100 * 2 * A * 100 / pi" 1e-4
same yield_branch subsurface "$(value yield_branch)"
# Pass after pass P = pi 2 b k, as max txy = p0/4.
is P_shakedown "(2 * pi) ^ 2 * 100 ^ 2 * 2 * A * 100 / pi" 1e-9
is safety_shakedown "(2 * pi) ^ 2 * 100 * 2 * A * 100 / pi" 1e-9
for name in Q_over_fP c c_over_b; do
    same "$name without friction" "" "$(value $name)"
done
same "max_tension without friction" 0 "$(value max_tension)"

# The sharp wedge yields at once at its apex, and has no peak pressure.
run solve $steel --theta 0.02 --a 0 --P 100 --Q 5 --f 0.2 --k 100
for name in p0 p_transition f_critical von_mises_sliding; do
    same "$name of the sharp wedge" "" "$(value $name)"
done
same P_yield 0 "$(value P_yield)"
same safety 0 "$(value safety)"
same yield_branch surface "$(value yield_branch)"
same P_shakedown 0 "$(value P_shakedown)"

# The same contact given in another way is the same.
kept first solve $steel --theta 0.1 --a 1 --P 100 --Q 5 --f 0.2 --k 100
prints_kept "second body of the same material" first solve $steel --E2 210000 --nu2 0.3 --theta 0.1 --a 1 --P 1e2 --Q 5 --f 0.2 --k 100
value_like() { # WHAT OPTIONS...
    what=$1
    shift
    run solve "$@" --layout row
    tr , '\n' <out | grep '^[0-9]' >got
    awk -F, 'NR > 1 && $2 ~ /^[0-9]/ { print $2 }' first | paste -d ' ' - got >both
    close_rows "$what" 1e-12 0
}
value_like degrees $steel --theta-deg 5.7295779513082321 --a 1 --P 100 --Q 5 --f 0.2 --k 100
value_like radius $steel --theta 0.1 --radius 10 --P 100 --Q 5 --f 0.2 --k 100
value_like "yield stress" $steel --theta 0.1 --a 1 --P 100 --Q 5 --f 0.2 --yield-stress 173.20508075688772

# Q < 0 is the mirror image.
kept first solve $steel --theta 0.1 --a 1 --P 100 --Q 5 --f 0.5 --k 100
run solve $steel --theta 0.1 --a 1 --P 100 --Q -5 --f 0.5 --k 100
same "what changes with the sign of Q" "Q_over_fP yield_x" \
    "$(diff first out | sed -n 's/^> \([^,]*\),.*/\1/p' | paste -s -d ' ' -)"
same "its sign" - "$(value yield_x | cut -c 1)"

# A rigid second body halves the compliance, and beta = (1 - 2 nu)/(2 (1 - nu)).
run solve $steel --E2 inf --theta 0.02 --a 1 --P 100 --f 0.1 --similar
is A "A / 2" 1e-15
close_to "|beta|" "$(formula "0.4 / 1.4")" "$(value dundurs_beta | tr -d -)" 1e-14
same "warning of coupling" "Dundurs' beta is not 0: with friction its coupling is neglected" "$(value warnings)"

# Warnings are no refusals; each stands alone.
warns() { # TEXT OPTIONS...
    text=$1
    shift
    does solve "$@"
    message_is "${text:+rwedge solve: $text}"
    same "warnings" "$text" "$(awk -F, '$1 == "warnings" { print $2 }' out)"
}
warns "" $steel --theta 0.1 --a 1 --P 100 --f 0 --k 500
warns "theta is above 0.1 rad: the wedge is hardly a half-plane" $steel --theta 0.11 --a 1 --P 100 --f 0 --k 500
warns "" $steel --E2 70000 --nu2 0.3 --theta 0.05 --a 1 --P 100 --f 0 --k 500
warns "P is above P_yield: the contact yields in full sliding" $steel --theta 0.05 --a 1 --P 1000 --f 0 --k 100
units="a/b is below 0.01 or above 10000: are the units consistent?"
warns "$units" $steel --theta 0.05 --a 1 --P 1e-5
warns "$units" --E1 210 --nu1 0.3 --theta 0.01 --a 1 --P 500 --f 0.6 # GPa beside N and mm
warns "k/E is below 0.00001 or above 0.1: are the stresses in one unit?" --E1 210 --nu1 0.3 --theta 0.1 --a 1 --P 0.5 --f 0.3 --k 25

# Where no load yields as far as the library looks, the load there is a bound.
does solve --E1 210000 --nu1 0.5 --theta 0.001 --a 1 --P 100 --f 0 --k 300
same "safety" "> 1e14" "$(value safety)"
same "P_yield" "" "$(value P_yield)"
same "why" "nothing yields before the contact is 1e14 a wide: safety is a bound" "$(value warnings)"
run solve --E1 210000 --nu1 0.5 --theta 0.001 --a 1 --P 100 --f 0 --k 300 --layout row --format json
same "safety in JSON" 1 "$(grep -c '"safety": "> 1e14"' out)"

# Partial slip under the given Q is never nearer to yield than full sliding, and equal to it at Q = f P.
run solve $steel --theta 0.05 --a 1 --P 100 --f 0.1 --Q 10 --k 100 --yield-factor
limit=$(formula "$(value P_over_bk) / $(value load_over_bk)")
close_to "yield factor in full sliding" "$limit" "$(value yield_factor)" 1e-10
run solve $steel --theta 0.05 --a 1 --P 100 --f 0.1 --Q 3 --k 100 --yield-factor
same "in partial slip" larger "$(awk "BEGIN { if ($(value yield_factor) > $limit) print \"larger\" }")"


# ---- Two bodies ----
# Two cylinders: ANSYS Mechanical APDL Verification Manual, VM191, after Chandrasekaran, Haisler and Goforth (1987): b 1.20, with three
# digits; by Hertz, with E* = 16000, 1.19971.
does solve --E1 30000 --nu1 0.25 --E2 29120 --nu2 0.3 --radius1 10 --radius2 13 --P 3200 --f 0
close_to "b of VM191" 1.20 "$(value b)" 4e-3
close_to "b of VM191 by Hertz" "$(awk 'BEGIN { printf "%.17g", sqrt(4 * 3200 / (0.1 + 1 / 13) / (3.14159265358979324 * 16000)) }')" "$(value b)" 1e-14
close_to "R of VM191" "$(awk 'BEGIN { printf "%.17g", 130 / 23 }')" "$(value radius)" 1e-15
# VM272 there: two half cylinders of 8, E 200, nu 0.3, in plane strain under 10 and 0.93622 in all. By Hertz and Cattaneo; f is 0.2 here.
does solve --E1 200 --nu1 0.3 --radius1 8 --radius2 8 --P 10 --Q 0.93622 --f 0.2
close_to "b of VM272" "$(awk 'BEGIN { printf "%.17g", sqrt(4 * 10 * 4 * 2 * 0.91 / (3.14159265358979324 * 200)) }')" "$(value b)" 1e-14
close_to "stick zone of VM272" "$(awk 'BEGIN { printf "%.17g", sqrt(1 - 0.93622 / 2) }')" "$(value c_over_b)" 1e-12
does solve --E1 210000 --nu1 0.3 --radius1 -11 --radius2 10 --P 100
close_to "a roller in a race" 110 "$(value radius)" 1e-14
refuses "--radius1 10, --radius2 -9: 1/R1 + 1/R2 must be above 0: a concave body has the larger radius, and neither is 0" \
    solve --E1 1 --nu1 0.3 --radius1 10 --radius2 -9 --P 1
refuses "--radius1 10: needs --radius2; of a body that is plane, the other's is radius alone" solve --E1 1 --nu1 0.3 --radius1 10 --P 1
refuses "--radius1 10: given together with --radius; allowed: one of the two" solve --E1 1 --nu1 0.3 --radius1 10 --radius2 9 --radius 3 --P 1
# Plane stress: 1/E of each body, and Dundurs' beta with kappa (3 - nu)/(1 + nu).
does solve --E1 30000 --nu1 0.25 --E2 29120 --nu2 0.3 --radius 10 --P 3200 --plane-stress
close_to "A in plane stress" "$(awk 'BEGIN { printf "%.17g", 2 / 30000 + 2 / 29120 }')" "$(value A)" 1e-14
close_to "beta in plane stress" "$(awk 'BEGIN { m1 = 12000; m2 = 11200; k1 = 2.75 / 1.25; k2 = 2.7 / 1.3
    printf "%.17g", (m1 * (k2 - 1) - m2 * (k1 - 1)) / (m1 * (k2 + 1) + m2 * (k1 + 1)) }')" "$(value dundurs_beta)" 1e-12
does solve --E1 210000 --nu1 0.3 --theta 0.01 --radius 10 --P 300 --f 0.3 --k 400 --plane-stress
close_to "yield in plane stress has no szz" "$(awk 'BEGIN { print 1 }')" \
    "$("$rwedge" solve --E1 210000 --nu1 0 --theta 0.01 --radius 10 --P 300 --f 0.3 --k 400 | awk -F, -v P="$(value P_yield)" '$1 == "P_yield" { printf "%.17g", P / $2 }')" 1e-14
same "no shakedown of plane strain" "" "$(value P_shakedown)"
# The pad's own strength is that of the bodies the other way round, its places mirrored.
other="--theta 0.01 --radius 10 --P 300 --Q 60 --f 0.3 --k 200 --yield-factor --similar"
does solve --E1 210000 --nu1 0.3 --E2 72000 --nu2 0.33 $other
kept turned solve --E1 210000 --nu1 0.3 --E2 72000 --nu2 0.33 $other
awk -F, -v OFS=, '$1 == "dundurs_beta" || $1 == "yield_x" || $1 == "yield_y" { if ($2 != 0 && !sub(/^-/, "", $2)) $2 = "-" $2 } { print $1, $2 }' turned >expected
sed '/^yield_x/d' expected >expected_rest
kept pad solve --E1 72000 --nu1 0.33 --E2 210000 --nu2 0.3 $other --strength-of 2
same "the strength of body 2" "" "$(awk -F, -v OFS=, '{ print $1, $2 }' pad | sed '/^yield_x/d' | diff - expected_rest 2>&1)"
close_to "its place" "$(awk -F, '$1 == "yield_x" { print $2 }' expected)" "$(awk -F, '$1 == "yield_x" { print $2 }' pad)" 1e-5
does solve --E1 72000 --nu1 0.33 --E2 210000 --nu2 0.3 --theta 0.01 --radius 10 --P 300 --Q 60 --f 0.3 --k 20 --similar --strength-of 2 --verdict
message_has "The strength of body 2, the pad. It yields: the stress is "
message_has " times what body 2 bears, at x = "
message_has ", in the pad, above the surface. If it slid, more so: "
refuses "--strength-of 2: body 2 is rigid, so it has no stresses" solve --E1 1 --nu1 0.3 --E2 inf --radius 1 --P 1 --strength-of 2
refuses "--strength-of 2: not with sigma; allowed: P and Q on a pad with two equal sides" solve --E1 1 --nu1 0.3 --radius 1 --P 1 --sigma 1 --f 1 --strength-of 2
refuses "--strength-of 3: must be 1 or 2" solve --E1 1 --nu1 0.3 --radius 1 --P 1 --strength-of 3
finish

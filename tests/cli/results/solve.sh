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
run solve $steel --E2 inf --theta 0.02 --a 1 --P 100 --f 0.1
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

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# Unlike bodies with friction: that the rotation must be said, full sliding in closed form, partial slip against boundary elements that
# are fully coupled (../../data/unlike_cases.csv), and what neglecting it is.
. "$(dirname "$0")/../claims.sh"

# A cylinder of radius 100 on a half-plane, A 0.01, rigid: beta = -(1 - 2 nu)/(2 (1 - nu)) = -0.1.
nu=0.44444444444444444
bodies="--E1 160.49382716049383 --nu1 $nu --E2 inf"
cylinder="$bodies --radius 100"
wedge="$bodies --theta 0.01 --a 1"

# ---- What must be said ----
say="whether the pad may turn must be said; --rotation held or free says it, --similar neglects that friction then moves the contact"
refuses "unlike bodies, Dundurs' beta -0.1, with friction: $say" solve $cylinder --P 1 --f 0.5
refuses "unlike bodies, Dundurs' beta -0.1, with friction: $say" history --load 1,0 --load 1,.1 $cylinder --f 0.5
refuses "unlike bodies, Dundurs' beta -0.1, with friction: $say" profile $cylinder --P 1 --f 0.5
does solve $cylinder --P 1
does solve $cylinder --P 1 --f 0
refuses "--rotation no: must be held or free" solve $cylinder --P 1 --f 0.5 --rotation no
refuses "--M .1: given together with a rotation that is held; allowed: one of the two" solve $cylinder --P 1 --M .1 --f .5 --rotation held
refuses "--tilt 0: given together with a rotation that is free; allowed: one of the two" solve $cylinder --P 1 --tilt 0 --f .5 --rotation free
refuses "--rotation: is of two bodies, not with --a-over-b" profile --a-over-b 1 --f .5 --rotation held
printf 'P,M,Q\n1,0,0\n1,0.1,0\n' >moments.csv
cannot "moments.csv: line 3: M 0.1: given together with --rotation held; allowed: one of the two" history moments.csv $cylinder --f .5 --rotation held
printf 'P,tilt,Q\n1,0.001,0\n' >tilts.csv
cannot "tilts.csv: line 2: tilt 0.001: given together with --rotation free; allowed: one of the two" history tilts.csv $cylinder --f .5 --rotation free
does history tilts.csv $cylinder --f .5 --rotation held
refuses "the loads: no closed form: unlike bodies have a closed form in full sliding alone, |Q| = f P; without --exact it is computed" \
    solve $wedge --P 1 --Q .2 --f .5 --rotation held --exact

# ---- Full sliding in closed form ----
# A cylinder held: m = -2 lambda d, P = (pi/2) d^2 (1 - 4 lambda^2)/(A R), lambda = atan(mu)/pi; free: its load stays above x = 0, and
# N is (x - l)^(1/2 - lambda) (r - x)^(1/2 + lambda), so that m = 2 lambda d/3. Q < 0 is the mirror image with the other mu.
lambda() {
    awk -v mu="$1" "BEGIN { pi = 4 * atan2(1, 1); l = atan2(mu, 1) / pi; d = sqrt(2 * 1 / pi / (1 - 4 * l * l)); printf \"%.17g\", $2 }"
}
does solve $cylinder --P 1 --Q .5 --f .5 --rotation held
close_to "mu" 0.05 "$(value mu)" 1e-14
close_to "b" "$(lambda .05 d)" "$(value b)" 1e-12
close_to "left" "$(lambda .05 "-2 * l * d - d")" "$(value left)" 1e-12
close_to "right" "$(lambda .05 "-2 * l * d + d")" "$(value right)" 1e-12
close_to "swing" "$(lambda .05 "-2 * l")" "$(value swing)" 1e-12
close_to "tension at the trailing edge, 2 f |l|/(A R)" "$(lambda .05 "2 * .5 * (1 + 2 * l) * d")" "$(value max_tension)" 1e-12
same "it is exact" 0 "$(grep -c "computed" out)"
same "and told" 1 "$(grep -c 'unlike bodies: the contact swings by 3.2 % of b to the trailing edge, and the tension beside the trailing one is [0-9.]* % above' out)"
close_to "held, Q < 0" "$(lambda -.05 "2 * l")" "$("$rwedge" solve $cylinder --P 1 --Q -.5 --f .5 --rotation held 2>/dev/null | awk -F, '$1 == "swing" { print $2 }')" 1e-12
does solve $cylinder --P 1 --Q .5 --f .5 --rotation free
close_to "free" "$(lambda .05 "2 * l / 3")" "$(value swing)" 1e-12
close_to "its tilt, of a cylinder's own slope" "$(lambda .05 "8 * l / 3 * d / 100")" "$(value tilt)" 1e-12

# The load at first yield slides to the stress at yield; that of Hertz' contact grows with the radius, and the factor is what was asked.
does solve $cylinder --P 1 --Q .5 --f .5 --rotation held --k 1 --yield-factor
limit=$(value P_yield)
close_to "P_yield slides to yield" 1 "$("$rwedge" solve $cylinder --P "$limit" --Q "$(awk "BEGIN { printf \"%.17g\", .5 * $limit }")" --f .5 --rotation held --k 1 --yield-factor 2>/dev/null | awk -F, '$1 == "yield_factor" { print $2 }')" 1e-8
close_to "load_over_bk over P_over_bk is the factor" "$(value yield_factor)" "$(awk "BEGIN { printf \"%.17g\", $(value P_over_bk) / $(value load_over_bk) }")" 1e-9
same "it shakes down above that" 1 "$(awk "BEGIN { print ($(value P_shakedown) > $limit) }")"
for input in P radius f; do
    rest=$(echo "--P 1 --radius 100 --f .5" | sed "s/--$input [^ ]*//")
    does solve $bodies $rest --rotation free --k 1 --for $input --safety 2
    close_to "safety with the $input that is found" 2 "$(value safety)" 1e-9
done
does solve $bodies --theta .01 --P 1 --f .5 --rotation free --k 1 --for a --safety 2
close_to "safety with the a that is found" 2 "$(value safety)" 1e-9
close_to "a that is found" "$(value a)" "$(value radius | awk '{ printf "%.17g", $1 / 100 }')" 1e-15

# ---- Partial slip, against boundary elements ----
# Case 1 is a cylinder that is free to tilt, with M and Q after pressing; errors of the reference are below 1e-4 of b.
awk -F, -v OFS=, 'NR == 1 || $1 == 1 { print $3, $4, $5, $6 }' "$data/unlike_loads.csv" >loads.csv
does history loads.csv $cylinder --f .3 --rotation free
reference() { # LOAD QUANTITY
    awk -F, -v load="$1" -v quantity="$2" '$1 == 1 && $2 == load && $6 == quantity { print $4 }' "$data/unlike_cases.csv"
}
of_load() { # LOAD COLUMN
    awk -F, -v load="$1" -v column="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR == load + 2 { print $at[column] }' out
}
for load in 3 6; do
    for edge in left right; do
        close_to "$edge after load $load" "$(reference $load $edge)" "$(of_load $load $edge)" 5e-4
    done
    close_to "tilt after load $load" "$(reference $load tilt | awk '{ print $1 * 0.01 }')" "$(of_load $load tilt)" 5e-3
done
# P and M come together, then Q; or all in one line.
told() {
    awk '/computed numerically/ { sub(/.*tractions to about /, ""); sub(/ of .*/, ""); print ($0 + 0 <= 5e-3); exit }' err
}
does solve $bodies --radius 100 --P 1 --M .05 --Q .1 --f .5 --rotation free
same "pressed under P and M first" 1 "$(told)"
printf 'P,M,Q\n1,0.05,0.1\n' >line.csv
does history line.csv $cylinder --f .5 --rotation free
same "all in one line" 1 "$(told)"
# A cylinder whose rotation is held, under Q in proportion to P, is like itself: b and swing grow like the root of P.
printf 'P,Q\n1,0.3\n4,1.2\n' >line.csv
does history line.csv $cylinder --f .5 --rotation held
close_to "twice as wide" 2 "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "left") at = i } NR == 2 { first = $at } NR == 3 { printf "%.9g", $at / first }' out)" 1e-5
does history loads.csv $cylinder --f .3 --rotation free
same "no doubt but what it is" 0 "$(grep -c neglected err)"

# What is of similar bodies alone, and a cycle that begins with Q.
printf 'P,Q\n1,.1\n1,-.1\n' >cycle.csv
cannot "--full-wear: is of similar bodies; --similar takes these as such" fretting cycle.csv --load 1,0 $cylinder --f .5 --rotation held --full-wear

# ---- In other words ----
# --similar neglects it, as similar bodies of this compliance and strain have it; and it is a doubt.
does solve $wedge --P 8 --Q 2 --f .5 --similar
neglected="Dundurs' beta is not 0: with friction its coupling is neglected"
same "a doubt" "$neglected" "$(value warnings)"
cp out similar
does solve --E1 320.98765432098766 --nu1 $nu --theta .01 --a 1 --P 8 --Q 2 --f .5
same "the same numbers" "$(sed '/^dundurs_beta/d; /^warnings/d' out)" "$(sed '/^dundurs_beta/d; /^warnings/d' similar)"
# A held pad of similar bodies is one that is held at the tilt 0.
does solve $wedge --P 8 --Q 2 --f .5 --similar --rotation held
cp out held
does solve $wedge --P 8 --Q 2 --f .5 --similar --tilt 0
same "held at the tilt 0" "$(cat out)" "$(cat held)"

# A table of contacts has the rotation of all; mu and swing are its last columns before the error.
printf 'P,Q\n1,0.5\n2,-1\n' >contacts.csv
does solve -i contacts.csv $cylinder --f .5 --rotation held
same "last columns" "mu,swing,error" "$(head -n 1 out | sed 's/.*\(mu,swing,error\)/\1/')"
same "their signs" "0.05 -0.05" "$(awk -F, 'NR > 1 { printf "%s%.6g", NR == 2 ? "" : " ", $(NF - 2) }' out)"
run solve -i contacts.csv $cylinder --f .5
status_is 1
same "a row says what is missing" 2 "$(grep -c "unlike bodies, Dundurs' beta" out)"
does solve -i contacts.csv $cylinder --f .5 --similar
same "no such columns where it is neglected" 0 "$(head -n 1 out | grep -c swing)"

# The pad's own strength is that of the bodies the other way round, seen from the other side.
one="--E1 210000 --nu1 .3 --E2 70000 --nu2 .33" other="--E1 70000 --nu1 .33 --E2 210000 --nu2 .3"
rest="--theta .02 --radius 10 --P 300 --Q 150 --f .5 --rotation held --k 300 --digits 8"
kept turned solve $one $rest
does solve $other $rest --strength-of 2
for name in max_tension P_yield safety b; do
    same "$name of body 2" "$(awk -F, -v name=$name '$1 == name { print $2 }' turned)" "$(value $name)"
done
same "left of body 2" "-$(awk -F, '$1 == "right" { print $2 }' turned)" "$(value left)"
same "mu of body 2" "$(awk -F, '$1 == "mu" { print $2 }' turned)" "-$(value mu)"

# A first load with a moment that leaves hardly a contact does not converge; after P alone it goes.
wedge="--E1 72e3 --nu1 0.33 --E2 210e3 --nu2 0.3 --theta 0.02 --radius 10 --f 0.5 --rotation free"
refuses "--load 300,199.5,0,0: an iteration did not converge: the first load of unlike bodies has too large an M or sigma; allowed: P \
alone first, then the rest" history $wedge --load 300,199.5,0,0
does history $wedge --load 300,0 --load 300,199.5,0,0

# Percent above a hundred have all their digits.
does solve --E1 2e5 --nu1 0.3 --E2 inf --radius 10 --P 100 --f 0.3 --Q 5 --rotation free
message_has "the tension beside the trailing one is 1"
same "a power of ten in percent" 0 "$(grep -c 'e+02 %' err)"

# A case keeps both.
does solve $cylinder --P 1 --Q .5 --f .5 --rotation free --save-case case.json
cp out free
does solve --case case.json
same "a case with a rotation" "$(cat free)" "$(cat out)"
does solve $cylinder --P 1 --Q .5 --f .5 --similar --save-case case.json
cp out similar
does solve --case case.json
same "a case of bodies that are taken as similar" "$(cat similar)" "$(cat out)"

finish

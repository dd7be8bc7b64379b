# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge crack: K, growth and verdicts themselves are tested in tests/lib/crack; here it is that the right ones stand in the right
# columns, by closed forms and reference values, and that no unit of K is guessed.
. "$(dirname "$0")/../claims.sh"

# row NAME LINE: the cell of a column in a line of out, from 2.
row() { sed -n "1p;$2p" out | awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } NR == 2 { print $c }'; }

# says TEXT...: each is in the output.
says() {
    for text; do
        same "output has '$text'" yes "$(grep -qF -e "$text" out && echo yes)"
    done
}

# A plain specimen: 1.1215222552310553 sigma sqrt(pi l).
printf 'P,Q,sigma\n0,0,100\n0,0,20\n' >pulled.csv
plain="--E1 72100 --nu1 0.33 --radius 50 --f 0.6 --x 0"
does crack pulled.csv $plain --lengths 0.5,2
closing=closing_K_I_max,closing_K_I_min,closing_K_II_max,closing_K_II_min,closing_dK_I,closing_dK_II,closing_dK,closing_K_max,closing_R,closed
same "columns" "length,shear,K_I_max,K_I_min,K_II_max,K_II_min,dK_I,dK_II,dK,K_max,R,overlap,$closing" "$(head -n 1 out)"
same "rows" 7 "$(wc -l <out | tr -d ' ')"
close_to "K_I_max" 281.12393955901 "$(row K_I_max 5)" 1e-12
close_to "dK" 224.89915164721 "$(row dK 5)" 1e-12
close_to "R" 0.2 "$(row R 5)" 1e-12
same "overlap" 0 "$(row overlap 5)"
same "shears" "none locked free" "$(column shear out | sed -n '1,3p' | tr '\n' ' ' | sed 's/ $//')"
does crack pulled.csv $plain --lengths 2 --angle 45 --each-load
same "columns of loads" "load,length,K_I,K_II,closing_K_I,closing_K_II,overlap,closed" "$(head -n 1 out)"
close_to "K_I" 176.6947723157 "$(row K_I 2)" 1e-12
close_to "K_II" 91.36439257728 "$(row K_II 2)" 1e-12
close_to "the second load" 18.272878515456 "$(row K_II 3)" 1e-12
does crack pulled.csv $plain --lengths 2 --angle-range 0:45:45 --shear free
same "columns of angles" "angle,length,shear" "$(head -n 1 out | cut -d , -f 1-3)"
same "angles" "0 45" "$(column angle out | tail -n 2 | tr '\n' ' ' | sed 's/ $//')"

# Paris: 2 (1/sqrt(l1) - 1/sqrt(l2))/(C (1.1215 80 sqrt(pi))^3), where m is 3.
does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --C 1e-12 --m 3 --K-in mm
life=$(awk 'BEGIN { y = 1.1215222552310553 * 80 * sqrt(3.141592653589793)
    printf "%.17g", 2 * (1 / sqrt(0.5) - 1 / sqrt(2)) / (1e-12 * y ^ 3) }')
close_to "life" "$life" "$(row cycles 2)" 1e-9
same "at the last length" 0 "$(row cycles 4)"
cp out as_mm
does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --C 3.1622776601683795e-8 --m 3 --K-in m
close_to "constants in m" "$life" "$(row cycles 2)" 1e-9
message_has "--K-in m: lengths are taken to be in mm; --units says other ones"
does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --C 1e-12 --m 3 --K-in m --units m,N,Pa
close_to "lengths in m" "$life" "$(row cycles 2)" 1e-9
same "told their unit" 0 "$(grep -c "taken to be in mm" err)"
printf '{"paris_C": 1e-12, "paris_m": 3}' >material.json
does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --material material.json --K-in mm
same "constants of a material" "$(cat as_mm)" "$(cat out)"
# The same with its unit: 1e-12 mm/(MPa sqrt(mm))^3 is 1e-12 1000^1.5 in mm/(MPa sqrt(m))^3, a thousandth of it in m.
for growth in '3.1622776601683795e-08 mm/(MPa sqrt(m))^3' '3.1622776601683795e-11 m/cycle/(MPa sqrt(m))^m' '1e-12 mm/(MPa sqrt(mm))^3'; do
    printf '{"paris_C": "%s", "paris_m": 3}' "$growth" >material.json
    does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --material material.json --units mm,N,MPa
    close_to "life by $growth" "$life" "$(row cycles 2)" 1e-9
    does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --C "$growth" --m 3 --units mm,N,MPa
    close_to "the same as an option" "$life" "$(row cycles 2)" 1e-9
done
printf '{"paris_C": "1e-12 m/(MPa sqrt(m))^4", "paris_m": 3}' >material.json
cannot "material.json: paris_C 1e-12 m/(MPa sqrt(m))^4: must be a number with its unit, such as 6.9e-12 m/(MPa sqrt(m))^3, which ends with the exponent or m" \
    crack pulled.csv $plain --lengths 0.5,1 --material material.json --units mm,N,MPa
printf '{"dK_th": "4.2 MPa", "ds0": 248}' >material.json
cannot "material.json: dK_th 4.2 MPa: the unit 'MPa' has the wrong dimension; needed: a unit of stress*sqrt(length)" \
    crack pulled.csv $plain --lengths 0.5,1 --material material.json --units mm,N,MPa
printf '{"dK_th": "4.2 MPa sqrt(m)", "ds0": 248}' >material.json
cannot "material.json: dK_th 4.2 MPa sqrt(m): has the unit 'MPa sqrt(m)', and no working units are known: --units, such as --units mm,N,MPa, converts it" \
    crack pulled.csv $plain --lengths 0.5,1 --material material.json

# Where it breaks: (K_c/(1.1215 100))^2/pi.
does crack pulled.csv $plain --from 0.5 --to 2 --shear none --C 1e-12 --m 3 --K-c 220 --K-in mm --verdict
same "it does not stop" "" "$(row arrest_length 2)"
says "By mode I the crack breaks at 1.225 mm, where K is K_c, in "

# The cycle of tests/data/crack_growth.csv, tension 60, by its reference values; the cylinder of A = 3e-5.
awk 'BEGIN { print "P,Q,sigma"; for (k = 1; k <= 24; k++) { c = cos(k * 3.141592653589793 / 12); printf "120,%.17g,%.17g\n", 50 * c, 60 * c } }' >cycle.csv
hertz="--E1 133333.33333333333 --nu1 0 --radius 60 --f 0.6 --load 120,0 --load 120,0,50,60 --edge left"
law="--dK-th 66.4 --ds0 248 --C 3.1622776601683795e-12 --m 3 --K-in mm"
does crack cycle.csv $hertz --from 0.03708 --to 2.967 $law --verdict
same "columns of a verdict" "shear,arrest_length,cycles,least_ratio,least_length,verdict" "$(head -n 1 out)"
close_to "mode I stops" 0.1485268160 "$(row arrest_length 2)" 1e-8
close_to "locked faces stop" 0.2038304205 "$(row arrest_length 3)" 1e-8
close_to "free faces grow through" 1034075.23 "$(row cycles 4)" 1e-6
says "By mode I the crack arrests at 0.1485 mm" "With K_II of free faces the crack grows through to 2.967 mm, in 1.03408e+06 cycles"
message_has "By mode I the crack arrests at 0.1485 mm; with K_II while it is open it arrests at 0.2038 mm; with K_II of free faces it grows through to 2.967 mm, in 1.03408e+06 cycles."
message_has "beyond a length of 0.03708, a tenth of its half-width, it changes the tractions, and what that does to K is not measured"
does crack cycle.csv $hertz --from 0.03708 --to 2.967 $law --shear free
close_to "the same from the rows" 1034075.23 "$(row cycles 2)" 1e-6
close_to "the ratio there" "$(awk -v a="$(row dK 2)" -v b="$(row threshold 2)" 'BEGIN { printf "%.17g", a / b }')" "$(row dK_over_threshold 2)" 1e-12
does crack cycle.csv $hertz --from 0.03708 --to 2.967 $law --verdict --angle-range=-20,0 --shear none
message_has "worst: at 0 deg: By mode I the crack arrests at 0.1485 mm"
says "By mode I the crack does not grow: dK is 0.97 of the threshold at 0.03708 mm"

# A crack under the contact is pressed together at its mouth: that is said.
does crack cycle.csv $hertz --lengths 1,2 --angle 45
message_has "at 45 deg faces overlap under the largest K_I"

# Faces that press: row 1 of tests/data/crack_closing.csv, the state of the largest K_I. A normal crack keeps its K_II.
printf 'P,Q,sigma\n120,50,60\n' >held.csv
does crack held.csv --E1 133333.33333333333 --nu1 0 --radius 60 --f 0.6 --load 0,0,0,60 --load 120,0,0,60 --x=-0.37082323394226202 --lengths 0.741646 --angle 30 --each-load
close_to "K_I where faces press" 13.3488 "$(row closing_K_I 2)" 2e-3
close_to "K_II where faces press" 117.616 "$(row closing_K_II 2)" 1e-4
does crack cycle.csv $hertz --lengths 0.1,1 --shear locked
same "K_I is never below 0" "0 0" "$(row closing_K_I_min 2) $(row closing_K_I_min 3)"
same "the open crack" "$(row K_I_max 2)" "$(row closing_K_I_max 2)"
same "K_II of a normal crack" "$(row K_II_max 3) $(row K_II_min 3)" "$(row closing_K_II_max 3) $(row closing_K_II_min 3)"

# What is refused.
bare='needs its unit, such as "4.2 MPa sqrt(m)", beside --units; or --K-in m where its root is of m, as in MPa sqrt(m), mm where it is of mm, 31.6 times as large'
refuses "--dK-th 66: $bare" crack cycle.csv $hertz --lengths 1 --dK-th 66
refuses "--K-in km: must be m or mm" crack cycle.csv $hertz --lengths 1 --dK-th 66 --K-in km
refuses "--K-in m: needs --dK-th, --C or --K-c" crack cycle.csv $hertz --lengths 1 --K-in m
refuses "--m: missing; needed beside --C" crack cycle.csv $hertz --lengths 1 --C 1 --K-in m
refuses "--dK-th: missing; needed beside --ds0" crack cycle.csv $hertz --lengths 1 --ds0 1
refuses "--lengths: missing; --lengths, or --from and --to, are needed" crack cycle.csv $hertz
refuses "--to: missing; --lengths, or --from and --to, are needed" crack cycle.csv $hertz --from 1
refuses "--lengths 2,1: must ascend, and be 1e-60 to 1e60" crack cycle.csv $hertz --lengths 2,1
refuses "--edge: given together with --x; one of --edge left, --edge right and --x NUMBER is needed" crack cycle.csv $hertz --lengths 1 --x 1
refuses "--edge middle: must be left or right" crack cycle.csv --E1 72100 --nu1 0 --radius 60 --f 0.6 --load 120,0 --load 120,0,50,60 --lengths 1 --edge middle
refuses "--angle 80: 80 is outside -75 to 75 degrees" crack cycle.csv $hertz --lengths 1 --angle 80
refuses "--shear all: must be none, locked or free" crack cycle.csv $hertz --lengths 1 --shear all
refuses "--verdict: needs --dK-th, or --C and --m" crack cycle.csv $hertz --from 1 --to 2 --verdict


# The law of growth that is shipped: C dK^3 of BS 7910, by its constants in mm and MPa.
does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --material bs-7910-ferritic-steel
cp out shipped
does crack pulled.csv $plain --lengths 0.5,1,2 --shear none --C 5.21e-13 --m 3 --K-in mm
same "its constants" "$(cat out)" "$(cat shipped)"
run materials
same "as they are listed" "paris_C,5.21e-13,mm/(MPa sqrt(mm))^3 paris_m,3," "$(grep '^bs-7910' out | cut -d , -f 2-4 | paste -s -d ' ' -)"
finish

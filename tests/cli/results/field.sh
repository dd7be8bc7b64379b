# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge field: stresses on a grid, as rows and as VTK. In natural units they are those of the figure: ../figures/figure_data.sh.
. "$(dirname "$0")/../claims.sh"

# von Mises' stress with szz = nu (sxx + syy), and the larger principal stress, from the tensor.
contact="--E1 210000 --nu1 0.25 --theta 0.05 --a 0.1 --f 0.3"
does field $contact --P 300 --Q 90
same "points by default" 3321 "$(column x out | wc -l | tr -d ' ')"
by_name 'NR > 1 { z = 0.25 * ($sxx + $syy); printf "%.17g %.17g\n",
    sqrt((($sxx - $syy) ^ 2 + ($syy - z) ^ 2 + (z - $sxx) ^ 2) / 2 + 3 * $txy ^ 2), $von_mises }' out >both
close_rows von_mises 1e-12 0
by_name 'NR > 1 { s = $s1; print 1, 1 + (($sxx - s) * ($syy - s) - $txy ^ 2) / ($sxx ^ 2 + $syy ^ 2 + $txy ^ 2) }' out >both
close_rows "s1 is a principal stress" 1e-12 0
# The others by their definitions: s1 + s2 is the trace, tau_max the largest of three differences, s1 the normal stress of its plane.
by_name 'function max(a, b) { return a > b ? a : b } function abs(a) { return a < 0 ? -a : a }
    NR > 1 { size = abs($sxx) + abs($syy) + abs($txy); a = $s1_angle * 3.14159265358979324 / 180
    print 1, 1 + ($s1 + $s2 - $sxx - $syy) / size; print 1, 1 + ($szz - 0.25 * ($sxx + $syy)) / size
    print 1, 1 + (2 * $tau_max - max(abs($s1 - $s2), max(abs($s1 - $szz), abs($s2 - $szz)))) / size
    print 1, 1 + ($sxx * sin(a) ^ 2 + $syy * cos(a) ^ 2 + 2 * $txy * sin(a) * cos(a) - $s1) / size }' out >both
close_rows "s2, szz, tau_max, s1_angle" 1e-12 0
same "s1 below the mean" "" "$(by_name 'NR > 1 && 2 * $s1 < $sxx + $syy' out)"
cp out sliding
largest=$(by_name 'NR > 1 && $von_mises > m { m = $von_mises } END { print m }' out)
edge=$(by_name 'NR > 1 && $x > 2 * w { w = $x / 2 } END { printf "%.17g", w }' out)
run solve $contact --P 300 --Q 90
close_to "the grid is 2 b wide" "$(value b)" "$edge" 1e-15
close_to "largest von Mises stress" "$(value von_mises_sliding)" "$largest" 0.05
same "no point is above it" yes "$(awk "BEGIN { if ($largest <= $(value von_mises_sliding)) print \"yes\" }")"

# The default grid has the middle, x = 0, and the mirror image of every point, to the last digit; of the sharp wedge the
# apex is there, and empty.
for a in 0 0.1; do
    shape="--E1 210000 --nu1 0.3 --theta 0.05 --a $a --f 0.3 --P 33.3"
    run field $shape
    same "rows" 3321 "$(column x out | wc -l | tr -d ' ')"
    column x out | head -n 81 >x
    same "the middle of 81" 0 "$(sed -n 41p x)"
    same "mirror images" "" "$(sed 's/^-//' x | tail -n 41 >right; sed 's/^-//' x | head -n 41 | sed -n '1!G;h;$p' | diff - right)"
    same "apex" "$([ $a = 0 ] && echo 0,0,,,,,,,,,)" "$(sed -n 42p out | grep ',,,,,,,,,$')"
done

# Far below, P and Q act in a point (Flamant): syy = -2 P/(pi y) below it, sxx = -2 P x^2/(pi r^2) y/r^2.
run field $contact --P 300 --x 0 --y 1000
close_to "Flamant" "$(awk 'BEGIN { print -2 * 300 / (3.14159265358979 * 1000) }')" "$(column syy out)" 1e-5

# Rows: x fastest; a history; the apex of the sharp wedge is empty, and nan in VTK.
run field $contact --load 300,0 --load 300,60 --load 300,-60 --x -0.1:0.1:0.1 --y 0,0.05
same "order" "-0.1 0 0 0 0.1 0 -0.1 0.05 0 0.05 0.1 0.05" "$(by_name 'NR > 1 { print $x, $y }' out | paste -s -d ' ' -)"
same "sign of txy under the contact after the reversal" "+" "$(by_name 'NR == 3 { print ($txy > 0 ? "+" : "-") }' out)"
# Below the sharp wedge: mean stress -(2/pi) arsinh(1/y), half the difference (2/pi)/sqrt(1 + y^2).
prints "x,y,sxx,syy,txy,von_mises,s1,szz,s2,tau_max,s1_angle
0,0,,,,,,,,,
0,1,-0.1109,-1.011,0,0.8114,-0.1109,-0.3367,-1.011,0.4502,90" field --a-over-b 0 --x 0 --y 0,1.0 --digits 4
prints "x,y,sxx,syy,txy,von_mises,s1,szz,s2,tau_max,s1_angle
0,1,0,0,0,0,0,0,0,0,0" field $contact --load 300,20 --load 0,0 --x 0 --y 1

# VTK: read back by its own counts, and the same numbers as in the rows.
vtk_to_rows() {
    awk '
        function die(why) { print "not VTK: " why; bad = 1; exit }
        function take(n, name,   i) { for (i = 1; i <= n; i++) { if (at > NF) { if ((getline) <= 0) die(name); at = 1 }
            got[name, i] = $at; at++ } if (at <= NF) die("more values of " name); at = 99 }
        NR == 1 && $0 != "# vtk DataFile Version 3.0" { die("first line") }
        NR == 2 && length($0) > 255 { die("title") }
        NR == 3 && $0 != "ASCII" { die("ASCII") }
        NR == 4 && $0 != "DATASET RECTILINEAR_GRID" { die("dataset") }
        NR <= 4 { at = 99999; next }
        $1 == "DIMENSIONS" { nx = $2; ny = $3; if ($4 != 1) die("nz"); next }
        $1 == "X_COORDINATES" { if ($2 != nx || $3 != "double") die("x"); at = 99999; take(nx, "x"); next }
        $1 == "Y_COORDINATES" { if ($2 != ny || $3 != "double") die("y"); at = 99999; take(ny, "y"); next }
        $1 == "Z_COORDINATES" { if ($2 != 1) die("z"); at = 99999; take(1, "z"); next }
        $1 == "POINT_DATA" { if ($2 != nx * ny) die("points"); next }
        $1 == "SCALARS" { if ($3 != "double" || $4 != 1) die("scalars"); name = $2; names[++count] = name; getline
            if ($0 != "LOOKUP_TABLE default") die("lookup"); at = 99999; take(nx * ny, name); next }
        $1 == "TENSORS" { if ($2 != "stress" || $3 != "double") die("tensors"); at = 99999; take(9 * nx * ny, "stress")
            for (p = 1; p <= nx * ny; p++) { t = 9 * (p - 1)
                for (i = 2; i <= 8; i++) if (got["stress", t + i] != (i == 2 || i == 4 ? got["txy", p] : i == 5 ? got["syy", p] : 0)) die("tensor")
                if (got["stress", t + 1] != got["sxx", p] || got["stress", t + 9] != got["szz", p]) die("tensor") }
            next }
        { die("line " NR ": " $0) }
        END { if (bad) exit
            printf "x,y"; for (n = 1; n <= count; n++) printf ",%s", names[n]; print ""
            for (j = 1; j <= ny; j++) for (i = 1; i <= nx; i++) { printf "%s,%s", got["x", i], got["y", j]
                for (n = 1; n <= count; n++) printf ",%s", got[names[n], (j - 1) * nx + i] == "nan" ? "" : got[names[n], (j - 1) * nx + i]
                print "" } }' "$1"
}
does field $contact --P 300 --Q 90 --format vtk
vtk_to_rows out >rows
same "VTK against rows" "" "$(diff sliding rows | head -n 5)"
run field --a-over-b 0 --f 0.2 --q-over-fp 1 --x -1:1:0.5 --y 0,1,3 --format vtk -o sharp.vtk
run field --a-over-b 0 --f 0.2 --q-over-fp 1 --x -1:1:0.5 --y 0,1,3
vtk_to_rows sharp.vtk >rows
same "VTK with an apex" "" "$(diff out rows | head -n 5)"
same "nan" 12 "$(grep -c nan sharp.vtk)"
head -c 900 sharp.vtk >cut.vtk
same "the check of VTK can fail" "not VTK" "$(vtk_to_rows cut.vtk | cut -c 1-7 | tail -n 1)"
# nu of a material counts in natural units too.
kept as_nu field --a-over-b 0.3 --f 0.3 --nu1 0.2 --x 0 --y 0.3
prints_kept "nu of a material" as_nu field --a-over-b 0.3 --f 0.3 --material '{"E": 210000, "nu": 0.2}' --x 0 --y 0.3
refuses "--x 1,0: must ascend; so the format vtk wants it" field --a-over-b 1 --x 1,0 --format vtk
refuses "--decimal-comma: not in VTK, whose numbers have a point; allowed with: csv, tsv" \
    field --a-over-b 1 --format vtk --decimal-comma
refuses "--format xml: unknown format; allowed: csv, tsv, json, xlsx, vtk" field --a-over-b 1 --format xml
run field --a-over-b 0.5 --x 0 --y 0,1
cp out rows
run field --a-over-b 0.5 --x 0 --depth 0,1 # as other commands call it
same "rows of --depth" "" "$(cmp rows out 2>&1)"
refuses "--y -1:1:1: depths must not be below 0" field --a-over-b 1 --y -1:1:1
refuses "--x 0:1:1e-8: must not give the grid more than 1000000000 points in all" field --a-over-b 1 --x 0:1:1e-8 --y 0:1:1e-3
refuses "--x: missing; after the last load there is no contact to lay a grid around" field $contact --load 0,0

# Rows stream: the first of a thousand million comes at once, in little memory.
memory_of 100000
shell '(ulimit -v $limit; "$rwedge" field --a-over-b 0.5 --x 1:100000:1 --y 1:10000:1) | head -n 5'
same "lines" 5 "$(wc -l <out | tr -d ' ')"

finish

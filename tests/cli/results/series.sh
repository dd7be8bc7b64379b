# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge fretting --input: a series of tests. Its numbers are those of single calls, to the same bits; the contacts of a published
# series are the printed ones.
. "$(dirname "$0")/../claims.sh"

# of_row ROW NAME FILE: of the row whose first of_row is that.
of_row() {
    awk -F, -v row="$1" -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i } $1 == row { print $c }' "${3-out}"
}
# stops STATUS TEXT ARGUMENTS...: with a message that has the text.
stops() {
    expected_status=$1 text=$2
    shift 2
    run "$@"
    same "status" "$expected_status" "$status"
    message_has "$text"
}
bodies="--E1 210e3 --nu1 0.3"

# Sixteen thresholds of nucleation of fretting cracks. The print cuts some last digits off.
printf 'name,value\ncrossland_alpha,0.28186\ncrossland_limit,386\n' >steel.csv
cp "$data/icf13.csv" .
does fretting --input icf13.csv $bodies --f 0.8 --material steel.csv --criteria crossland --length 0.08
message_has "length 0.08: crossland scatters by 6.31 %, at the surface by 15.6 %"
same "its columns" "left,right,stick_left,stick_right,peak_pressure,length,crossland,crossland_x,crossland_at_length,crossland_load_factor,warnings,error" "$(head -n 1 out | cut -d , -f 11-)"
same "printed contacts" "16 rows" "$(by_name 'NR > 1 { n++; a = $right; c = ($stick_right - $stick_left) / 2; e = ($stick_right + $stick_left) / 2
    if ((a - $a_printed) ^ 2 > 0.005 ^ 2 || (c / a - $c_over_a_printed) ^ 2 > 0.0101 ^ 2 || (e - $offset_printed) ^ 2 > 0.005 ^ 2) print $case, a, c / a, e }
    END { print n, "rows" }' out)"
# The scatter of the table by another program.
scatter() { awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next } { n++; s += $c; q += $c * $c }
    END { printf "%.4f", sqrt((q - s * s / n) / (n - 1)) / (s / n) }' out; }
close_to "scatter at the surface" 0.156 "$(scatter crossland)" 3e-3
close_to "scatter at 40 um" 0.0631 "$(scatter crossland_at_length)" 2e-3
cp out at_length
does fretting --input icf13.csv $bodies --f 0.8 --material steel.csv --criteria crossland --fit-length
fitted=$(sed -n 's/.*: length \([0-9.]*\): crossland scatters by 6.26 %.*/\1/p' err)
same "a length is fitted" yes "$(awk -v l="$fitted" 'BEGIN { print (l > 0.08 && l < 0.1) ? "yes" : l }')"
least=$(scatter crossland_at_length)
for factor in 0.9 1.1; do
    run fretting --input icf13.csv $bodies --f 0.8 --material steel.csv --criteria crossland --length "$(awk -v l="$fitted" -v f=$factor 'BEGIN { print l * f }')"
    same "less scatter than at $factor times the length" yes "$(awk -v a="$least" -v b="$(scatter crossland_at_length)" 'BEGIN { print (a < b) ? "yes" : a " " b }')"
done

# Single calls.
single() { # ROW CYCLE OPTIONS...: the verdict of crossland is that of the row
    row=$1 cycle=$2
    shift 2
    printf "P,M,Q,sigma\n$cycle" >one.csv
    does fretting one.csv $bodies --material steel.csv --criteria crossland --at-worst --f 0.8 "$@"
    same "$row alone" "$(part_of out value x at_length load_factor | tail -n 1)" \
        "$(of_row "$row" crossland rows),$(of_row "$row" crossland_x rows),$(of_row "$row" crossland_at_length rows),$(of_row "$row" crossland_load_factor rows)"
}
cp at_length rows
single PF_3 '398,0,271,0\n398,0,-271,0\n' --radius 40 --load 398,0,0,0 --length 0.08
single FF_4 '398,0,210,100\n398,0,-210,10\n' --radius 40 --load 0,0,0,55 --load 398,0,0,55 --length 0.08
# A log, a moment, a tilt, one smallest Q, a flat pad, other cycles.
printf 'P,Q\n300,30\n320,-100\n300,80\n' >log.csv
printf 'test,radius,flat,P,M,Q_max,Q_min,loads\nlog,50,1,300,,,,log.csv\nmoment,50,1,300,20,100,-20,\n' >tests.csv
sed 's/,M,/,tilt,/; s/300,20,/300,0.0001,/; s/300,,,,log/300,0,,,log/; s/^moment/tilt/' tests.csv >tilted.csv
sed -i 's/300,,,,log/300,0,,,log/' tests.csv
does fretting --input tests.csv $bodies --f 0.8 --material steel.csv --criteria crossland --length 0.05 --method line --cycles 4
cp out rows
single log '300,0,30,0\n320,0,-100,0\n300,0,80,0\n' --radius 50 --flat 1 --load 300,0,0,0 --length 0.05 --method line --cycles 4
single moment '300,20,100,0\n300,20,-20,0\n' --radius 50 --flat 1 --load 300,20,0,0 --length 0.05 --method line --cycles 4
does fretting --input tilted.csv $bodies --f 0.8 --material steel.csv --criteria crossland --length 0.05
cp out rows
single tilt '300,0,100,0\n300,0,-20,0\n' --radius 50 --flat 1 --tilt 0.0001 --load 300,0,0,0 --length 0.05

# Logs with noise beyond f P, and of displacements: as a single call takes them.
printf 'P,Q\n300,241\n300,-241\n' >noisy.csv
printf 'P,displacement\n300,0.002\n300,-0.002\n' >driven.csv
for log in noisy driven; do
    option=--clip
    [ $log = noisy ] || option='--compliance 1e-5'
    printf 'test,radius,P,loads\n%s,50,300,%s.csv\n' $log $log >logs.csv
    does fretting --input logs.csv $bodies --f 0.8 --criteria crossland --crossland-alpha 0.3 $option
    cp out rows
    does fretting $log.csv $bodies --f 0.8 --criteria crossland --crossland-alpha 0.3 --at-worst --radius 50 --load 300,0 $option
    same "$log alone" "$(of_row crossland value)" "$(of_row $log crossland rows)"
done

# Lives: damage, and what was tested over it; a run-out is a bound.
printf 'test,radius,P,Q_max,sigma_max,life_tested\n1,50,300,100,100,88216\n2,50,300,140,110,>1e7\n3,50,300,140,110,> 10^7\n4,50,300,140,110,\n5,50,300,60,60,2e5\n' >lives.csv
does fretting --input lives.csv --f 0.6 --material sae-1015-normalized
cp out rows
close_to "damage and life" 1 "$(awk -v d="$(of_row 1 damage)" -v n="$(of_row 1 life)" 'BEGIN { printf "%.17g", d * n }')" 1e-15
close_to "tested over predicted" "$(awk -v n="$(of_row 1 life)" 'BEGIN { printf "%.17g", 88216 / n }')" "$(of_row 1 tested_over_predicted)" 1e-15
same "a run-out is a bound" "$(awk -v n="$(of_row 2 life)" 'BEGIN { printf ">%.6g", 1e7 / n }')" "$(of_row 2 tested_over_predicted)"
same "however it is written" "$(of_row 2 tested_over_predicted)" "$(of_row 3 tested_over_predicted)"
same "nothing was measured" "" "$(of_row 4 tested_over_predicted)"
printf 'P,Q,sigma\n300,100,100\n300,-100,-100\n' >one.csv
run fretting one.csv --radius 50 --f 0.6 --material sae-1015-normalized --load 300,0 --at-worst
same "the life alone" "$(of_row swt life)" "$(of_row 1 life rows)"
# Lives as they are predicted at a length tell that length.
printf 'test,radius,P,Q_max,sigma_max\n1,50,300,100,100\n2,20,300,140,110\n3,100,500,200,60\n4,50,600,260,160\n' >contacts.csv
run fretting --input contacts.csv --f 0.6 --material sae-1015-normalized --length 0.03
{ echo test,radius,P,Q_max,sigma_max,life_tested && part_of out test radius P Q_max sigma_max life; } >told.csv
does fretting --input told.csv --f 0.6 --material sae-1015-normalized --fit-length
close_to "the length of these lives" 0.03 "$(sed -n 's/.*length \([0-9.]*\): tested over predicted lives by swt scatter by a factor of 1, .*/\1/p' err)" 1e-5

# Constants that differ; units and other names; P of a largest pressure.
printf 'test,radius,P,Q_max,crossland_alpha,crossland_limit\n1,50,300,100,0.3,400\n2,50,300,100,0.1,200\n' >constants.csv
does fretting --input constants.csv $bodies --f 0.6 --criteria crossland
same "constants of a row" yes "$(awk -v a="$(of_row 1 crossland)" -v b="$(of_row 2 crossland)" 'BEGIN { print (a > b) ? "yes" : "no" }')"
cp out rows
printf 'P,Q\n300,100\n300,-100\n' >one.csv
run fretting one.csv $bodies --radius 50 --f 0.6 --criteria crossland --crossland-alpha 0.1 --at-worst --load 300,0
same "as its option" "$(of_row crossland value)" "$(of_row 2 crossland rows)"
close_to "its own limit" "$(awk -v v="$(of_row crossland value)" 'BEGIN { printf "%.17g", 200 / v }')" "$(of_row 2 crossland_load_factor rows)" 1e-15
printf 'Rig 7\n\nTest;Radius [m];Load (kN);Friction force;alpha\n;m;kN;N;\n1;0.05;2.4;800;0.1\n' >rig.csv
does fretting --input rig.csv $bodies --f 0.6 --units mm,N,MPa --width 8 --criteria crossland --column 'radius=Radius [m]' --column P='Load (kN)' --column Q_max='Friction force' --column crossland_alpha=alpha
message_has "rig.csv: header in line 3, units in line 4"
same "converted" "$(of_row 2 crossland rows)" "$(tr ';' , <out | of_row 1 crossland -)"
printf 'test,radius,p0,Q_max\n1,50,600,100\n' >p0.csv
does fretting --input p0.csv $bodies --f 0.6
close_to "the load of p0 (Hertz)" "$(awk 'BEGIN { A = 4 * 0.91 / 210e3; printf "%.17g", 3.14159265358979324 * A * 50 * 600 ^ 2 / 2 }')" "$(of_row 1 P)" 1e-13
close_to "its pressure" 600 "$(of_row 1 peak_pressure)" 1e-13

# A bad row costs only itself.
cat >bad.csv <<'END'
test,radius,P,Q_max,life_tested,loads
1,50,300,100,1e5,
2,50,300,100,run-out,
3,50,,100,1e5,
4,50,300,,1e5,
5,50,300,200,1e5,
6,50,300,100,1e5,log.csv
7,50,300,,1e5,nowhere.csv
8,50,300,100,1e5
END
does fretting --input bad.csv $bodies --f 0.6
message_has "bad.csv: 7 of 8 tests have an error: see the column error"
same "an error each" "|life_tested run-out: must be a number above 0, or a run-out, as >1e7|P: the cell is empty|Q_max: the cell is empty, and so is that of sigma_max|Q 200: must not exceed f P = 180: there is no equilibrium|Q_max: given together with loads; allowed: one of the two|nowhere.csv: No such file or directory|5 cells in this row, 6 in the header" \
    "$(awk -F, 'NR > 1 { e = $0; sub(/^.*,,/, "", e); gsub(/^,|"/, "", e); print e }' out | sed 's/^Q 200\(.*\)/Q 200\1/' | awk '{ printf "%s%s", s, $0; s = "|" }' | sed 's/^[^|]*|/|/')"
printf 'radius,E1,nu1,f,P,Q_max\n50,72000,.33,.6,300,100\n' >other.csv
run fretting --input other.csv --material sae-1015-normalized
same "another E than the material's" "E1 72000: the material has 206800; allowed: one of the two" "$(column error out)"
# In JSON what was read as a number is one.
printf 'test,radius,P,Q_max\n007,50.0,300.0,100.0\n' >spelled.csv
does fretting --input spelled.csv $bodies --f 0.6 --format json
same "cells" '{"test": "007", "radius": 50, "P": 300, "Q_max": 100,' "$(sed -n 's/^\({"test".*"Q_max": [^,]*,\).*/\1/p' out)"
printf 'test,R,P,Q,mu\n1,50,300,100,0.6\n' >lab.csv
stops 1 "lab.csv: column 'R': allowed: radius, or another name if it is something else; --column radius='R' takes it" fretting --input lab.csv $bodies
stops 1 "lab.csv: column Q: a test has Q_max, and the smallest where that is not its negative; --column Q_max=Q takes it" fretting --input lab.csv $bodies --column radius=R --column f=mu
does fretting --input lab.csv $bodies --column radius=R --column f=mu --column Q_max=Q
printf 'test,radius,Q_max\n1,50,100\n' >lacks.csv
stops 1 "lacks.csv: column P or p0: missing; or loads, the name of a file" fretting --input lacks.csv $bodies --f 0.6
does fretting --input lacks.csv $bodies --f 0.6 --P 300
stops 2 "--load: not with --input" fretting --input lives.csv $bodies --f 0.6 --load 1,2
stops 2 "--fit-length: needs --input, a series of tests" fretting one.csv $bodies --radius 50 --f 0.6 --fit-length
stops 2 "--length 1: given together with --fit-length; allowed: one of the two" fretting --input lives.csv $bodies --f 0.6 --fit-length --length 1
stops 2 "--output tests.csv: it is the file of --input; allowed: another file" fretting --input tests.csv $bodies --f 0.6 -o tests.csv
stops 2 "--output tests.csv: it is the file of --input; allowed: another file" figure tests --input tests.csv $bodies --f 0.6 --data -o tests.csv
printf 'x,slope\n-1,-0.1\n1,0.1\n' >pad.csv
printf 'profile,P,Q_max\npad.csv,300,60\n' >pads.csv
stops 2 "--output pad.csv: it is the file of a cell in column profile; allowed: another file" fretting --input pads.csv $bodies --f 0.6 -o pad.csv
stops 2 "--output log.csv: it is" fretting --input tests.csv $bodies --f 0.6 -o log.csv
finish

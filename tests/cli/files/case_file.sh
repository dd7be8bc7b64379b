# SPDX-License-Identifier: GPL-3.0-or-later
# A case in a file gives the same bytes as the options that made it; its names are those of the schema, and no others.
. "$(dirname "$0")/../claims.sh"

schema=$here/../../../cli/model/words/case.schema.json
case_of() { printf '{"rwedge_case": 1, %s}\n' "$1" >case.json; }

# ---- There and back: WHAT COMMAND OPTIONS... ----
round_trip() {
    what=$1 command=$2
    shift 2
    kept first "$command" "$@" --save-case saved.json
    prints_kept "$what" first "$command" --case saved.json
    does "$command" --case saved.json --save-case again.json
    same "$what, saved again" "" "$(cmp saved.json again.json 2>&1)"
}
printf 'P,Q,M,sigma\n100,10,0,0\n120,-10,1,20\n100,10,0,0\n' >log.csv
printf 'x,height\n-1,0.05\n-0.6,0.018\n-0.2,0.002\n0,0\n0.3,0.003\n0.4,0.008\n0.7,0.015\n1,0.05\n' >worn.csv
printf 'name,steel\nsf,900\nb,-0.1\nef,0.5\nc,-0.6\n' >steel.csv
printf '{"source": "a \\"book\\"", "t_A": 200, "su": 900, "dK_th": "5.4 MPa sqrt(m)", "ds0": 400}\n' >steel.json
steel="--E1 210000 --nu1 0.3"
round_trip "a wedge" solve $steel --theta-deg 2 --radius 10 --P 300 --Q 40 --f 0.3 --yield-stress 900
round_trip "two bodies, one of them rigid" solve $steel --E2 inf --theta 0.01 --a 0 --P 300.1
round_trip "units, the whole width" solve --E1 '210 GPa' --nu1 0.3 --flat '500 um' --radius 10 --P '3 kN' --Q 400 --f 0.3 \
    --width 10 --units mm,N,MPa
round_trip "a profile" solve $steel --profile worn.csv --hull --P 300 --f 0.3 --layout row --yield-stress 900 --yield-factor
round_trip "a scan with its origin" solve $steel --profile "$data/instruments/start0_L10.csv" --origin lowest --P 500
round_trip "heights that point down" profile $steel --profile "$data/instruments/p_down.csv" --heights down --P 500 --x -1:1:0.1
round_trip "a fit" solve $steel --profile "$data/instruments/cyl900_noise.csv" --fit --P 500
round_trip "loads one after the other" field $steel --theta 0.01 --radius 10 --f 0.3 --load 100,10 --load 100,0,20,30 --x 0.1 --y 0.1
round_trip "a log" history log.csv $steel --theta 0.01 --radius 10 --f 0.3 --at 0.1,0.1
round_trip "a log, in kN of 10 mm" fretting log.csv $steel --theta 0.01 --radius 10 --f 0.3 --width 10 --cycles 2 --x -1:1:0.5
printf 'P,Q\n100,10\n120,-10\n100,10\n' >held.csv
round_trip "a pad that is held" history held.csv $steel --theta 0.01 --radius 10 --f 0.3 --tilt 1e-4
printf 'P,Q,tilt\n100,10,1e-4\n120,-10,2e-4\n' >turns.csv
round_trip "a pad that turns" history turns.csv $steel --theta 0.01 --radius 10 --f 0.3
round_trip "a pad that is held under one load" solve $steel --theta 0.01 --radius 10 --P 300 --tilt 1e-4
round_trip "a material of a CSV file" fretting log.csv $steel --theta 0.01 --radius 10 --f 0.3 --x 0 --material steel.csv
round_trip "a material of a JSON file" fretting log.csv $steel --theta 0.01 --radius 10 --f 0.3 --x 0 --units mm,N,MPa --material steel.json
round_trip "a crack" crack log.csv $steel --theta 0.01 --radius 10 --f 0.3 --edge left --lengths 0.01,0.02 --angle-range=-10,0
sed 's/0.018/0.020/' worn.csv >other.csv && mv other.csv worn.csv
prints_kept "a case holds the places" first crack --case saved.json

# ---- Options replace what a case has ----
does_quietly solve $steel --theta 0.01 --a 0.05 --P 190 --Q 20 --f 0.2 --save-case wedge.json
kept first solve $steel --theta 0.01 --radius 7 --P 190 --Q 25 --f 0.2
prints_kept "a load and the other way of the rounding" first solve --case wedge.json --radius 7 --Q 25
kept first history log.csv $steel --theta 0.01 --a 0.05 --f 0.2
prints_kept "a log in place of the loads" first history log.csv --case wedge.json
kept first solve $steel --theta 0.01 --a 0.05 --f 0.2 --load 190,20 --load 190,10
prints_kept "loads in place of a load" first solve --case wedge.json --load 190,20 --load 190,10

# ---- By hand ----
case_of '"name": "by hand", "units": "mm,N,MPa", "width": "1 cm", "bodies": {"E1": "210 GPa", "nu1": 0.3, "f": 0.2},
    "pad": {"theta": 0.01, "a": "50 um"}, "loads": {"P": "1.9 kN", "Q": 200},
    "asked": {"command": "profile", "options": {"x": [-0.1, 0, 0.1]}}'
kept first solve --case wedge.json
prints_kept "units and the whole width" first solve --case case.json
kept first profile --case wedge.json --x -0.1,0,0.1
prints_kept "a list that is asked for" first profile --case case.json
case_of '"loads": {"P": 1900, "Q": [200, -200]}, "width": 10, "bodies": {"E1": 210000, "nu1": 0.3, "f": 0.2}, "pad": {"theta": 0.01, "a": 0.05}'
kept first history $steel --theta 0.01 --a 0.05 --f 0.2 --load 190,20 --load 190,-20
prints_kept "loads of the whole width, one after the other" first history --case case.json
case_of '"bodies": {"E1": 210000, "nu1": 0.3, "f": 0.2}, "pad": {"theta": 0.01, "a": 0.05}, "loads": {"P": 190, "Q": [20, -20]}'
kept first history $steel --theta 0.01 --a 0.05 --f 0.2 --load 190,20 --load 190,-20
prints_kept "a number beside a list" first history --case case.json

# ---- What is wrong is one line ----
cannot "nowhere.json: No such file or directory" solve --case nowhere.json
printf '{"rwedge_case": 1,\n "pad": {,}}\n' >broken.json
run solve --case broken.json
ended 1 "rwedge solve: broken.json: line 2, column 10: string or '}' expected near ','"
echo '{"P": 1}' >none.json
cannot 'none.json: no "rwedge_case": 1, so it is no case file' solve --case none.json
echo '{"rwedge_case": 2}' >newer.json
cannot "newer.json: rwedge_case 2: a case of another version; this program reads 1" solve --case newer.json
case_of '"bodies": {"E": 1}'
cannot "case.json: bodies: E: unknown; the nearest is E1" solve --case case.json
case_of '"pads": {}'
cannot "case.json: pads: unknown; allowed: units, width, section, K_in, bodies, pad, loads, material, asked" solve --case case.json
case_of '"pad": {"x": [0, 1], "slope": [0]}'
cannot "case.json: slope: must be a list of numbers, as many as beside it" solve --case case.json
case_of '"pad": {"x": [0, 1]}'
cannot "case.json: pad: needs x, and slope or height" solve --case case.json
case_of '"loads": {"P": [1, 2], "Q": [1]}'
cannot "case.json: loads: Q has 1 numbers, and another one 2" solve --case case.json
case_of '"loads": {"P": [1, "2"], "Q": 1}'
cannot "case.json: P: number 2 of the list is none" solve --case case.json
case_of '"asked": {"command": "solve", "options": {"verdcit": true}}'
cannot "case.json: asked: verdcit: no option of solve that a case may have; the nearest is verdict" solve --case case.json
case_of '"asked": {"command": "profile", "options": {"verdcit": true}}, "bodies": {"E1": true}'
cannot "case.json: E1: must be a number, or a text with its unit" solve --case case.json
case_of '"bodies": {"E1": -1, "nu1": 0.3}, "pad": {"radius": 1}, "loads": {"P": 1}'
refuses "--E1 -1: Young's modulus of body 1 must be a number above 0" solve --case case.json
case_of '"bodies": {"E1": 210000, "nu1": 0.3, "f": 0.2, "k": 100, "strength_of": 2}, "pad": {"theta": 0.01, "a": 0.05}, "loads": {"P": 190, "Q": 20}'
kept first solve $steel --theta 0.01 --a 0.05 --f 0.2 --P 190 --Q 20 --k 100 --strength-of 2
prints_kept "the strength of the pad" first solve --case case.json
cannot "case.json: strength_of 2: k is of that body; allowed: 'rwedge solve' and the page, which answer for it" profile --case case.json
printf 'P\n1\n' >rows.csv
refuses "--save-case new.json: is of one contact, not with --input" solve -i rows.csv --save-case new.json
refuses "--save-case new.json: a case has one list of loads; not with --load beside a file" fretting log.csv --load 1,0 \
    --save-case new.json
refuses "--save-case -: must be the name of a file" solve --save-case -
cannot "nowhere/new.json: No such file or directory" solve --case wedge.json --save-case nowhere/new.json
# No file of the command line is overwritten, but a case itself.
printf 'P,Q\n190,20\n' >log.csv
cp log.csv kept.csv
pad="$steel --theta 0.01 --a 0.05 --f 0.2"
refuses "--save-case log.csv: it is the input; allowed: another file" history log.csv $pad --save-case log.csv
refuses "--save-case log.csv: it is the file of --history; allowed: another file" profile $pad --history log.csv --save-case log.csv
refuses "--save-case new.csv: it is the file of --output; allowed: another file" history log.csv $pad --save-case new.csv -o new.csv
refuses "--output log.csv: it is the input; allowed: another file" read log.csv $pad -o log.csv
same "the log" "" "$(cmp log.csv kept.csv 2>&1)"
does_quietly solve --case wedge.json --Q 10 --save-case wedge.json
same "a case that is written anew" 1 "$(grep -c '"Q": 10$' wedge.json)"
cp wedge.json before.json
run solve --case wedge.json --Q 1000 --save-case wedge.json
status_is 2
same "a case that is refused leaves the file" "" "$(cmp wedge.json before.json 2>&1)"

# ---- The schema has the names of the tool ----
names_of() { # GROUP: in the schema, sorted
    awk -v group="    \"$1\": {" '$0 == group { inside = 1; next } /^    }/ { inside = 0 }
        inside && /^        "[A-Za-z0-9_]+": \{$/ { gsub(/[ ":{]/, ""); print }' "$schema" | sort | tr '\n' ' '
}
for group in bodies pad loads; do
    case_of "\"$group\": {\"zzzzzzzzzzzz\": 1}"
    run solve --case case.json
    same "names of $group in the schema" "$(sed 's/.*allowed: //; s/, /\n/g' err | sort | tr '\n' ' ')" "$(names_of $group)"
done
case_of '"zzzzzzzzzzzz": 1'
run solve --case case.json
same "names at the top of the schema" "$({ sed 's/.*allowed: //; s/, /\n/g' err; echo rwedge_case; echo name; } | sort | tr '\n' ' ')" \
    "$(sed -n 's/^    "\([A-Za-z_]*\)": {$/\1/p' "$schema" | sed '/^numbers$/d; /^quantity$/d; /^load$/d' | sort | tr '\n' ' ')"

# ---- Read alone: a case in the working units, of whatever is given ----
printf 'Load;Shear\nkN;N\n1.2;0\n1.2;300\n' >rig.csv
kept read.json read rig.csv --column P=Load --column Q=Shear --units mm,N,MPa --width '1 cm' --radius1 '10 mm' --radius2 -20 --E1 '210 GPa' \
    --material '{"dK_th": "1 MPa sqrt(mm)", "ds0": 300}'
same "what was read" '{ "rwedge_case": 1, "units": "mm,N,MPa", "bodies": { "E1": 210000 }, "pad": { "radius": 20 }, "loads": {
"P": [120, 120], "M": [0, 0], "Q": [0, 30], "sigma": [0, 0] }, "material": { "dK_th": 1, "ds0": 300 } }' \
    "$(tr -s ' \n' ' ' <read.json | sed 's/"loads": { /"loads": {\n/; s/ $//')"
does read --profile "$data/instruments/p_down.csv" --heights down
same "slopes are made of heights" yes "$(grep -q '"slope": \[-' out && ! grep -q height out && echo yes)"
cannot "nowhere.csv: No such file or directory" read nowhere.csv
finish

# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge report: its numbers are those of solve and fretting, its equations are true as they stand there, and it is one whole page.
. "$(dirname "$0")/../claims.sh"

steel="--E1 210000 --nu1 0.3"
units="--units mm,N,MPa"
has() { # WHAT TEXT - in the page, which is in the file out
    same "$1" yes "$(grep -qF -- "$2" out && echo yes || echo "no '$2'")"
}
hasnt() {
    same "$1" no "$(grep -qF -- "$2" out && echo "'$2' is there" || echo no)"
}
shown() { # NAME - the number of a result, with a point and a minus of ASCII
    sed -n "s|^<div><span>.* <span class=\"meaning\">$1</span></span><b>\(.*\)</b><i>.*|\1|p" out | tail -n 1 | sed 's/−/-/g'
}

# ---- The numbers of solve, to the four digits that are shown ----
like_solve() { # WHAT OPTIONS...
    what=$1
    shift
    does solve "$@" --digits 4
    cp out solved
    does report "$@" --no-pictures
    for name in A b a_over_b p0 Q_over_fP c c_over_b left right stick_left tilt max_tension_sliding P_over_bk P_yield safety \
        yield_x yield_y P_shakedown safety_shakedown; do
        same "$what: $name" "$(awk -F, -v name="$name" '$1 == name { print $2 }' solved)" "$(shown $name)"
    done
    hasnt "a name that is left, $what" "{{"
}
like_solve "a wedge" $steel --theta 0.02 --radius 50 --P 3000 --Q 40 --f 0.3 --yield-stress 900
like_solve "a cylinder" $steel --radius 50 --P 300 --Q 40 --f 0.3
# A meaning stands without what is of the options alone.
does report $steel --radius 50 --P 300 --f 0.3 --yield-stress 900 --no-pictures
for text in "<span>Radius of the rounding <" "<span>Yield stress in tension <" "<span>Young's modulus of body 1 <" "<span>Poisson's ratio of body 1 <"; do
    has "a meaning" "$text"
done
like_solve "a flat pad with a moment" $steel --flat 0.5 --radius 10 --P 300 --M 20 --Q 40 --f 0.3
like_solve "a history" $steel --radius 50 --f 0.3 --load 300,0 --load 300,40,0,0 --load 200,20

# ---- The criteria of fretting, at their worst places ----
printf '{"rwedge_case": 1, "name": "Rig & <7>", "units": "mm,N,MPa", "bodies": {"f": 0.3, "yield_stress": 500},
 "pad": {"theta": 0.05, "radius": 10}, "material": "sae-1045-500-hb",
 "loads": {"P": 135.75, "Q": [0, 38.75, -38.75], "sigma": [0, 100, -100]},
 "asked": {"command": "fretting", "options": {"at-worst": true, "criteria": "swt,swt-damage", "cycles": 4}}}\n' >rig.json
does fretting --case rig.json --digits 4
cp out worst
does report rig.json --no-pictures
for name in swt swt_damage; do
    same "$name" "$(awk -F, -v name=$name '$1 == name { print $2, $11 }' worst)" \
        "$(sed -n "s|^.*>$name</span></td><td>\([^<]*\)</td>.*<td>\([^<]*\)</td></tr>|\1 \2|p" out)"
done
has "the name of the case" "<h1>Rig &amp; &lt;7></h1>"
has "units of the case" "MPa"
has "the source of its material" "Fundamentals of Metal Fatigue Analysis"
has "a cycle" "in the last of 4 passes of the loads"
has "the hardest of the loads" "load 3 is the hardest: a factor of 0.989 on the stress"
has "what yields is red" 'class="verdict red"'
has "shakedown" "with all stresses times 1.1 the cycle is sure to be elastic"
kept of_word report rig.json --no-pictures
does report --case rig.json --no-pictures
same "a word and --case" "$(sed '/class="made"/d' of_word)" "$(sed '/class="made"/d' out)"
# a load in the middle yields, the last does not
does report $steel --radius 50 --f 0.3 --yield-stress 900 --load 300,0 --load 30000,0 --load 300,0 --no-pictures
has "a load before the last yields" "YIELDS: the stress after load 2 is above the yield stress"
has "and is red" 'class="verdict red"'

# ---- What was assumed, and which errors are told ----
does report $steel --radius 50 --P 300 --no-pictures
has "no friction" "No friction is given: it is taken for 0."
has "one material" "Body 2 is of the material of body 1."
has "no units" "The numbers are in consistent units"
has "closed form" "All is in closed form"
does report $steel --E2 inf --theta 0.2 --radius 50 --P 300 --f 0.1 --plane-stress --similar $units --width 10 --no-pictures
has "rigid" "Body 2 is rigid."
has "plane stress" "Plane stress: a thin plate."
has "a doubt" "theta is above 0.1 rad"
has "a width" "given for the whole width, and divided by it"
printf 'x,height\n-1,0.1\n0,0\n0.3,0.01\n0.4,0.012\n1,0.1\n' >worn.csv
does report $steel --profile worn.csv --hull --P 300 --tilt 0 --no-pictures
has "a hull" "The pad is the convex hull of its heights."
hasnt "a word of the command line" "in place of --"
does report --E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --P 135.75 --Q 38.75 --f 0.3 --sigma 300 --no-pictures
has "an error that is told" "computed numerically: tractions to about"
hasnt "and is no closed form" "All is in closed form"

# ---- Equations: Python computes each as it stands there ----
cat >evaluate.py <<'PYTHON'
import html, math, re, sys
count, names = 0, []
for line in open("out", encoding="utf-8"):
    found = re.match(r"<p><b>(.*?)</b> = .* = <code>(.*)</code> = <b>(.*?)</b>", line)
    if found:
        name, text, value = map(html.unescape, found.groups())
        for old, new in (("·", "*"), ("−", "-"), ("²", "**2"), ("π", "pi"), ("ln(", "log(")):
            text = text.replace(old, new)
        got = eval(text, {"__builtins__": {}}, vars(math))
        # six digits are shown of each number; differences of these magnify their rounding
        if abs(got - float(value)) > 1e-4 * abs(float(value)):
            print(name, text, got, value)
        names.append(name)
print(*names, sep=", ")
PYTHON
equations() { # NAMES OPTIONS...
    names=$1
    shift
    does report "$@" --equations --no-pictures
    same "equations" "$names" "$(python3 evaluate.py)"
}
if command -v python3 >/dev/null 2>&1; then
    strong="k, P/(bk), safety, safety of shakedown"
    equations "A, R, N, b, p₀, p(a), Q/(fP), 1 − Q/(fP), σ of full sliding, $strong" \
        $steel --theta 0.02 --a 0.2 --P 1200 --Q 40 --f 0.3 --yield-stress 900
    equations "A, R, N, b, p₀, p(a), Q/(fP), 1 − Q/(fP), σ of full sliding" $steel --theta 0.02 --a 0.8 --P 3000 --Q 850 --f 0.3
    equations "A, N, b, Q/(fP), c, σ of full sliding" $steel --theta 0.02 --a 0 --P 1200 --Q 40 --f 0.3
    equations "A, b, p₀, Q/(fP), c, σ of full sliding, $strong" $steel --E2 inf --radius 50 --P 300 --Q 40 --f 0.3 --k 400 --similar
    equations "A, b, p₀" $steel --E2 70000 --nu2 0.33 --radius 50 --P 300 --plane-stress
    equations "A, P, Q/(fP), 1 − Q/(fP), σ of full sliding" $steel --flat 0.5 --radius 10 --P 300 --Q 40 --f 0.3
    equations "A" $steel --flat 0.5 --radius 10 --P 300 --M 1
else
    echo "SKIPPED: equations, for lack of python3"
fi
does report $steel --radius 50 --P 300 --no-pictures
hasnt "equations that nobody asked for" "Equations with"

# ---- Bad input ----
refuses "given.json: unexpected; allowed: one case file" report rig.json given.json
refuses "rig.json: given together with --case; allowed: one of the two" report rig.json --case rig.json
refuses "missing: --P" report $steel --radius 50
fails_with_status 1 "absent.json: No such file or directory" report absent.json
fails_with_status 1 "the last load has P = 0, which separates the bodies; allowed: a last P above 0" \
    report $steel --radius 50 --f 0.3 --load 300,0 --load 0,0
printf 'old\n' >page.html
run report $steel --radius 50 --P -1 -o page.html
same "the old file stays" old "$(cat page.html)"
run report rig.json -o rig.json
status_is 2
same "the case is not overwritten" '{"rwedge_case": 1,' "$(head -c 18 rig.json)"

# ---- Pictures ----
shell "PATH=/nonexistent '$rwedge' report rig.json -o page.html"
status_is 1
message_has "gnuplot: not found on PATH"
message_has "or use --no-pictures"
same "the old file stays" old "$(cat page.html)"
if command -v gnuplot >/dev/null 2>&1; then
    does report rig.json
    same "pictures" 3 "$(grep -c '<svg' out)"
    same "declarations inside" 0 "$(grep -c '<?xml' out)"
    hasnt "a script" "<script"
    same "what is loaded" "" "$(grep -oE '(href|src)="[^#][^"]*"' out)"
    kept first report rig.json
    prints_kept "the same bytes again" first report rig.json
else
    echo "SKIPPED: pictures, for lack of gnuplot"
fi
# A specimen of finite thickness would be beside results of a half-plane.
refuses "--specimen-thickness 5: not in a report, whose results are of a half-plane; allowed: history, fretting, crack" \
    report $steel --radius 50 --f 0.3 --load 300,0 --load 300,20 --specimen-thickness 5 --no-pictures

finish

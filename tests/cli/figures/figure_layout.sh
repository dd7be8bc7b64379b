# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of usual and unusual choices show what they are of, and can be read: no text is cut, none lies on another or on the mark
# of first yield. Names of curves stand below the picture. What would be empty axes is refused.
. "$(dirname "$0")/../claims.sh"

# Nothing to draw; the numbers are still there.
nothing() { # MESSAGE ARGUMENTS...
    message=$1
    shift
    cannot "figure $1: nothing to draw: $message" figure "$@" -o none.svg
    same "files" "" "$(ls none.svg 2>/dev/null)"
    does figure "$@" --data
}
nothing "it yields at the surface, whatever f is" 5 --a-over-b 0
nothing "the elastic limit of a sharp wedge is 0" 4 --a-over-b 0
nothing "without slip there is no shear traction" 7 --c-over-b 1

if ! command -v gnuplot >/dev/null 2>&1; then
    [ "$failures" -eq 0 ] || finish
    skip "gnuplot is not here; $checks checks do without it"
fi

draws() {
    does_quietly figure "$@" -o drawn.svg
    awk -f "$here/figure_texts.awk" drawn.svg >texts
    same "texts that cannot be read" "" "$(grep -v '^text ' texts)"
}
has() {
    for text; do
        same "picture has $text" yes "$(sed 's/<[^>]*>//g' drawn.svg | grep -q -F -e "$text" && echo yes)"
    done
}
number_of() { # REGULAR EXPRESSION: texts that match as a whole
    cut -d ' ' -f 5- texts | grep -c -x -e "$1"
}
shows() {
    for text; do
        same "'$text' is in the picture" 1 "$(number_of "$text")"
    done
}
height_of() { # TEXT: its y, downwards
    awk -v text="$1" '{ y = $4; sub(/^text [^ ]* [^ ]* [^ ]* /, "") } $0 == text { print y; exit }' texts
}
above() { # TEXT TEXT
    same "'$1' is above '$2'" yes \
        "$(awk -v one="$(height_of "$1")" -v other="$(height_of "$2")" 'BEGIN { print (one != "" && one + 0 < other + 0) ? "yes" : one " against " other }')"
}

draws 2
has −pAπ/θ 0.1 0.9 "Contact pressure"
draws 2 --a-over-b 5,50
above x/b 50
draws 2 --a-over-b 0.1:2:0.17272727
draws 2 --a-over-b 0.5:0.61:0.01
above x/b 0.61
draws 2 --a-over-b 0.123456789,0.333333333
shows 0.123457 0.333333
draws 2 --a-over-b 0.5,0.50000001 # names tell curves apart
shows 0.50000001

draws 3 --nu 0
draws 3 --nu 0.2
has a/b "P/(bk)" y/b "ν = 0.2" "jump at 0.5542"
draws 3 --nu 0.333333
shows "Elastic limit under a normal load, ν = 0.333333"

draws 4
above f 0.1
has "P/(bk)" 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 "ν = 0.3"
same "curves" 10 "$(grep -c 'id="gnuplot_plot_' drawn.svg)"
draws 4 --a-over-b 0:1:0.0909090909
shows 0.0909091 0.909091
draws 4 --a-over-b 1:3:0.2
above f 1.2
draws 4 --a-over-b 0.9:0.95:0.01

draws 5
shows 0.1 0.3 0.5 0.7 0.9
above "x/b" "circles: jump to the surface"
draws 5 --a-over-b 0.95,0.96,0.97,0.98,0.99,1,1.5,2,3
draws 5 --a-over-b 0,0.1
shows "always at the surface: a/b = 0"

draws 6
has "bσ1/(fP)" "1, sharp wedge" "4/π, Hertz"

draws 7
above x/b "c/b = 1/6"
draws 7 --a-over-b 0 --c-over-b 0,0.1,1
draws 7 --c-over-b 0:1:0.09090909
same "twelve names" 12 "$(number_of 'c/b = [0-9./]*')"

# The contours have their numbers, and the title the digits that were given.
draws field
shows 0.45 "circle: first yield, 0.578" "bar: contact, sliding; lines: every 0.05;"
draws field --a-over-b 0.333 --friction 0.6666 --nu 0.333 --c-over-b 0.4444
shows 0.45 "c/b = 0.4444, ν = 0.333"
has "f = 0.6666" "black: stick" "first yield"
draws field --friction 5 --a-over-b 1
shows 3 2
draws field --a-over-b 0.001 --friction 0.8 --nu 0.5
draws field --a-over-b 3 --c-over-b 1
draws field --a-over-b 0.333333 --friction 0.123456 --nu 0.333333 --q-over-fp 0.777777
shows "Q/(fP) = 0.777777, ν = 0.333333"

# The legend is below the curves.
draws loop --q-over-fp 0.1:0.6:0.1
above "displacement by slip / (fθb)" "0.1: W = 0.000855"
draws loop --q-over-fp 0.05:0.6:0.05
same "twelve names" 12 "$(number_of '0[.0-9]*: W = [0-9.]*')"
has "Q/(fP)"
draws loop --a-over-b 0.123456 --q-over-fp 0.91,0.92,0.93
shows "Cycles of Q under constant P, a/b = 0.123456"

# Q that stays 0 while a tension moves the bodies: its axis has a length all the same, of which gnuplot complained.
run figure loop --E1 72100 --nu1 0.33 --flat 1 --radius 50 --f 0.4 --load 500,0,0,0 --load 500,0,0,30 --load 500,0,0,-30 -o drawn.svg
status_is 0

printf 'P,Q\n135.75,0\n135.75,30\n135.75,-30\n135.75,30\n' >loads.csv
draws measure --history loads.csv --E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.3 --measure ruiz_f1
has "Ruiz parameter" "in units of force/length"

draws unlike-limit
draws unlike-limit --a-over-b 1 --beta-f 0
draws unlike-limit --beta-f=-0.4:0.4:0.1
draws unlike-tension
draws unlike-tension --beta-f 0
draws eccentric
above "bars: stick zones; thin line: friction's limit" "πbσ/(4Q) = 0"
draws eccentric --a-over-b 0 --q-over-fp 0.9 --sigma-over-max=-1:1:0.5
draws eccentric --sigma-over-max=-1:1:0.4
same "six names" 6 "$(number_of 'πbσ/(4Q) = [-0-9.]*')"

# A measured loop and the fitted one.
draws measured --history "$data/instruments/gross.csv" --E1 115000 --nu1 0.32 --radius 50
has "A measured loop" measured fitted "compliance 1.498e-05"

# Lives of tests, with bands around them.
printf 'test,radius,P,Q_max,sigma_max,life_tested\n1,50,300,100,100,12000\n2,50,300,140,110,>1e6\n' >tests.csv
printf '{"E": 206800, "nu": 0.3, "sf": 827, "b": -0.11, "ef": 0.95, "c": -0.64}' >steel.json
draws tests --input tests.csv --f 0.6 --material steel.json
has "Lives of tests" "dashed: a factor of 2; dotted: of 3" broken run-out "measured life"
nothing "no test has a life that was measured, and one that is predicted" tests --input tests.csv --f 0.6 --E1 206800 --nu1 0.3
finish

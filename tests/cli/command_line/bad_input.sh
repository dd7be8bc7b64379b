# SPDX-License-Identifier: GPL-3.0-or-later
# A mistake on the command line gives one line, with the option, the value and what is allowed. The status is 2, and nothing is
# written.
. "$(dirname "$0")/../claims.sh"

limit="table elastic-limit"
range="must be a number, a comma list of numbers, or START:STOP:STEP"
list=" (a comma separates the numbers of a list)"
tables="elastic-limit, max-tension, contact-law, critical-friction, stick-zone"

# Which command, which table.
commands=$("$rwedge" --help | sed -n '/^Commands/,/^$/s/^  \([a-z]*\) .*/\1/p' | paste -s -d , - | sed 's/,/, /g')
refuses "rwedge: a command must follow; allowed: $commands, --help, --version"
refuses "rwedge: tables: unknown command; the nearest is table; allowed: $commands" tables
refuses "rwedge: plot: unknown command; allowed: $commands" plot
refuses "rwedge: : unknown command; allowed: $commands" ""
refuses "table: unexpected; allowed: one command" help solve table
refuses "rwedge: --verbose: unknown option; allowed: --version, --completion, --help" --verbose
refuses "the name of a table must follow; allowed: $tables" table
refuses "elastic: unknown table; allowed: $tables" table elastic
refuses "contact-law: unexpected; allowed: one table, and options" $limit contact-law

# Options that do not exist, lack a value, or have one too many.
options="--a-over-b, --friction, --nu, --q-over-fp, --layout, --quantity, --pad"
common="--help, --format, --digits, --decimal-comma, --output, --quiet, --threads"
refuses "--colour: unknown option; allowed: $options, $common" $limit --colour 0.3
nearest() { # COMMAND OPTION NEAREST
    refuses "rwedge $1: $2: unknown option; the nearest is $3; \"rwedge $1 --help\" lists all" "$1" "$2" 1
}
for command in table figure; do
    nearest $command --mu --friction
    nearest $command --frcition --friction
    nearest $command --a_over_b --a-over-b
done
for command in solve profile field; do
    nearest $command --mu --f
    nearest $command --R --radius
    nearest $command -Q --Q
    nearest $command --E --E1
    nearest $command --theta_deg --theta-deg
    nearest $command --encodng --encoding
done
nearest solve --yeild-stress --yield-stress
nearest solve --sigma-y --yield-stress
refuses "--frcition=1: unknown option; the nearest is --friction; \"rwedge table --help\" lists all" table --frcition=1
# One set of names: both are taken everywhere, and are one option.
for words in "table max-tension --a-over-b 1 --friction 0.3" "table critical-friction --a-over-b 1 --nu 0.25" \
    "figure field --data --x 1 --friction 0.3 --nu 0.25" "profile --a-over-b 1 --f 0.3 --nu1 0.25 --points 2" \
    "solve --E1 2e5 --nu1 0.3 --theta 0.01 --a 1 --P 100 --f 0.3"; do
    kept first $(echo "$words" | sed 's/ --x 1//')
    run $(echo "$words" | sed 's/ --x 1//; s/--friction /--F /; s/--f /--friction /; s/--F /--f /
        s/--nu /--NU /; s/--nu1 /--nu /; s/--NU /--nu1 /')
    status_is 0
    same "the other names" "" "$(cmp first out 2>&1)"
done
refuses "--P: a value must follow, not the option --Q" solve --P --Q 3
refuses "--f 0.3: given twice; allowed: once" solve --friction 0.2 --f 0.3
refuses "--nu: a value must follow" $limit --nu
refuses "--quiet=1: takes no value" $limit --quiet=1
refuses "--nu 0.35: given twice; allowed: once" $limit --nu 0.3 --nu 0.35
refuses "--output '': must be the name of a file, or - for standard output" $limit --output=

# Numbers outside their domain, alone, in a list, at either end of a range.
refuses "--nu 0.7: Poisson's ratio must be a number from 0 to 0.5" $limit --nu 0.7
refuses "--nu 0,3: Poisson's ratio must be a number from 0 to 0.5, not 3$list" $limit --nu 0,3
refuses "--nu 0:0.6:0.1: Poisson's ratio must be a number from 0 to 0.5, not 0.6" $limit --nu 0:0.6:0.1
refuses "--friction -1: the coefficient of friction must be a number from 0 to 1e6" $limit --friction=-1
# What has a size is 0, or 1e-60 to 1e60, in every range.
size="must be 0, or 1e-60 to 1e60 in magnitude"
for extreme in 1e-70 1e61 0.1,1e-70 0:1e308:1e-308; do
    refuses "--a-over-b $extreme: $size" table contact-law --a-over-b $extreme
done
refuses "--y 1e70: $size" field --a-over-b 0.3 --x 0 --y 1e70

# What is no number, no list and no range.
for text in "" abc nan NaN inf -inf infinity 0x1 1e 1e999 1..2 1.2.3 + - . 1_000 "0.3 " " 0.3" 0.3k "0,,1" ,1 1, \
    "0.1;0.2" 1: :1 1:2 1:2: 1:2:3:4 1:2:3,4 1:nan:1 0:inf:1 0:1:0x1 "1 2" 0.1..1; do
    refuses "--a-over-b $text: $range" $limit --a-over-b "$text"
done
refuses "--a-over-b 1?2: $range" $limit --a-over-b "1${newline}2"

# Steps.
refuses "--a-over-b 0:1:0: the STEP of START:STOP:STEP must not be 0" $limit --a-over-b 0:1:0
refuses "--a-over-b 0:1:-0.1: the STEP of START:STOP:STEP must lead from START towards STOP" $limit --a-over-b 0:1:-0.1

# Sizes.
many="must not have more than 1000000000 values"
refuses "--a-over-b 0:1:1e-9: $many" $limit --a-over-b 0:1:1e-9
all="must not give the table more than 1000000000 rows in all"
refuses "--friction 0:1:1e-5: $all" $limit --friction 0:1:1e-5 --a-over-b 0.0001:1:1e-4

# Options that do not belong to the table or the layout.
refuses "--nu 0.3: max-tension does not depend on it; allowed: --friction, --a-over-b" table max-tension --nu 0.3
refuses "--q-over-fp 0: elastic-limit does not depend on it; allowed: --friction, --a-over-b, --nu" $limit --q-over-fp 0
refuses "--layout wide: unknown layout; allowed: long, grid" $limit --layout wide
refuses "--layout grid: contact-law has one variable, and nothing to go across; allowed: long" table contact-law --layout grid
refuses "--nu 0.25,0.3: a grid has one Poisson's ratio; allowed: one number, or --layout long" $limit --layout grid --nu 0.25,0.3
refuses "--quantity x_over_b: it chooses what a grid shows; allowed with: --layout grid" $limit --quantity x_over_b
quantities="P_over_bk, x_over_b, y_over_b, branch, P_over_bk_subsurface, P_over_bk_surface"
refuses "--quantity f: not a quantity of elastic-limit; allowed: $quantities" $limit --layout grid --quantity f

# Formats, and the endings that stand for them.
table="table contact-law --a-over-b 1"
field="field --a-over-b 1 --x 0 --y 1"
for format in csv tsv json; do
    kept wanted $table --format $format
    prints "" $table -o chosen.$format
    same "the ending chooses" "" "$(cmp wanted chosen.$format 2>&1)"
done
prints "" $table -o CHOSEN.JSON
same "in capitals" "[" "$(head -n 1 CHOSEN.JSON)"
prints "" $field -o chosen.vtk
same "vtk" "# vtk DataFile Version 3.0" "$(head -n 1 chosen.vtk)"
prints "" figure 6 --data -o chosen.tsv
same "data of a figure" "a_over_b${tab}b_sigma_over_fP" "$(head -n 1 chosen.tsv)"
for path in plain .hidden chosen.d/plain; do
    mkdir -p chosen.d
    prints "" $table -o $path
    same "no ending: csv" "a_over_b,AP_over_theta_b" "$(head -n 1 $path | cut -d , -f 1,2)"
done
prints "" $table --format csv -o named.txt
rm -r named.txt plain chosen.* CHOSEN.JSON .hidden
other="allowed: .csv, .tsv, .json, .xlsx"
for ending in txt vtk pdf xls; do
    refuses "--output x.$ending: the ending .$ending belongs to no format here; $other" $table -o x.$ending
done
refuses "--output f.png: the ending .png belongs to no format here; $other, .vtk" $field -o f.png
refuses "--output f.vtk: the ending .vtk belongs to no format here; $other" solve -o f.vtk
for ending in jpg csv; do
    refuses "--output x.$ending: the ending .$ending belongs to no format here; allowed: .svg, .png, .pdf; with \
--data: csv, tsv, json, xlsx" figure 4 -o x.$ending
done
refuses "--output f.png: the ending .png belongs to no format here; $other" figure 4 --data -o f.png
refuses "--output w.csv: the ending .csv belongs to no format here; allowed: .xlsx" workbook -o w.csv
refuses "--output x.json: its ending contradicts --format csv; allowed: .csv" $table --format csv -o x.json
refuses "--output x.csv: its ending contradicts --format vtk; allowed: .vtk" $field --format vtk -o x.csv
refuses "--output x.png: its ending contradicts --format svg; allowed: .svg" figure 4 --format svg -o x.png
same "nothing is written" "err first out wanted" "$(ls | paste -s -d " " -)"
refuses "--format xml: unknown format; allowed: csv, tsv, json, xlsx" $limit --format xml
refuses "--decimal-comma: not in JSON, whose numbers have a point; allowed with: csv, tsv" $limit --format json --decimal-comma
for digits in 0 18 1.5 "" 17x 99999999999999999999; do
    refuses "--digits $digits: must be a whole number from 1 to 17" $limit --digits "$digits"
done

# A contact: what is missing, given twice over, or not physical. Each line spoils one that is whole.
contact="--E1 210000 --nu1 0.3 --theta 0.05 --a 1 --P 100"
missing() { # OPTION NEEDED: without that option and its value
    called="rwedge solve without $1"
    words=$(echo "$contact" | sed "s/ *$1 [^ ]*//")
    refuses "missing: $2" solve $words
}
missing --E1 --E1
missing --nu1 --nu1
missing --theta "--theta or --theta-deg"
missing --a "--a or --radius"
missing --P --P
refuses "missing: --E1, --nu1, --theta or --theta-deg, --a or --radius, --P" solve
for option in --Q=0 --k=300 --yield-stress=300; do
    refuses "missing: --f; friction has no default where Q, sigma or a yield stress is given" solve $contact $option
done
refuses "--theta-deg 3: given together with --theta; allowed: one of the two" solve $contact --theta-deg 3
refuses "--radius 3: given together with --a; allowed: one of the two" solve $contact --radius 3
refuses "--E2 7e4: needs --nu2; allowed: both, or neither for two bodies of one material" solve $contact --E2 7e4
refuses "contact: unexpected; allowed: options only" solve $contact contact
refuses "--yield-factor: needs --k or --yield-stress" solve $contact --yield-factor

unphysical() { # OPTION VALUE MESSAGE: which follows the option and its value
    words=$(echo "$contact" | sed "s/ *$1 [^ ]*//")
    refuses "$1 $2: $3" solve $words $1 "$2"
}
for text in 0 -1 "" nan x 1e999 0x1 " "; do
    case $text in *[!\ ]*) ;; *) continue ;; esac # empty ones are missing
    unphysical --E1 "$text" "Young's modulus of body 1 must be a number above 0"
    unphysical --P "$text" "the normal force must be a number above 0"
done
unphysical --E1 inf "Young's modulus of body 1 must be a number above 0; a rigid body is body 2, with --E2 inf"
unphysical --E1 210,5 "Young's modulus of body 1 must be a number above 0; the decimal sign is a point"
unphysical --nu1 0.51 "Poisson's ratio must be a number from 0 to 0.5"
unphysical --theta 0 "the angle must be a number above 0 and below pi/2, in radians"
unphysical --a -1e-9 "the half-width of the rounding must be a number not below 0"
unphysical --f -0.1 "the coefficient of friction must be a number from 0 to 1000000"
refuses "--k 0: the yield stress must be a number above 0" solve $contact --f 0 --k 0
refuses "--Q ten: the tangential force must be a number" solve $contact --f 0 --Q ten
refuses "--E1 '': Young's modulus of body 1 must be a number above 0" solve --E1 "" --nu1 0 --theta 0.1 --a 1 --P 1
refuses "--E2 0: Young's modulus must be a number above 0, or inf" solve $contact --E2 0 --nu2 0.3
refuses "--Q 21: must not exceed f P = 20: there is no equilibrium" solve $contact --f 0.2 --Q 21
refuses "--Q 1: must not exceed f P = 0: there is no equilibrium; f is missing" profile $contact --Q 1
refuses "the moduli and the rounding are so large or small that results leave 1e-60 to 1e60" \
    solve --E1 1e-60 --nu1 0 --theta 1e-55 --a 1 --P 1
size="1e-60 to 1e60 in magnitude"
refuses "--a 1e61: the half-width of the rounding must be $size, or 0" solve --E1 1 --nu1 0 --theta 1 --a 1e61 --P 1

# Natural units and dimensional ones do not mix, nor do two histories.
natural="given together with --a-over-b"
refuses "--P 1: $natural; allowed: --f, --nu1, --M, --sigma, --q-over-fp, --c-over-b" profile --a-over-b 1 --P 1
refuses "--load: $natural; allowed: --q-over-fp or --c-over-b" profile --a-over-b 1 --load 1,0
refuses "--c-over-b 0.5: given together with --q-over-fp; allowed: one of the two" \
    profile --a-over-b 1 --f 0.1 --q-over-fp 0.5 --c-over-b 0.5
refuses "--q-over-fp 0.5: needs --a-over-b; allowed with bodies and loads: --Q" profile $contact --q-over-fp 0.5
refuses "--a-over-b 0.1,0.2: must be one number" profile --a-over-b 0.1,0.2
refuses "--a-over-b -1: a/b must be a number not below 0" profile --a-over-b -1
refuses "--f x: the coefficient of friction must be a number from 0 to 1000000" profile --a-over-b 1 --f x
refuses "--P 100: given together with --load, which has the loads; allowed: one of the two" profile $contact --load 1,0
refuses "--history h.csv: given together with --load; allowed: one of the two" \
    profile --E1 1 --nu1 0 --theta 0.1 --a 1 --load 1,0 --history h.csv
refuses "--points 5: given together with --x; allowed: one of the two" profile --a-over-b 1 --x 0 --points 5
for points in 1 x 99999999999; do
    refuses "--points $points: must be a whole number from 2 to 1000000000" profile --a-over-b 1 --points "$points"
done

# The output is not touched by a mistake.
echo old >kept.csv
refuses "--nu 0.7: Poisson's ratio must be a number from 0 to 0.5" $limit --nu 0.7 -o kept.csv
same "the old file" old "$(cat kept.csv)"

finish

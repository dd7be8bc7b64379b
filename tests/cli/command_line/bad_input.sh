# SPDX-License-Identifier: GPL-3.0-or-later
# A mistake on the command line gives one line, with the option, the value and what is allowed. The status is 2, and nothing is
# written. tests/data/mistakes.tsv has the usual ones.
. "$(dirname "$0")/../claims.sh"

while IFS=$tab read -r words message; do
    case $words in '#'*) ;; *) eval "refuses \"\$message\" $words" ;; esac
done <"$data/mistakes.tsv"

limit="table elastic-limit"
range="must be a number, a comma list of numbers, or START:STOP:STEP"

# Which command.
commands=$("$rwedge" --help | sed -n '/^Commands/,/^$/s/^  \([a-z]*\) .*/\1/p' | paste -s -d , - | sed 's/,/, /g')
refuses "rwedge: a command must follow; allowed: $commands, --help, --version"
refuses "rwedge: tables: unknown command; the nearest is table; allowed: $commands" tables
refuses "rwedge: plot: unknown command; allowed: $commands" plot
refuses "rwedge: : unknown command; allowed: $commands" ""

# Options that do not exist.
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

# What has a size is 0, or 1e-60 to 1e60, in every range.
size="must be 0, or 1e-60 to 1e60 in magnitude"
for extreme in 1e-70 1e61 0.1,1e-70 0:1e308:1e-308; do
    refuses "--a-over-b $extreme: $size" table contact-law --a-over-b $extreme
done

# What is no number, no list and no range.
for text in "" abc nan NaN inf -inf infinity 0x1 1e 1e999 1..2 1.2.3 + - . 1_000 "0.3 " " 0.3" 0.3k "0,,1" ,1 1, \
    "0.1;0.2" 1: :1 1:2 1:2: 1:2:3:4 1:2:3,4 1:nan:1 0:inf:1 0:1:0x1 "1 2" 0.1..1; do
    refuses "--a-over-b $text: $range" $limit --a-over-b "$text"
done
refuses "--a-over-b 1?2: $range" $limit --a-over-b "1${newline}2"

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
same "nothing is written" "err first out wanted" "$(ls | paste -s -d " " -)"
for digits in 0 18 1.5 "" 17x 99999999999999999999; do
    refuses "--digits $digits: must be a whole number from 1 to 17" $limit --digits "$digits"
done

for points in 1 x 99999999999; do
    refuses "--points $points: must be a whole number from 2 to 1000000000" profile --a-over-b 1 --points "$points"
done

# The output is not touched by a mistake.
echo old >kept.csv
refuses "--nu 0.7: Poisson's ratio must be a number from 0 to 0.5" $limit --nu 0.7 -o kept.csv
same "the old file" old "$(cat kept.csv)"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# Mistakes on the command line: one line with the option, the value and what is allowed; status 2; nothing written.
. "$(dirname "$0")/claims.sh"

limit="table elastic-limit"
range="must be a number, a comma list of numbers, or START:STOP:STEP"
list=" (a comma separates the numbers of a list)"
tables="elastic-limit, max-tension, contact-law, critical-friction, stick-zone"

# Which command, which table.
refuses "rwedge: a command must follow; allowed: table, --help, --version"
refuses "rwedge: tables: unknown command; allowed: table" tables
refuses "rwedge: --verbose: unknown option; allowed: --version, --help" --verbose
refuses "rwedge table: the name of a table must follow; allowed: $tables" table
refuses "rwedge table: elastic: unknown table; allowed: $tables" table elastic
refuses "rwedge table: contact-law: unexpected; allowed: one table, and options" $limit contact-law

# Options that do not exist, lack a value, or have one too many.
options="--a-over-b, --friction, --nu, --q-over-fp, --layout, --quantity"
common="--help, --format, --digits, --decimal-comma, --output, --quiet"
refuses "rwedge table: --mu: unknown option; allowed: $options, $common" $limit --mu 0.3
refuses "rwedge table: -x: unknown option; allowed: $options, $common" $limit -x
refuses "rwedge table: --nu: a value must follow" $limit --nu
refuses "rwedge table: -o: a value must follow" $limit -o
refuses "rwedge table: --quiet=1: takes no value" $limit --quiet=1
refuses "rwedge table: --nu 0.35: given twice; allowed: once" $limit --nu 0.3 --nu 0.35
refuses "rwedge table: --output '': must be the name of a file, or - for standard output" $limit --output=

# Numbers outside their domain, alone, in a list, at either end of a range.
refuses "rwedge table: --nu 0.7: Poisson's ratio must be a number from 0 to 0.5" $limit --nu 0.7
refuses "rwedge table: --nu -0.1: Poisson's ratio must be a number from 0 to 0.5" $limit --nu -0.1
refuses "rwedge table: --nu 0,3: Poisson's ratio must be a number from 0 to 0.5, not 3$list" $limit --nu 0,3
refuses "rwedge table: --nu 0:0.6:0.1: Poisson's ratio must be a number from 0 to 0.5, not 0.6" $limit --nu 0:0.6:0.1
refuses "rwedge table: --friction -1: the coefficient of friction must be a number not below 0" $limit --friction=-1
refuses "rwedge table: --friction -0.1:1:0.1: the coefficient of friction must be a number not below 0, not -0.1" \
    $limit --friction -0.1:1:0.1
refuses "rwedge table: --a-over-b -1e-300: a/b must be a number not below 0" $limit --a-over-b -1e-300
refuses "rwedge table: --q-over-fp 1.1: Q/(fP) must be a number from 0 to 1" table stick-zone --q-over-fp 1.1

# What is no number, no list and no range.
for text in "" abc nan NaN inf -inf infinity 0x1 1e 1e999 1..2 1.2.3 + - . 1_000 "0.3 " " 0.3" 0.3k "0,,1" ,1 1, \
    "0.1;0.2" 1: :1 1:2 1:2: 1:2:3:4 1:2:3,4 1:nan:1 0:inf:1 0:1:0x1 "1 2" 0.1..1; do
    refuses "rwedge table: --a-over-b $text: $range" $limit --a-over-b "$text"
done
refuses "rwedge table: --a-over-b 1?2: $range" $limit --a-over-b "1${newline}2"

# Steps.
refuses "rwedge table: --a-over-b 0:1:0: the STEP of START:STOP:STEP must not be 0" $limit --a-over-b 0:1:0
refuses "rwedge table: --a-over-b 0:1:1e-400: the STEP of START:STOP:STEP must not be 0" $limit --a-over-b 0:1:1e-400
refuses "rwedge table: --a-over-b 0:1:-0.1: the STEP of START:STOP:STEP must lead from START towards STOP" \
    $limit --a-over-b 0:1:-0.1
refuses "rwedge table: --a-over-b 1:0:0.1: the STEP of START:STOP:STEP must lead from START towards STOP" \
    $limit --a-over-b 1:0:0.1

# Sizes.
many="must not have more than 1000000000 values"
refuses "rwedge table: --a-over-b 0:1:1e-9: $many" $limit --a-over-b 0:1:1e-9
refuses "rwedge table: --a-over-b 0:1:1e-300: $many" $limit --a-over-b 0:1:1e-300
refuses "rwedge table: --a-over-b 0:1e308:1e-308: $many" $limit --a-over-b 0:1e308:1e-308
refuses "rwedge table: --a-over-b 0:9007199254740992:1: $many" $limit --a-over-b 0:9007199254740992:1
all="must not give the table more than 1000000000 rows in all"
refuses "rwedge table: --friction 0:1:1e-5: $all" $limit --friction 0:1:1e-5 --a-over-b 0.0001:1:1e-4
refuses "rwedge table: --a-over-b 1:1000000000:1: $all" $limit --a-over-b 1:1000000000:1 --friction 1:1000000000:1 \
    --nu 0:0.5:1e-9

# Options that do not belong to the table or the layout.
refuses "rwedge table: --nu 0.3: max-tension does not depend on it; allowed: --friction, --a-over-b" \
    table max-tension --nu 0.3
refuses "rwedge table: --q-over-fp 0: elastic-limit does not depend on it; allowed: --friction, --a-over-b, --nu" \
    $limit --q-over-fp 0
refuses "rwedge table: --layout wide: unknown layout; allowed: long, grid" $limit --layout wide
refuses "rwedge table: --layout grid: contact-law has one variable, and nothing to go across; allowed: long" \
    table contact-law --layout grid
refuses "rwedge table: --nu 0.25,0.3: a grid has one Poisson's ratio; allowed: one number, or --layout long" \
    $limit --layout grid --nu 0.25,0.3
refuses "rwedge table: --quantity x_over_b: it chooses what a grid shows; allowed with: --layout grid" \
    $limit --quantity x_over_b
quantities="P_over_bk, x_over_b, y_over_b, branch, P_over_bk_subsurface, P_over_bk_surface"
refuses "rwedge table: --quantity f: not a quantity of elastic-limit; allowed: $quantities" \
    $limit --layout grid --quantity f

# Formats.
refuses "rwedge table: --format xml: unknown format; allowed: csv, tsv, json" $limit --format xml
refuses "rwedge table: --format xlsx: this build cannot write it; allowed: csv, tsv, json" $limit --format xlsx
refuses "rwedge table: --decimal-comma: not in JSON, whose numbers have a point; allowed with: csv, tsv" \
    $limit --format json --decimal-comma
for digits in 0 18 1.5 -1 "" seventeen 17x 99999999999999999999; do
    refuses "rwedge table: --digits $digits: must be a whole number from 1 to 17" $limit --digits "$digits"
done

# The output is not touched by a mistake.
echo old >kept.csv
refuses "rwedge table: --nu 0.7: Poisson's ratio must be a number from 0 to 0.5" $limit --nu 0.7 -o kept.csv
same "the old file" old "$(cat kept.csv)"

finish

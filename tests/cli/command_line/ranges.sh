# SPDX-License-Identifier: GPL-3.0-or-later
# START:STOP:STEP, lists and numbers: the values that the text of an option stands for.
. "$(dirname "$0")/../claims.sh"

# values EXPECTED RANGE: the values of a/b, in one line.
values() {
    does table contact-law --a-over-b "$2"
    same "values" "$1" "$(column a_over_b out | paste -s -d ' ' -)"
}

# The decimals that were meant, not sums of rounded steps.
values "0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8 0.9 1" 0.1:1:0.1
values "1 0.9 0.8 0.7 0.6 0.5 0.4 0.3 0.2 0.1 0" 1:0:-0.1
values "1e-08 3e-08 5e-08" 1e-8:5e-8:2e-8
values "0.1 0.2 0.3" 0.10000000000000000000:0.3:.1
values "0.1 0.2 0.3" +0.1:3.0e-1:1E-1

# STOP belongs to the range where a step hits it.
values "0 0.3 0.6 0.9" 0:1:0.3
values "0 0.25 0.5 0.75 1" 0:1:0.25
values "0.5" 0.5:0.5:0.1
values "0.5" 0.5:1:1e300

# Steps with more digits than are exact: hit to rounding, and then STOP itself.
values "0 0.3333333333333333 0.6666666666666666 1" 0:1:0.33333333333333333333
values "0.1 0.19090909090909092 0.2818181818181818" 0.1:0.281818181818181818:0.090909090909090909

# Lists keep their order, and may repeat; -0 is 0.
values "0.5 0.1 0.5" 0.5,0.1,0.5
values "0" -0
values "0 0.5" -0:0.5:0.5
values "1e-60 1e+60" 1e-60,1e60

# Nothing is kept: the first row of a thousand million comes at once, in little memory.
memory_of 100000
shell '(ulimit -v $limit; "$rwedge" table max-tension --a-over-b 0.5 --friction 1:1000:1e-6) | sed -n 2p\;2q'
output_is "0.5,1,1.0453564728528064,1.0453564728528064"

# The order of rows: nu slowest, then a/b, then the other variable.
run table elastic-limit --a-over-b 0.5,1 --friction 0,0.1 --nu 0.3,0.25
same "order" "0.5 0 0.3;0.5 0.1 0.3;1 0 0.3;1 0.1 0.3;0.5 0 0.25;0.5 0.1 0.25;1 0 0.25;1 0.1 0.25" \
    "$(part_of out a_over_b f nu | tr , ' ' | paste -s -d ';' -)"

# Without options: the paper's grid.
run table elastic-limit
same "rows of the paper's grid" 650 "$(column f out | wc -l | tr -d ' ')"
run table stick-zone
same "rows of the default" 210 "$(column Q_over_fP out | wc -l | tr -d ' ')"

# A number with a decimal comma is a list of two. Where it looks so, a line says how it was understood.
two() { # WORDS-BEFORE OPTION TEXT FIRST SECOND DECIMAL
    does $1 $2 $3 --format csv
    message_is "rwedge ${1%% *}: $2 $3: two values, $4 and $5; a decimal is written $6"
}
two "table max-tension --a-over-b 1" --friction 0,5 0 5 0.5
two "table max-tension --friction 1" --a-over-b 1,05 1 05 1.05
two "profile --a-over-b 1" --x 0,5 0 5 0.5
two "field --a-over-b 1 --y 1" --x -0,5 -0 5 -0.5
run figure 5 --data --a-over-b 0,5
message_is "rwedge figure: --a-over-b 0,5: two values, 0 and 5; a decimal is written 0.5"
for list in 1,5 0,0.5 0,1,2 0.0,1 5 0:1:0.5 10,20; do
    does_quietly table max-tension --a-over-b 1 --friction $list
done
refuses "--q-over-fp 0,1: must be one number" profile --a-over-b 1 --q-over-fp 0,1

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# Loads without a closed form: computed, with the error; refused with --exact.
. "$(dirname "$0")/../claims.sh"

# A tension that lags behind Q. What has a closed form is the same with and without computing, to the last digit.
awk 'BEGIN { print "P,Q,sigma\n135.75,0,0"; for (i = 1; i <= 6; i++) { w = 6.283185307 * i / 12
    printf "135.75,%.6g,%.6g\n", 30 * sin(w), 100 * sin(w - 0.7) } }' >lags.csv
kept usual history lags.csv $specimen
same "exact at first, then computed" "0 0 0 1 1 1 1" "$(column error out | awk '{ print ($1 == 0 ? 0 : $1 > 0 && $1 < 1e-4 ? 1 : "?") }' | paste -s -d ' ' -)"
same "said in the rows that are" "0 0 0 1 1 1 1" \
    "$(column warnings out | awk '{ print /(^|; )computed numerically: tractions to about [1-9]e-[0-9]* of f p0$/ + 0 }' | paste -s -d ' ' -)"
same "and where several zones stick" "0 0 0 1 0 0 0" "$(column warnings out | awk '{ print /^several zones stick/ + 0 }' | paste -s -d ' ' -)"
same "and once on standard error" 1 "$(grep -c '^rwedge history: lags.csv, in some rows: computed numerically: tractions to about [1-9]e-[0-9]* of f p0$' err)"
cannot "lags.csv: line 5: no closed form: the two edges would slip in opposite directions; change sigma by less; sigma may change by 24.7579 with this Q; without --exact it is computed" \
    history lags.csv $specimen --exact
printf 'P,Q,sigma\n135.75,0,0\n135.75,38.75,100\n135.75,-38.75,-100\n' >phase.csv
kept exact history phase.csv $specimen --exact
prints_kept "closed forms" exact history phase.csv $specimen
message_is ""

# Every command that goes through loads.
for command in "solve --history lags.csv" "field --history lags.csv --x 0 --y 0" "fretting lags.csv --at 0,0 --cycles 1" "history lags.csv --at 0,0" \
    "figure history --history lags.csv --at 0,0 --data" "figure loop --history lags.csv --data" "solve --P 135.75 --Q 30 --sigma 300"; do
    does $command $specimen
    message_has "computed numerically: tractions to about "
done
same "in the warnings of solve" 1 "$(value warnings | grep -c '^computed numerically: ')"
printf 'P,Q,sigma\n135.75,30,100\n135.75,30,300\n' >cases.csv
run solve -i cases.csv $specimen
same "in the rows of a file of contacts" "- yes" "$(column warnings out | sed 's/^computed numerically: .*/yes/' | paste -s -d ' ' -)"
run solve -i cases.csv $specimen --exact
same "or refused there" 1 "$(grep -c 'sigma 300: no closed form: ' out)"
does profile --a-over-b 0.5 --f 0.3 --q-over-fp 0.5 --sigma 0.5 --points 11
message_has "rwedge profile: computed numerically: "
same "natural units, whose middle sticks" stick "$(column zone out | sed -n 6p)"

for wrong in 0 1e-7 0.1 nan 1,5; do
    refuses "--tolerance $wrong: must be a number from 1e-6 to 1e-2" history lags.csv $specimen --tolerance $wrong
done
refuses "--tolerance 1e-3: given together with --exact; allowed: one of the two" \
    fretting lags.csv $specimen --tolerance 1e-3 --exact
refuses "figure 7: a contact and its loads are for history, fretting, measure, crack, wear, contact, tractions, stress, tests, measured, and loop with --history or --load" figure 7 --exact
cannot "error.csv: column error: a result has that name; allowed: any other" \
    history "$(printf 'P,Q,error\n1,0,0\n' >error.csv; echo error.csv)" $specimen

# Loads that slide fully off the centre do not tell the energy; it is not said to be "nan".
printf 'P,M,Q,sigma\n100,5,0,0\n120,6,20,40\n100,5,-30,-20\n' >moves.csv
run history moves.csv $specimen --cycles 2
same "energy of a cycle" "- 0" "$(column energy out | tail -n 1) $(grep -c nan err)"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# CSV, TSV and JSON, digits, the decimal comma, long and grid: what the examples of the README do not show.
. "$(dirname "$0")/../claims.sh"

stick="table stick-zone --a-over-b 0 --q-over-fp 0,0.25"
law="table contact-law --a-over-b 0,1.0"

prints "a_over_b${tab}Q_over_fP${tab}c_over_b
0${tab}0${tab}1
0${tab}0.25${tab}0.75" $stick --format tsv

# Infinite and absent values are empty cells, null in JSON.
prints "a_over_b,AP_over_theta_b,AP_over_theta_a,peak_pressure,transition_pressure
0,2,,,
1,1.57079633,1.57079633,1,0" $law --digits 9
prints '[
{"a_over_b": 0, "AP_over_theta_b": 2, "AP_over_theta_a": null, "peak_pressure": null, "transition_pressure": null},
{"a_over_b": 1, "AP_over_theta_b": 1.571, "AP_over_theta_a": 1.571, "peak_pressure": 1, "transition_pressure": 0}
]' $law --digits 4 --format json

# The comma as decimal sign in TSV.
prints "a_over_b${tab}Q_over_fP${tab}c_over_b
0${tab}0${tab}1
0${tab}0,25${tab}0,75" $stick --format tsv --decimal-comma

# Digits: the shortest text that reads back, or as many as asked for.
prints "a_over_b,f,b_sigma_over_P,b_sigma_over_fP
1,0.3,0.38197186342054884,1.2732395447351628" table max-tension --a-over-b 1 --friction 0.3
prints "a_over_b,f,b_sigma_over_P,b_sigma_over_fP
1,0.3,0.382,1.273" table max-tension --a-over-b 1 --friction 0.3 --digits 4
prints "a_over_b,f,b_sigma_over_P,b_sigma_over_fP
1e-20,0.3,0.3,1" table max-tension --a-over-b 1e-20 --friction 0.3

# Reading a table's a/b back gives the same bits: the same table.
run table contact-law --a-over-b 0.012345678901234567:1:0.0987654321987654321
cp out first
run table contact-law --a-over-b "$(column a_over_b first | paste -s -d , -)"
same "table from its own a/b" "" "$(diff first out)"

# Grids: a/b down, the second variable across, the quantity in the corner.
prints "c_over_b,0,0.5,1
0,1,0.5,0
1,1,0.7071067811865476,0" table stick-zone --a-over-b 0,1.0 --q-over-fp 0:1:0.5 --layout grid
prints "b_sigma_over_fP,0,1
1,1.27,1.27" table max-tension --a-over-b 1 --friction 0,1.0 --layout grid --quantity b_sigma_over_fP --digits 3
prints "branch,0,0.8
0,surface,surface
1,subsurface,surface" table elastic-limit --a-over-b 0,1.0 --friction 0,0.8 --layout grid --quantity branch

# A grid's columns stay apart however few digits its cells have.
prints "c_over_b,0.25,0.254
0,0.8,0.7" table stick-zone --a-over-b 0 --q-over-fp 0.25,0.254 --layout grid --digits 1

# A grid and the long table have the same numbers.
run table elastic-limit --layout grid
awk -F, 'NR == 1 { for (i = 2; i <= NF; i++) f[i] = $i; next } { for (i = 2; i <= NF; i++) print $1 "," f[i] "," $i }' \
    out >from_grid
run table elastic-limit
part_of out a_over_b f P_over_bk >from_long
same "grid against long" "" "$(diff from_long from_grid | head -n 5)"

finish

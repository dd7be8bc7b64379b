# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge solve --input: rows in, rows out. A bad row spoils no other row. A bad file is refused before its first row.
#
#     batch.sh PROGRAM REFERENCES [ROWS]     ROWS: of the long file (default 3000)
rows=${3:-3000}
. "$(dirname "$0")/../claims.sh"

fixed="--E1 210000 --nu1 0.3 --theta 0.05"

# A row is what the single contact is.
awk 'BEGIN { srand(5); print "name,theta_deg,radius,P,Q,f,yield_stress"
    for (i = 0; i < 5; i++) { f = 0.01 + rand() / 2; P = 10 + 500 * rand()
        printf "n%d,%.4g,%.4g,%.5g,%.4g,%.3g,%.4g\n", i, 0.2 + 5 * rand(), 20 * rand(), P, f * P * (2 * rand() - 1) * 0.98, f,
               100 + 900 * rand() } }' >cases.csv
does solve -i cases.csv --E1 210000 --nu1 0.3
same "columns of shakedown are asked for" 0 "$(head -n 1 out | grep -c P_shakedown)"
refuses "--shakedown: needs --k or --yield-stress" solve --E1 210000 --nu1 0.3 --P 1 --radius 1 --shakedown
does solve -i cases.csv --E1 210000 --nu1 0.3 --yield-factor --shakedown
message_is "rwedge solve: cases.csv, in some rows: P is above P_yield: the contact yields in full sliding"
cp out solved.csv
same "rows" 6 "$(wc -l <solved.csv | tr -d ' ')"
same "the rows come back as they were" "" "$(cut -d , -f 1-7 solved.csv | diff cases.csv -)"
same "errors" "" "$(column error solved.csv | tr -d '\n-')"
n=1
tail -n +2 cases.csv >rows
while IFS=, read -r name theta radius P Q f Y; do
    n=$((n + 1))
    run solve --E1 210000 --nu1 0.3 --theta-deg "$theta" --radius "$radius" --P "$P" --Q "$Q" --f "$f" \
        --yield-stress "$Y" --yield-factor --layout row
    # Every column of the single row, by its name, against that row of the batch; radius is an input there.
    sed -n "1p;${n}p" solved.csv >row
    same "single and batch, $name" "" "$(awk -F, 'NR == FNR { if (FNR == 1) split($0, h, ","); else for (i in h) batch[h[i]] = $i; next }
        FNR == 1 { split($0, g, ","); next }
        { for (i in g) if (g[i] != "radius" && batch[g[i]] != $i) print g[i], batch[g[i]], $i }' row out)"
done <rows

# What is not an input passes through, with its quotes, spaces and line breaks; blank lines and rows of empty cells are no rows;
# CR LF and a missing last line end change nothing. The mark in front of UTF-8 stays there.
printf 'note,P,a\n"one, ""1""",100,1\n two ,200, 1\n"three\nlines",1e2,1\n' >plain.csv
kept plain_solved solve -i plain.csv $fixed
{ printf '\357\273\277'; cat out; } >marked_solved
printf '\357\273\277note,P,a\r\n"one, ""1""",100,1\r\n\r\n two ,200, 1\r\n,,\r\n"", ,\r\n"three\nlines",1e2,1' >marked.csv
prints_kept "mark, CR LF, blank lines" marked_solved solve -i marked.csv $fixed
same "errors" 0 "$(grep -c 'must be\|quotes\|cells' out)"

# The comma as decimal sign goes for what is read and what is written; options keep the point.
printf 'note;P;a\nx;100,5;0,25\ny;100.5;0,25\n' >comma.csv
run solve -i comma.csv $fixed --decimal-comma --digits 5
message_is "rwedge solve: comma.csv: 1 of 2 rows could not be solved: see the column error"
same "comma" 'x;100,5;0,25;1,7333e-05' "$(sed -n 2p out | cut -d ';' -f 1-4)"
same "point where a comma is due" \
    "P 100.5: the normal force must be a number above 0; the decimal sign is a comma" \
    "$(sed -n 3p out | sed 's/.*"\(P 100.*\)"$/\1/')"
run solve -i plain.csv $fixed --format json --digits 4
same "in JSON, the inputs are numbers" '{"note": "one, \"1\"", "P": 100, "a": 1, "A": 1.733e-05,' \
    "$(sed -n 2p out | cut -d ' ' -f 1-9)"

# A cell stands for what a material has; E and nu of a row that are not the material's are an error of that row.
echo '{"E": 210000, "nu": 0.3, "yield_stress": 400}' >steel.json
printf 'E1,nu1,yield_stress\n210000,.3,300\n72000,.3,300\n210000,.33,300\n' >material.csv
run solve -i material.csv --material steel.json --radius 50 --P 100 --Q 50 --f 0.75
same "E and nu beside a material's" "E1 72000: the material has 210000; allowed: one of the two|nu1 .33: the material has 0.3; allowed: one of the two|" \
    "$(column error out | sed 's/^-$//;/^$/d' | tr '\n' '|')"
safety=$(column safety out | head -n 1)
does solve --E1 210000 --nu1 0.3 --yield-stress 300 --radius 50 --P 100 --Q 50 --f 0.75 --layout row
same "the yield stress of the row" "$(column safety out)" "$safety"
printf 'k\n200\n' >strength.csv
does solve -i strength.csv --material steel.json --radius 50 --P 100 --Q 50 --f 0.75
safety=$(column safety out)
does solve --E1 210000 --nu1 0.3 --k 200 --radius 50 --P 100 --Q 50 --f 0.75 --layout row
same "k of the row, not the yield stress of the material" "$(column safety out)" "$safety"

# Bad rows, each for its own reason; the others are as if alone. (What no input may be, bad_input.sh has.)
cat >bad.csv <<'ROWS'
id,E1,nu1,theta,a,P,Q,f,k
1,210000,0.3,0.05,1,100,10,0.2,300
2,-1,0.3,0.05,1,100,10,0.2,300
3,210000,0.3,0.05,1,100,21,0.2,300
4,2e5 MPa,0.3,0.05,1,100,10,0.2,300
5,,0.3,0.05,1,100,10,0.2,300
6,210000,0.3,0.05,1,100,10
7,210000,0.3,0.05,1,100,10,0.2,300,extra
8,210000,"0.3"5,0.05,1,100,10,0.2,300
9,210000,"0,3",0.05,1,100,10,0.2,300
10,inf,0.3,0.05,1,100,10,0.2,300
11,1e40,0.3,0.05,1e-15,100,10,0.2,300
12,210000,0.3,0.05,1,100,0,0.2,
13,210000,0.3,0.05,1,100,10,,300
14,210000,0.3,0.05,1,100, ,0.2,300
15,210000,0.3,0.05,,100,10,0.2,300
16,210000,0.3,0.05,1,100,10,0.2,300
ROWS
cat >expected <<'ERRORS'
E1 -1: Young's modulus of body 1 must be a number above 0
Q 21: must not exceed f P = 20: there is no equilibrium
E1 2e5 MPa: has the unit 'MPa', and no working units are known: --units, such as --units mm,N,MPa, converts it
E1: the cell is empty
7 cells in this row, 9 in the header
10 cells in this row, 9 in the header; with decimal commas, separate the cells by ';' and give --decimal-comma: 7,210000,0.3,0.05,1,100,10,0.2,300,extra
misplaced quotes in the row of line 9: 8,210000,""0.3""5,0.05,1,100,10,0.2,300
nu1 0,3: Poisson's ratio must be a number from 0 to 0.5; the decimal sign is a point, or a comma with --decimal-comma
E1 inf: Young's modulus of body 1 must be a number above 0; a rigid body is body 2, with --E2 inf
k: the cell is empty
f: the cell is empty
Q: the cell is empty
a: the cell is empty
ERRORS
does solve -i bad.csv
message_is "rwedge solve: bad.csv: 13 of 16 rows could not be solved: see the column error
rwedge solve: bad.csv, in some rows: P is above P_yield: the contact yields in full sliding
rwedge solve: bad.csv, in some rows: a/b is below 0.01 or above 10000: are the units consistent?
rwedge solve: bad.csv, in some rows: k/E is below 0.00001 or above 0.1: are the stresses in one unit?"
same "rows" 17 "$(wc -l <out | tr -d ' ')"
awk -F, '{ gsub(/.*,,,,/, ""); gsub(/^,*"?|"$/, ""); print }' out | sed '1,2d;/^11,/d;$d' >got
same "errors" "" "$(diff expected got)"
same "first and last, but for the number" "$(sed -n 2p out | cut -d , -f 2-)" "$(tail -n 1 out | cut -d , -f 2-)"
same "rows that were misread keep their number" "$(seq 16 | paste -s -d ' ' -)" \
    "$(tail -n +2 out | cut -d , -f 1 | paste -s -d ' ' -)"
printf 'P,radius,theta_deg,yield_stress\n100,,1,900\n100,1,,900\n100,1,1,\n100,1,1,900\n' >gap.csv
run solve -i gap.csv --E1 210000 --nu1 0.3 --f 0
same "empty cells name their own column" \
    "radius: the cell is empty|theta_deg: the cell is empty|yield_stress: the cell is empty|-" \
    "$(column error out | paste -s -d '|' -)"

# Without friction there may be none, or it was forgotten.
printf 'P,a\n100,1\n' >frictionless.csv
run solve -i frictionless.csv $fixed
same "friction that nothing gives" "no friction given" "$(column warnings out)"
run solve -i frictionless.csv --E1 210000 --nu1 0.3 --theta 0.2
same "with another warning" "theta is above 0.1 rad: the wedge is hardly a half-plane; no friction given" \
    "$(column warnings out)"
message_is "rwedge solve: frictionless.csv, in some rows: theta is above 0.1 rad: the wedge is hardly a half-plane"
run solve -i frictionless.csv $fixed --f 0
same "friction 0 by an option" "-" "$(column warnings out)"
printf 'P,a,f\n100,1,0\n' >frictionless.csv
run solve -i frictionless.csv $fixed
same "friction 0 in a column" "-" "$(column warnings out)"
# Where Q or a yield stress is given, a default of 0 would look like a result.
no_default="missing: f; friction has no default where Q, sigma or a yield stress is given; allowed: columns or options"
printf 'P,a,Q\n100,1,0\n' >frictionless.csv
cannot "frictionless.csv: $no_default" solve -i frictionless.csv $fixed
for strength in k yield_stress; do
    printf 'P,a,%s\n100,1,300\n' $strength >frictionless.csv
    cannot "frictionless.csv: $no_default" solve -i frictionless.csv $fixed
done
printf 'P,a\n100,1\n' >frictionless.csv
cannot "frictionless.csv: $no_default" solve -i frictionless.csv $fixed --k 300

# Where every row has an error, it could not be done; the rows are written all the same.
printf 'P,a\n-1,1\n100,-1\n' >hopeless.csv
cannot "hopeless.csv: 2 of 2 rows could not be solved: see the column error" solve -i hopeless.csv $fixed -o hopeless_solved.csv
same "rows with errors" \
    "P -1: the normal force must be a number above 0|a -1: the half-width of the rounding must be a number not below 0" \
    "$(column error hopeless_solved.csv | paste -s -d '|' -)"
printf 'P,a\n' >hopeless.csv
does solve -i hopeless.csv $fixed

# Lines are counted whatever ends them, and a bad row may be longer than what is read at once.
for end in '\r' '\n' '\r\n'; do
    printf "P,a,note${end}100,1,\"two\nlines\"$end\"1\"2,1,x${end}100,1,x$end" >ends.csv
    run solve -i ends.csv $fixed
    same "lines with ends $end" 5 "$(wc -l <out | tr -d ' ')"
    same "line with ends $end" '"misplaced quotes in the row of line 4: ""1""2,1,x"' "$(sed -n 4p out | sed 's/.*,"m/"m/')"
    same "error of the next row" "" "$(tail -n 1 out | sed 's/.*,//')"
done
{ printf 'P,a\n'; head -c 1200000 /dev/zero | tr '\0' '\n'; printf '100,1\n\n\n"1"2,1\n'; } >blank.csv
run solve -i blank.csv $fixed
same "rows among blank lines" 3 "$(wc -l <out | tr -d ' ')"
same "line after blank lines" '"misplaced quotes in the row of line 1200005: ""1""2,1"' "$(sed -n 3p out | sed 's/.*,"m/"m/')"

# A rigid body in a column needs no Poisson's ratio; an elastic one does, in its row.
printf 'P,a,E2,nu2\n100,1,inf,\n100,1,7e4,\n' >rigid.csv
run solve -i rigid.csv $fixed
same "errors with an empty nu2" "-|nu2: the cell is empty" "$(column error out | paste -s -d '|' -)"
printf 'P,a,E2\n100,1,inf\n100,1,7e4\n' >rigid.csv
run solve -i rigid.csv $fixed
same "errors" ",7e4: needs nu2" "$(sed -n 2p out | sed 's/.*,/,/')$(sed -n 3p out | sed 's/.*E2 \(7e4: needs [-a-z0-9]*\).*/\1/')"

# A quote that is not closed ends the file, with its line: it may have taken rows. So does one that is closed where it cannot be,
# or that makes of several lines no row like the header. Whatever ends the lines; what is solved before is written.
ends_at() { # COUNT MESSAGE: what is in open.csv
    cannot "open.csv: $2" solve -i open.csv $fixed --f 0.1
    same "solved before, and that there may be more" "$1 1" "$(grep -c '1[.]73.*,$' out) $(grep -c 'could not be read beyond' out)"
    cannot "open.csv: $2" solve -i open.csv $fixed --f 0.1 -o kept.csv
    same "the old file" old "$(cat kept.csv)"
}
echo old >kept.csv
printf 'P,a,n\n1,1,x\n"2,1,x\n3,1,x\n\n4,1,x\n' >open.csv
ends_at 1 "line 3: a quote that is not closed"
printf 'P,a,n\r\n1,1,"x\r\n2,1,x\r\n3,1,x\r\n"4",1,x\r\n' >open.csv
ends_at 0 "line 2: a quote that is not closed"
printf 'P,a,n\r1,"1,x\r2,1,x\r3,1,x"\r4,1,"y, z"' >open.csv
ends_at 0 "line 2: a quote over several lines, and too few or too many cells"
awk 'BEGIN { print "P,a,n"; print "1,1,\"x"; for (i = 0; i < 60000; i++) print ",,,,,,,,,,,,,,,,,,,,,"; print "2,1,x" }' >open.csv
ends_at 0 "line 2: a quote that is not closed"

# A header that cannot be right is an error before any row, and before the output is touched.
header() { # MESSAGE HEADER OPTIONS...
    message=$1
    printf '%b\n100,1\n' "$2" >header.csv
    shift 2
    cannot "header.csv: $message" solve -i header.csv "$@" -o kept.csv
    output_is ""
    same "the old file" old "$(cat kept.csv)"
}
columns="; allowed: columns or options"
header "missing: E1, nu1, theta or theta_deg$columns" "P,a"
header "missing: P$columns" "Pmax,a" $fixed
header "column P: there twice; allowed: once" "P,P" $fixed
header "radius (a column): given together with a; allowed: one of the two" "P,a,radius" $fixed
header "theta_deg (a column): given together with --theta; allowed: one of the two" "P,a,theta_deg" $fixed
header "--nu2 0.3: needs E2; allowed: both, or neither for two bodies of one material" "P,a" $fixed --nu2 0.3
header "column 'Yield stress': allowed: yield_stress; --column yield_stress='Yield stress' takes it" "P,a,Yield stress" $fixed
header "column 'e1': allowed: E1; --column E1='e1' takes it" "P,a,e1" $fixed
# What is meant for an input must not pass for a remark: the contact would be solved without it.
header "column 'q': allowed: Q; --column Q='q' takes it" "P;a;q" $fixed --f 0.3 --decimal-comma
header "column 'Shear force in kN': allowed: Q, or another name if it is something else; --column Q='Shear force in kN' takes it" \
    "P,a,Shear force in kN" $fixed --f 0.3
header "column 'K': allowed: k; --column k='K' takes it" "P,a,K" $fixed
# A unit is converted to the working ones, which must be known. "-" is none; blanks around a name are no part of it.
unit() { # UNIT HEADER OPTIONS...
    own=$1
    names=$2
    shift 2
    header "column '${names##*[,;]}': has the unit '$own', and no working units are known: --units, such as --units mm,N,MPa, converts it" \
        "$names" "$@"
}
unit N/mm "P;a;Q [N/mm]" $fixed --f 0.3 --decimal-comma
unit N/mm "P;a;Q(N/mm)" $fixed --f 0.3 --decimal-comma
for name in Q/N "Q in N" Q_N "Q N"; do
    unit N "P;a;$name" $fixed --f 0.3 --decimal-comma
done
unit % "P;a;Q%" $fixed --f 0.3 --decimal-comma
unit N.mm-1 "P;a;Q N·mm⁻¹" $fixed --f 0.3 --decimal-comma
unit N 'sep=;\nP;a;Q N' $fixed --f 0.3
unit deg "P,a,theta in deg" --E1 1 --nu1 0
unit deg "P,a,theta (deg)" --E1 1 --nu1 0
for name in " f" "f [-]" "f "; do
    printf 'P,a,%s\n100,1,0.3\n' "$name" >named.csv
    does_quietly solve -i named.csv $fixed --Q 30
    same "friction in '$name'" 1 "$(column Q_over_fP out)"
done
synonym() { # ALLOWED HEADER OPTIONS...
    allowed=$1
    names=$2
    shift 2
    header "column '${names##*,}': allowed: $allowed, or another name if it is something else; \
--column $allowed='${names##*,}' takes it" "$names" "$@"
}
for name in mu friction friction_coefficient "mu [-]" μ "μ [-]"; do
    synonym f "P,a,$name" $fixed
done
for name in sigma_y yield "Sigma_Y [MPa]" σy Sy "Rp0.2 [MPa]" Re; do
    synonym yield_stress "P,a,$name" $fixed
done
synonym P "a,load" $fixed
synonym Q "P,a,shear force" $fixed
synonym nu1 "P,a,ν" --E1 1 --theta 0.05
synonym nu2 "P,a,E2,ν2" $fixed
synonym radius "P,R" $fixed
# Where what they may mean is given, they are columns like any other.
printf 'P,a,p,q,mu,load,sigma_y,E,nu,K,f,Q\n100,1,x,x,x,x,x,x,x,x,0.3,20\n' >others.csv
does_quietly solve -i others.csv $fixed --yield-stress 900
same "columns that pass through" "100,1,x,x,x,x,x,x,x,x,0.3,20" "$(sed -n 2p out | cut -d , -f 1-12)"
# But for numbers, which are named: they may be meant for something. What labels a row is not.
printf 'P,a,μ,ν1,case,note\n100,1,0.5,0.33,x,0.5 x\n100,1,,,7,\n' >others.csv
does solve -i others.csv $fixed --f 0.05
message_is "rwedge solve: others.csv: columns with numbers that are not used: 'μ', 'ν1'"
same "said once, not in the rows" 0 "$(grep -c 'not used' out)"
printf 'P,a,Zeit,Test,N_f,Nf [cycles]\n100,1,1,2,3e5,4\n' >others.csv
does_quietly solve -i others.csv $fixed --f 0.05
# A quotient, a count, a result and a second column beside an input's own are no inputs with a unit.
printf 'P,Q,a,f,Q/P,P_2,a/c,Q [kN],N\n100,10,1,0.3,x,x,x,x,x\n' >others.csv
run solve -i others.csv $fixed
message_is ""
# What may be a force is no time, and percent and a decimal comma are numbers where nothing reads them.
printf 'P;a;T;share;width;t\n100;1;300;40%%;40,5;1\n' >others.csv
run solve -i others.csv $fixed --decimal-comma
message_is "rwedge solve: others.csv: columns with numbers that are not used: 'T', 'share', 'width'"
printf 'P,a,F,mu\n100,1,x,x\n' >others.csv
does_quietly solve -i others.csv $fixed --f 0.3
header "column b: a result has that name; allowed: any other" "P,a,b" $fixed
header "misplaced quotes in the first row; needed: a header row with the names of the columns" 'P,"a"b' $fixed
header "missing: a or radius, P; allowed: columns or options; the columns seem to be separated by ';': $semicolons" \
    "P;a" $fixed
header "missing: a or radius, P; allowed: columns or options; the columns seem to be separated by ',': leave out --decimal-comma, and blanks within numbers" \
    "P,a" $fixed --decimal-comma
refuses "--P 5: plain.csv has a column for it; allowed: one of the two" solve -i plain.csv $fixed --P 5
refuses "--layout list: a file has a row for each contact; allowed with --input: row" solve -i plain.csv --layout list
: >empty.csv
cannot "empty.csv: empty; needed: a header row with the names of the columns" solve -i empty.csv $fixed
cannot "nowhere.csv: No such file or directory" solve -i nowhere.csv $fixed
cannot ".: Is a directory" solve -i . $fixed
prints "$(head -n 1 plain_solved)" solve -i - $fixed <<'ROWS'
note,P,a
ROWS

# What is no CSV: binary, endless, too wide. The message names the line, the old file stays.
hopeless() { # MESSAGE: what is in the file "input"
    cannot "standard input: $1" solve -i - $fixed -o kept.csv <input
    same "the old file" old "$(cat kept.csv)"
}
printf 'P,a\n100,1\n\000\001\002\n' >input
hopeless "line 3, column 1: the character U+0000 belongs to no text; allowed: text, no binary files"
{ printf 'P,a\n100,1\n'; head -c 2000 /dev/zero | tr '\0' ,; } >input
hopeless "line 3: more than 1000 cells in a row"
if command -v timeout >/dev/null; then
    shell '{ printf "P,a\n100,1\n"; tr "\0" 9 </dev/zero; } 2>/dev/null | timeout 60 "$rwedge" solve -i - $fixed'
    ended 1 "rwedge solve: standard input: line 3: a line of more than 1 MiB; allowed: CSV"
    same "on standard output, the rows before it, and that there may be more" 3 "$(wc -l <out | tr -d ' ')"
fi

# Many rows in little memory (an address sanitizer reserves more than any limit, and takes its time).
memory_of 65536
[ $limit != unlimited ] || rows=1000
awk -v rows=$rows 'BEGIN { srand(7); print "case,theta,a,P,Q,f,k"
    for (i = 1; i <= rows; i++) printf "%d,%.4g,%.4g,%.5g,%.3g,%.3g,300\n", i, 0.005 + 0.09 * rand(), 2 * rand(),
        10 + 300 * rand(), 0.5 * rand(), 0.05 + rand() / 2 }' >many.csv
started=$(date +%s)
shell '(ulimit -v $limit; "$rwedge" solve -i many.csv --E1 210000 --nu1 0.3 -o many_solved.csv)'
echo "$rows rows in $(($(date +%s) - started)) s"
ended 0 "rwedge solve: many.csv, in some rows: P is above P_yield: the contact yields in full sliding
rwedge solve: many.csv, in some rows: a/b is below 0.01 or above 10000: are the units consistent?"
same "rows" "$((rows + 1))" "$(wc -l <many_solved.csv | tr -d ' ')"
same "last case" "$rows" "$(tail -n 1 many_solved.csv | cut -d , -f 1)"
same "rows without an error" "$rows" "$(grep -c ',$' many_solved.csv)"

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# Texts that come in: encodings, files as spreadsheets write them, and what no text may hold. Whatever the format of the output, a
# text that is not UTF-8 is refused where it is read, and nothing that XML cannot hold gets into a spreadsheet.
. "$(dirname "$0")/../claims.sh"

fixed="--theta 0.01 --E1 2e5 --nu1 0.3"
solved() { # FILE OPTIONS...: the first columns and the error of each row
    file=$1
    shift
    does solve -i "$file" $fixed "$@"
    cut -d , -f 1-"${columns:-4}" out
}
utf8="case,a,P,f
Prüfling 1,2,2000,0.3
größer,1,100,0.1"
printf '%s\n' "$utf8" >utf8.csv

# What is not UTF-8 is refused, with its place, in every format, and before anything is written.
printf 'case,a,P,f\nPr\374fling 1,2,2000,0.3\n' >latin.csv
refused="the byte FC is not UTF-8; allowed: UTF-8, UTF-16 with its mark, or --encoding, such as windows-1252"
cannot "latin.csv: line 2, column 3: $refused" solve -i latin.csv $fixed -o solved.csv
same "no file" "" "$(ls solved.csv 2>/dev/null)"
cannot "latin.csv: line 2, column 3: $refused" solve -i latin.csv $fixed
# A file is read as it is solved. What went to standard output before stays, and its last row tells; a file is not written.
awk 'BEGIN { print "note,a,P,f"; for (i = 0; i < 2000; i++) printf "%0100d,1,100,0.1\n", 0; print "1,1,100,0.1,\374" }' >late.csv
cannot "late.csv: line 2002, column 13: $refused" solve -i late.csv $fixed --format json
same "ends of the JSON" '[|"error": null}|"error": "the file could not be read beyond this row"}|]' \
    "$(sed 's/.* \("error".*}\),*/\1/' out | uniq | paste -s -d '|' -)"
same "rows before it" yes "$([ "$(wc -l <out)" -gt 1000 ] && echo yes)"
# Other encodings are read as UTF-8.
if command -v iconv >/dev/null && echo ü | iconv -f UTF-8 -t WINDOWS-1252 >/dev/null 2>&1; then
    for encoding in windows-1252 utf-16le iso-8859-1; do
        iconv -f UTF-8 -t "$encoding" utf8.csv >other.csv
        same "$encoding" "$utf8" "$(solved other.csv --encoding $encoding)"
    done
    same "from standard input" "$(iconv -f UTF-8 -t WINDOWS-1252 utf8.csv | "$rwedge" solve -i - $fixed --encoding CP1252)" \
        "$("$rwedge" solve -i utf8.csv $fixed)"
    # UTF-16 says so itself, in both orders of its bytes; the result has the mark of UTF-8.
    for encoding in utf-16le utf-16be; do
        { printf '\357\273\277'; cat utf8.csv; } | iconv -f UTF-8 -t $encoding >marked.csv
        for option in "" "--encoding utf-16" "--encoding $encoding"; do
            same "$encoding with its mark, $option" "$(printf '\357\273\277')$utf8" "$(solved marked.csv $option)"
        done
    done
    # A character may be cut where the file is read in pieces.
    note=$(printf 'é€𝄞%.0s' $(seq 50))
    awk -v note="$note" 'BEGIN { print "note,a,P,f"; for (i = 0; i < 1500; i++) print note ",1,100,0.1" }' >long.csv
    iconv -f UTF-8 -t UTF-16 long.csv >long16.csv
    does solve -i long16.csv $fixed
    same "rows" 1501 "$(wc -l <out | tr -d ' ')"
    run solve -i long.csv $fixed
    same "rows" 1500 "$(grep -c "^$note,1,100,0.1," out)"
fi
refuses "--encoding klingon: unknown encoding; allowed: utf-8, utf-16, windows-1252, and others that iconv knows" \
    solve -i utf8.csv $fixed --encoding klingon
printf 'PK\003\004\024\000' >book.xlsx
cannot "book.xlsx: a spreadsheet, or another archive; allowed: text: save it as CSV" solve -i book.xlsx $fixed
printf 'P|Q\n1|0\n' >bars.csv
cannot "bars.csv: column P: missing; a history needs P and Q; the columns seem to be separated by '|': a first line \"sep=|\" says so; the \
names there: 'P|Q'; --column NAME='THEIR NAME' takes one" history bars.csv $fixed --a 1 --f 0.1
refuses "--encoding utf-8: needs --input, --history or --profile" solve --encoding utf-8
# A profile has an encoding too, and whatever is read, an unknown one is a mistake on the command line.
printf '\303\234ber,x,height\n,-1,0.1\n,0,0\n,1,0.1\n' | iconv -f UTF-8 -t WINDOWS-1252 >profile.csv
does solve --E1 2e5 --nu1 0.3 --P 1 --profile profile.csv --encoding windows-1252
printf 'P,Q,displacement\n1,0,0\n1,0.1,0.1\n' >log.csv
for call in "solve --P 1 --profile profile.csv" "loop log.csv --radius 10" "history log.csv --radius 10 --f 0.3 --points profile.csv"; do
    refuses "--encoding klingon: unknown encoding; allowed: utf-8, utf-16, windows-1252, and others that iconv knows" \
        $call --E1 2e5 --nu1 0.3 --encoding klingon
done
printf '\357\273\277a,P,f\n1,100,0.1\n' >marked.csv
cannot "--encoding windows-1252: marked.csv begins with the mark of UTF-8; allowed: utf-8" \
    solve -i marked.csv $fixed --encoding windows-1252

# No text at all: a cut character, a surrogate, a long form, a code beyond Unicode, a control character.
for bytes in '\303' '\355\240\200' '\300\200' '\364\220\200\200' '\200'; do
    printf "a,P,f,note\n1,100,0.1,é$bytes\n" >none.csv
    cannot "none.csv: line 2, column 12: the byte $(printf "$bytes" | head -c 1 | od -An -tx1 | tr -d ' \n' | tr a-f A-F) is${refused#*is}" \
        solve -i none.csv $fixed --format json
done
printf 'a,P,f,note\n1,100,0.1,\001\n' >none.csv
cannot "none.csv: line 2, column 11: the character U+0001 belongs to no text; allowed: text, no binary files" solve -i none.csv $fixed
printf 'a,P,f,note\n1,100,0.1,"tab\there, a return\r\nand \360\235\204\236"\n' >fine.csv
does solve -i fine.csv $fixed --format json

# As spreadsheets write them: "sep=;", tabs, rows of empty cells; what is a number stays one.
rows='case;a;P;f
007;2;2000;0.3
;;;
8;1;100;0.1'
wanted="case,a,P,f
007,2,2000,0.3
8,1,100,0.1"
for first in 'sep=;' 'SEP=;\r'; do
    { printf "$first\n"; echo "$rows"; } >sep.csv
    same "$first" "$wanted" "$(solved sep.csv)"
done
{ echo 'sep=;'; echo "$rows" | tr . ,; } >sep.csv
run solve -i sep.csv $fixed --decimal-comma
same "sep and a decimal comma" '007;2;2000;0,3' "$(sed -n 2p out | cut -d ';' -f 1-4)"
echo "$rows" | tr ';' "$tab" >tabs.txt
same "tabs" "$wanted" "$(solved tabs.txt)"
echo "$rows" | tr ';' "$tab" | sed 's/case/case, or none/' >tabs.tsv
columns=5
same "tabs, by the ending" '"case, or none",a,P,f' "$(solved tabs.tsv | sed -n 1p)"
columns=
echo "$rows" | tr ';' "$tab" | tr . , >tabs.txt
run solve -i tabs.txt $fixed --decimal-comma
same "tabs and a decimal comma" '007;2;2000;0,3' "$(sed -n 2p out | cut -d ';' -f 1-4)"
{ echo 'sep=;'; echo 'P;Q'; echo '100;10'; echo ';'; } >history.csv
does profile $fixed --a 1 --f 0.3 --history history.csv --x 0
echo "$rows" | tr ';' , | sed 's/100,/1e2,/' >numbers.csv
run solve -i numbers.csv $fixed --format json --digits 2
same "numbers in JSON, with all their digits" '{"case": "007", "a": 2, "P": 2000, "f": 0.3,|{"case": 8, "a": 1, "P": 100, "f": 0.1,' \
    "$(sed -n 2,3p out | cut -d ' ' -f 1-8 | paste -s -d '|' -)"
printf 'a,P,f,n\n1,100,0.1234,+49\n1,100,0.1234,12345678901234567890\n1,100,0.1234,-0.5\n1,100,0.1234,1e-05\n' >numbers.csv
for label in 0.10 1E5 1e5 .5 5. -0; do
    printf '1,100,0.1234,%s\n' $label >>numbers.csv
done
run solve -i numbers.csv $fixed --format json --digits 2
same "what a number would not keep" \
    '"+49" "12345678901234567890" -0.5 1e-05 "0.10" "1E5" "1e5" ".5" "5." "-0"' \
    "$(sed -n 's/.*"n": \([^,]*\).*/\1/p' out | paste -s -d ' ' -)"
same "with all its digits" 10 "$(grep -c '"f": 0.1234,' out)"
printf 'P,Q\n0.10,0\n' | "$rwedge" history - $fixed --a 1 --f 0.3 --format json >out
same "a load is a number as it is" 1 "$(grep -c '"P": 0.1,' out)"
printf 'P,Q,label\n100,0,0.10\n' | "$rwedge" history - $fixed --a 1 --f 0.3 --format json >out
same "and a label a text" 1 "$(grep -c '"label": "0.10",' out)"

# A text that a spreadsheet would compute gets a ' in front, if that is wished for. Numbers are not texts.
printf 'a,P,f,=n,x\n1,100,0.1,=1+1,x\n1,100,0.1,"@a,b",x\n1,100,0.1,-5,x\n1,100,0.1,+49,x\n1,100,0.1,-x,x\n1,100,0.1,＝1+1,x\n1,100,0.1,＠a,x\n' >formulas.csv
run solve -i formulas.csv $fixed
same "as they are" "$(cat formulas.csv)" "$(sed 's/,A,dundurs.*//; s/,1.82.*//' out)"
same "guarded" "a,P,f,'=n|1,100,0.1,'=1+1|1,100,0.1,\"'@a|1,100,0.1,-5|1,100,0.1,+49|1,100,0.1,'-x|1,100,0.1,'＝1+1|1,100,0.1,'＠a" \
    "$(solved formulas.csv --no-formulas | paste -s -d '|' -)"
columns=
printf 'P,Q,=n\n100,10,=1+1\n100,-10,-5\n' >formulas.csv
run history formulas.csv $fixed --a 1 --f 0.3 --no-formulas
same "guarded in a history" "'=n|'=1+1|-5" "$(cut -d , -f 1 out | paste -s -d '|' -)"

# Names that are there twice get a number in JSON: its readers take the last of equal ones.
printf 'note,P,a,f,note,,,note_2\nx,100,1,0.1,y,z,w,v\n' >twice.csv
run solve -i twice.csv $fixed --format json
message_is "rwedge solve: column 'note': there again; in JSON it is 'note_2'
rwedge solve: column '': there again; in JSON it is '_2'
rwedge solve: column 'note_2': there again; in JSON it is 'note_2_2'"
same "every cell has a key" '"note": "x" "note_2": "y" "": "z" "_2": "w" "note_2_2": "v"' \
    "$(grep -o '"[a-z_2]*": "[v-z]"' out | paste -s -d ' ' -)"
run solve -i twice.csv $fixed
same "in CSV they stay" "note,P,a,f,note,,,note_2" "$(head -n 1 out | cut -d , -f 1-8)"

# Messages: neither control characters of two bytes, nor marks of direction, nor broken characters reach the terminal.
for bytes in '\302\233' '\342\200\256' '\033' '\377'; do
    refuses "x?y: unknown table; allowed: elastic-limit, max-tension, contact-law, critical-friction, stick-zone, shakedown-limit" \
        table "$(printf "x${bytes}y")"
done

# A spreadsheet's command is cut in whole characters; its date, which SOURCE_DATE_EPOCH gives, ends with the year 9999.
run table contact-law -o probe.xlsx
[ "$status" -eq 0 ] || finish
command -v python3 >/dev/null 2>&1 || { echo "SKIPPED: what is in the spreadsheets, for lack of python3"; finish; }
SOURCE_DATE_EPOCH=253402300799
export SOURCE_DATE_EPOCH
bad=$(printf 'Pr\374fung\001.xlsx')
list=$(awk 'BEGIN { for (i = 0; i < 461; i++) printf "0,"; print 0 }')
does table contact-law --a-over-b "$list" -o "$bad"
does table contact-law -o "$bad"
same "command and date" "with the command:  rwedge table contact-law -o 'Pr�fung�.xlsx'|9999-12-31T23:59:59Z" "$(python3 -c '
import sys, zipfile
archive = zipfile.ZipFile(sys.argv[1])
text = "".join(archive.read(name).decode() for name in archive.namelist() if "sheet" in name)
date = archive.read("docProps/core.xml").decode().split("</dcterms:created>")[0].split(">")[-1]
print(text[text.index("with the command:"):].split("<")[0], date, sep="|")' "$bad" 2>&1)"
for SOURCE_DATE_EPOCH in 253402300800 -1 now; do
    cannot "new.xlsx: the variable SOURCE_DATE_EPOCH: must be a whole number of seconds, 0 to \
253402300799, the end of the year 9999" table contact-law -o new.xlsx
    same "no file" "" "$(ls new.xlsx 2>/dev/null)"
done

finish

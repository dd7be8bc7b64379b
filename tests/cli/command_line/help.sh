# SPDX-License-Identifier: GPL-3.0-or-later
# --help and --version: on stdout, status 0, and complete.
. "$(dirname "$0")/../claims.sh"

says() { # each text is in the output
    status_is 0
    message_is ""
    for text; do
        same "help has '$text'" 1 "$(grep -c -m 1 -e "$text" out)"
    done
}

run --version
says '^rwedge [0-9]*\.[0-9]*\.[0-9]*$'
same "lines of --version" 1 "$(wc -l <out | tr -d ' ')"
run -V
says '^rwedge '

run --help
says 'Usage: rwedge COMMAND' 'table' 'Exit status' '--version'
run -h
says 'Usage: rwedge COMMAND'

run help
cp out whole
says 'Usage: rwedge COMMAND'
run --help
same "help without a command" "" "$(diff whole out)"
for command in solve table profile field history fretting figure workbook; do
    run $command --help
    cp out whole
    does help $command
    same "help of a command" "" "$(diff whole out)"
done

run table --help
says 'Usage: rwedge table TABLE' 'a-over-b' 'friction' '--nu' 'q-over-fp' 'layout' 'quantity' 'format' 'digits' \
    'decimal-comma' '-o, --output' '-q, --quiet' 'elastic-limit' 'max-tension' 'contact-law' 'critical-friction' \
    'stick-zone' '0.1:1:0.1' '0:0.8:0.0125' 'P_over_bk_subsurface'
cp out help
same "lines over 80 columns" 0 "$(awk 'length > 80' help | wc -l | tr -d ' ')"

run solve --help
says 'Usage: rwedge solve' '--E1' '--yield-stress' '--input' 'P_yield' 'consistent units'
run profile --help
says 'Usage: rwedge profile' '--history' '--load' '--c-over-b' 'zone'
run field --help
says 'Usage: rwedge field' 'csv|tsv|json|xlsx|vtk' 'von_mises' 'depth'
for command in solve profile field history fretting; do
    called="rwedge $command --help"
    same "lines over 81 columns" 0 "$("$rwedge" $command --help | awk 'length > 81' | wc -l | tr -d ' ')"
done

# Help wins wherever it stands, and nothing is computed.
run table elastic-limit --help
same "help" "" "$(diff help out)"
run table -h elastic-limit --friction 0.1
same "help" "" "$(diff help out)"

# Options may stand on either side of the table's name, wherever the environment would have them.
called="POSIXLY_CORRECT=1 rwedge table contact-law --a-over-b 1"
same "columns" 5 "$(POSIXLY_CORRECT=1 "$rwedge" table contact-law --a-over-b 1 | head -n 1 | tr , '\n' | wc -l | tr -d ' ')"
called="rwedge table --a-over-b 1 contact-law"
same "columns" 5 "$("$rwedge" table --a-over-b 1 contact-law | head -n 1 | tr , '\n' | wc -l | tr -d ' ')"

# Help that cannot be written is an error.
if [ -c /dev/full ]; then
    for words in --help --version "table --help"; do
        called="rwedge $words >/dev/full"
        status=0
        "$rwedge" $words >/dev/full 2>"$scratch/err" || status=$?
        status_is 1
        message_has "standard output: No space left on device"
    done
fi

# Every command, option, table and column is described in the README; the columns of tables in that of tables/.
readme=$here/../../../cli/README.md
called="rwedge table --help"
for word in $(grep -o -e '--[a-z][a-z-]*' help | sort -u) \
    $(sed -n '/^Tables/,$ { s/^    columns: //p; s/^             //p; }' help) \
    elastic-limit max-tension contact-law critical-friction stick-zone; do
    same "README has $word" yes "$(grep -q -e "$word" "$readme" "$here/../../../tables/README.md" && echo yes)"
done

for command in solve profile field history fretting; do
    called="rwedge $command --help"
    "$rwedge" $command --help >out
    columns=$(sed -n '/^Results/,/^$/p; /^Columns/,/^$/p' out | # a line: "  x, y  the point"
        sed -n 's/^  \([A-Za-z_0-9]*\(, [A-Za-z_0-9]*\)*\) .*/\1/p' | tr -d ,)
    same "help without columns" "" "$([ "$columns" ] || echo "$command")"
    for word in $(grep -o -e '--[a-zA-Z][a-zA-Z0-9-]*' out | sort -u) $columns; do
        same "README has $word" 1 "$(grep -c -m 1 -e "\`$word[ \`]" -e "^$word," "$readme")"
    done
done

finish

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

kept whole help
says 'Usage: rwedge COMMAND' 'table' 'Exit status' '--version'
for option in --help -h; do
    prints_kept "help without a command" whole $option
done
for command in $(sed -n '/^Commands/,/^$/s/^  \([a-z]*\) .*/\1/p' whole | grep -vx help); do
    kept whole $command --help
    says "Usage: rwedge $command"
    same "lines over 81 columns" 0 "$(awk 'length > 81' out | wc -l | tr -d ' ')"
    prints_kept "help of a command" whole help $command
done
"$rwedge" table --help >help

# Help wins wherever it stands, and nothing is computed.
prints_kept "help" help table elastic-limit --help
prints_kept "help" help table -h elastic-limit --friction 0.1

# Options may stand on either side of the table's name, wherever the environment would have them.
shell 'POSIXLY_CORRECT=1 "$rwedge" table contact-law --a-over-b 1'
same "columns" 5 "$(head -n 1 out | tr , '\n' | wc -l | tr -d ' ')"
does_quietly table --a-over-b 1 contact-law

# Help that cannot be written is an error.
if [ -c /dev/full ]; then
    shell '"$rwedge" --help >/dev/full'
    status_is 1
    message_has "standard output: No space left on device"
fi

# Every command, option, table, figure and column is described in the README; the columns of tables in that of tables/.
readme=$here/../../../cli/README.md
called="rwedge table --help"
for word in $(grep -o -e '--[a-z][a-z-]*' help | sort -u) \
    $(sed -n '/^Tables/,$ { s/^    columns: //p; s/^             //p; }' help) \
    elastic-limit max-tension contact-law critical-friction stick-zone; do
    same "README has $word" yes "$(grep -q -e "$word" "$readme" "$here/../../../tables/README.md" && echo yes)"
done

for command in solve profile field history fretting crack figure; do
    called="rwedge $command --help"
    "$rwedge" $command --help >out
    columns=$(sed -n '/^Results/,/^$/p; /^Columns/,/^$/p; /^Figures/,/^$/p' out | # a line: "  x, y  the point"
        sed -n 's/^  \([A-Za-z_0-9]*\(, [A-Za-z_0-9]*\)*\) .*/\1/p' | tr -d ,)
    same "help without columns" "" "$([ "$columns" ] || echo "$command")"
    for word in $(grep -o -e '--[a-zA-Z][a-zA-Z0-9-]*' out | sort -u) $columns; do
        same "README has $word" 1 "$(grep -c -m 1 -e "\`$word[ \`]" -e "^$word," "$readme")"
    done
done

finish

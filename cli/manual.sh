#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The man page, from what the tool says of itself: its help and that of every command.
#     manual.sh TOOL DATE
set -eu
tool=$1 date=$2
# section TITLE AFTER-USAGE COMMAND... - the help that the command prints, as roff: options and columns are items, lines that end in :
# are headings
section()
{
    echo ".SH $1"
    after_usage=$2
    shift 2
    "$@" | awk -v after_usage="$after_usage" '
        function roff(text) { gsub(/\\/, "\\e", text); gsub(/-/, "\\-", text); sub(/^[.\047]/, "\\\\\\&&", text); return text }
        /^Usage: / { print ".B " roff(substr($0, 8)); if (after_usage) print after_usage; between = 1; next }
        /^$/ { between = 1; next }
        /^[^ ].*:$/ { print ".SS " roff(substr($0, 1, length($0) - 1)); between = 0; next }
        /^  [^ ]/ || /^      [^ ].*  / { # a name, perhaps as wide as its column, and its meaning
            sub(/^ +/, "")
            at = match($0, /  /) ? RSTART : index($0, " ")
            print ".TP\n.B " roff(substr($0, 1, at - 1))
            $0 = substr($0, at)
        }
        /^ / { sub(/^ +/, ""); print roff($0); between = 0; next }
        { if (between) print ".PP"; between = 0; print roff($0) }'
}
echo '.\" SPDX-License-Identifier: GPL-3.0-or-later'
echo ".TH RWEDGE 1 $date \"$("$tool" --version | head -n 1)\" \"User Commands\""
printf '.SH NAME\nrwedge \\- contact of a wedge with a rounded apex and a half-plane\n'
section SYNOPSIS '.SH DESCRIPTION' "$tool" --help
for command in $("$tool" --help | sed -n '/^Commands/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
    [ "$command" = help ] || section "$(echo "RWEDGE $command" | tr a-z A-Z)" '' "$tool" "$command" --help
done
cat <<'END'
.SH SEE ALSO
The README of the command-line tool describes every column, with examples.
.PP
M. Ciavarella, D. A. Hills, G. Monno, Contact problems for a wedge with rounded apex,
Int. J. Mech. Sci. 40 (1998) 977\(en988.
END

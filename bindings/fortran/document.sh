#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Gives every procedure of rwedge.f90 the comment that rwedge.h has for it, as !> lines, and prints the result: the text is
# written once, in the header, and the test holds the two together.    document.sh HEADER FORTRAN
set -eu
awk -v width=121 '
function indentation(line) { match(line, /^ */); return substr(line, 1, RLENGTH) }

# The source of a formula is set off to the right in the header; here it follows.
function with_source_near(line)
{
    if (!match(line, /    +(Eq\.|Sec\.|Figs?\.|new$)/)) return line
    text = substr(line, 1, RSTART - 1)
    line = substr(line, RSTART)
    sub(/^ +/, "", line)
    return text == "" ? line : text "   " line
}

# What does not fit into a line goes to the next one where that is as far in.
function print_comment(comment,    lines, n, i, line, lead, rest, end)
{
    n = split(comment, lines, "\n")
    for (i = 1; i <= n || rest != ""; i++) {
        line = with_source_near(i <= n ? lines[i] : "")
        if (rest != "") {
            if (i <= n && indentation(line) == lead) line = lead rest " " substr(line, length(lead) + 1)
            else { print "    !> " lead rest; if (i > n) break }
            rest = ""
        }
        lead = indentation(line)
        if (length(line) > width) {
            for (end = width + 1; substr(line, end, 1) != " "; end--)
                ;
            rest = substr(line, end + 1)
            line = substr(line, 1, end - 1)
        }
        print "    !> " line
    }
}

FNR == NR {
    if (/^\/\* /) { comment = ""; inside = 1 }
    if (inside) {
        line = $0
        sub(/^(\/\*| \*) ?/, "", line)
        sub(/ *\*\/$/, "", line)
        comment = comment (comment == "" ? "" : "\n") line
        if (/\*\/$/) inside = 0
    }
    if (/^RWEDGE_API/ && match($0, /rwedge_[a-z_0-9]*\(/)) comment_of[substr($0, RSTART, RLENGTH - 1)] = comment
    if (/^$/) comment = ""
    next
}

/^    !>/ { held = held $0 "\n"; next }

{
    name = ""
    if (/^    [a-z ]*(function|subroutine) / && match($0, /[a-z_]*\(/)) name = substr($0, RSTART, RLENGTH - 1)
    if (name ~ /^(contact|series)_/) name = "rwedge_" name
    if (name in comment_of) print_comment(comment_of[name]); else printf "%s", held
    held = ""
    print
}' "$1" "$2"

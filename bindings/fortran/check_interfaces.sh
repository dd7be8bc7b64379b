#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The interfaces of rwedge.f90 are those of rwedge.h: every function, its result, and each argument's name, type and how it is
# passed. And so are the values of the status codes.    check_interfaces.sh HEADER FORTRAN
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What a C declaration is in Fortran, one function a line: NAME RESULT ARGUMENT:TYPE ...
sed 's|/\*.*\*/||' "$1" | awk '
function type(c)
{
    if (c ~ /double/) return "real(c_double)"
    if (c ~ /int32_t/) return "integer(c_int32_t)"
    if (c ~ /size_t/) return "integer(c_size_t)"
    return c ~ /\*/ ? "type(c_ptr)" : "void"
}
function argument(c,    name, passed)
{
    match(c, /[A-Za-z_0-9]+(\[\])?$/)
    name = substr(c, RSTART)
    if (c ~ /rwedge_.*\*\*/) passed = ",intent(out)"
    else if (c ~ /rwedge_.*\*/) passed = ",value"
    else if (c ~ /^const.*\[\]/) passed = ",intent(in)"
    else if (c ~ /\[\]|\*/) passed = ",intent(inout)"
    else passed = ",value"
    sub(/\[\]/, "(*)", name)
    if (name == "A") name = "compliance"        # Fortran takes a and A for one name
    return " " name ":" type(substr(c, 1, RSTART - 1)) passed
}
/^RWEDGE_API/ { line = "" ; inside = 1 }
inside { line = line " " $0 }
inside && /;/ {
    inside = 0
    sub(/^ *RWEDGE_API /, "", line); sub(/\).*/, "", line); gsub(/  +/, " ", line)
    open = index(line, "(")
    head = substr(line, 1, open - 1)
    match(head, /rwedge_[a-z_0-9]*$/)
    all = substr(head, RSTART) " " type(substr(head, 1, RSTART - 1))
    n = split(substr(line, open + 1), arguments, / *, */)
    for (i = 1; i <= n; i++)
        if (arguments[i] != "void") all = all argument(arguments[i])
    print all
}' | sort >"$work/header"

awk '
/^    interface/ { inside = 1 }
/^    end interface/ { inside = 0 }
!inside { next }
/&$/ { held = held substr($0, 1, length($0) - 1); next }
{ line = held $0; held = ""; gsub(/&/, "", line) }
line ~ /bind\(C/ {
    match(line, /name="[a-z_0-9]*"/)
    name = substr(line, RSTART + 6, RLENGTH - 7)
    match(line, /(function|subroutine) [a-z_0-9]*\([^)]*\)/)
    call = substr(line, RSTART, RLENGTH)
    is_function = call ~ /^function/
    sub(/^[^(]*\(/, "", call); sub(/\)$/, "", call)
    n = split(call, arguments, / *, */)
    match(line, /result\([a-z]*\)/)
    result = is_function ? substr(line, RSTART + 7, RLENGTH - 8) : ""
    split("", declared)
}
line ~ /::/ && line !~ /import/ {
    split(line, part, / *:: */)
    gsub(/ /, "", part[1])
    m = split(part[2], names, / *, */)
    for (i = 1; i <= m; i++) { bare = names[i]; sub(/\(\*\)/, "", bare); declared[bare] = names[i] ":" part[1] }
}
line ~ /end (function|subroutine)/ && name != "strlen" {
    of_result = is_function ? declared[result] : ":void"
    sub(/.*:/, "", of_result)
    all = name " " of_result
    for (i = 1; i <= n; i++) all = all " " declared[arguments[i]]
    print all
}' "$2" | sort >"$work/fortran"

sed -n 's/^ *\(RWEDGE_[A-Z]*\) = \([0-9]*\).*/\1 = \2/p' "$1" | tr '[:upper:]' '[:lower:]' | sort >>"$work/header"
sed -n '/parameter, public/,/[0-9]$/p' "$2" | grep -o 'rwedge_[a-z]* = [0-9]*' | sort >>"$work/fortran"

[ "$(wc -l <"$work/header")" -gt 40 ] || { echo "FAILED: no declarations found in $1"; exit 1; }
if ! diff "$work/header" "$work/fortran"; then
    echo "FAILED: < as the header declares, > as Fortran does"
    exit 1
fi
echo "$(grep -vc ' = ' "$work/header") functions and $(grep -c ' = ' "$work/header") status codes declared as in the header"

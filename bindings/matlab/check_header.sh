#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge.h keeps to the C that MATLAB's loadlibrary and clib both take, by MathWorks' pages "Limitations to Shared Library
# Support", "Pass Arguments to Shared C Library Functions" and "Limitations to C/C++ Support". What is allowed is listed, and
# all else refused: opaque structs, one enum of status codes, and functions
#     of    double, int32_t, size_t, and pointers and arrays of double; [const] OPAQUE *; OPAQUE ** (a lib.pointer for
#           loadlibrary; for clib only as a parameter, and of a class: these functions are named, see README.md)
#     to    double, int32_t, size_t, const char *, or nothing.
# That leaves out callbacks, variadic functions, struct, union, complex and long double, bit-fields, other unsigned types, and
# macros with arguments.    check_header.sh HEADER
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Declarations of this header alone, one a line.
cc -E "$1" | awk -v header="$1" '
/^# [0-9]+ "/ { ours = index($0, " \"" header "\"") > 0; next }
ours' | tr '\n' ' ' | sed 's/;/;\n/g' | awk '
{
    gsub(/__attribute__ *\(\( *visibility *\("default"\) *\)\)/, "")
    gsub(/[ \t]+/, " "); sub(/^ /, ""); sub(/ $/, "")
}
$0 != ""' >"$work/declarations"

awk '
function refuse(why) { print "REFUSED: " why ": " $0; refused++ }

function is_opaque(type) { return type in opaque }

# "" or what is wrong with a parameter
function fault(c,    type)
{
    if (c ~ /^(double|int32_t|size_t) [A-Za-z_0-9]+$/ || c ~ /^(const )?double (\*[A-Za-z_0-9]+|[A-Za-z_0-9]+\[\])$/) return ""
    type = c
    sub(/^const /, "", type); sub(/ .*/, "", type)
    if (is_opaque(type) && c ~ /^(const )?[a-z_]+ \*[A-Za-z_0-9]+$/) return ""
    if (is_opaque(type) && c ~ /^[a-z_]+ \*\*[A-Za-z_0-9]+$/) { handles = 1; return "" }
    return "parameter \"" c "\""
}

/^typedef struct [a-z_]+ [a-z_]+;$/ && $3 ";" == $4 { opaque[$3] = 1; next }
/^enum \{[A-Z_0-9=, ]*\} ?;$/ { next }
/^(double|int32_t|size_t|void|const char \*) ?rwedge_[a-zA-Z_0-9]+\([^()]*\);$/ {
    functions++
    name = $0
    sub(/\(.*/, "", name); sub(/.*[ *]/, "", name)
    list = $0
    sub(/^[^(]*\(/, "", list); sub(/\);$/, "", list)
    if (list == "void") next
    if (list == "") { refuse("no parameters, which is not void"); next }
    n = split(list, parameters, / *, */)
    handles = 0
    for (i = 1; i <= n; i++)
        if (fault(parameters[i]) != "") { refuse(fault(parameters[i])); next }
    if (handles) makers = makers " " name
    next
}
{ refuse("declaration") }
END {
    if (functions < 1) { print "no functions found"; exit 1 }
    if (refused) exit 1
    print functions " functions for loadlibrary and clib; clib takes these only if it takes a struct that is declared but not"
    print "defined for a class:" makers
}' "$work/declarations"

if grep -n '^ *# *define  *[A-Za-z_0-9]*(' "$1"; then
    echo "REFUSED: a macro with arguments"
    exit 1
fi

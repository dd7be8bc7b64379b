#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The shared library exports exactly what the header declares. It calls nothing that prints, ends the process or changes its state.
# It calls nothing that reads or writes text, where a locale would matter, and none of GSL's allocators: they report to a handler
# that ends the process. The static library has no other global name.
#     symbols.sh HEADER LIBRARY STATIC_LIBRARY
set -eu
command -v python3 >/dev/null || { echo "SKIPPED: no python3 here, which reads the header"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
grep -o 'rwedge_[a-zA-Z_0-9]*(' "$1" | tr -d '(' | sort -u >"$work/mentioned"
# Comments mention functions too, but only those that are declared.
python3 -B "$(dirname "$1")/../bindings/interface/header.py" --names "$1" >"$work/names"
sort -u "$work/names" >"$work/declared"
nm -D --defined-only "$2" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort -u >"$work/exported"
if ! diff "$work/declared" "$work/exported"; then
    echo "FAILED: < declared in the header, > exported"
    exit 1
fi
if ! diff "$work/declared" "$work/mentioned" >"$work/difference"; then
    echo "FAILED: the header's comments name functions that it does not declare:"
    cat "$work/difference"
    exit 1
fi
nm --defined-only --extern-only "$3" | awk 'NF == 3 { print $3 }' | sort -u >"$work/visible"
if ! diff "$work/declared" "$work/visible"; then
    echo "FAILED: < declared in the header, > visible in the static library"
    exit 1
fi
forbidden='^(abort|exit|_exit|_Exit|quick_exit|raise|signal|longjmp|.*locale.*|.*strto.*|.*scanf.*|ato.|.*s.*printf.*|printf|fprintf|vfprintf|puts|putchar|fputs|fputc|'
forbidden="$forbidden"'fwrite|perror|__printf_chk|__fprintf_chk|srand|rand|gsl_set_error_handler.*|gsl_.*_c?alloc.*|'
forbidden="$forbidden"'feclearexcept|feraiseexcept|fesetexcept|fesetexceptflag|feholdexcept|feupdateenv|fesetenv|fesetmode|'
forbidden="$forbidden"'fesetround|feenableexcept|fedisableexcept)$'
nm -D --undefined-only "$2" | awk '{ sub(/@.*/, "", $NF); print $NF }' | sort -u >"$work/called"
if grep -E "$forbidden" "$work/called"; then
    echo "FAILED: the library calls what it must not"
    exit 1
fi
echo "$(wc -l <"$work/exported") functions exported, as declared; $(wc -l <"$work/called") called, none of them forbidden"

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
# same NAMES NAMES WHAT - two lists
same()
{
    diff "$work/$1" "$work/$2" || { echo "FAILED: < $1, > $2: $3"; exit 1; }
}
python3 -B "$(dirname "$1")/../bindings/interface/header.py" --names "$1" | sort -u >"$work/declared"
nm -D --defined-only "$2" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort -u >"$work/exported"
same declared exported "by the shared library"
# Comments mention functions too, but only those that are declared.
grep -o 'rwedge_[a-zA-Z_0-9]*(' "$1" | tr -d '(' | sort -u >"$work/mentioned"
same declared mentioned "in the header's comments"
nm --defined-only --extern-only "$3" | awk 'NF == 3 { print $3 }' | sort -u >"$work/visible"
same declared visible "in the static library"
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

# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by what builds the library in other ways. Runs in the top folder.

# The options of lib/CMakeLists.txt on which bits depend, for gcc and clang.
library_options='-std=c99 -ffp-contract=off -fno-math-errno'

# Left out where another compiler or the sanitizers are tried: what builds the library itself, needs another language than C, or
# holds times against those of gcc.
of_another_compiler='^(package|reproducible|abi|answers|page|workbook|speed|bindings_.*)$'

# compilers_here - gcc, gcc-*, clang, clang-* on this machine, each once whatever its names.
compilers_here()
{
    seen=' '
    for directory in $(echo "$PATH" | tr : ' '); do
        for path in "$directory"/gcc "$directory"/clang "$directory"/gcc-[0-9]* "$directory"/clang-[0-9]*; do
            case $path in *[!0-9]) case $path in */gcc | */clang) ;; *) continue ;; esac ;; esac
            [ -x "$path" ] || continue
            real=$(realpath "$path")
            case $seen in *" $real "*) continue ;; esac
            seen="$seen$real "
            basename "$path"
        done
    done
}

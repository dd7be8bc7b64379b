# SPDX-License-Identifier: GPL-3.0-or-later
# Completion in real shells, and the man page. Both have every option, and no other.
. "$(dirname "$0")/../claims.sh"

for shell in bash zsh fish; do
    does_quietly --completion $shell
    cp out rwedge.$shell
done
refuses "rwedge: --completion csh: unknown shell; allowed: bash, zsh, fish" --completion csh

# every_option COMMAND: of its help, "" for rwedge's own.
every_option() {
    "$rwedge" $1 --help | sed -n 's/^  \(-[a-zA-Z],\|   \) \(--[a-zA-Z][a-zA-Z0-9-]*\).*/\2/p' | sort -u
}
"$rwedge" --help | sed -n '/^Commands/,/^$/s/^  \([a-z]*\) .*/\1/p' >commands
same "commands" "4" "$(grep -c -x -e solve -e table -e profile -e field commands)"
same "options of table" 15 "$(every_option table | wc -l | tr -d ' ')"

if command -v bash >/dev/null 2>&1; then
    cat >complete.bash <<'BASH'
source ./rwedge.bash
complete -p rwedge >/dev/null || exit 1
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_rwedge
printf '%s\n' "${COMPREPLY[@]}"
BASH
    completes() { # EXPECTED WORDS...: words as bash splits them, the last one being completed
        expected=$1
        shift
        called="bash completion of '$*'"
        same "words" "$(echo "$expected" | tr ' ' '\n' | LC_ALL=C sort | paste -s -d ' ' -)" "$(bash complete.bash "$@" 2>&1 | LC_ALL=C sort | paste -s -d ' ' -)"
    }
    touch "a file.csv" another.csv
    completes "$(paste -s -d ' ' commands) --help --completion --version" rwedge ""
    completes "bash zsh fish" rwedge --completion ""
    completes "elastic-limit" rwedge table el
    completes "--yield-stress --yield-factor" rwedge solve --yi
    completes "csv tsv json xlsx vtk" rwedge field --format ""
    completes "csv tsv json xlsx" rwedge profile --format =
    completes "list row" rwedge solve --layout ""
    called="bash completion of a name with a space"
    same "words" "a file.csv:another.csv" "$(bash complete.bash rwedge solve -i a | sort | paste -s -d : -)"
    completes "another.csv" rwedge table elastic-limit --output = an
    completes "" rwedge solve --E1 ""
    for command in $(cat commands); do
        called="bash completion of $command"
        same "options" "$(every_option "$command")" "$(bash complete.bash rwedge "$command" -- | sort)"
    done
    called="bash completion of rwedge"
    same "options" "$(every_option "")" "$(bash complete.bash rwedge -- | sort)"
fi

if command -v fish >/dev/null 2>&1; then
    HOME=$scratch
    export HOME
    offers() { # EXPECTED LINE
        called="fish completion of '$2'"
        same "words" "$1" "$(fish --no-config -c "source ./rwedge.fish; complete -C '$2'" 2>&1 | cut -f 1 | sort | paste -s -d ' ' -)"
    }
    offers "$(sort commands | paste -s -d ' ' -)" "rwedge "
    offers "csv json tsv vtk xlsx" "rwedge field --format "
    for command in $(cat commands); do
        offers "$(every_option "$command" | paste -s -d ' ' -)" "rwedge $command --"
    done
fi

# zsh, on a terminal of its own: what a Tab inserts.
if command -v zsh >/dev/null 2>&1; then
    called="zsh -n rwedge.zsh"
    same "syntax" "" "$(zsh -n rwedge.zsh 2>&1)"
    mkdir functions
    cp rwedge.zsh functions/_rwedge
    cat >complete.zsh <<'ZSH'
zmodload zsh/zpty || exit 77
zpty shell 'TERM=dumb zsh -f -i'
zpty -w shell 'PS1=; unsetopt zle_bracketed_paste 2>/dev/null; fpath=($PWD/functions $fpath); autoload -U compinit; compinit -u -D; rwedge() { print -r -- "<<$*>>" }; print READY'
zpty -r shell line '*READY*READY*'
zpty -w shell "$1"$'\t'
zpty -r -t shell line 2>/dev/null
zpty -r shell line '*\<\<*\>\>*'
print -r -- "${${line##*<<}%%>>*}"
zpty -d shell
ZSH
    inserts() { # EXPECTED LINE
        called="zsh completion of '$2'"
        same "line" "$1" "$(timeout 20 zsh -f complete.zsh "$2" 2>/dev/null)"
    }
    if ! zsh -fc 'zmodload zsh/zpty && zpty probe :' 2>/dev/null; then
        echo "SKIPPED: what a Tab inserts in zsh, for lack of a pseudo-terminal"
        inserts() { :; }
    fi
    inserts "profile" "rwedge pro"
    inserts "table elastic-limit" "rwedge table ela"
    inserts "field --format vtk" "rwedge field --format v"
    inserts "profile --load 1,0 --load" "rwedge profile --load 1,0 --lo"
    inserts "solve --yield-stress" "rwedge solve --yield-s"
fi

# The man page: every option and command of the help is in it, and no other.
sh "$here/../../../cli/manual.sh" "$rwedge" 2026-11-22 >page
sed 's/\\-/-/g' page | grep -v '^\.\\"' >plain
grep -o -e '--[a-zA-Z][a-zA-Z0-9-]*' plain | sort -u >in_page
{
    every_option ""
    for command in $(cat commands); do
        every_option "$command"
    done
} | sort -u >in_help
called="man page"
same "options" "" "$(diff in_help in_page)"
for command in $(cat commands) elastic-limit max-tension contact-law critical-friction stick-zone; do
    same "has $command" yes "$(grep -q -e "$command" plain && echo yes)"
done
if command -v mandoc >/dev/null 2>&1; then
    same "mandoc -Tlint -Wwarning" "" "$(mandoc -Tlint -Wwarning page)"
fi
if man --version 2>/dev/null | grep -q '^man 2'; then
    same "man --warnings" "" "$(LC_ALL=C.UTF-8 man -l --warnings ./page 2>&1 >/dev/null)"
fi

finish

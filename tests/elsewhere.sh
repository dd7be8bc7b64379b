#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the two commands on another release of Debian. For this it makes a minimal system in a temporary folder. The system has only
# git and ca-certificates, and a clean clone of what is committed here.
#     elsewhere.sh SUITE        bookworm, trixie, testing; stable is the present stable release, if this machine is another one
# It claims that ./tables/generate.sh ends well and changes no file of the clone, and that ./tests/run.sh --strict passes.
# It takes about ten minutes and 6 GB. The status is 77 if it may not, or cannot, make the system.
set -eu
[ $# = 1 ] || { echo "usage: $0 SUITE" >&2; exit 2; }
suite=$1
top=$(cd "$(dirname "$0")/.." && pwd)
. "$top/tests/support/install.sh"
. "$top/tests/support/clean_system.sh"

skip() { echo "SKIPPED: $suite cannot be tried here: $*"; exit 77; }
fail() { echo "FAILED: on $suite: $*"; exit 1; }

git -C "$top" rev-parse HEAD >/dev/null 2>&1 || skip "these files are no clone"
! reason=$(cannot_make_system) || skip "$reason"

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
system=$work/system
make_system "$suite" "$system" git "$work/log" || skip "debootstrap ends with: $(tail -n 1 "$work/log")"
if [ "$suite" = stable ] && [ "$(grep VERSION_CODENAME "$system/etc/os-release")" = "$(grep VERSION_CODENAME /etc/os-release)" ]; then
    echo "This machine is the stable release itself."
    exit 0
fi
there() { in_system "$system" /srv/rwedge "$@"; }
git clone --quiet --no-hardlinks "$top" "$system/srv/rwedge"
echo "$(. "$system/etc/os-release" && echo "$PRETTY_NAME"), $(git -C "$top" log -1 --format='%h %s')"

there ./tables/generate.sh || fail "generate.sh ends with status $?"
changed=$(there git status --porcelain)
[ -z "$changed" ] || fail "generate.sh has changed $changed"
there ./tests/run.sh --strict >"$work/said" 2>&1 && ended=0 || ended=$?
sed 's/SKIPPED: /skipped there: /' "$work/said" # it has judged them itself
[ $ended = 0 ] || fail "run.sh ends with status $ended"

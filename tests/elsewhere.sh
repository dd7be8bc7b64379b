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

skip() { echo "SKIPPED: $suite cannot be tried here: $*"; exit 77; }
fail() { echo "FAILED: on $suite: $*"; exit 1; }

[ "$(id -u)" -eq 0 ] || skip "only root can make the system"
git -C "$top" rev-parse HEAD >/dev/null 2>&1 || skip "these files are no clone"
wish command:debootstrap=debootstrap command:unshare=util-linux
command -v debootstrap >/dev/null || skip "debootstrap is missing"
unshare --mount --pid --fork true 2>/dev/null || skip "this machine does not let root mount"

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
system=$work/system
debootstrap --variant=minbase --include=git,ca-certificates "$suite" "$system" >"$work/log" 2>&1 ||
    skip "debootstrap ends with: $(tail -n 1 "$work/log")"
if [ "$suite" = stable ] && [ "$(grep VERSION_CODENAME "$system/etc/os-release")" = "$(grep VERSION_CODENAME /etc/os-release)" ]; then
    echo "This machine is the stable release itself."
    exit 0
fi
# How this machine comes to the network: its name servers, apt's proxies, the certificates that it trusts besides.
cp /etc/resolv.conf "$system/etc/resolv.conf"
apt-config dump | sed -n '/^Acquire::\(https*::\|Check-\)/p' >"$system/etc/apt/apt.conf.d/90network"
find /usr/local/share/ca-certificates -name '*.crt' -exec cp '{}' "$system/usr/local/share/ca-certificates" ';'
chroot "$system" update-ca-certificates >"$work/log" 2>&1

# there COMMAND... - runs it in the clone there, which has its own processes and devices
there()
{
    # shellcheck disable=SC2016
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 http_proxy="${http_proxy-}" https_proxy="${https_proxy-}" \
        unshare --mount --pid --fork --kill-child sh -c '
            mount --make-rprivate / && mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" &&
                exec chroot "$0" sh -c "cd /srv/rwedge && exec \"\$@\"" sh "$@"' "$system" "$@"
}
git clone --quiet --no-hardlinks "$top" "$system/srv/rwedge"
echo "$(. "$system/etc/os-release" && echo "$PRETTY_NAME"), $(git -C "$top" log -1 --format='%h %s')"

there ./tables/generate.sh || fail "generate.sh ends with status $?"
changed=$(there git status --porcelain)
[ -z "$changed" ] || fail "generate.sh has changed $changed"
there ./tests/run.sh --strict || fail "run.sh ends with status $?"

# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced, after install.sh: a minimal Debian in a folder, as nobody has touched it, and commands in it.

# cannot_make_system - says why this machine cannot make one; fails where it can
cannot_make_system()
{
    [ "$(id -u)" -eq 0 ] || { echo "only root can make the system"; return; }
    wish command:debootstrap=debootstrap command:unshare=util-linux >&2
    command -v debootstrap >/dev/null || { echo "debootstrap is missing"; return; }
    unshare --mount --pid --fork true 2>/dev/null || { echo "this machine does not let root mount"; return; }
    return 1
}

# make_system SUITE FOLDER PACKAGE[,PACKAGE...] LOG - that release of Debian with these packages. It comes to the network as this
# machine does: its name servers, apt's proxies, the certificates that it trusts besides.
make_system()
{
    debootstrap --variant=minbase --include="$3,ca-certificates" "$1" "$2" >"$4" 2>&1 || return 1
    cp /etc/resolv.conf "$2/etc/resolv.conf"
    apt-config dump | sed -n '/^Acquire::\(https*::\|Check-\)/p' >"$2/etc/apt/apt.conf.d/90network"
    find /usr/local/share/ca-certificates -name '*.crt' -exec cp '{}' "$2/usr/local/share/ca-certificates" ';'
    chroot "$2" update-ca-certificates >"$4" 2>&1
    echo force-unsafe-io >"$2/etc/dpkg/dpkg.cfg.d/unsafe-io" # a system for an hour: its packages need not reach the disk
}

# in_system FOLDER PLACE COMMAND... - runs it in that folder of the system, which has its own processes and devices
in_system()
{
    # shellcheck disable=SC2016
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LANG=C.UTF-8 http_proxy="${http_proxy-}" https_proxy="${https_proxy-}" \
        unshare --mount --pid --fork --kill-child sh -c '
            mount --make-rprivate / && mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" &&
                exec chroot "$0" sh -c "cd \"\$0\" && exec \"\$@\"" "$@"' "$@"
}

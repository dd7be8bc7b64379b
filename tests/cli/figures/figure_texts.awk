# SPDX-License-Identifier: GPL-3.0-or-later
# The texts of an SVG that gnuplot wrote, by where they stand:  awk -f figure_texts.awk FILE
# A line for each: "text LEFT RIGHT Y WORDS". Then what cannot be read: "cut WORDS", "over WORDS | WORDS", "mark under WORDS".
# Lengths are pixels; letters are taken a little narrower than they are. Upright texts are left out.
function overlap(i, k) {
    return left[i] < right[k] && left[k] < right[i] && (y[i] - y[k]) ^ 2 < HEIGHT * HEIGHT
}
function value_after(line, key) {
    sub(".*" key, "", line)
    return line + 0
}
BEGIN {
    EM = 15
    LETTER = 0.55 * EM
    HEIGHT = 0.75 * EM
}
/<svg/ { for (line = $0; line !~ /viewBox/ && (getline next_line) > 0;) line = line next_line
    match(line, /viewBox="0 0 [0-9]+/)
    width = substr(line, RSTART + 13, RLENGTH - 13) + 0 }
/href='#gpPt5'/ { marks++
    mark_x[marks] = value_after($0, "translate\\(")
    mark_y[marks] = value_after($0, "translate\\([-0-9.]*,") }
/text-anchor=/ { upright = /rotate/
    x = value_after($0, "translate\\(")
    at_y = value_after($0, "translate\\([-0-9.]*,")
    match($0, /text-anchor="[a-z]*/)
    anchor = substr($0, RSTART + 13, RLENGTH - 13) }
/<text>/ { words = $0
    gsub(/<[^>]*>|^[ \t]+/, "", words)
    letters = words
    gsub(/[\200-\277]/, "", letters)
    long = length(letters) * LETTER
    from = anchor == "start" ? x : anchor == "end" ? x - long : x - long / 2
    if (upright || long == 0 || seen[from, at_y, words]++)
        next
    n++
    left[n] = from; right[n] = from + long; y[n] = at_y; text[n] = words
    print "text", from, from + long, at_y, words }
END {
    for (i = 1; i <= n; i++) {
        if (left[i] < 0 || right[i] > width)
            print "cut", text[i]
        for (k = 1; k < i; k++)
            if (overlap(i, k))
                print "over", text[i] " | " text[k]
        for (m = 1; m <= marks; m++)
            if (mark_x[m] > left[i] && mark_x[m] < right[i] && (mark_y[m] - (y[i] - EM / 3)) ^ 2 < (EM / 2) ^ 2)
                print "mark under", text[i]
    }
    if (n == 0)
        print "no text"
}

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The MATLAB interface in GNU Octave, linked with the private build.
#     test.sh BUILD-FOLDER
set -eu
: "${1:?usage: test.sh BUILD-FOLDER}"
here=$(cd "$(dirname "$0")" && pwd)
top=$here/../..
for tool in octave-cli mkoctfile python3; do
    command -v $tool >/dev/null 2>&1 || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
sh "$top/tests/answers/answers.sh" "$1"
prefix=$(cd "$1/private/prefix" && pwd)
made=$(cd "$1/private/made" && pwd)
rm -rf "$1/matlab"
mkdir -p "$1/matlab"
cd "$1/matlab"

fail()
{
    echo "FAILED: $1"
    exit 1
}

octave()
{
    octave-cli --no-init-file --no-history --path "$prefix/share/rwedge/matlab" --path "$PWD/rwedge" "$@"
}

# as installed, and as a program of the C Matrix API: nothing but what MATLAB has too is called
mkdir -p "in stalled/lib/x86_64-linux-gnu" # where Debian has it
ln -s "$prefix/include" "$prefix/share" "in stalled/"
ln -s "$prefix/lib/librwedge.a" "in stalled/lib/x86_64-linux-gnu"
octave-cli --no-init-file --no-history --path "in stalled/share/rwedge/matlab" --eval 'build_rwedge();' >/dev/null
# a library that lacks something is told when it is built, not when it is used
mkdir -p lacking/lib
ln -s "$prefix/include" lacking/
ar rc lacking/lib/librwedge.a
octave --eval "for from = {'lacking', 'nowhere'}, try, build_rwedge(from{1}, 'refused'), catch err, disp(err.message), end, end" >refused.txt 2>&1
grep -q 'librwedge.a built with -DRWEDGE_PRIVATE_DEPS=ON?' refused.txt || fail "a library that lacks something is taken"
# and nothing is left behind then, nor where nothing is installed; what was built before stays
grep -q 'rwedge.h is missing: is rwedge installed at nowhere?' refused.txt || fail "nothing is taken for a library"
cp -r rwedge before
# objects of one build are none of another's
cat >other_build.m <<'END'
old = rwedge_contact(0.01, 2, 1e-5, 0.3);
old.load(10, 0);
addpath('before');
new = rwedge_contact(0.01, 2, 1e-5, 0.3);
new.load(1000, 0);
width = new.half_width();
try, old.half_width(), catch err, disp(err.identifier), end
clear old
disp(new.half_width() == width)
END
[ "$(octave other_build.m)" = "$(printf 'rwedge:handle\n1')" ] || fail "another build's object: $(octave other_build.m)"
octave --eval "try, build_rwedge('lacking', 'before'), catch err, disp(err.message), end" >/dev/null 2>&1
diff -r rwedge before || fail "a build that fails changes what was there"
for left in refused refused-* before-* rwedge-*; do
    [ ! -e "$left" ] || fail "a build leaves $left behind"
done
cc -std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla -Werror -fsyntax-only -I"$prefix/include" \
    -I"$made/c" \
    -isystem "$(mkoctfile -p OCTINCLUDEDIR)" "$here/rwedge_mex.c"
nm -D --undefined-only rwedge/rwedge_mex.mex | sed -n 's/.* \(me*x[A-Z][A-Za-z]*\)\(@.*\)*$/\1/p' | sort -u >called.txt
tr ' ' '\n' >known.txt <<'END'
mexCallMATLAB mexErrMsgIdAndTxt mexLock mexUnlock mxCreateDoubleMatrix mxCreateDoubleScalar mxCreateNumericArray mxCreateString
mxGetClassName mxGetDimensions mxGetNumberOfDimensions mxGetNumberOfElements mxGetPr mxGetString mxIsComplex
mxIsDouble mxIsLogical mxIsNumeric mxIsSparse
END
diff called.txt known.txt || fail "< called, > known to be in MATLAB's C Matrix API"

octave "$here/answer.m" <"$prefix/../answers/calls.matlab" >answers.csv
cmp answers.csv "$prefix/../answers/answers.csv" || fail "the answers differ from those in C"
echo "$(wc -l <answers.csv) calls answered as in C, to the last bit"

octave "$here/rwedge_example.m" >example.txt
grep -q "^ -28.8 *4.0370e-04" example.txt || fail "the example's slip is not that of tests/data/example_fretting.txt"
swt=$(sed -n 's/^Smith-Watson-Topper \(.*\) MPa$/\1/p' "$top/tests/data/example_fretting.txt")
grep -q "^Smith-Watson-Topper: at most $swt MPa, at x = -1.0000 b, plane 90.0 degrees" example.txt ||
    fail "the example's Smith-Watson-Topper is not the $swt of tests/data/example_fretting.txt"

octave "$here/test_rwedge.m"

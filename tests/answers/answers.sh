#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The calls, and what C answers with the private build: BUILD/private/answers/calls.csv, answers.csv; the calls as each language
# makes them. They are made once for the tests of all languages, which may run side by side.    answers.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/../../bindings/private.sh" "$1"
cd "$1/private"
exec 9>answers.lock
flock 9
made_of=$(cksum prefix/lib/librwedge.a "$here"/*.* "$here"/../../bindings/interface/*.* "$here"/../../bindings/fortran/answer.f90.in)
[ "$(cat answers/made_of 2>/dev/null)" != "$made_of" ] || exit 0
mkdir -p answers
python3 -B "$here/calls.py" >answers/calls.csv
python3 -B "$here/calls.py" c >answers/answer.c
for language in javascript matlab python; do
    python3 -B "$here/calls.py" $language >answers/calls.$language
done
python3 -B "$here/calls.py" fortran >answers/answer.f90
cc -std=c99 -Iprefix/include answers/answer.c prefix/lib/librwedge.a -lm -o answers/answer
answers/answer >answers/answers.csv
echo "$made_of" >answers/made_of

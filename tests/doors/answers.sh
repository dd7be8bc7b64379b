#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The calls, and what C answers with the private build: BUILD/private/doors/calls.csv, answers.csv. They are made once for the tests
# of all languages, which may run side by side.    answers.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sh "$here/../../bindings/private.sh" "$1"
cd "$1/private"
exec 9>doors.lock
flock 9
made_of=$(cksum prefix/lib/librwedge.a prefix/include/rwedge.h "$here"/*)
[ "$(cat doors/made_of 2>/dev/null)" != "$made_of" ] || exit 0
mkdir -p doors
python3 -B "$here/calls.py" >doors/calls.csv
cc -std=c99 -Iprefix/include -Imade/c "$here/door.c" prefix/lib/librwedge.a -lm -o doors/door
doors/door <doors/calls.csv >doors/answers.csv
echo "$made_of" >doors/made_of

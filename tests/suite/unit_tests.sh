# SPDX-License-Identifier: GPL-3.0-or-later
# For coverage/: which programs are the unit tests of lib/.    . unit_tests.sh

# unit_tests SOURCE - their names: the tests of the rooms, and those of calls with bad arguments or too little memory.
# Those that go along with the boundary-element solver are left out, because they take longer than all others.
unit_tests()
{
    for file in "$1"/tests/lib/*/test_*.c "$1"/tests/host/test_*.c "$1"/tests/proof/test_*.c; do
        [ -f "$file" ] || continue
        case $file in
        */test_boundary_element.c | */test_eccentric_histories.c) ;;
        *) basename "$file" .c ;;
        esac
    done
    echo strength_survey yield_survey
}

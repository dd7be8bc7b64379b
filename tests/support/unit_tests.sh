# SPDX-License-Identifier: GPL-3.0-or-later
# For coverage/ and mutation/: which programs are the unit tests of lib/.    . unit_tests.sh

# unit_tests SOURCE - their names: of the rooms, and of all calls with bad arguments and too little memory. Not test_tables,
# which compares with what the library itself wrote; test_boundary_element, which takes longer than all others; test_speed,
# which measures times.
unit_tests()
{
    for file in "$1"/tests/test_*.c "$1"/tests/faults/test_*.c; do
        [ -f "$file" ] || continue
        case $file in
        */test_tables.c | */test_boundary_element.c | */test_speed.c) ;;
        *) basename "$file" .c ;;
        esac
    done
    echo strength_survey
}

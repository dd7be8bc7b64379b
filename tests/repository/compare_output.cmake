# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DPROGRAM=... -DEXPECTED=... -P compare_output.cmake: the program's output must be that text.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output RESULT_VARIABLE status)
file(READ ${EXPECTED} expected)
if(NOT status EQUAL 0 OR NOT output STREQUAL expected)
    message(FATAL_ERROR "status ${status}, output:\n${output}expected:\n${expected}")
endif()

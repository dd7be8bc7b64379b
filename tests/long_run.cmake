# SPDX-License-Identifier: GPL-3.0-or-later
# The long run: tests that take minutes. Each is declared in its room. ctest leaves them out unless it is asked for them:
#     ctest --test-dir build -C Long -L campaign             as tests/run.sh --campaign does; also: compilers, packages, elsewhere
#     ctest --test-dir build -C Long -R '^long_random_files$' one of them
cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
set(RWEDGE_PROCESSORS ${processors} CACHE INTERNAL "of this machine")

# long_run(LABEL NAME [WIDE | ALONE] MINUTES N [LOCKS LOCK...] [AFTER NAME] COMMAND...)
# It runs in the source folder. WIDE: it needs all processors for itself. ALONE: it measures times. MINUTES: about how many, as the
# longest is begun first. LOCKS: what it may not share. AFTER: the test that must end first, if there is one of that name.
function(long_run label name)
    cmake_parse_arguments(PARSE_ARGV 2 long "WIDE;ALONE" "MINUTES;AFTER" "LOCKS;COMMAND")
    add_test(NAME long_${name} CONFIGURATIONS Long COMMAND ${long_COMMAND} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(long_${name} PROPERTIES LABELS ${label} SKIP_RETURN_CODE 77 TIMEOUT 7200 COST ${long_MINUTES})
    if(long_WIDE)
        set_tests_properties(long_${name} PROPERTIES PROCESSORS ${RWEDGE_PROCESSORS})
    endif()
    if(long_ALONE)
        set_tests_properties(long_${name} PROPERTIES RUN_SERIAL TRUE)
    endif()
    if(long_LOCKS)
        set_tests_properties(long_${name} PROPERTIES RESOURCE_LOCK "${long_LOCKS}")
    endif()
    if(long_AFTER)
        set_tests_properties(long_${name} PROPERTIES DEPENDS long_${long_AFTER})
    endif()
endfunction()

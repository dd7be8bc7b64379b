# SPDX-License-Identifier: GPL-3.0-or-later
# The library and what it takes from GSL, LAPACK and BLAS, in one object whose only global symbols are the library's own.
set(objects ${CMAKE_CURRENT_BINARY_DIR}/rwedge_private${CMAKE_C_OUTPUT_EXTENSION})
add_custom_command(OUTPUT ${objects}
    COMMAND ${CMAKE_LINKER} -r -o ${objects} $<TARGET_OBJECTS:rwedge_objects>
        ${RWEDGE_GSL_ARCHIVE} ${RWEDGE_LAPACK_ARCHIVE} ${RWEDGE_BLAS_ARCHIVE}
    COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=rw* ${objects}
    DEPENDS rwedge_objects $<TARGET_OBJECTS:rwedge_objects>
    COMMAND_EXPAND_LISTS VERBATIM
    COMMENT "Joining the library with its private GSL and LAPACK")
set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)

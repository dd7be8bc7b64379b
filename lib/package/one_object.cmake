# SPDX-License-Identifier: GPL-3.0-or-later
# The library in one object whose only global symbols are the header's, with what it takes from GSL, LAPACK and BLAS inside where
# these are private: RWEDGE_ONE_OBJECT. A program that links the static library may have functions of any other name.
set(RWEDGE_ONE_OBJECT ${CMAKE_CURRENT_BINARY_DIR}/rwedge_one_object${CMAKE_C_OUTPUT_EXTENSION})
add_custom_command(OUTPUT ${RWEDGE_ONE_OBJECT}
    COMMAND ${CMAKE_LINKER} -r -o ${RWEDGE_ONE_OBJECT} $<TARGET_OBJECTS:rwedge_objects>
        ${RWEDGE_GSL_ARCHIVE} ${RWEDGE_LAPACK_ARCHIVE} ${RWEDGE_BLAS_ARCHIVE}
    COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=rwedge_* ${RWEDGE_ONE_OBJECT}
    DEPENDS rwedge_objects $<TARGET_OBJECTS:rwedge_objects>
    COMMAND_EXPAND_LISTS VERBATIM
    COMMENT "Joining the library in one object")
set_source_files_properties(${RWEDGE_ONE_OBJECT} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
# The two libraries that hold it may be built at the same time: it is made before either.
add_custom_target(rwedge_one_object DEPENDS ${RWEDGE_ONE_OBJECT})
add_dependencies(rwedge_static rwedge_one_object)
if(RWEDGE_PRIVATE_DEPS)
    add_dependencies(rwedge rwedge_one_object)
endif()

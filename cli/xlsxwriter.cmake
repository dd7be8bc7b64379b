# SPDX-License-Identifier: GPL-3.0-or-later
# The target rwedge_xlsxwriter, where a program with libxlsxwriter can be linked. Without it the tool says what is missing when a
# spreadsheet file is asked for. pkg-config is not asked: it names libraries that only a static libxlsxwriter needs, and that its
# package does not bring.
find_path(XLSXWRITER_INCLUDE_DIR xlsxwriter.h)
find_library(XLSXWRITER_LIBRARY xlsxwriter)
find_library(ZLIB_LIBRARY z)
set(xlsxwriter ${XLSXWRITER_LIBRARY})
if(ZLIB_LIBRARY)
    list(APPEND xlsxwriter ${ZLIB_LIBRARY})
endif()

if(XLSXWRITER_INCLUDE_DIR AND XLSXWRITER_LIBRARY)
    include(CheckSymbolExists)
    include(CMakePushCheckState)
    cmake_push_check_state(RESET)
    set(CMAKE_REQUIRED_INCLUDES ${XLSXWRITER_INCLUDE_DIR})
    set(CMAKE_REQUIRED_LIBRARIES ${xlsxwriter})
    if(NOT XLSXWRITER_LINKS)
        unset(XLSXWRITER_LINKS CACHE) # what was missing may have come
    endif()
    check_symbol_exists(workbook_new xlsxwriter.h XLSXWRITER_LINKS)
    cmake_pop_check_state()
endif()

if(XLSXWRITER_LINKS)
    add_library(rwedge_xlsxwriter INTERFACE)
    target_include_directories(rwedge_xlsxwriter SYSTEM INTERFACE ${XLSXWRITER_INCLUDE_DIR})
    target_link_libraries(rwedge_xlsxwriter INTERFACE ${xlsxwriter})
else()
    message(STATUS "No spreadsheet files (XLSX): libxlsxwriter is missing or cannot be linked; on Debian and Ubuntu install "
        "libxlsxwriter-dev")
endif()

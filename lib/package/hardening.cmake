# SPDX-License-Identifier: GPL-3.0-or-later
# rwedge_hardening: what ends a program that a mistake has let overwrite its memory, before it can do harm. It is for what is
# installed: optimised builds without sanitizers, which look for the same themselves. Windows' loader has its own means.
option(RWEDGE_HARDENING "Guard the stack, the C library's calls and the tables of addresses, where the compiler can" ON)
add_library(rwedge_hardening INTERFACE)
if(NOT RWEDGE_HARDENING OR WIN32 OR CMAKE_C_FLAGS MATCHES "-fsanitize" OR NOT CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
    return()
endif()

include(CheckCSourceCompiles)
include(CheckLinkerFlag)

# Adds compile options to the optimised builds, where a program compiles and links with them without a warning. Returns whether.
function(rwedge_harden name)
    string(JOIN " " flags ${ARGN})
    set(CMAKE_REQUIRED_FLAGS "-Werror -O2 ${flags}")
    check_c_source_compiles("#include <string.h>\n#include <stdlib.h>\nint main(int n, char **v)
        { char text[8]; memset(text, 0, sizeof text); strncat(text, v[n - 1], 7); return atoi(text); }" RWEDGE_HAS_${name})
    if(RWEDGE_HAS_${name})
        target_compile_options(rwedge_hardening INTERFACE "$<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:${ARGN}>")
    endif()
endfunction()

rwedge_harden(STACK_PROTECTOR -fstack-protector-strong)
rwedge_harden(FORTIFY_3 -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
if(NOT RWEDGE_HAS_FORTIFY_3)
    rwedge_harden(FORTIFY_2 -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()
check_linker_flag(C LINKER:-z,relro,-z,now RWEDGE_HAS_RELRO)
if(RWEDGE_HAS_RELRO)
    target_link_options(rwedge_hardening INTERFACE LINKER:-z,relro,-z,now)
endif()
if(RWEDGE_HAS_STACK_PROTECTOR AND RWEDGE_HAS_FORTIFY_3 AND RWEDGE_HAS_RELRO)
    set_property(GLOBAL PROPERTY RWEDGE_IS_HARDENED ON) # for the test
endif()

# SPDX-License-Identifier: GPL-3.0-or-later
# 64-bit Windows from Debian: cmake -DCMAKE_TOOLCHAIN_FILE=.../mingw.cmake. What is built needs nothing that Windows lacks.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
string(APPEND CMAKE_C_FLAGS_INIT " -Wno-float-conversion ") # its isnan() and the like would each say so
string(APPEND CMAKE_SHARED_LINKER_FLAGS_INIT " -static-libgcc -s -Wl,--no-insert-timestamp \"-L${RWEDGE_LIBM_FOLDER}\" ") # whose libm.a is found for -lm
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -static -s -Wl,--no-insert-timestamp \"-L${RWEDGE_LIBM_FOLDER}\" ")

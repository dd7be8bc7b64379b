# SPDX-License-Identifier: GPL-3.0-or-later
# What the library links: RWEDGE_DEPENDENCIES. Either the system's GSL and LAPACK; or, with RWEDGE_PRIVATE_DEPS, copies of
# theirs inside the library that nothing outside can see or replace: for hosts that bring their own (MATLAB, Excel, Python).
option(RWEDGE_PRIVATE_DEPS "Put static, hidden copies of GSL and LAPACK into the library" OFF)

if(NOT RWEDGE_PRIVATE_DEPS)
    find_package(GSL)
    find_package(LAPACK)
    if(NOT GSL_FOUND OR NOT LAPACK_FOUND)
        message(FATAL_ERROR "GSL or LAPACK was not found. Debian and Ubuntu have them in the packages libgsl-dev and "
            "liblapack-dev.")
    endif()
    set(RWEDGE_DEPENDENCIES GSL::gsl GSL::gslcblas LAPACK::LAPACK m)
    # As options of a linker that reads static libraries once, from left to right: Fortran's run-time library after LAPACK, and
    # the mathematical one last. (The .pc files of LAPACK do not name the former.)
    include(CheckLibraryExists)
    set(libraries ${GSL_LIBRARIES} ${LAPACK_LIBRARIES})
    unset(RWEDGE_HAS_GFORTRAN CACHE) # the compiler of Fortran may have come since the last time
    check_library_exists(gfortran _gfortran_stop_string "" RWEDGE_HAS_GFORTRAN)
    check_library_exists(quadmath sqrtq "" RWEDGE_HAS_QUADMATH)
    if(RWEDGE_HAS_GFORTRAN)
        list(APPEND libraries gfortran)
        if(RWEDGE_HAS_QUADMATH)
            list(APPEND libraries quadmath)
        endif()
    endif()
    set(RWEDGE_STATIC_LIBRARIES "")
    foreach(library ${libraries} m)
        if(library MATCHES "^-")
            string(APPEND RWEDGE_STATIC_LIBRARIES " ${library}")
        elseif(library MATCHES "/([^/]+)[.]framework")
            string(APPEND RWEDGE_STATIC_LIBRARIES " -framework ${CMAKE_MATCH_1}")
        elseif(library MATCHES "^(.*)/lib([^/]+)[.](a|so|dylib|dll[.]a|tbd)$")
            string(APPEND RWEDGE_STATIC_LIBRARIES " -L${CMAKE_MATCH_1} -l${CMAKE_MATCH_2}")
        else()
            string(APPEND RWEDGE_STATIC_LIBRARIES " -l${library}")
        endif()
    endforeach()
    string(STRIP "${RWEDGE_STATIC_LIBRARIES}" RWEDGE_STATIC_LIBRARIES)
    return()
endif()

# The reference LAPACK and BLAS, where a distribution keeps several: they start no threads.
find_path(RWEDGE_GSL_INCLUDE gsl/gsl_roots.h)
find_library(RWEDGE_GSL_ARCHIVE libgsl.a)
find_library(RWEDGE_LAPACK_ARCHIVE NAMES liblapack_pic.a liblapack.a PATH_SUFFIXES lapack)
find_library(RWEDGE_BLAS_ARCHIVE NAMES libblas_pic.a libblas.a PATH_SUFFIXES blas)
foreach(needed RWEDGE_GSL_INCLUDE RWEDGE_GSL_ARCHIVE RWEDGE_LAPACK_ARCHIVE RWEDGE_BLAS_ARCHIVE)
    if(NOT ${needed})
        message(FATAL_ERROR "${needed} was not found: this build puts static GSL, LAPACK and BLAS into the library, with GSL's "
            "headers. Debian and Ubuntu have them in the packages libgsl-dev, liblapack-dev and libblas-dev; elsewhere, build GSL "
            "with --enable-static. Name a file that is elsewhere by -D${needed}=...")
    endif()
endforeach()
set(RWEDGE_DEPENDENCIES m)
set(RWEDGE_STATIC_LIBRARIES -lm)

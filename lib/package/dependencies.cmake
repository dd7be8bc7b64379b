# SPDX-License-Identifier: GPL-3.0-or-later
# What the library links: RWEDGE_DEPENDENCIES. Either the system's GSL and LAPACK; or, with RWEDGE_PRIVATE_DEPS, copies of
# theirs inside the library that nothing outside can see or replace: for hosts that bring their own (MATLAB, Excel, Python).
option(RWEDGE_PRIVATE_DEPS "Put static, hidden copies of GSL and LAPACK into the library" OFF)

if(NOT RWEDGE_PRIVATE_DEPS)
    find_package(GSL REQUIRED)
    find_package(LAPACK REQUIRED)
    set(RWEDGE_PKGCONFIG_REQUIRES "gsl lapack")
    set(RWEDGE_DEPENDENCIES GSL::gsl GSL::gslcblas LAPACK::LAPACK m)
    return()
endif()

# The reference LAPACK and BLAS, where a distribution keeps several: they start no threads.
find_path(RWEDGE_GSL_INCLUDE gsl/gsl_roots.h REQUIRED)
find_library(RWEDGE_GSL_ARCHIVE libgsl.a REQUIRED)
find_library(RWEDGE_LAPACK_ARCHIVE NAMES liblapack_pic.a liblapack.a PATH_SUFFIXES lapack REQUIRED)
find_library(RWEDGE_BLAS_ARCHIVE NAMES libblas_pic.a libblas.a PATH_SUFFIXES blas REQUIRED)
set(RWEDGE_DEPENDENCIES m)

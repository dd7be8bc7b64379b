/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What GSL, LAPACK and Fortran's run-time call when something is wrong, for the build that holds
 * its own copies of them (RWEDGE_PRIVATE_DEPS). Theirs end the process or print; these return,
 * and the caller sees a status. As they are defined here, the linker never takes theirs, nor the
 * run-time library behind them. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

void gsl_error(const char *reason, const char *file, int line, int gsl_errno);
void xerbla_(const char *routine, const int32_t *argument, size_t length);
void _gfortran_concat_string(size_t length, char *joined, size_t length_1, const char *first,
                             size_t length_2, const char *second);

void gsl_error(const char *reason, const char *file, int line, int gsl_errno)
{
    (void)reason;
    (void)file;
    (void)line;
    (void)gsl_errno;
}

void xerbla_(const char *routine, const int32_t *argument, size_t length)
{
    (void)routine;
    (void)argument;
    (void)length;
}

/* LAPACK joins two letters to an option of ilaenv(). Fortran's rule: cut, or filled with blanks,
 * to the length of the target. */
void _gfortran_concat_string(size_t length, char *joined, size_t length_1, const char *first,
                             size_t length_2, const char *second)
{
    const size_t from_first = length_1 < length ? length_1 : length;
    const size_t from_second = length_2 < length - from_first ? length_2 : length - from_first;
    memcpy(joined, first, from_first);
    memcpy(joined + from_first, second, from_second);
    memset(joined + from_first + from_second, ' ', length - from_first - from_second);
}

! SPDX-License-Identifier: GPL-3.0-or-later
! Makes the calls of tests/answers/calls.py, which writes this program, through the module, and prints what tests/answers/answer.c
! prints.
program answers
    use rwedge
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_positive_inf, ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_fortran_env, only: int64
    implicit none
    type(rwedge_contact) :: contact, copy
    type(rwedge_series) :: series
    real(c_double), allocatable :: before(:)
    real(c_double) :: inf, nan
    integer :: stat

    inf = ieee_value(inf, ieee_positive_inf)
    nan = ieee_value(nan, ieee_quiet_nan)
    {calls}

contains

    subroutine tell(call, results, status)
        character(*), intent(in) :: call
        real(c_double), intent(in) :: results(:)
        integer(c_int32_t), intent(in) :: status
        integer :: i
        if (status == rwedge_ok) then
            before = results
            write (*, '(*(a))') call, (bits(results(i)), i = 1, size(results))
        else
            write (*, '(2a)') call, ',error'
        end if
    end subroutine

    function bits(value) result(text)
        real(c_double), intent(in) :: value
        character(:), allocatable :: text
        character(16) :: digits
        text = ',nan'
        if (ieee_is_nan(value)) return
        write (digits, '(z16.16)') transfer(value, 0_int64)
        text = ',' // digits
    end function

    {parts}
end program

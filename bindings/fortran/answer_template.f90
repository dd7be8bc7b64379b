! SPDX-License-Identifier: GPL-3.0-or-later
! Answers the calls of tests/answers/calls.py from standard input as tests/answers/answer.c does, through the module.
! Written by bindings/interface/generate.py from include/rwedge.h and answer_template.f90: change those, not answer.f90.
program answers
    use rwedge
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
    use, intrinsic :: iso_fortran_env, only: error_unit, int64
    implicit none
    type :: numbers
        real(c_double), allocatable :: x(:), xx(:, :) ! of two sizes: the points of a load in a column
    end type
    type(rwedge_contact) :: contact, other
    type(rwedge_series) :: series
    real(c_double), allocatable :: before(:)
    character(1024) :: line
    integer :: iostat

    do
        read (*, '(a)', iostat=iostat) line
        if (iostat /= 0) exit
        call answer(trim(line))
    end do

contains

    subroutine answer(line)
        character(*), intent(in) :: line
        type(numbers) :: v(14)
        real(c_double), allocatable :: r(:), s(:, :, :)
        integer :: stat, i

        v = arguments(line)
        stat = rwedge_ok
        select case (line(:index(line, ':') - 1))
        {cases}
        case default
            write (error_unit, '(2a)') line, ': no such call'
            error stop 1
        end select
        if (stat == rwedge_ok) then
            before = r
            write (*, '(*(a))') line, (bits(r(i)), i = 1, size(r))
        else
            write (*, '(2a)') line, ',error'
        end if
    end subroutine

    ! What stands after the commas.
    function arguments(line) result(v)
        character(*), intent(in) :: line
        type(numbers) :: v(14)
        integer :: i, from, to
        to = index(line // ',', ',')
        do i = 1, size(v)
            from = to + 1
            if (from > len(line)) exit
            to = from + index(line(from:) // ',', ',') - 1
            v(i)%x = numbers_of(line(from:to - 1))
            v(i)%xx = reshape(v(i)%x, [size(v(i)%x) / rows(line(from:to - 1)), rows(line(from:to - 1))])
        end do
    end function

    function rows(text)
        character(*), intent(in) :: text
        integer :: i, rows
        rows = 1 + count([(text(i:i) == ';', i = 1, len(text))])
    end function

    function numbers_of(text) result(x)
        character(*), intent(in) :: text
        real(c_double), allocatable :: x(:)
        character(len(text)) :: spaced
        integer :: i
        if (text == '@') then
            x = before
            return
        end if
        allocate (x(1 + count([(scan(text(i:i), ' ;') == 1, i = 1, len(text))])))
        spaced = text
        do i = 1, len(text)
            if (text(i:i) == ';') spaced(i:i) = ' '
        end do
        read (spaced, *) x
    end function

    function bits(value) result(text)
        real(c_double), intent(in) :: value
        character(:), allocatable :: text
        character(16) :: digits
        text = ',nan'
        if (ieee_is_nan(value)) return
        write (digits, '(z16.16)') transfer(value, 0_int64)
        text = ',' // digits
    end function
end program

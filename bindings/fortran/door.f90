! SPDX-License-Identifier: GPL-3.0-or-later
! Answers the calls of tests/doors/calls.sh from standard input as tests/doors/door.c does, through the module.
program door
    use rwedge
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
    use, intrinsic :: iso_fortran_env, only: error_unit, int64
    implicit none
    type(rwedge_contact) :: contact
    character(256) :: line
    integer :: iostat

    do
        read (*, '(a)', iostat=iostat) line
        if (iostat /= 0) exit
        call answer(trim(line))
    end do

contains

    subroutine answer(line)
        character(*), intent(in) :: line
        real(c_double), allocatable :: r(:)
        real(c_double) :: v(5), s(3, 1)
        integer :: i

        v = arguments(line)
        s = 0
        select case (line(:index(line // ',', ',') - 1))
        case ('compliance'); r = [rwedge_compliance(v(1), v(2), v(3), v(4))]
        case ('dundurs_beta'); r = [rwedge_dundurs_beta(v(1), v(2), v(3), v(4))]
        case ('load'); r = [rwedge_load(v(1))]
        case ('a_over_b'); r = [rwedge_a_over_b(v(1))]
        case ('pressure'); r = [rwedge_pressure(v(1), v(2))]
        case ('peak_pressure'); r = [rwedge_peak_pressure(v(1))]
        case ('transition_pressure'); r = [rwedge_transition_pressure(v(1))]
        case ('coefficient'); r = [rwedge_coefficient(v(1), int(v(2), c_int32_t))]
        case ('max_tension'); r = [rwedge_max_tension(v(1))]
        case ('stick_width'); r = [rwedge_stick_width(v(1), v(2))]
        case ('shear_ratio'); r = [rwedge_shear_ratio(v(1), v(2))]
        case ('shear'); r = [rwedge_shear(v(1), v(2), v(3))]
        case ('elastic_limit'); r = [rwedge_elastic_limit(v(1), v(2), v(3))]
        case ('critical_friction'); r = [rwedge_critical_friction(v(1), v(2))]
        case ('radius'); r = [rwedge_radius(v(1), v(2))]
        case ('rounding'); r = [rwedge_rounding(v(1), v(2))]
        case ('half_width'); r = [rwedge_half_width(v(1), v(2), v(3), v(4))]
        case ('normal_load'); r = [rwedge_normal_load(v(1), v(2), v(3), v(4))]
        case ('stress')
            call rwedge_stress(v(1), v(2), v(3), v(4), v(5), s(1, 1), s(2, 1), s(3, 1))
            r = s(:, 1)
        case ('yield_point')
            call rwedge_yield_point(v(1), v(2), v(3), s(1, 1), s(2, 1), s(3, 1))
            r = s(:, 1)
        case ('subsurface_yield')
            call rwedge_subsurface_yield(v(1), v(2), v(3), s(1, 1), s(2, 1), s(3, 1))
            r = s(:, 1)
        case ('surface_yield')
            call rwedge_surface_yield(v(1), v(2), v(3), s(1, 1), s(2, 1))
            r = s(:2, 1)
        case ('contact_create')
            call contact%create(v(1), v(2), v(3), v(4))
            r = s(:0, 1)
        case ('contact_load')
            call contact%load(v(1), v(2))
            r = s(:0, 1)
        case ('contact_half_width'); r = [contact%half_width()]
        case ('contact_stick_half_width'); r = [contact%stick_half_width()]
        case ('contact_dissipated_energy'); r = [contact%dissipated_energy()]
        case ('contact_tractions')
            call contact%tractions(v(1:1), s(1, :), s(2, :))
            r = s(:2, 1)
        case ('contact_stresses')
            call contact%stresses(v(1:1), v(2:2), s(1, :), s(2, :), s(3, :))
            r = s(:, 1)
        case ('contact_slip')
            call contact%slip(v(1:1), s(1, :))
            r = s(:1, 1)
        case ('contact_yield_factor')
            call contact%yield_factor(v(1), v(2), s(1, 1), s(2, 1), s(3, 1))
            r = s(:, 1)
        case default
            write (error_unit, '(2a)') line, ': no such call'
            error stop 1
        end select
        write (*, '(*(a))') line, (bits(r(i)), i = 1, size(r))
    end subroutine

    ! The numbers after the name.
    function arguments(line) result(v)
        character(*), intent(in) :: line
        real(c_double) :: v(5)
        integer :: i, from, to
        v = 0
        to = index(line // ',', ',')
        do i = 1, size(v)
            from = to + 1
            if (from > len(line)) exit
            to = from - 1 + index(line(from:) // ',', ',')
            read (line(from:to - 1), *) v(i)
        end do
    end function

    function bits(value) result(text)
        real(c_double), intent(in) :: value
        character(:), allocatable :: text
        character(16) :: digits
        integer :: i
        text = ',nan'
        if (ieee_is_nan(value)) return
        write (digits, '(z16.16)') transfer(value, 0_int64)
        do i = 1, len(digits) ! to lower case
            if (digits(i:i) > '9') digits(i:i) = achar(iachar(digits(i:i)) + 32)
        end do
        text = ',' // digits
    end function
end program

! SPDX-License-Identifier: GPL-3.0-or-later
! Answers the calls of tests/doors/calls.py from standard input as tests/doors/door.c does, through the module.
! Written by bindings/interface/generate.py from include/rwedge.h and door_template.f90: change those, not door.f90.
program door
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
        type(numbers) :: v(12)
        real(c_double), allocatable :: r(:), s(:, :, :)
        integer :: stat, i

        v = arguments(line)
        stat = rwedge_ok
        select case (line(:index(line, ':') - 1))
        case ('compliance')
            r = [rwedge_compliance(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))]
        case ('dundurs_beta')
            r = [rwedge_dundurs_beta(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))]
        case ('load')
            r = [rwedge_load(v(1)%x(1))]
        case ('a_over_b')
            r = [rwedge_a_over_b(v(1)%x(1))]
        case ('pressure')
            r = [rwedge_pressure(v(1)%x(1), v(2)%x(1))]
        case ('peak_pressure')
            r = [rwedge_peak_pressure(v(1)%x(1))]
        case ('transition_pressure')
            r = [rwedge_transition_pressure(v(1)%x(1))]
        case ('coefficient')
            r = [rwedge_coefficient(v(1)%x(1), int(v(2)%x(1), c_int32_t))]
        case ('stick_width')
            r = [rwedge_stick_width(v(1)%x(1), v(2)%x(1))]
        case ('shear_ratio')
            r = [rwedge_shear_ratio(v(1)%x(1), v(2)%x(1))]
        case ('shear')
            r = [rwedge_shear(v(1)%x(1), v(2)%x(1), v(3)%x(1))]
        case ('stress')
            allocate (s(1, 1, 3))
            call rwedge_stress(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1), v(5)%x(1), s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), stat)
            r = [s]
        case ('stresses')
            allocate (s(size(v(4)%x), 1, 3))
            call rwedge_stresses(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x, v(5)%x, s(:, 1, 1), s(:, 1, 2), s(:, 1, 3), stat)
            r = [s]
        case ('max_tension')
            r = [rwedge_max_tension(v(1)%x(1))]
        case ('elastic_limit')
            r = [rwedge_elastic_limit(v(1)%x(1), v(2)%x(1), v(3)%x(1))]
        case ('elastic_limits')
            allocate (s(size(v(1)%x), 1, 1))
            call rwedge_elastic_limits(v(1)%x, v(2)%x, v(3)%x(1), s(:, 1, 1), stat)
            r = [s]
        case ('yield_point')
            allocate (s(1, 1, 3))
            call rwedge_yield_point(v(1)%x(1), v(2)%x(1), v(3)%x(1), s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), stat)
            r = [s]
        case ('subsurface_yield')
            allocate (s(1, 1, 3))
            call rwedge_subsurface_yield(v(1)%x(1), v(2)%x(1), v(3)%x(1), s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), stat)
            r = [s]
        case ('surface_yield')
            allocate (s(1, 1, 2))
            call rwedge_surface_yield(v(1)%x(1), v(2)%x(1), v(3)%x(1), s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('critical_friction')
            r = [rwedge_critical_friction(v(1)%x(1), v(2)%x(1))]
        case ('validity')
            r = [real(rwedge_validity(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1), v(5)%x(1), v(6)%x(1)), c_double)]
        case ('validity_text')
            r = [real(len(rwedge_validity_text(int(v(1)%x(1), c_int32_t))), c_double)]
        case ('radius')
            r = [rwedge_radius(v(1)%x(1), v(2)%x(1))]
        case ('rounding')
            r = [rwedge_rounding(v(1)%x(1), v(2)%x(1))]
        case ('half_width')
            r = [rwedge_half_width(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))]
        case ('normal_load')
            r = [rwedge_normal_load(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))]
        case ('yield_load')
            r = [rwedge_yield_load(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1), v(5)%x(1), v(6)%x(1))]
        case ('contact_create')
            call contact%create(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1), stat)
            r = [real(c_double) ::]
        case ('contact_set_strain')
            call contact%set_strain(v(1)%x(1), stat)
            r = [real(c_double) ::]
        case ('contact_copy')
            call other%copy(contact, stat)
            contact = other
            r = [real(c_double) ::]
        case ('contact_load')
            call contact%load(v(1)%x(1), v(2)%x(1), stat)
            r = [real(c_double) ::]
        case ('contact_apply')
            call contact%apply(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1), stat)
            r = [real(c_double) ::]
        case ('contact_obstacle')
            r = [real(len(contact%obstacle(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))), c_double)]
        case ('contact_largest_tension_step')
            r = [contact%largest_tension_step(v(1)%x(1))]
        case ('contact_loads')
            allocate (s(1, 1, 4))
            call contact%loads(s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), s(1, 1, 4), stat)
            r = [s]
        case ('contact_edges')
            allocate (s(1, 1, 2))
            call contact%edges(s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('contact_stick_zone')
            allocate (s(1, 1, 2))
            call contact%stick_zone(s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('contact_tilt')
            r = [contact%tilt()]
        case ('contact_edge_asymptotes')
            allocate (s(1, 1, 4))
            call contact%edge_asymptotes(s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), s(1, 1, 4), stat)
            r = [s]
        case ('permanent_stick')
            allocate (s(1, 1, 2))
            call rwedge_permanent_stick(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1), v(5)%x(1), v(6)%x(1), v(7)%x(1), &
                v(8)%x(1), v(9)%x(1), v(10)%x(1), v(11)%x(1), v(12)%x(1), s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('contact_half_width')
            r = [contact%half_width()]
        case ('contact_stick_half_width')
            r = [contact%stick_half_width()]
        case ('contact_memory')
            r = [real(contact%memory(), c_double)]
        case ('contact_tractions')
            allocate (s(size(v(1)%x), 1, 2))
            call contact%tractions(v(1)%x, s(:, 1, 1), s(:, 1, 2), stat)
            r = [s]
        case ('contact_stresses')
            allocate (s(size(v(1)%x), 1, 3))
            call contact%stresses(v(1)%x, v(2)%x, s(:, 1, 1), s(:, 1, 2), s(:, 1, 3), stat)
            r = [s]
        case ('contact_stress_history')
            allocate (s(size(v(5)%x), size(v(1)%x), 3))
            call contact%stress_history(v(1)%x, v(2)%x, v(3)%x, v(4)%x, v(5)%x, v(6)%x, s(:, :, 1), s(:, :, 2), s(:, :, 3), &
                stat)
            r = [s]
        case ('contact_state_size')
            r = [real(contact%state_size(), c_double)]
        case ('contact_state')
            allocate (s(int(contact%state_size()), 1, 1))
            call contact%state(s(:, 1, 1), stat)
            r = [s]
        case ('contact_restore')
            call contact%restore(v(1)%x, stat)
            r = [real(c_double) ::]
        case ('contact_slip')
            allocate (s(size(v(1)%x), 1, 1))
            call contact%slip(v(1)%x, s(:, 1, 1), stat)
            r = [s]
        case ('contact_dissipated_energy')
            r = [contact%dissipated_energy()]
        case ('contact_yield_factor')
            allocate (s(1, 1, 3))
            call contact%yield_factor(v(1)%x(1), v(2)%x(1), s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), stat)
            r = [s]
        case ('contact_cycle_fatigue')
            allocate (s(size(v(5)%x), 1, 5))
            call contact%cycle_fatigue(v(1)%x, v(2)%x, v(3)%x, v(4)%x, v(5)%x, v(6)%x, v(7)%x(1), v(8)%x(1), v(9)%x(1), s(:, &
                1, 1), s(:, 1, 2), s(:, 1, 3), s(:, 1, 4), s(:, 1, 5), stat)
            r = [s]
        case ('contact_cycle_friction')
            allocate (s(size(v(5)%x), 1, 4))
            call contact%cycle_friction(v(1)%x, v(2)%x, v(3)%x, v(4)%x, v(5)%x, s(:, 1, 1), s(:, 1, 2), s(:, 1, 3), s(:, 1, &
                4), stat)
            r = [s]
        case ('contact_cycle_worst')
            allocate (s(1, 1, 2))
            call contact%cycle_worst(int(v(1)%x(1), c_int32_t), v(2)%x, v(3)%x, v(4)%x, v(5)%x, v(6)%x, v(7)%x, v(8)%x(1), &
                v(9)%x(1), v(10)%x(1), v(11)%x(1), s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('contact_displacement')
            r = [contact%displacement(v(1)%x(1))]
        case ('von_mises')
            r = [rwedge_von_mises(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))]
        case ('out_of_plane_stress')
            r = [rwedge_out_of_plane_stress(v(1)%x(1), v(2)%x(1), v(3)%x(1))]
        case ('largest_shear')
            r = [rwedge_largest_shear(v(1)%x(1), v(2)%x(1), v(3)%x(1), v(4)%x(1))]
        case ('principal_stresses')
            allocate (s(1, 1, 3))
            call rwedge_principal_stresses(v(1)%x(1), v(2)%x(1), v(3)%x(1), s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), stat)
            r = [s]
        case ('smith_watson_topper')
            allocate (s(1, 1, 2))
            call rwedge_smith_watson_topper(v(1)%x, v(2)%x, v(3)%x, v(4)%x(1), v(5)%x(1), s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('smith_watson_topper_field')
            allocate (s(size(v(3)%xx, 1), 1, 2))
            call rwedge_smith_watson_topper_field(v(1)%xx, v(2)%xx, v(3)%xx, v(4)%x(1), v(5)%x(1), s(:, 1, 1), s(:, 1, 2), stat)
            r = [s]
        case ('fatemi_socie')
            allocate (s(1, 1, 2))
            call rwedge_fatemi_socie(v(1)%x, v(2)%x, v(3)%x, v(4)%x(1), v(5)%x(1), v(6)%x(1), s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('fatemi_socie_field')
            allocate (s(size(v(3)%xx, 1), 1, 2))
            call rwedge_fatemi_socie_field(v(1)%xx, v(2)%xx, v(3)%xx, v(4)%x(1), v(5)%x(1), v(6)%x(1), s(:, 1, 1), s(:, 1, &
                2), stat)
            r = [s]
        case ('series_create')
            call series%create(v(1)%x(1), int(v(2)%x(1), c_int32_t), stat)
            r = [real(c_double) ::]
        case ('series_fit')
            call series%fit(v(1)%x, v(2)%x, int(v(3)%x(1), c_int32_t), stat)
            r = [real(c_double) ::]
        case ('series_terms')
            r = [real(series%terms(), c_double)]
        case ('series_coefficient')
            r = [series%coefficient(int(v(1)%x(1), c_int32_t))]
        case ('series_residual')
            r = [series%residual()]
        case ('series_pressure')
            r = [series%pressure(v(1)%x(1))]
        case ('series_potential')
            allocate (s(1, 1, 2))
            call series%potential(v(1)%x(1), v(2)%x(1), v(3)%x(1), s(1, 1, 1), s(1, 1, 2), stat)
            r = [s]
        case ('series_stress')
            allocate (s(1, 1, 3))
            call series%stress(v(1)%x(1), v(2)%x(1), v(3)%x(1), s(1, 1, 1), s(1, 1, 2), s(1, 1, 3), stat)
            r = [s]
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
        type(numbers) :: v(12)
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

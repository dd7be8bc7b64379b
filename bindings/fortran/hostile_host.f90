! SPDX-License-Identifier: GPL-3.0-or-later
! A host that has made the processor trap on invalid operations, division by zero and overflow (gfortran
! -ffpe-trap=invalid,zero,overflow) calls every function with arguments from one edge of double precision to the other, valid or
! not. It numbers its calls and says each on standard output before it makes it, so that the last line names the one that
! trapped; and it looks after each whether the modes of the processor are as before.
!     hostile_host [NUMBER...]    does not make the calls of these numbers, to go on after a trap; 0 makes a trap of its own
program hostile_host
    use rwedge
    use, intrinsic :: ieee_arithmetic
    use, intrinsic :: ieee_exceptions
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    use, intrinsic :: iso_fortran_env, only: error_unit
    implicit none
    type(ieee_flag_type), parameter :: trapping(3) = [ieee_invalid, ieee_divide_by_zero, ieee_overflow]
    real(c_double) :: edges(33), some(11)
    integer, allocatable :: left_out(:)
    integer :: number = 0, i, j, k, l

    left_out = [(number_argument(i), i = 1, command_argument_count())]
    edges(:30) = [0.0_c_double, tiny(1.0_c_double), 1e-310_c_double, 1e-200_c_double, 1e-120_c_double, 1e-60_c_double, &
        1e-16_c_double, 1e-14_c_double, 3e-9_c_double, 1e-6_c_double, 1e-3_c_double, 0.01_c_double, 0.25_c_double, &
        0.3_c_double, 0.5_c_double, 1 - epsilon(1.0_c_double), 1.0_c_double, 1 + epsilon(1.0_c_double), 1.5_c_double, &
        2.0_c_double, 100.0_c_double, 1e6_c_double, 1e10_c_double, 1e160_c_double, huge(1.0_c_double), -1e-300_c_double, &
        -0.3_c_double, &
        -1.0_c_double, -1e9_c_double, -huge(1.0_c_double)]
    edges(31) = ieee_value(1.0_c_double, ieee_quiet_nan)
    edges(32) = ieee_value(1.0_c_double, ieee_positive_inf)
    edges(33) = ieee_value(1.0_c_double, ieee_negative_inf)
    some = edges([1, 3, 9, 13, 15, 17, 21, 25, 28, 31, 32])

    if (any(left_out == 0)) edges(1) = 1 / edges(1)
    do i = 1, size(edges)
        call one_number(edges(i))
        do j = 1, size(edges)
            call two_numbers(edges(i), edges(j))
        end do
    end do
    do i = 1, size(some)
        do j = 1, size(some)
            do k = 1, size(some)
                call three_numbers(some(i), some(j), some(k))
                do l = 1, size(some)
                    call four_numbers(some(i), some(j), some(k), some(l))
                end do
            end do
        end do
    end do
    call a_contact(0.01_c_double, 0.5_c_double)
    call a_contact(0.01_c_double, 0.0_c_double)
    call a_series()
    write (*, '(a)') 'all calls made'

contains

    function number_argument(i) result(value)
        integer, intent(in) :: i
        integer :: value
        character(16) :: argument
        call get_command_argument(i, argument)
        read (argument, *) value
    end function

    ! Whether to make this call; says it before.
    function making(name, values) result(yes)
        character(*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        logical :: yes
        number = number + 1
        yes = all(left_out /= number)
        if (.not. yes) return
        write (*, '(i0, 1x, a, *(1x, g0))') number, name, values
        flush (6)
    end function

    ! The processor is as it was.
    subroutine look()
        logical :: halting(3)
        type(ieee_round_type) :: rounding
        call ieee_get_halting_mode(trapping, halting)
        call ieee_get_rounding_mode(rounding)
        if (all(halting) .and. rounding == ieee_nearest) return
        write (error_unit, '(a, i0)') 'changed the modes of its host: call ', number
        error stop 2
    end subroutine

    subroutine one_number(u)
        real(c_double), intent(in) :: u
        real(c_double) :: value
        if (making('load', [u])) value = rwedge_load(u)
        if (making('a_over_b', [u])) value = rwedge_a_over_b(u)
        if (making('peak_pressure', [u])) value = rwedge_peak_pressure(u)
        if (making('transition_pressure', [u])) value = rwedge_transition_pressure(u)
        if (making('max_tension', [u])) value = rwedge_max_tension(u)
        if (making('coefficient 0', [u])) value = rwedge_coefficient(u, 0_c_int32_t)
        if (making('coefficient 7', [u])) value = rwedge_coefficient(u, 7_c_int32_t)
        if (making('coefficient 10^9', [u])) value = rwedge_coefficient(u, 1000000000_c_int32_t)
        if (making('coefficient -1', [u])) value = rwedge_coefficient(u, -1_c_int32_t)
        call look()
    end subroutine

    subroutine two_numbers(u, v)
        real(c_double), intent(in) :: u, v
        real(c_double) :: value
        if (making('pressure', [u, v])) value = rwedge_pressure(u, v)
        if (making('stick_width', [u, v])) value = rwedge_stick_width(u, v)
        if (making('shear_ratio', [u, v])) value = rwedge_shear_ratio(u, v)
        if (making('critical_friction', [u, v])) value = rwedge_critical_friction(u, v)
        if (making('radius', [u, v])) value = rwedge_radius(u, v)
        if (making('rounding', [u, v])) value = rwedge_rounding(u, v)
        call look()
    end subroutine

    subroutine three_numbers(u, v, w)
        real(c_double), intent(in) :: u, v, w
        real(c_double) :: value, limit, x, y
        integer :: stat
        if (making('shear', [u, v, w])) value = rwedge_shear(u, v, w)
        if (making('elastic_limit', [u, v, w])) value = rwedge_elastic_limit(u, v, w)
        if (making('yield_point', [u, v, w])) call rwedge_yield_point(u, v, w, limit, x, y, stat)
        if (making('subsurface_yield', [u, v, w])) call rwedge_subsurface_yield(u, v, w, limit, x, y, stat)
        if (making('surface_yield', [u, v, w])) call rwedge_surface_yield(u, v, w, limit, x, stat)
        call look()
    end subroutine

    subroutine four_numbers(u, v, w, s)
        real(c_double), intent(in) :: u, v, w, s
        real(c_double) :: value, sxx, syy, txy
        type(rwedge_contact) :: contact
        integer :: stat
        if (making('compliance', [u, v, w, s])) value = rwedge_compliance(u, v, w, s)
        if (making('dundurs_beta', [u, v, w, s])) value = rwedge_dundurs_beta(u, v, w, s)
        if (making('half_width', [u, v, w, s])) value = rwedge_half_width(u, v, w, s)
        if (making('normal_load', [u, v, w, s])) value = rwedge_normal_load(u, v, w, s)
        if (making('yield_load', [u, v, w, s])) value = rwedge_yield_load(u, v, w, 0.3_c_double, 0.3_c_double, s)
        if (making('stress, f = 0.5', [u, v, w, s])) call rwedge_stress(u, 0.5_c_double, v, w, s, sxx, syy, txy, stat)
        if (making('stress, c = 0', [u, v, w, s])) call rwedge_stress(u, v, 0.0_c_double, w, s, sxx, syy, txy, stat)
        if (making('contact_create', [u, v, w, s])) call contact%create(u, v, w, s, stat)
        call look()
    end subroutine

    ! A history, every load of it and every place, valid or not.
    subroutine a_contact(theta, a)
        real(c_double), intent(in) :: theta, a
        real(c_double), parameter :: Q_over_P(*) = [0.0_c_double, 0.3_c_double, -0.4_c_double, 0.55_c_double, 0.6_c_double, &
            -0.6_c_double]
        type(rwedge_contact) :: contact
        integer :: m, n
        call contact%create(theta, a, 1.8e-5_c_double, 0.6_c_double)
        do m = 1, size(edges)
            do n = 1, size(Q_over_P)
                if (m <= 24) call one_load(contact, edges(m), Q_over_P(n) * edges(m)) ! the 24 that are loads
            end do
            do n = 1, size(edges)
                call one_load(contact, edges(m), edges(n))
            end do
        end do
    end subroutine

    subroutine one_load(contact, P, Q)
        type(rwedge_contact), intent(inout) :: contact
        real(c_double), intent(in) :: P, Q
        real(c_double) :: factor, x(1), y(1), s(3, 1)
        integer :: stat, n
        if (making('contact%load', [P, Q])) call contact%load(P, Q, stat)
        do n = 1, size(some)
            x = some(n)
            y = abs(some(n))
            if (n <= 7) x = x * contact%half_width() ! the 7 from 0 to 100
            if (making('contact%tractions', x)) call contact%tractions(x, s(1, :), s(2, :), stat)
            if (making('contact%slip', x)) call contact%slip(x, s(1, :), stat)
            if (making('contact%stresses', [x, y])) call contact%stresses(x, y, s(1, :), s(2, :), s(3, :), stat)
        end do
        if (making('contact%yield_factor', [contact%half_width()])) &
            call contact%yield_factor(0.3_c_double, 300.0_c_double, factor, stat=stat)
        call look()
    end subroutine

    subroutine a_series()
        type(rwedge_series) :: series
        real(c_double) :: value, s(3)
        integer :: stat, m, n
        call series%create(0.3_c_double, 51_c_int32_t)
        do m = 1, size(edges)
            if (making('series%pressure', [edges(m)])) value = series%pressure(edges(m))
            do n = 1, size(edges)
                if (making('series%potential', [edges(m), edges(n)])) &
                    call series%potential(0.5_c_double, edges(m), edges(n), s(1), s(2), stat)
                if (making('series%stress', [edges(m), edges(n)])) &
                    call series%stress(0.5_c_double, edges(m), edges(n), s(1), s(2), s(3), stat)
            end do
            if (making('series%create', [edges(m)])) call series%create(edges(m), 51_c_int32_t, stat)
            if (stat /= rwedge_ok .or. m == 1) call series%create(0.3_c_double, 51_c_int32_t)
        end do
        call look()
    end subroutine
end program

! SPDX-License-Identifier: GPL-3.0-or-later
! The module as its users meet it: errors, arrays, and the life of objects. test.sh builds it with a sanitizer, which finds what is
! never freed and what is freed twice. With the argument "threads" it is about OpenMP, whose private objects gfortran never frees;
! with "stop" it makes an error without stat, which must end it.
program test_module
    use rwedge
    use, intrinsic :: ieee_arithmetic
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    implicit none

    type :: specimen
        type(rwedge_contact) :: pad
        type(rwedge_contact), allocatable :: others(:) ! not of fixed size: README.md
    end type

    integer :: failures = 0
    character(8) :: part = ''

    if (command_argument_count() > 0) call get_command_argument(1, part)
    select case (part)
    case ('stop')
        call without_stat()
    case ('threads')
        call threads()
    case default
        call formulas()
        call arrays()
        call contacts()
        call points()
        call a_cycle()
        call several_series()
        call copies()
        call overlapping()
    end select
    if (failures > 0) error stop 1

contains

    subroutine claim(sentence, holds)
        character(*), intent(in) :: sentence
        logical, intent(in) :: holds
        if (holds) return
        write (*, '(2a)') 'FAILED: ', sentence
        failures = failures + 1
    end subroutine

    ! The message of an error: how it begins, what stands in it, and the status.
    subroutine says(errmsg, begin, words, stat, status)
        character(*), intent(in) :: errmsg, begin, words
        integer, intent(in) :: stat, status
        call claim(trim(errmsg) // ' has ' // words, stat == status .and. index(errmsg, begin) == 1 .and. index(errmsg, words) > 0)
    end subroutine

    function loaded(thousands) result(contact)
        real(c_double), intent(in) :: thousands
        type(rwedge_contact), pointer :: contact
        allocate (contact)
        call contact%create(0.01d0, 0.5d0, 1.8d-5, 0.6d0)
        call contact%load(1000 * thousands, 0d0)
    end function

    subroutine without_stat()
        real(c_double) :: sxx, syy, txy
        call rwedge_stress(0.25d0, 0.3d0, 0d0, 0d0, -1d0, sxx, syy, txy)
    end subroutine

    subroutine formulas()
        real(c_double) :: s(3), limit, nan
        integer :: stat
        character(400) :: errmsg
        nan = ieee_value(nan, ieee_quiet_nan)
        call claim('the version has two points', index(rwedge_version(), '.') < index(rwedge_version(), '.', back=.true.))
        call claim('a status has its text', rwedge_error_text(rwedge_edomain) == 'an argument is outside its domain')
        call claim('NaN gives NaN', ieee_is_nan(rwedge_load(nan)) .and. ieee_is_nan(rwedge_elastic_limit(0.3d0, nan, nan)))
        s = 5
        errmsg = 'as it was'
        call rwedge_yield_point(0.25d0, 0.3d0, 0.3d0, limit, s(1), s(2), stat, errmsg)
        call claim('no error, no message', stat == rwedge_ok .and. errmsg == 'as it was')
        s = 5
        call rwedge_stress(0.25d0, 0.3d0, 0d0, 0d0, -1d0, s(1), s(2), s(3), stat, errmsg)
        call claim('outputs are as they were', all(s == 5))
        call says(errmsg, 'rwedge_stress(alpha, f, c, x, y): an argument is outside its domain: alpha = 0.25', ', y = -1.0', &
            stat, rwedge_edomain)
        call says(errmsg, '', '; allowed is alpha 0, or 1e-60 to 1e60', stat, rwedge_edomain)
        call rwedge_surface_yield(0.25d0, 0d0, 0.5d0, limit, s(1), stat)
        call claim('absent', stat == rwedge_eabsent)
    end subroutine

    subroutine arrays()
        real(c_double) :: alpha(3, 4), sxx(3, 4), syy(3, 4), txy(3, 4), one(3), x(12), y(12), all_sxx(24), row(12), column(12)
        integer :: i, stat(3, 4), first
        character(400) :: errmsg
        alpha = reshape([(0.1d0 * i, i = 1, 12)], [3, 4])
        alpha(2, 3) = -1
        call rwedge_stress(alpha, 0.3d0, 0.5d0, 0.2d0, 0.4d0, sxx, syy, txy, stat)
        call claim('a status per element', stat(2, 3) == rwedge_edomain .and. count(stat == rwedge_ok) == 11)
        call rwedge_stress(alpha(3, 4), 0.3d0, 0.5d0, 0.2d0, 0.4d0, one(1), one(2), one(3))
        call claim('a stress per element', all([sxx(3, 4), syy(3, 4), txy(3, 4)] == one))
        x = [(0.1d0 * i - 0.5d0, i = 1, 12)]
        y = 0.3d0
        all_sxx = 5
        call rwedge_stresses(0.3d0, 0.5d0, 0.2d0, x, y, all_sxx(1::2), row, column)
        call rwedge_stress(0.3d0, 0.5d0, 0.2d0, x(7), y(7), one(1), one(2), one(3))
        call claim('every second element', all_sxx(13) == one(1) .and. row(7) == one(2) .and. all(all_sxx(2::2) == 5))
        row = 5
        call rwedge_elastic_limits([0.1d0, 0.25d0], [0.1d0, -0.5d0], 0.3d0, row(:2), first, errmsg)
        call claim('none is written', all(row == 5))
        call says(errmsg, 'rwedge_elastic_limits(alpha, f, nu), element 2: an argument', ': alpha = 0.25', first, rwedge_edomain)
        call rwedge_elastic_limits(row(:0), row(:0), 0.6d0, row(:0), first, errmsg)
        call says(errmsg, 'rwedge_elastic_limits', '0 <= nu <= 0.5', first, rwedge_edomain)
    end subroutine

    subroutine contacts()
        type(rwedge_contact) :: contact
        real(c_double) :: limit
        integer :: stat
        character(400) :: errmsg
        call contact%load(1d0, 0d0, stat, errmsg)
        call says(errmsg, 'rwedge_contact%load(P, Q): ', 'create it first', stat, rwedge_enull)
        call claim('not created, half-width', ieee_is_nan(contact%half_width()) .and. contact%memory() == 0)
        call contact%create_profile([0d0, 1d0], [0.1d0, 0d0], 1d-4, 0.5d0, stat)
        call claim('a profile that is not convex', stat == rwedge_edomain)
        call contact%create(0.02d0, 0.5d0, 1.8d-5, 0.6d0)
        call contact%create(0.01d0, 0.5d0, 1.8d-5, 0.6d0) ! frees the first
        call contact%yield_factor(0.3d0, 300d0, limit, stat=stat)
        call claim('separated', stat == rwedge_eabsent)
        call contact%load(1000d0, 300d0)
        call contact%load(1000d0, 601d0, stat, errmsg)
        call says(errmsg, 'rwedge_contact%load(P, Q): ', 'exceeds friction times the normal force: P = 1000.', stat, &
            rwedge_esliding)
        call says(errmsg, '', '|Q| <= f P', stat, rwedge_esliding)
        call contact%load(1d308, 0d0, stat, errmsg)
        call says(errmsg, '', 'allowed is P 0, or 1e-60 to 1e60', stat, rwedge_edomain)
        call contact%load(0d0, 0d0)
        call contact%apply(1000d0, 100d0, 0d0, 0d0)
        call contact%apply(1000d0, 100d0, 0d0, 500d0, stat, errmsg)
        call says(errmsg, '', 'the two edges would slip in opposite directions', stat, rwedge_epath)
    end subroutine

    subroutine points()
        type(rwedge_contact), pointer :: contact
        real(c_double) :: p(2), q(2), x(2, 3), grid_p(2, 3), grid_q(2, 3), list_p(6), list_q(6)
        integer :: stat
        character(400) :: errmsg
        contact => loaded(1d0)
        p = 5
        call contact%tractions([0d0, ieee_value(p(1), ieee_quiet_nan)], p, q, stat, errmsg)
        call claim('no tractions are written', all(p == 5))
        call says(errmsg, 'rwedge_contact%tractions(x), element 2', 'NaN; allowed is x 0, or 1e-60 to 1e60 in magnitude', stat, &
            rwedge_edomain)
        call contact%tractions([0d0], p, q, stat, errmsg)
        call says(errmsg, '', '; arrays of one size', stat, rwedge_erange)
        call contact%slip([0d0, 50d0], p, stat, errmsg)
        call says(errmsg, 'rwedge_contact%slip(x), element 2: an argument', '|x| <= b', stat, rwedge_edomain)
        x = reshape([-0.4d0, -0.2d0, 0d0, 0.1d0, 0.2d0, 0.3d0], [2, 3])
        call contact%tractions(x, grid_p, grid_q, stat)
        call contact%tractions([x], list_p, list_q)
        call claim('a grid is its points', stat == rwedge_ok .and. all([grid_p] == list_p) .and. all([grid_q] == list_q))
        call contact%tractions(x, grid_p(:, 1:2), grid_q, stat, errmsg)
        call says(errmsg, '', 'arrays of one shape', stat, rwedge_erange)
        deallocate (contact)
    end subroutine

    subroutine a_cycle()
        type(rwedge_contact) :: pad
        type(rwedge_cycle) :: cycle, shared
        real(c_double) :: left, right, l, r
        real(c_double), dimension(2) :: slip, f1, f2, energy
        integer :: stat
        call pad%create(0.01d0, 2d0, 1.82d-5, 0.3d0)
        call pad%load(2000d0, 0d0)
        call pad%load(2000d0, 300d0)
        call cycle%create(pad, [2000d0, 2000d0], [0d0, 0d0], [-300d0, 300d0], [0d0, 0d0])
        shared = cycle
        call cycle%destroy()
        call pad%permanent_stick(2000d0, 0d0, -300d0, 0d0, 2000d0, 0d0, 300d0, 0d0, l, r)
        call shared%friction([0d0, 0.99d0 * pad%half_width()], slip, f1, f2, energy)
        call pad%destroy()
        call shared%permanent_stick(left, right)
        call claim('a cycle lives on', shared%loads() == 2 .and. cycle%loads() == 0)
        call claim('what never slips', abs(left - l) < 1d-12 .and. abs(right - r) < 1d-12)
        call claim('the edge slips', .not. slip(1) > 0 .and. slip(2) > 0)
        call cycle%permanent_stick(left, right, stat)
        call claim('no cycle', stat == rwedge_enull)
    end subroutine

    subroutine several_series()
        type(rwedge_series) :: series, shared
        integer :: stat
        character(400) :: errmsg
        call series%create(0.25d0, 0_c_int32_t, stat, errmsg)
        call says(errmsg, '', '1 <= terms <= 2^24', stat, rwedge_erange)
        call series%fit([0.1d0, 0.2d0, 1.5d0], [1d0, 1d0, 1d0], 2_c_int32_t, stat, errmsg)
        call says(errmsg, 'rwedge_series%fit(x, p), element 3', '1.5', stat, rwedge_edomain)
        call series%fit([0.1d0, 0.2d0], [1d0, 1d0], 3_c_int32_t, stat, errmsg) ! said "size(x = 2" once
        call says(errmsg, '', ': size(x) = 2.00000000000000, terms = 3.', stat, rwedge_erank)
        call series%fit([0.1d0, 0.2d0], [1d0], 1_c_int32_t, stat, errmsg)
        call says(errmsg, '', 'arrays of one size', stat, rwedge_erange)
        call series%fit([0.1d0, 0.1d0, 0.1d0], [1d0, 1d0, 1d0], 3_c_int32_t, stat)
        call claim('rank', stat == rwedge_erank)
        call series%create(0.3d0, 5_c_int32_t)
        series = series
        shared = series
        call series%destroy()
        call claim('shared lives on', shared%terms() == 5 .and. series%terms() == 0)
    end subroutine

    ! Copies by assignment are independent; those that a compiler makes byte by byte are noticed.
    subroutine copies()
        type(rwedge_contact), pointer :: contact
        type(rwedge_contact) :: freed, empty
        type(rwedge_contact), allocatable :: several(:), sourced
        type(specimen) :: one, other
        integer :: stat
        contact => loaded(1d0)
        contact = contact
        freed = contact
        freed = empty
        call freed%destroy()
        allocate (several(4))
        several = contact
        one%pad = contact
        allocate (one%others(2))
        one%others = contact
        other%pad = one%pad ! not other = one: README.md
        call one%pad%load(2000d0, 0d0)
        call claim('copies are independent', has(several, [1, 1, 1, 1]) .and. has(one%others, [1, 1]) .and. &
            other%pad%half_width() == contact%half_width() .and. one%pad%half_width() > contact%half_width())
        allocate (sourced, source=contact)
        call sourced%load(3000d0, 0d0, stat)
        call claim('a contact by SOURCE= is none', stat == rwedge_enull .and. ieee_is_nan(sourced%half_width()))
        deallocate (contact)
    end subroutine

    ! Parts of an array go to other places of it: as if all at the right were copied first.
    subroutine overlapping()
        type(rwedge_contact), pointer :: pad
        type(rwedge_contact), allocatable :: pads(:), grid(:, :)
        type(rwedge_series), allocatable :: series(:)
        integer :: k
        allocate (pads(3), grid(2, 2), series(3))
        do k = 1, 3
            pad => loaded(real(k, c_double))
            pads(k) = pad
            deallocate (pad)
            call series(k)%create(0.25d0, 10 * k)
        end do
        pads(2:3) = pads([3, 2])
        call claim('by its indices', has(pads, [1, 3, 2]))
        pads(2:3) = pads(1:2)
        call claim('a part moved up', has(pads, [1, 1, 3]))
        pads = pads(3:1:-1)
        call claim('an array reversed', has(pads, [3, 1, 1]))
        grid(:, 1) = pads(1)
        grid(:, 2) = pads(3)
        grid = grid(:, 2:1:-1)
        call claim('a grid', has(grid(:, 1), [1, 1]) .and. has(grid(:, 2), [3, 3]))
        series(2:3) = series(1:2)
        call claim('series', all([(series(k)%terms(), k = 1, 3)] == [10, 10, 20]))
    end subroutine

    logical function has(pads, thousands)
        type(rwedge_contact), intent(in) :: pads(:)
        integer, intent(in) :: thousands(:)
        integer :: k
        has = .true.
        do k = 1, size(pads)
            has = has .and. pads(k)%half_width() == rwedge_half_width(0.01d0, 0.5d0, 1.8d-5, 1000d0 * thousands(k))
        end do
    end function

    ! private(c) is assigned a contact; firstprivate(c) makes a copy byte by byte, which is none until it is assigned one.
    subroutine threads()
        type(rwedge_contact) :: base, c
        type(rwedge_series) :: pressure, s
        real(c_double) :: b(8)
        integer :: i, stat, refused
        call base%create(0.01d0, 0.5d0, 1.8d-5, 0.6d0)
        !$omp parallel do private(c, stat) num_threads(4)
        do i = 1, 8
            c = base
            call c%load(2000d0 + i, 100d0, stat)
            b(i) = c%half_width()
        end do
        call claim('private: each its own', all([(b(i) == rwedge_half_width(0.01d0, 0.5d0, 1.8d-5, 2000d0 + i), i = 1, 8)]))
        refused = 0
        c = base
        !$omp parallel do firstprivate(c) private(stat) reduction(+:refused) num_threads(4)
        do i = 1, 8
            call c%load(3000d0, 0d0, stat)
            if (stat == rwedge_enull) refused = refused + 1
            c = base
            call c%load(3000d0, 0d0, stat)
            if (stat == rwedge_ok) refused = refused + 1
        end do
        call claim('firstprivate is no contact, until it is assigned one', refused > 8)
        call claim('the base is as it was', base%half_width() == 0 .and. c%half_width() == 0)
        ! series share what they are made of, counted across threads
        call pressure%create(0.25d0, 60)
        refused = 0
        s = pressure
        !$omp parallel do firstprivate(s) reduction(+:refused) num_threads(4)
        do i = 1, 400
            if (s%terms() == 0 .and. s%residual() /= s%residual()) refused = refused + 1
            s = pressure
            if (s%terms() == 60) refused = refused + 1
        end do
        call claim('a firstprivate series is none, until it is assigned one', refused > 400)
    end subroutine
end program

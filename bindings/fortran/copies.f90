! SPDX-License-Identifier: GPL-3.0-or-later
! Copies that a compiler makes byte by byte, as OpenMP's private and firstprivate and SOURCE= do, are noticed: they are used by
! error or by assignment, never freed twice. Grids of points. What a message names.
program copies
    use rwedge
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
    implicit none
    type(rwedge_contact) :: base, c
    type(rwedge_contact), allocatable :: sourced
    type(rwedge_series) :: pressure, s
    type(rwedge_series), allocatable :: sourced_series
    character(400) :: text
    integer :: i, stat, refused, failures
    real(c_double) :: b(8), x(2, 3), p(2, 3), q(2, 3), list_p(6), list_q(6)

    failures = 0
    call base%create(0.01d0, 0.5d0, 1.8d-5, 0.6d0)
    call base%load(2000d0, 0d0)

    !$omp parallel do private(c, stat) num_threads(4)
    do i = 1, 8
        c = base
        call c%load(2000d0 + i, 100d0, stat)
        b(i) = c%half_width()
    end do
    do i = 1, 8
        call claim('private: each its own', abs(b(i) - rwedge_half_width(0.01d0, 0.5d0, 1.8d-5, 2000d0 + i)) <= 0)
    end do

    refused = 0
    c = base
    !$omp parallel do firstprivate(c) private(stat) reduction(+:refused) num_threads(4)
    do i = 1, 8
        call c%load(3000d0, 0d0, stat)
        if (stat == rwedge_enull .and. c%half_width() /= c%half_width()) refused = refused + 1
        c = base
        call c%load(3000d0, 0d0, stat)
        if (stat == rwedge_ok) refused = refused + 1
    end do
    call claim('firstprivate is no contact, until it is assigned one', refused > 8)
    call claim('the base is as it was', abs(base%half_width() - c%half_width()) <= 0)

    allocate (sourced, source=base)
    call sourced%load(3000d0, 0d0, stat)
    text = sourced%obstacle(1d0, 0d0, 0d0, 0d0)
    call claim('a contact by SOURCE= is none', stat == rwedge_enull .and. text == '')
    deallocate (sourced)

    ! series share what they are made of, counted across threads
    call pressure%create(0.25d0, 60)
    !$omp parallel do private(s) num_threads(4)
    do i = 1, 8
        s = pressure
        b(i) = s%pressure(0.1d0 * i)
    end do
    do i = 1, 8
        call claim('a private series', abs(b(i) - pressure%pressure(0.1d0 * i)) <= 0)
    end do
    refused = 0
    s = pressure
    !$omp parallel do firstprivate(s) reduction(+:refused) num_threads(4)
    do i = 1, 400
        if (s%terms() == 0 .and. s%residual() /= s%residual()) refused = refused + 1
        s = pressure
        if (s%terms() == 60) refused = refused + 1
    end do
    call claim('a firstprivate series is none, until it is assigned one', refused > 400)
    allocate (sourced_series, source=pressure)
    call claim('a series by SOURCE= is none', sourced_series%terms() == 0)
    deallocate (sourced_series)
    s = pressure
    s = s
    call pressure%destroy()
    call claim('what was shared is there until its last', s%terms() == 60 .and. pressure%terms() == 0)

    call overlapping()

    x = reshape([-0.4d0, -0.2d0, 0d0, 0.1d0, 0.2d0, 0.3d0], [2, 3])
    p = 0
    call base%tractions(x, p, q, stat)
    call base%tractions([x], list_p, list_q)
    call claim('a grid is its points', stat == rwedge_ok .and. all(abs([p] - list_p) <= 0) .and. all(abs([q] - list_q) <= 0))
    call base%tractions(x, p(:, 1:2), q, stat, text)
    call claim('arrays of two shapes', stat == rwedge_erange .and. index(text, 'arrays of one shape') > 0)

    call base%load(2000d0, 1300d0, stat, text)
    call claim(trim(text), stat == rwedge_esliding .and. index(text, ': P = 2000.') > 0 .and. index(text, ', Q = 1300.') > 0)
    call base%apply(2000d0, 100d0, 0d0, 0d0)
    call base%apply(2000d0, 100d0, 0d0, 500d0, stat, text)
    call claim(trim(text), stat == rwedge_epath .and. index(text, 'the two edges would slip in opposite directions') > 0)
    call base%tractions([0d0, 1d300], list_p(1:2), list_q(1:2), stat, text)
    call claim(trim(text), stat == rwedge_edomain .and. index(text, 'element 2') > 0 .and. index(text, ': x = ') > 0)
    if (failures > 0) error stop 1
    print '(a)', 'copies byte by byte are noticed'

contains

    ! Parts of an array go to other places of it: as if all at the right were copied first.
    subroutine overlapping()
        type(rwedge_contact), allocatable :: pads(:), grid(:, :)
        type(rwedge_series), allocatable :: series(:)
        integer :: k
        allocate (pads(3), grid(2, 2), series(3))
        do k = 1, 3
            pads(k) = base
            call pads(k)%load(1000d0 * k, 0d0)
            call series(k)%create(0.25d0, 10 * k)
        end do
        pads(2:3) = pads(1:2)
        call claim('a part moved up', has(pads, [1, 1, 2]))
        pads(3) = base
        call pads(3)%load(3000d0, 0d0)
        pads = pads(3:1:-1)
        call claim('an array reversed', has(pads, [3, 1, 1]))
        pads = pads([2, 3, 1])
        call claim('an array by its indices', has(pads, [1, 1, 3]))
        grid(:, 1) = pads(1)
        grid(:, 2) = pads(3)
        grid = grid(:, 2:1:-1)
        call claim('a grid', has(grid(:, 1), [3, 3]) .and. has(grid(:, 2), [1, 1]))
        series(2:3) = series(1:2)
        call claim('series', series(1)%terms() == 10 .and. series(2)%terms() == 10 .and. series(3)%terms() == 20)
    end subroutine

    logical function has(pads, thousands)
        type(rwedge_contact), intent(in) :: pads(:)
        integer, intent(in) :: thousands(:)
        integer :: k
        has = .true.
        do k = 1, size(pads)
            has = has .and. abs(pads(k)%half_width() - rwedge_half_width(0.01d0, 0.5d0, 1.8d-5, 1000d0 * thousands(k))) <= 0
        end do
    end function

    subroutine claim(what, holds)
        character(*), intent(in) :: what
        logical, intent(in) :: holds
        if (holds) return
        failures = failures + 1
        print '(2a)', 'FAILED: ', what
    end subroutine
end program

! SPDX-License-Identifier: GPL-3.0-or-later
! The module as its users meet it: errors, arrays, the life of handles, and what a call costs. With the argument "stop" it makes
! an error without stat, which must end it.
program test_module
    use rwedge
    use, intrinsic :: ieee_arithmetic
    use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_size_t
    implicit none

    interface
        function handles_alive() bind(C) result(number)
            import :: c_int32_t
            integer(c_int32_t) :: number
        end function

        subroutine loads_in_c(n, alpha, load) bind(C)
            import :: c_double, c_size_t
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: alpha(*)
            real(c_double), intent(out) :: load(*)
        end subroutine
    end interface

    type :: specimen
        type(rwedge_contact) :: pad
        type(rwedge_contact), allocatable :: others(:) ! not of fixed size: README.md
    end type

    integer :: failures = 0

    if (command_argument_count() > 0) call without_stat()
    call errors()
    call arrays()
    call lives()
    call histories()
    call pads()
    call costs()
    if (failures > 0) error stop 1

contains

    subroutine claim(what, holds)
        character(*), intent(in) :: what
        logical, intent(in) :: holds
        if (holds) return
        write (*, '(2a)') 'FAILED: ', what
        failures = failures + 1
    end subroutine

    subroutine without_stat()
        real(c_double) :: sxx, syy, txy
        call rwedge_stress(0.25_c_double, 0.3_c_double, 0.0_c_double, 0.0_c_double, -1.0_c_double, sxx, syy, txy)
    end subroutine

    subroutine errors()
        type(rwedge_contact) :: contact
        type(rwedge_series) :: series
        real(c_double) :: s(3), p(2), q(2), limit, nan
        integer :: stat
        character(400) :: errmsg
        nan = ieee_value(nan, ieee_quiet_nan)
        call claim('the version has two points', &
            index(rwedge_version(), '.') < index(rwedge_version(), '.', back=.true.))
        call claim('a status has its text', rwedge_error_text(rwedge_edomain) == 'an argument is outside its domain')
        call claim('an unknown status too', rwedge_error_text(-77_c_int32_t) == 'unknown status')
        call claim('NaN gives NaN', &
            ieee_is_nan(rwedge_load(nan)) .and. ieee_is_nan(rwedge_elastic_limit(0.3_c_double, nan, nan)))

        s = 5
        errmsg = 'as it was'
        call rwedge_stress(0.25_c_double, 0.3_c_double, 0.0_c_double, 0.0_c_double, -1.0_c_double, s(1), s(2), s(3), &
            stat, errmsg)
        call claim('domain', stat == rwedge_edomain .and. all(s == 5))
        call claim('its message: ' // errmsg, index(errmsg, 'rwedge_stress(alpha, f, c, x, y): an argument is outside ' // &
            'its domain: alpha = 0.25') == 1 .and. index(errmsg, ', y = -1.0') > 0 .and. &
            index(errmsg, '; allowed is alpha 0, or 1e-60 to 1e60') > 0)
        errmsg = 'as it was'
        call rwedge_yield_point(0.25_c_double, 0.3_c_double, 0.3_c_double, limit, s(1), s(2), stat, errmsg)
        call claim('no error, no message', stat == rwedge_ok .and. errmsg == 'as it was')
        call rwedge_surface_yield(0.25_c_double, 0.0_c_double, 0.5_c_double, limit, s(1), stat)
        call claim('absent', stat == rwedge_eabsent)

        call contact%load(1.0_c_double, 0.0_c_double, stat, errmsg)
        call claim('not created', stat == rwedge_enull .and. index(errmsg, 'create it first') > 0)
        call claim('not created, half-width', ieee_is_nan(contact%half_width()) .and. contact%memory() == 0)
        call contact%create(-1.0_c_double, 0.5_c_double, 1.8e-5_c_double, 0.6_c_double, stat)
        call claim('create: domain', stat == rwedge_edomain)
        call contact%create(0.01_c_double, 0.5_c_double, 1.8e-5_c_double, 0.6_c_double)
        call contact%yield_factor(0.3_c_double, 300.0_c_double, limit, stat=stat)
        call claim('separated', stat == rwedge_eabsent)
        call contact%load(1000.0_c_double, 300.0_c_double)
        call contact%load(1000.0_c_double, 601.0_c_double, stat, errmsg)
        call claim('sliding', stat == rwedge_esliding .and. &
            index(errmsg, 'exceeds friction') > 0 .and. index(errmsg, '601') > 0 .and. index(errmsg, 'allowed') == 0)
        call contact%load(1e308_c_double, 0.0_c_double, stat, errmsg)
        call claim('domain: ' // errmsg, stat == rwedge_edomain .and. index(errmsg, 'allowed is P 0, or 1e-60 to 1e60') > 0)
        p = 5
        call contact%tractions([0.0_c_double, nan], p, q, stat, errmsg)
        call claim('tractions: domain', stat == rwedge_edomain .and. all(p == 5))
        call claim('tractions: ' // errmsg, says(errmsg, 'rwedge_contact%tractions(x), element 2', &
            'NaN; allowed is x 0, or 1e-60 to 1e60 in magnitude'))
        call contact%tractions([0.0_c_double], p, q, stat, errmsg)
        call claim('sizes that differ', stat == rwedge_erange)
        call claim('sizes that differ: ' // errmsg, index(errmsg, '; arrays of one size') > 0)
        call contact%stresses([0.0_c_double, 0.0_c_double], [0.0_c_double, -1.0_c_double], p, q, s(:2), stat, errmsg)
        call claim('stresses: ' // errmsg, says(errmsg, 'rwedge_contact%stresses(x, y), element 2', 'y 0, or 1e-60 to 1e60'))
        call contact%slip([0.0_c_double, 50.0_c_double], p, stat, errmsg)
        call claim('slip: ' // errmsg, says(errmsg, 'rwedge_contact%slip(x), element 2', '50.0') .and. &
            index(errmsg, '|x| <= b') > 0 .and. all(p == 5))
        call rwedge_stresses(0.25_c_double, 0.3_c_double, 0.0_c_double, [0.0_c_double, 0.0_c_double], &
            [0.0_c_double, -1.0_c_double], p, q, s(:2), stat, errmsg)
        call claim('rwedge_stresses: ' // errmsg, says(errmsg, 'rwedge_stresses(alpha, f, c, x, y), element 2', '-1.0'))
        call rwedge_elastic_limits([0.1_c_double, 0.25_c_double], [0.1_c_double, -0.5_c_double], 0.3_c_double, p, stat, errmsg)
        call claim('rwedge_elastic_limits: ' // errmsg, stat == rwedge_edomain .and. all(p == 5) .and. &
            says(errmsg, 'rwedge_elastic_limits(alpha, f, nu), element 2', ': alpha = 0.25') .and. &
            index(errmsg, '0 <= f <= 1e6, 0 or at least 1e-60; 0 <= nu <= 0.5') > 0)
        call rwedge_elastic_limits(p(:0), p(:0), 0.6_c_double, p(:0), stat, errmsg)
        call claim('no elements: ' // errmsg, stat == rwedge_edomain .and. index(errmsg, '0 <= nu <= 0.5') > 0)
        call series%create(0.25_c_double, 0_c_int32_t, stat, errmsg)
        call claim('series: ' // errmsg, stat == rwedge_erange .and. index(errmsg, '1 <= terms <= 2^24') > 0)
        call series%fit([0.1_c_double, 0.2_c_double, 1.5_c_double], [1.0_c_double, 1.0_c_double, 1.0_c_double], &
            2_c_int32_t, stat, errmsg)
        call claim('fit: ' // errmsg, says(errmsg, 'rwedge_series%fit(x, p), element 3', '1.5') .and. series%terms() == 0)
        call series%fit([0.1_c_double, 0.2_c_double], [1.0_c_double], 1_c_int32_t, stat, errmsg)
        call claim('fit, sizes: ' // errmsg, stat == rwedge_erange .and. index(errmsg, 'arrays of one size') > 0)
        call series%fit([0.1_c_double, 0.1_c_double, 0.1_c_double], [1.0_c_double, 1.0_c_double, 1.0_c_double], &
            3_c_int32_t, stat)
        call claim('rank', stat == rwedge_erank)
    end subroutine

    ! It begins with the call, is about the domain, has the words and says what is allowed.
    function says(errmsg, call, words) result(yes)
        character(*), intent(in) :: errmsg, call, words
        logical :: yes
        yes = index(errmsg, call // ': an argument is outside its domain: ') == 1 .and. index(errmsg, words) > 0 .and. &
            index(errmsg, '; allowed is ') > 0
    end function

    subroutine arrays()
        real(c_double) :: alpha(3, 4), sxx(3, 4), syy(3, 4), txy(3, 4), one(3), x(12), y(12), all_sxx(24), row(12), column(12)
        integer :: i, j, stat(3, 4)
        alpha = reshape([(0.1_c_double * i, i = 1, 12)], [3, 4])
        call claim('an elemental function', &
            all(rwedge_load(alpha) == reshape([((rwedge_load(alpha(i, j)), i = 1, 3), j = 1, 4)], [3, 4])))
        alpha(2, 3) = -1
        call rwedge_stress(alpha, 0.3_c_double, 0.5_c_double, 0.2_c_double, 0.4_c_double, sxx, syy, txy, stat)
        call claim('a status per element', stat(2, 3) == rwedge_edomain .and. count(stat == rwedge_ok) == 11)
        call rwedge_stress(alpha(3, 4), 0.3_c_double, 0.5_c_double, 0.2_c_double, 0.4_c_double, one(1), one(2), one(3))
        call claim('a stress per element', all([sxx(3, 4), syy(3, 4), txy(3, 4)] == one))

        x = [(0.1_c_double * i - 0.5_c_double, i = 1, 12)]
        y = 0.3_c_double
        all_sxx = 5
        call rwedge_stresses(0.3_c_double, 0.5_c_double, 0.2_c_double, x, y, all_sxx(1::2), row, column)
        call rwedge_stress(0.3_c_double, 0.5_c_double, 0.2_c_double, x(7), y(7), one(1), one(2), one(3))
        call claim('every second element', all_sxx(13) == one(1) .and. row(7) == one(2) .and. all(all_sxx(2::2) == 5))
        call rwedge_elastic_limits(abs(x), y, 0.3_c_double, row)
        call claim('elastic limits', all(row == rwedge_elastic_limit(abs(x), y, 0.3_c_double)))
    end subroutine

    ! As many handles are freed as were made, in every way they come and go.
    subroutine lives()
        integer(c_int32_t) :: before
        before = handles_alive()
        call claim('one alive', lives_in_scope() == before + 1)
        call claim('none left by a scope', handles_alive() == before)
        call claim('nine alive', lives_of_copies() == before + 9)
        call claim('none left by copies', handles_alive() == before)
        call claim('one alive, shared', lives_of_series() == before + 1)
        call claim('none left by series', handles_alive() == before)
    end subroutine

    function lives_in_scope() result(alive)
        integer(c_int32_t) :: alive
        type(rwedge_contact) :: contact
        call contact%create(0.01_c_double, 0.5_c_double, 1.8e-5_c_double, 0.6_c_double)
        call contact%create(0.02_c_double, 0.5_c_double, 1.8e-5_c_double, 0.6_c_double) ! frees the first
        alive = handles_alive()
    end function

    function lives_of_copies() result(alive)
        integer(c_int32_t) :: alive
        type(rwedge_contact) :: contact, empty, freed
        type(rwedge_contact), allocatable :: several(:)
        type(specimen) :: one, other
        call contact%create(0.01_c_double, 0.5_c_double, 1.8e-5_c_double, 0.6_c_double)
        call contact%load(1000.0_c_double, 0.0_c_double)
        contact = contact
        call claim('a = a', contact%half_width() > 0)
        freed = contact
        freed = empty
        call freed%destroy()
        allocate (several(4))
        several(1) = contact
        several(2:) = contact
        one%pad = contact
        allocate (one%others(2))
        one%others = contact ! 1 + 4 + 1 + 2 + 1
        other%pad = one%pad ! not other = one: README.md
        alive = handles_alive()
        call one%pad%load(2000.0_c_double, 0.0_c_double)
        call claim('copies are independent', other%pad%half_width() == contact%half_width() .and. &
            one%pad%half_width() > contact%half_width())
    end function

    function lives_of_series() result(alive)
        integer(c_int32_t) :: alive
        type(rwedge_series) :: series, shared
        call series%create(0.3_c_double, 5_c_int32_t)
        series = series
        shared = series
        call series%destroy()
        alive = handles_alive()
        call claim('shared lives on', shared%terms() == 5 .and. series%terms() == 0)
    end function

    subroutine histories()
        type(rwedge_contact) :: contact, trial
        real(c_double) :: q(1), p(1), kept(1), factor, x, y
        integer :: stat
        call contact%create(0.01_c_double, 0.5_c_double, 1.8e-5_c_double, 0.6_c_double)
        call contact%load(1000.0_c_double, 300.0_c_double)
        call contact%tractions([0.3_c_double], p, kept)
        trial = contact
        call trial%load(1000.0_c_double, -500.0_c_double)
        call trial%tractions([0.3_c_double], p, q)
        call claim('the trial has another shear', q(1) /= kept(1))
        trial = contact
        call trial%tractions([0.3_c_double], p, q)
        call claim('and goes back', q(1) == kept(1))
        call contact%yield_factor(0.3_c_double, 300.0_c_double, factor, x, y, stat)
        call claim('yield factor', stat == rwedge_ok .and. factor > 0 .and. y >= 0 .and. abs(x) <= contact%half_width())
    end subroutine

    ! Slopes that are not convex.
    subroutine pads()
        type(rwedge_contact) :: contact
        integer :: stat
        call contact%create_profile([0.0_c_double, 1.0_c_double], [0.1_c_double, 0.0_c_double], 1e-4_c_double, 0.5_c_double, stat)
        call claim('a profile that is not convex', stat == rwedge_edomain)
    end subroutine

    ! A million calls by the elemental function and by a loop in C, the fastest of five each.
    subroutine costs()
        integer, parameter :: n = 1000000
        real(c_double), allocatable :: alpha(:), of_c(:), of_fortran(:)
        real(c_double) :: t(3), fastest(2)
        integer :: i
        allocate (alpha(n), of_c(n), of_fortran(n))
        do i = 1, n ! not a constructor: gfortran would take eight seconds to write it out
            alpha(i) = 1.2_c_double * i / n
        end do
        fastest = huge(t)
        do i = 1, 25 ! a busy machine needs more attempts
            if (i > 5 .and. fastest(2) < 1.5 * fastest(1)) exit
            call cpu_time(t(1))
            call loads_in_c(size(alpha, kind=c_size_t), alpha, of_c)
            call cpu_time(t(2))
            of_fortran = rwedge_load(alpha)
            call cpu_time(t(3))
            fastest = min(fastest, t(2:) - t(:2))
        end do
        call claim('the same loads', all(of_c == of_fortran))
        write (*, '(2(a, f0.1), a, f0.2)') 'a load ', 1e9 * fastest(2) / n, ' ns, in C ', 1e9 * fastest(1) / n, ' ns: ratio ', &
            fastest(2) / fastest(1)
        call claim('a load costs no more than 1.5 of what it does in C', fastest(2) < 1.5 * fastest(1))
    end subroutine
end program

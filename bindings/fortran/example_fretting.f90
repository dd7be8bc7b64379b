! SPDX-License-Identifier: GPL-3.0-or-later
! A fretting test as in lib/README.md (N, mm), driven as by a finite-element code: time goes on in increments, in
! each the solver tries tangential loads until it is content, and only the last trial becomes history.

! The pad, as a user subroutine of the solver sees it: what was accepted, and what is being tried.
module pad
    use rwedge
    use, intrinsic :: iso_c_binding, only: c_double
    implicit none
    private
    public :: try_loads, accept_loads

    type(rwedge_contact), public :: accepted
    type(rwedge_contact) :: trial

contains

    ! From the accepted state, whatever was tried before. bearable is false where the pad would slide away: the solver is to cut
    ! back its step.
    subroutine try_loads(P, Q, bearable)
        real(c_double), intent(in) :: P, Q
        logical, intent(out) :: bearable
        integer :: stat
        character(200) :: errmsg
        trial = accepted ! copies the history
        call trial%load(P, Q, stat, errmsg)
        bearable = stat == rwedge_ok
        if (stat /= rwedge_ok .and. stat /= rwedge_esliding) error stop 'pad: neither bears the load nor slides'
    end subroutine

    subroutine accept_loads()
        accepted = trial
    end subroutine
end module

program example_fretting
    use pad
    use rwedge
    use, intrinsic :: iso_c_binding, only: c_double
    implicit none
    integer, parameter :: steps = 12
    real(c_double), parameter :: E = 72e3_c_double, nu = 0.33_c_double, theta = 0.005_c_double ! an aluminium alloy
    real(c_double), parameter :: radius = 20, f = 0.6_c_double, k = 190, P = 60, Q_max = 0.8_c_double * f * P
    real(c_double) :: compliance, a, b, before, Q, slip(1), factor, factor_min, swt, angle, out_of_plane
    real(c_double), dimension(0:steps) :: cycle
    real(c_double), dimension(1, 0:steps) :: sxx, syy, txy
    type(rwedge_contact) :: ahead
    integer :: i, trials, refused

    trials = 0
    refused = 0
    compliance = rwedge_compliance(E, nu, E, nu)
    a = rwedge_rounding(theta, radius)
    call accepted%create(theta, a, compliance, f)
    call accepted%load(P, 0.0_c_double)
    Q = 0
    call advance(Q, Q_max) ! the first loading differs from the cycles after it
    b = accepted%half_width()
    before = accepted%dissipated_energy()
    write (*, '(a, f0.4, a, f0.4, a)') 'contact 0', b, ' mm, stick zone 0', accepted%stick_half_width(), ' mm'

    ! where a cycle is known, its stresses are one call, here at the trailing edge: of a copy, as the contact goes on with it
    cycle = [(Q_max * merge(1 - 4.0_c_double * i / steps, 4.0_c_double * i / steps - 3, i <= steps / 2), i = 0, steps)]
    ahead = accepted
    call ahead%stress_history(0 * cycle + P, 0 * cycle, cycle, 0 * cycle, [-b], [0.0_c_double], sxx, syy, txy)
    call rwedge_criterion(rwedge_measure_swt_in_plane, [E], sxx(1, :), syy(1, :), txy(1, :), nu, 0, swt, angle, out_of_plane)

    write (*, '(a8, a11, a13)') 'Q', 'sxx', 'slip at .9 b'
    factor_min = huge(factor_min)
    do i = 0, steps
        call advance(Q, cycle(i))
        call accepted%slip([-0.9_c_double * b], slip)
        call accepted%yield_factor(nu, k, factor)
        factor_min = min(factor_min, factor)
        write (*, '(f8.2, f11.4, es13.4)') Q, sxx(1, i), slip
    end do
    write (*, '(a, f8.6, a)') 'Smith-Watson-Topper ', swt, ' MPa'
    write (*, '(a, es12.6, a)') 'dissipated per cycle ', accepted%dissipated_energy() - before, ' N'
    write (*, '(a, f6.4, a, f6.2, a)') 'yield factor ', factor_min, ', yield load when sliding ', &
        rwedge_yield_load(theta, a, compliance, f, nu, k), ' N/mm'
    write (*, '(i0, a, i0, a)') trials, ' loads tried, ', refused, ' refused'

contains

    ! One increment. The solver's first guess goes too far by half, as guesses do, and is cut back where the pad would slide;
    ! then comes the balance. What was tried in between leaves no trace.
    subroutine advance(Q, goal)
        real(c_double), intent(inout) :: Q
        real(c_double), intent(in) :: goal
        real(c_double) :: guess
        logical :: bearable
        guess = Q + 1.5_c_double * (goal - Q)
        do
            call try_loads(P, guess, bearable)
            trials = trials + 1
            if (bearable) exit
            refused = refused + 1
            guess = (guess + goal) / 2
        end do
        call try_loads(P, goal, bearable)
        trials = trials + 1
        if (.not. bearable) error stop 'no balance'
        call accept_loads()
        Q = goal
    end subroutine
end program

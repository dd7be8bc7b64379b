! SPDX-License-Identifier: GPL-3.0-or-later
! rwedge for Fortran: the contact of a wedge with a rounded apex and an elastically similar half-plane.
! Written by bindings/interface/generate.py from include/rwedge.h and template.f90: change those, not rwedge.f90.
! Compile this file with your program and link the library: gfortran rwedge.f90 program.f90 -lrwedge.
!
! The comments that begin with !> are those of rwedge.h, which has the geometry, units and the domains of the arguments that
! return everywhere. What is different here:
! - The composite compliance A is the argument "compliance": Fortran takes a and A for one name.
! - Functions of numbers are elemental: they take arrays too. They give NaN outside their domain.
! - What has a status has the optional arguments stat and errmsg, as ALLOCATE has: stat receives rwedge_ok or the reason,
!   errmsg the reason in words, with the arguments and what is allowed. Where stat is absent, an error ends the program with
!   that text.
! - On error the outputs are as they were.
! - rwedge_contact and rwedge_series are freed when they go out of scope. contact2 = contact1 copies the history: to try a
!   load and go back. Assign contacts themselves, not objects that hold them; do not ALLOCATE one with SOURCE=, and do not
!   return one from a function: compilers copy the handle there, not what it holds. Such a copy is noticed: it is as if it had
!   not been created. In OpenMP take private(c) and assign to it; firstprivate(c) makes such copies. README.md says more.
! - Where C says that a pointer is NULL, create() has not been called; HUGE_VAL is ieee_value(0d0, ieee_positive_inf).
module rwedge
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int32_t, c_null_ptr, c_ptr, c_size_t
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
    use, intrinsic :: iso_fortran_env, only: error_unit
    implicit none
    private

    integer(c_int32_t), parameter, public :: rwedge_ok = 0, rwedge_edomain = 1, rwedge_enull = 2, rwedge_erange = 3, &
        rwedge_enoconv = 4, rwedge_enomem = 5, rwedge_esliding = 6, rwedge_erank = 7, rwedge_eabsent = 8, rwedge_epath = 9, &
        rwedge_doubt_angle = 1, rwedge_doubt_coupling = 2, rwedge_doubt_yield = 4, rwedge_doubt_rounding = 8, &
        rwedge_doubt_strength = 16, rwedge_measure_stress_range = 0, rwedge_measure_swt = 1, rwedge_measure_fatemi_socie = 2, &
        rwedge_measure_slip_range = 3, rwedge_measure_ruiz_f1 = 4, rwedge_measure_ruiz_f2 = 5, &
        rwedge_measure_energy_per_area = 6

    public :: rwedge_version, rwedge_error_text
    public :: rwedge_compliance, rwedge_dundurs_beta, rwedge_load, rwedge_a_over_b, rwedge_pressure, rwedge_peak_pressure, &
        rwedge_transition_pressure, rwedge_coefficient, rwedge_stick_width, rwedge_shear_ratio, rwedge_shear, rwedge_stress, &
        rwedge_stresses, rwedge_max_tension, rwedge_elastic_limit, rwedge_elastic_limits, rwedge_yield_point, &
        rwedge_subsurface_yield, rwedge_surface_yield, rwedge_critical_friction, rwedge_validity, rwedge_validity_text, &
        rwedge_radius, rwedge_rounding, rwedge_half_width, rwedge_normal_load, rwedge_yield_load, rwedge_permanent_stick, &
        rwedge_von_mises, rwedge_out_of_plane_stress, rwedge_largest_shear, rwedge_principal_stresses, &
        rwedge_smith_watson_topper, rwedge_smith_watson_topper_field, rwedge_fatemi_socie, rwedge_fatemi_socie_field

    ! An object of the library, and where its handle is when it is this one's own.
    type :: owner
        private
        type(c_ptr) :: handle = c_null_ptr
        type(c_ptr) :: place = c_null_ptr
    end type

    ! One contact and what it remembers of its loads.
    type, extends(owner), public :: rwedge_contact
        private
    contains
        procedure :: create => contact_create
        procedure :: set_strain => contact_set_strain
        procedure :: copy => contact_copy
        procedure :: destroy => contact_destroy
        procedure :: load => contact_load
        procedure :: apply => contact_apply
        procedure :: obstacle => contact_obstacle
        procedure :: largest_tension_step => contact_largest_tension_step
        procedure :: loads => contact_loads
        procedure :: edges => contact_edges
        procedure :: stick_zone => contact_stick_zone
        procedure :: tilt => contact_tilt
        procedure :: edge_asymptotes => contact_edge_asymptotes
        procedure :: half_width => contact_half_width
        procedure :: stick_half_width => contact_stick_half_width
        procedure :: memory => contact_memory
        procedure, private :: tractions_of_list => contact_tractions
        procedure, private :: tractions_of_grid => contact_tractions_of_grid
        generic :: tractions => tractions_of_list, tractions_of_grid
        procedure, private :: stresses_of_list => contact_stresses
        procedure, private :: stresses_of_grid => contact_stresses_of_grid
        generic :: stresses => stresses_of_list, stresses_of_grid
        procedure :: stress_history => contact_stress_history
        procedure :: state_size => contact_state_size
        procedure :: state => contact_state
        procedure :: restore => contact_restore
        procedure, private :: slip_of_list => contact_slip
        procedure, private :: slip_of_grid => contact_slip_of_grid
        generic :: slip => slip_of_list, slip_of_grid
        procedure :: dissipated_energy => contact_dissipated_energy
        procedure :: yield_factor => contact_yield_factor
        procedure :: cycle_fatigue => contact_cycle_fatigue
        procedure :: cycle_friction => contact_cycle_friction
        procedure :: cycle_worst => contact_cycle_worst
        procedure :: displacement => contact_displacement
        procedure, private :: assign_contact
        generic :: assignment(=) => assign_contact
        final :: finalize_contact
    end type

    ! The paper's series. It never changes once made, so that copies share it.
    type, extends(owner), public :: rwedge_series
        private
        integer, pointer :: users => null()
    contains
        procedure :: create => series_create
        procedure :: fit => series_fit
        procedure :: destroy => series_destroy
        procedure :: terms => series_terms
        procedure :: coefficient => series_coefficient
        procedure :: residual => series_residual
        procedure :: pressure => series_pressure
        procedure :: potential => series_potential
        procedure :: stress => series_stress
        procedure, private :: assign_series
        generic :: assignment(=) => assign_series
        final :: finalize_series
    end type

    ! rwedge.h
    interface
        pure function strlen(text) bind(C, name="strlen") result(length)
            import :: c_ptr, c_size_t
            type(c_ptr), value :: text
            integer(c_size_t) :: length
        end function

        ! The address of a handle: that to which nothing is moved.
        pure function address_of(handle, same, nothing) bind(C, name="memmove") result(address)
            import :: c_ptr, c_size_t
            type(c_ptr), intent(in) :: handle, same
            integer(c_size_t), value :: nothing
            type(c_ptr) :: address
        end function

        function c_version() bind(C, name="rwedge_version") result(value)
            import :: c_ptr
            type(c_ptr) :: value
        end function

        function c_strerror(status) bind(C, name="rwedge_strerror") result(value)
            import :: c_int32_t, c_ptr
            integer(c_int32_t), value :: status
            type(c_ptr) :: value
        end function

        pure function c_compliance(E1, nu1, E2, nu2) bind(C, name="rwedge_compliance") result(value)
            import :: c_double
            real(c_double), value :: E1, nu1, E2, nu2
            real(c_double) :: value
        end function

        pure function c_dundurs_beta(E1, nu1, E2, nu2) bind(C, name="rwedge_dundurs_beta") result(value)
            import :: c_double
            real(c_double), value :: E1, nu1, E2, nu2
            real(c_double) :: value
        end function

        pure function c_load(alpha) bind(C, name="rwedge_load") result(value)
            import :: c_double
            real(c_double), value :: alpha
            real(c_double) :: value
        end function

        pure function c_a_over_b(AP_over_theta_a) bind(C, name="rwedge_a_over_b") result(value)
            import :: c_double
            real(c_double), value :: AP_over_theta_a
            real(c_double) :: value
        end function

        pure function c_pressure(alpha, x) bind(C, name="rwedge_pressure") result(value)
            import :: c_double
            real(c_double), value :: alpha, x
            real(c_double) :: value
        end function

        pure function c_peak_pressure(alpha) bind(C, name="rwedge_peak_pressure") result(value)
            import :: c_double
            real(c_double), value :: alpha
            real(c_double) :: value
        end function

        pure function c_transition_pressure(alpha) bind(C, name="rwedge_transition_pressure") result(value)
            import :: c_double
            real(c_double), value :: alpha
            real(c_double) :: value
        end function

        pure function c_coefficient(alpha, n) bind(C, name="rwedge_coefficient") result(value)
            import :: c_double, c_int32_t
            real(c_double), value :: alpha
            integer(c_int32_t), value :: n
            real(c_double) :: value
        end function

        pure function c_stick_width(alpha, Q_over_fP) bind(C, name="rwedge_stick_width") result(value)
            import :: c_double
            real(c_double), value :: alpha, Q_over_fP
            real(c_double) :: value
        end function

        pure function c_shear_ratio(alpha, c) bind(C, name="rwedge_shear_ratio") result(value)
            import :: c_double
            real(c_double), value :: alpha, c
            real(c_double) :: value
        end function

        pure function c_shear(alpha, c, x) bind(C, name="rwedge_shear") result(value)
            import :: c_double
            real(c_double), value :: alpha, c, x
            real(c_double) :: value
        end function

        function c_stress(alpha, f, c, x, y, sxx, syy, txy) bind(C, name="rwedge_stress") result(status)
            import :: c_double, c_int32_t
            real(c_double), value :: alpha, f, c, x, y
            real(c_double), intent(inout) :: sxx, syy, txy
            integer(c_int32_t) :: status
        end function

        function c_stresses(alpha, f, c, n, x, y, sxx, syy, txy) bind(C, name="rwedge_stresses") result(status)
            import :: c_double, c_int32_t, c_size_t
            real(c_double), value :: alpha, f, c
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*), y(*)
            real(c_double), intent(inout) :: sxx(*), syy(*), txy(*)
            integer(c_int32_t) :: status
        end function

        pure function c_max_tension(alpha) bind(C, name="rwedge_max_tension") result(value)
            import :: c_double
            real(c_double), value :: alpha
            real(c_double) :: value
        end function

        pure function c_elastic_limit(alpha, f, nu) bind(C, name="rwedge_elastic_limit") result(value)
            import :: c_double
            real(c_double), value :: alpha, f, nu
            real(c_double) :: value
        end function

        function c_elastic_limits(n, alpha, f, nu, limit) bind(C, name="rwedge_elastic_limits") result(status)
            import :: c_double, c_int32_t, c_size_t
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: alpha(*), f(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: limit(*)
            integer(c_int32_t) :: status
        end function

        function c_yield_point(alpha, f, nu, limit, x, y) bind(C, name="rwedge_yield_point") result(status)
            import :: c_double, c_int32_t
            real(c_double), value :: alpha, f, nu
            real(c_double), intent(inout) :: limit, x, y
            integer(c_int32_t) :: status
        end function

        function c_subsurface_yield(alpha, f, nu, limit, x, y) bind(C, name="rwedge_subsurface_yield") result(status)
            import :: c_double, c_int32_t
            real(c_double), value :: alpha, f, nu
            real(c_double), intent(inout) :: limit, x, y
            integer(c_int32_t) :: status
        end function

        function c_surface_yield(alpha, f, nu, limit, x) bind(C, name="rwedge_surface_yield") result(status)
            import :: c_double, c_int32_t
            real(c_double), value :: alpha, f, nu
            real(c_double), intent(inout) :: limit, x
            integer(c_int32_t) :: status
        end function

        pure function c_critical_friction(alpha, nu) bind(C, name="rwedge_critical_friction") result(value)
            import :: c_double
            real(c_double), value :: alpha, nu
            real(c_double) :: value
        end function

        pure function c_validity(theta, alpha, beta, f, k_over_E, safety) bind(C, name="rwedge_validity") result(value)
            import :: c_double, c_int32_t
            real(c_double), value :: theta, alpha, beta, f, k_over_E, safety
            integer(c_int32_t) :: value
        end function

        function c_validity_text(doubt) bind(C, name="rwedge_validity_text") result(value)
            import :: c_int32_t, c_ptr
            integer(c_int32_t), value :: doubt
            type(c_ptr) :: value
        end function

        pure function c_radius(theta, a) bind(C, name="rwedge_radius") result(value)
            import :: c_double
            real(c_double), value :: theta, a
            real(c_double) :: value
        end function

        pure function c_rounding(theta, R) bind(C, name="rwedge_rounding") result(value)
            import :: c_double
            real(c_double), value :: theta, R
            real(c_double) :: value
        end function

        pure function c_half_width(theta, a, compliance, P) bind(C, name="rwedge_half_width") result(value)
            import :: c_double
            real(c_double), value :: theta, a, compliance, P
            real(c_double) :: value
        end function

        pure function c_normal_load(theta, a, compliance, b) bind(C, name="rwedge_normal_load") result(value)
            import :: c_double
            real(c_double), value :: theta, a, compliance, b
            real(c_double) :: value
        end function

        pure function c_yield_load(theta, a, compliance, f, nu, k) bind(C, name="rwedge_yield_load") result(value)
            import :: c_double
            real(c_double), value :: theta, a, compliance, f, nu, k
            real(c_double) :: value
        end function

        function c_contact_create(theta, a, compliance, f, contact) bind(C, name="rwedge_contact_create") result(status)
            import :: c_double, c_int32_t, c_ptr
            real(c_double), value :: theta, a, compliance, f
            type(c_ptr), intent(out) :: contact
            integer(c_int32_t) :: status
        end function

        function c_contact_set_strain(contact, strain_per_tension) bind(C, name="rwedge_contact_set_strain") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: strain_per_tension
            integer(c_int32_t) :: status
        end function

        function c_contact_copy(contact, copy) bind(C, name="rwedge_contact_copy") result(status)
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: contact
            type(c_ptr), intent(out) :: copy
            integer(c_int32_t) :: status
        end function

        subroutine c_contact_destroy(contact) bind(C, name="rwedge_contact_destroy")
            import :: c_ptr
            type(c_ptr), value :: contact
        end subroutine

        function c_contact_load(contact, P, Q) bind(C, name="rwedge_contact_load") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: P, Q
            integer(c_int32_t) :: status
        end function

        function c_contact_apply(contact, P, M, Q, sigma) bind(C, name="rwedge_contact_apply") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: P, M, Q, sigma
            integer(c_int32_t) :: status
        end function

        function c_contact_obstacle(contact, P, M, Q, sigma) bind(C, name="rwedge_contact_obstacle") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: P, M, Q, sigma
            type(c_ptr) :: value
        end function

        pure function c_contact_largest_tension_step(contact, Q) &
            &bind(C, name="rwedge_contact_largest_tension_step") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: Q
            real(c_double) :: value
        end function

        function c_contact_loads(contact, P, M, Q, sigma) bind(C, name="rwedge_contact_loads") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), intent(inout) :: P, M, Q, sigma
            integer(c_int32_t) :: status
        end function

        function c_contact_edges(contact, left, right) bind(C, name="rwedge_contact_edges") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), intent(inout) :: left, right
            integer(c_int32_t) :: status
        end function

        function c_contact_stick_zone(contact, left, right) bind(C, name="rwedge_contact_stick_zone") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), intent(inout) :: left, right
            integer(c_int32_t) :: status
        end function

        pure function c_contact_tilt(contact) bind(C, name="rwedge_contact_tilt") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double) :: value
        end function

        function c_contact_edge_asymptotes(contact, normal_left, normal_right, shear_left, shear_right) &
            &bind(C, name="rwedge_contact_edge_asymptotes") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), intent(inout) :: normal_left, normal_right, shear_left, shear_right
            integer(c_int32_t) :: status
        end function

        function c_permanent_stick(theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2, left, right) &
            &bind(C, name="rwedge_permanent_stick") result(status)
            import :: c_double, c_int32_t
            real(c_double), value :: theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2
            real(c_double), intent(inout) :: left, right
            integer(c_int32_t) :: status
        end function

        pure function c_contact_half_width(contact) bind(C, name="rwedge_contact_half_width") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double) :: value
        end function

        pure function c_contact_stick_half_width(contact) bind(C, name="rwedge_contact_stick_half_width") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double) :: value
        end function

        pure function c_contact_memory(contact) bind(C, name="rwedge_contact_memory") result(value)
            import :: c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t) :: value
        end function

        function c_contact_tractions(contact, n, x, p, q) bind(C, name="rwedge_contact_tractions") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: p(*), q(*)
            integer(c_int32_t) :: status
        end function

        function c_contact_stresses(contact, n, x, y, sxx, syy, txy) bind(C, name="rwedge_contact_stresses") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*), y(*)
            real(c_double), intent(inout) :: sxx(*), syy(*), txy(*)
            integer(c_int32_t) :: status
        end function

        function c_contact_stress_history(contact, loads, P, M, Q, sigma, n, x, y, sxx, syy, txy) &
            &bind(C, name="rwedge_contact_stress_history") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: loads
            real(c_double), intent(in) :: P(*), M(*), Q(*), sigma(*)
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*), y(*)
            real(c_double), intent(inout) :: sxx(*), syy(*), txy(*)
            integer(c_int32_t) :: status
        end function

        pure function c_contact_state_size(contact) bind(C, name="rwedge_contact_state_size") result(value)
            import :: c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t) :: value
        end function

        function c_contact_state(contact, n, state) bind(C, name="rwedge_contact_state") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: n
            real(c_double), intent(inout) :: state(*)
            integer(c_int32_t) :: status
        end function

        function c_contact_restore(n, state, contact) bind(C, name="rwedge_contact_restore") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: state(*)
            type(c_ptr), intent(out) :: contact
            integer(c_int32_t) :: status
        end function

        function c_contact_slip(contact, n, x, slip) bind(C, name="rwedge_contact_slip") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: slip(*)
            integer(c_int32_t) :: status
        end function

        pure function c_contact_dissipated_energy(contact) bind(C, name="rwedge_contact_dissipated_energy") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double) :: value
        end function

        function c_contact_yield_factor(contact, nu, k, factor, x, y) &
            &bind(C, name="rwedge_contact_yield_factor") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: nu, k
            real(c_double), intent(inout) :: factor, x, y
            integer(c_int32_t) :: status
        end function

        function c_contact_cycle_fatigue(contact, loads, P, M, Q, sigma, n, x, y, E, nu, k_over_sy, stress_range, swt, swt_angle, fatemi_socie, fs_angle) &
            &bind(C, name="rwedge_contact_cycle_fatigue") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: loads
            real(c_double), intent(in) :: P(*), M(*), Q(*), sigma(*)
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*), y(*)
            real(c_double), value :: E, nu, k_over_sy
            real(c_double), intent(inout) :: stress_range(*), swt(*), swt_angle(*), fatemi_socie(*), fs_angle(*)
            integer(c_int32_t) :: status
        end function

        function c_contact_cycle_friction(contact, loads, P, M, Q, sigma, n, x, slip_range, ruiz_f1, ruiz_f2, energy) &
            &bind(C, name="rwedge_contact_cycle_friction") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_size_t), value :: loads
            real(c_double), intent(in) :: P(*), M(*), Q(*), sigma(*)
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: slip_range(*), ruiz_f1(*), ruiz_f2(*), energy(*)
            integer(c_int32_t) :: status
        end function

        function c_contact_cycle_worst(contact, measure, loads, P, M, Q, sigma, n, x, value, y, E, nu, k_over_sy, worst_x, worst_value) &
            &bind(C, name="rwedge_contact_cycle_worst") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            type(c_ptr), value :: contact
            integer(c_int32_t), value :: measure
            integer(c_size_t), value :: loads
            real(c_double), intent(in) :: P(*), M(*), Q(*), sigma(*)
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: x(*), value(*)
            real(c_double), value :: y, E, nu, k_over_sy
            real(c_double), intent(inout) :: worst_x, worst_value
            integer(c_int32_t) :: status
        end function

        pure function c_contact_displacement(contact, b) bind(C, name="rwedge_contact_displacement") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: contact
            real(c_double), value :: b
            real(c_double) :: value
        end function

        pure function c_von_mises(sxx, syy, txy, nu) bind(C, name="rwedge_von_mises") result(value)
            import :: c_double
            real(c_double), value :: sxx, syy, txy, nu
            real(c_double) :: value
        end function

        pure function c_out_of_plane_stress(sxx, syy, nu) bind(C, name="rwedge_out_of_plane_stress") result(value)
            import :: c_double
            real(c_double), value :: sxx, syy, nu
            real(c_double) :: value
        end function

        pure function c_largest_shear(sxx, syy, txy, nu) bind(C, name="rwedge_largest_shear") result(value)
            import :: c_double
            real(c_double), value :: sxx, syy, txy, nu
            real(c_double) :: value
        end function

        function c_principal_stresses(sxx, syy, txy, s1, s2, angle) bind(C, name="rwedge_principal_stresses") result(status)
            import :: c_double, c_int32_t
            real(c_double), value :: sxx, syy, txy
            real(c_double), intent(inout) :: s1, s2, angle
            integer(c_int32_t) :: status
        end function

        function c_smith_watson_topper(n, sxx, syy, txy, E, nu, value, angle) &
            &bind(C, name="rwedge_smith_watson_topper") result(status)
            import :: c_double, c_int32_t, c_size_t
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: sxx(*), syy(*), txy(*)
            real(c_double), value :: E, nu
            real(c_double), intent(inout) :: value, angle
            integer(c_int32_t) :: status
        end function

        function c_smith_watson_topper_field(loads, n, sxx, syy, txy, E, nu, value, angle) &
            &bind(C, name="rwedge_smith_watson_topper_field") result(status)
            import :: c_double, c_int32_t, c_size_t
            integer(c_size_t), value :: loads, n
            real(c_double), intent(in) :: sxx(*), syy(*), txy(*)
            real(c_double), value :: E, nu
            real(c_double), intent(inout) :: value(*), angle(*)
            integer(c_int32_t) :: status
        end function

        function c_fatemi_socie(n, sxx, syy, txy, E, nu, k_over_sy, value, angle) &
            &bind(C, name="rwedge_fatemi_socie") result(status)
            import :: c_double, c_int32_t, c_size_t
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: sxx(*), syy(*), txy(*)
            real(c_double), value :: E, nu, k_over_sy
            real(c_double), intent(inout) :: value, angle
            integer(c_int32_t) :: status
        end function

        function c_fatemi_socie_field(loads, n, sxx, syy, txy, E, nu, k_over_sy, value, angle) &
            &bind(C, name="rwedge_fatemi_socie_field") result(status)
            import :: c_double, c_int32_t, c_size_t
            integer(c_size_t), value :: loads, n
            real(c_double), intent(in) :: sxx(*), syy(*), txy(*)
            real(c_double), value :: E, nu, k_over_sy
            real(c_double), intent(inout) :: value(*), angle(*)
            integer(c_int32_t) :: status
        end function

        function c_series_create(alpha, terms, series) bind(C, name="rwedge_series_create") result(status)
            import :: c_double, c_int32_t, c_ptr
            real(c_double), value :: alpha
            integer(c_int32_t), value :: terms
            type(c_ptr), intent(out) :: series
            integer(c_int32_t) :: status
        end function

        function c_series_fit(samples, x, p, terms, series) bind(C, name="rwedge_series_fit") result(status)
            import :: c_double, c_int32_t, c_ptr, c_size_t
            integer(c_size_t), value :: samples
            real(c_double), intent(in) :: x(*), p(*)
            integer(c_int32_t), value :: terms
            type(c_ptr), intent(out) :: series
            integer(c_int32_t) :: status
        end function

        subroutine c_series_destroy(series) bind(C, name="rwedge_series_destroy")
            import :: c_ptr
            type(c_ptr), value :: series
        end subroutine

        pure function c_series_terms(series) bind(C, name="rwedge_series_terms") result(value)
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: series
            integer(c_int32_t) :: value
        end function

        pure function c_series_coefficient(series, k) bind(C, name="rwedge_series_coefficient") result(value)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: series
            integer(c_int32_t), value :: k
            real(c_double) :: value
        end function

        pure function c_series_residual(series) bind(C, name="rwedge_series_residual") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: series
            real(c_double) :: value
        end function

        pure function c_series_pressure(series, x) bind(C, name="rwedge_series_pressure") result(value)
            import :: c_double, c_ptr
            type(c_ptr), value :: series
            real(c_double), value :: x
            real(c_double) :: value
        end function

        function c_series_potential(series, f, x, y, re, im) bind(C, name="rwedge_series_potential") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: series
            real(c_double), value :: f, x, y
            real(c_double), intent(inout) :: re, im
            integer(c_int32_t) :: status
        end function

        function c_series_stress(series, f, x, y, sxx, syy, txy) bind(C, name="rwedge_series_stress") result(status)
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: series
            real(c_double), value :: f, x, y
            real(c_double), intent(inout) :: sxx, syy, txy
            integer(c_int32_t) :: status
        end function
    end interface

contains

    ! ---- Texts and errors ----------------------------------------------------------------------------------------------

    !> The library's version, "MAJOR.MINOR.PATCH"; RWEDGE_VERSION is that of the header. Static text.
    function rwedge_version() result(text)
        character(:), allocatable :: text
        text = text_of(c_version())
    end function

    !> What a status means.
    function rwedge_error_text(status) result(text)
        integer(c_int32_t), intent(in) :: status
        character(:), allocatable :: text
        text = text_of(c_strerror(status))
    end function

    function text_of(c_text) result(text)
        type(c_ptr), intent(in) :: c_text
        character(:), allocatable :: text
        character(kind=c_char), pointer :: letters(:)
        integer :: i
        call c_f_pointer(c_text, letters, [strlen(c_text)])
        allocate (character(size(letters)) :: text)
        do i = 1, size(letters)
            text(i:i) = letters(i)
        end do
    end function

    ! Hands a status over as ALLOCATE does. call is "name(arguments)", values are those of its arguments, allowed says what they
    ! may be, element is the one of its arrays that was refused.
    subroutine conclude(status, call, values, allowed, stat, errmsg, element)
        integer(c_int32_t), intent(in) :: status
        character(*), intent(in) :: call, allowed
        real(c_double), intent(in) :: values(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer, intent(in), optional :: element
        if (present(stat)) stat = status
        if (status == rwedge_ok) return
        if (present(errmsg)) errmsg = message(status, call, values, allowed, element)
        if (present(stat)) return
        write (error_unit, '(a)') message(status, call, values, allowed, element)
        error stop 1
    end subroutine

    function message(status, call, values, allowed, element) result(text)
        integer(c_int32_t), intent(in) :: status
        character(*), intent(in) :: call, allowed
        real(c_double), intent(in) :: values(:)
        integer, intent(in), optional :: element
        character(:), allocatable :: text
        character(24) :: number
        integer :: i
        text = call
        if (present(element)) then
            write (number, '(i0)') element
            text = text // ', element ' // trim(number)
        end if
        text = text // ': ' // rwedge_error_text(status)
        if (status == rwedge_enull) text = text // ' (create it first; a copy by firstprivate or SOURCE= is none)'
        do i = 1, size(values)
            write (number, '(g0.15)') values(i)
            text = text // merge(': ', ', ', i == 1) // name_in(call, i) // trim(number)
        end do
        if (status == rwedge_edomain .or. status == rwedge_erange) text = text // '; allowed is ' // allowed
    end function

    ! The i-th name in "name(arguments)", with " = " behind it; nothing where there are no names.
    pure function name_in(call, i) result(text)
        character(*), intent(in) :: call
        integer, intent(in) :: i
        character(:), allocatable :: text
        integer :: k, first, last
        first = index(call, '(') + 1
        do k = 2, i
            first = first + index(call(first:), ',')
        end do
        last = first - 1 + scan(call(first:), ',)')
        text = adjustl(call(first:last - 1))
        text = trim(text) // ' = '
        if (call(first:last - 1) == '...' .or. i > 1 .and. index(call, ',') == 0) text = ''
    end function

    ! The first element that is not between the bounds, 0 where there is none. A NaN is not compared: the host may trap that.
    pure function first_outside(x, low, high, smallest, low_open, high_open, or_zero) result(element)
        real(c_double), intent(in) :: x(:), low, high, smallest
        logical, intent(in) :: low_open, high_open, or_zero
        integer :: element
        do element = 1, size(x)
            if (ieee_is_nan(x(element))) return
            if (or_zero .and. .not. abs(x(element)) > 0) cycle
            if (x(element) < low .or. x(element) > high) return
            if (abs(x(element)) > 0 .and. abs(x(element)) < smallest) return
            if ((low_open .and. .not. x(element) > low) .or. (high_open .and. .not. x(element) < high)) return
        end do
        element = 0
    end function

    ! ---- The life of objects -------------------------------------------------------------------------------------------

    ! The handle, if this object is where it was made. A copy that a compiler makes byte by byte, as for firstprivate, owns
    ! nothing; nor does memory that was never set, as for private.
    pure function own(this) result(handle)
        class(owner), intent(in) :: this
        type(c_ptr) :: handle
        handle = c_null_ptr
        if (c_associated(this%place, address_of(this%handle, this%handle, 0_c_size_t))) handle = this%handle
    end function

    subroutine set(this, handle)
        class(owner), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        this%handle = handle
        this%place = address_of(this%handle, this%handle, 0_c_size_t)
    end subroutine

    ! The handle of what stands at the right of an assignment. Compilers may hand over a copy of that, byte by byte: the object
    ! is where it was made.
    function assigned(from) result(handle)
        class(owner), intent(in) :: from
        type(c_ptr) :: handle
        type(c_ptr), pointer :: held
        handle = c_null_ptr
        if (.not. c_associated(from%place)) return
        call c_f_pointer(from%place, held)
        if (c_associated(held, from%handle)) handle = held
    end function

    ! What the contact held before is freed last: it may have been copied from itself.
    subroutine own_contact(this, handle)
        class(rwedge_contact), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call c_contact_destroy(own(this))
        call set(this, handle)
    end subroutine

    !> this = from, by copy(); both may be without a contact.
    impure elemental subroutine assign_contact(this, from)
        class(rwedge_contact), intent(inout) :: this
        type(rwedge_contact), intent(in) :: from
        type(c_ptr) :: held, created
        held = assigned(from)
        created = c_null_ptr
        if (c_associated(held)) call conclude(c_contact_copy(held, created), 'rwedge_contact%copy(...)', [real(c_double) ::], '')
        call own_contact(this, created)
    end subroutine

    !> Frees; NULL is allowed.
    subroutine contact_destroy(this)
        class(rwedge_contact), intent(inout) :: this
        call own_contact(this, c_null_ptr)
    end subroutine

    impure elemental subroutine finalize_contact(this)
        type(rwedge_contact), intent(inout) :: this
        call this%destroy()
    end subroutine

    subroutine own_series(this, handle)
        class(rwedge_series), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call this%destroy()
        call set(this, handle)
        allocate (this%users)
        this%users = 1
    end subroutine

    ! this = from, which share the series from then on.
    impure elemental subroutine assign_series(this, from)
        class(rwedge_series), intent(inout) :: this
        type(rwedge_series), intent(in) :: from
        type(c_ptr) :: handle
        integer, pointer :: users
        handle = assigned(from)
        nullify (users)
        if (c_associated(handle)) then
            users => from%users
            !$omp atomic
            users = users + 1
        end if
        call this%destroy() ! which may be from
        call set(this, handle)
        this%users => users
    end subroutine

    !> Frees; NULL is allowed.
    subroutine series_destroy(this)
        class(rwedge_series), intent(inout) :: this
        integer :: left
        if (c_associated(own(this))) then
            !$omp atomic capture
            this%users = this%users - 1
            left = this%users
            !$omp end atomic
            if (left == 0) then
                call c_series_destroy(this%handle)
                deallocate (this%users)
            end if
        end if
        nullify (this%users)
        call set(this, c_null_ptr)
    end subroutine

    impure elemental subroutine finalize_series(this)
        type(rwedge_series), intent(inout) :: this
        call this%destroy()
    end subroutine

    ! ---- Materials ----------------------------------------------------------------------------------------------------

    !> Composite compliance A = 2(1-nu1^2)/E1 + 2(1-nu2^2)/E2, in 1/unit of E.   Eq. (2)
    !>   E1, E2    Young's moduli, > 0; HUGE_VAL is a rigid body (one of the two at most)
    !>   nu1, nu2  Poisson's ratios, -1 < nu <= 0.5
    !> NaN outside the domain, or where A leaves it. Relative error below 4 epsilon.
    elemental function rwedge_compliance(E1, nu1, E2, nu2) result(value)
        real(c_double), intent(in) :: E1, nu1, E2, nu2
        real(c_double) :: value
        value = c_compliance(E1, nu1, E2, nu2)
    end function

    !> Dundurs' second constant for plane strain. It couples the normal and the tangential problem: the
    !> theory with friction is exact where it is 0 (elastically similar bodies).
    !>    Dundurs (1969), see lib/README.md
    !>   arguments as for rwedge_compliance(); beta changes sign when the bodies are exchanged;
    !>   |beta| <= 1/2 for nu >= 0
    !> NaN outside the domain. Error below 4 epsilon, absolutely.
    elemental function rwedge_dundurs_beta(E1, nu1, E2, nu2) result(value)
        real(c_double), intent(in) :: E1, nu1, E2, nu2
        real(c_double) :: value
        value = c_dundurs_beta(E1, nu1, E2, nu2)
    end function

    ! ---- Contact law --------------------------------------------------------------------------------------------------

    !> Load of a contact of half-width b, as A P/(theta b): 2 for the sharp wedge, (pi/2)/alpha for
    !> Hertz.   Eq. (7), (11), (13), (15)
    !> NaN outside the domain of alpha. Relative error below 4 epsilon. Inverse: rwedge_a_over_b().
    elemental function rwedge_load(alpha) result(value)
        real(c_double), intent(in) :: alpha
        real(c_double) :: value
        value = c_load(alpha)
    end function

    !> The contact law solved for its half-width: a/b from A P/(theta a), over the whole range, Hertz
    !> (a/b >= 1) included.   Eq. (7), (11), inverse
    !>   AP_over_theta_a  > 0, finite
    !> NaN outside the domain, or where a/b leaves it. Relative error below 1e-14.
    elemental function rwedge_a_over_b(AP_over_theta_a) result(value)
        real(c_double), intent(in) :: AP_over_theta_a
        real(c_double) :: value
        value = c_a_over_b(AP_over_theta_a)
    end function

    ! ---- Pressure -----------------------------------------------------------------------------------------------------

    !> Contact pressure A p/theta at x, compression negative; 0 for |x| >= 1.   Eq. (8), (12), (14)
    !> NaN outside the domain, and at the apex of the sharp wedge (alpha = 0, x = 0), where it is
    !> infinite. Relative error below 1e-12, up to the zeros at x = +-1.
    elemental function rwedge_pressure(alpha, x) result(value)
        real(c_double), intent(in) :: alpha, x
        real(c_double) :: value
        value = c_pressure(alpha, x)
    end function

    !> Magnitude of the peak pressure, at x = 0, as A p0/theta.   Eq. (10), (16)
    !> NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14.
    elemental function rwedge_peak_pressure(alpha) result(value)
        real(c_double), intent(in) :: alpha
        real(c_double) :: value
        value = c_peak_pressure(alpha)
    end function

    !> Magnitude of the pressure where the rounding meets the flank, x = +-a, as A p/theta; 0 for
    !> alpha >= 1, where x = a is not inside the contact.   Eq. (9)
    !> NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14.
    elemental function rwedge_transition_pressure(alpha) result(value)
        real(c_double), intent(in) :: alpha
        real(c_double) :: value
        value = c_transition_pressure(alpha)
    end function

    !> Coefficient b_n of the paper's series p = -sqrt(1-x^2) sum b_n U_2n(x).
    !>    Eq. (29), (31) with E1; new
    !>   n  index of the coefficient, >= 0
    !> NaN outside the domain; 0 for alpha >= 1 and n >= 1. Error below the larger of 1e-14,
    !> relatively, and 1e-22 of the values around: this counts next to a zero of b_n.
    elemental function rwedge_coefficient(alpha, n) result(value)
        real(c_double), intent(in) :: alpha
        integer(c_int32_t), intent(in) :: n
        real(c_double) :: value
        value = c_coefficient(alpha, n)
    end function

    ! ---- Partial slip -------------------------------------------------------------------------------------------------

    !> Half-width of the stick zone c/b, under a tangential force Q < fP that grew from zero under
    !> constant P.   Eq. (25)
    !>   Q_over_fP  0 <= Q/(fP) <= 1; 0 sticks everywhere (1), 1 slides (0)
    !> NaN outside the domain. Relative error below 1e-14. Inverse: rwedge_shear_ratio().
    elemental function rwedge_stick_width(alpha, Q_over_fP) result(value)
        real(c_double), intent(in) :: alpha, Q_over_fP
        real(c_double) :: value
        value = c_stick_width(alpha, Q_over_fP)
    end function

    !> Q/(fP) from the half-width of the stick zone.   Eq. (25)
    !> NaN outside the domain. Relative error below 1e-14, also where it goes to 0 (c near 1).
    elemental function rwedge_shear_ratio(alpha, c) result(value)
        real(c_double), intent(in) :: alpha, c
        real(c_double) :: value
        value = c_shear_ratio(alpha, c)
    end function

    !> Shear traction A q/(f theta) at x, with a stick zone |x| < c; it has the sign of the pressure
    !> (q = f p where it slips); 0 for |x| >= 1.   Eq. (23), (26), (27)
    !> NaN outside the domain, and for alpha = c = x = 0. Error below 1e-14 (1 + |A p/theta|).
    elemental function rwedge_shear(alpha, c, x) result(value)
        real(c_double), intent(in) :: alpha, c, x
        real(c_double) :: value
        value = c_shear(alpha, c, x)
    end function

    ! ---- Interior stresses --------------------------------------------------------------------------------------------

    !> Stresses at the point (x, y), in theta/A, tension positive; closed form.
    !>    Eq. (28), (32), (33) with E4, E8; new
    !>   x, y           in b, finite, y >= 0; not the apex (0, 0) of the sharp wedge
    !>   sxx, syy, txy  each receives one number
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL.
    !> Error below 1e-13 of the larger of the tensor's norm and max(1, f)/(1+|z|), z = x + iy.
    impure elemental subroutine rwedge_stress(alpha, f, c, x, y, sxx, syy, txy, stat, errmsg)
        real(c_double), intent(in) :: alpha, f, c, x, y
        real(c_double), intent(inout) :: sxx, syy, txy
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_stress(alpha, f, c, x, y, sxx, syy, txy), 'rwedge_stress(alpha, f, c, x, y)', [alpha, f, c, x, y], &
            'alpha 0, or 1e-60 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= c <= 1, 0 or at least ' // &
            '1e-60; x 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of the sharp wedge; y 0, or ' // &
            '1e-60 to 1e60, not the apex (0, 0) of the sharp wedge', stat, errmsg)
    end subroutine

    !> The same at n points: x[i], y[i] -> sxx[i], syy[i], txy[i]. Nothing is written unless every
    !> point is in the domain.
    subroutine rwedge_stresses(alpha, f, c, x, y, sxx, syy, txy, stat, errmsg)
        real(c_double), intent(in) :: alpha, f, c, x(:), y(:)
        real(c_double), intent(inout) :: sxx(:), syy(:), txy(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double) :: s(3)
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(y), size(sxx), size(syy), size(txy)] == size(x))) &
            status = c_stresses(alpha, f, c, size(x, kind=c_size_t), x, y, sxx, syy, txy)
        if (status == rwedge_edomain) then
            do i = 1, size(x)
                if (c_stresses(alpha, f, c, 1_c_size_t, x(i:i), y(i:i), s(1:1), s(2:2), s(3:3)) == rwedge_ok) cycle
                call conclude(status, 'rwedge_stresses(alpha, f, c, x, y)', [alpha, f, c, x(i), y(i)], &
                    'alpha 0, or 1e-60 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= c <= 1, 0 or at ' // &
                    'least 1e-60; x 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of the sharp ' // &
                    'wedge; y 0, or 1e-60 to 1e60, not the apex (0, 0) of the sharp wedge', stat, errmsg, i)
                return
            end do
        end if
        call conclude(status, 'rwedge_stresses(...)', [real(c_double) ::], &
            'alpha 0, or 1e-60 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= c <= 1, 0 or at least ' // &
            '1e-60; x 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of the sharp wedge; y 0, or ' // &
            '1e-60 to 1e60, not the apex (0, 0) of the sharp wedge; arrays of one size', stat, errmsg)
    end subroutine

    ! ---- Strength -----------------------------------------------------------------------------------------------------

    !> Maximum tension b s1/(fP), at the trailing edge in full sliding: 1 for the sharp wedge, 4/pi
    !> for Hertz.   Eq. (38); new
    !> NaN outside the domain. Relative error below 1e-14.
    elemental function rwedge_max_tension(alpha) result(value)
        real(c_double), intent(in) :: alpha
        real(c_double) :: value
        value = c_max_tension(alpha)
    end function

    !> Elastic limit P/(bk): the load at first yield (von Mises, plane strain) in full sliding, or
    !> under a normal load (f = 0).   Figs. 3 to 5
    !> It belongs to the global maximum of J2 over the half-plane. It is 0 for the sharp wedge, whose
    !> stresses are infinite; but pi for nu = 0.5 and f = 0.
    !>   alpha  0, or at least 1e-14: the J2 of smaller tips can be too flat for its maximum to be found
    !> NaN outside the domain. Relative error below 1e-12.
    elemental function rwedge_elastic_limit(alpha, f, nu) result(value)
        real(c_double), intent(in) :: alpha, f, nu
        real(c_double) :: value
        value = c_elastic_limit(alpha, f, nu)
    end function

    !> The same for n pairs alpha[i], f[i]. Nothing is written unless every pair is in the domain.
    subroutine rwedge_elastic_limits(alpha, f, nu, limit, stat, errmsg)
        real(c_double), intent(in) :: alpha(:), f(:), nu
        real(c_double), intent(inout) :: limit(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double) :: s(1)
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(f), size(limit)] == size(alpha))) &
            status = c_elastic_limits(size(alpha, kind=c_size_t), alpha, f, nu, limit)
        if (status == rwedge_edomain) then
            do i = 1, size(alpha)
                if (c_elastic_limits(1_c_size_t, alpha(i:i), f(i:i), nu, s(1:1)) == rwedge_ok) cycle
                call conclude(status, 'rwedge_elastic_limits(alpha, f, nu)', [alpha(i), f(i), nu], &
                    'alpha 0, or 1e-14 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= nu <= 0.5', stat, errmsg, i)
                return
            end do
        end if
        call conclude(status, 'rwedge_elastic_limits(...)', [real(c_double) ::], &
            'alpha 0, or 1e-14 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= nu <= 0.5; arrays of one' // &
            ' size', stat, errmsg)
    end subroutine

    !> The elastic limit and where it yields: y = 0 is at the surface.   Fig. 5
    !>   alpha  0, or at least 1e-14
    !> The sharp wedge yields at its apex. For nu = 0.5 and alpha >= 1 the whole surface of the
    !> contact is equally stressed.
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL. Error of the place about 1e-12 where the maximum is not flat.
    impure elemental subroutine rwedge_yield_point(alpha, f, nu, limit, x, y, stat, errmsg)
        real(c_double), intent(in) :: alpha, f, nu
        real(c_double), intent(inout) :: limit, x, y
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_yield_point(alpha, f, nu, limit, x, y), 'rwedge_yield_point(alpha, f, nu)', [alpha, f, nu], &
            'alpha 0, or 1e-14 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= nu <= 0.5', stat, errmsg)
    end subroutine

    !> The elastic limit has two branches, below the surface and at it. It is the smaller of the two,
    !> and the cusps of Fig. 4 are where they cross. Each branch is smooth in alpha, f and nu, so that
    !> each can be interpolated.   Fig. 4; new
    !>
    !> Below the surface: the local maximum of J2 that is on the axis for f = 0. Large f and small
    !> alpha have none: RWEDGE_EABSENT.
    !>   alpha  0, or at least 1e-14
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL.
    impure elemental subroutine rwedge_subsurface_yield(alpha, f, nu, limit, x, y, stat, errmsg)
        real(c_double), intent(in) :: alpha, f, nu
        real(c_double), intent(inout) :: limit, x, y
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_subsurface_yield(alpha, f, nu, limit, x, y), 'rwedge_subsurface_yield(alpha, f, nu)', [alpha, f, nu], &
            'alpha 0, or 1e-14 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= nu <= 0.5', stat, errmsg)
    end subroutine

    !> At the surface: the maximum of J2 over y = 0. It is at 0 <= x <= min(alpha, 1). RWEDGE_EABSENT
    !> for nu = 0.5 and f = 0, where J2 is 0 on the surface.
    !>   alpha  0, or at least 1e-14
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL.   Fig. 4; new
    impure elemental subroutine rwedge_surface_yield(alpha, f, nu, limit, x, stat, errmsg)
        real(c_double), intent(in) :: alpha, f, nu
        real(c_double), intent(inout) :: limit, x
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_surface_yield(alpha, f, nu, limit, x), 'rwedge_surface_yield(alpha, f, nu)', [alpha, f, nu], &
            'alpha 0, or 1e-14 to 1e60; 0 <= f <= 1e6, 0 or at least 1e-60; 0 <= nu <= 0.5', stat, errmsg)
    end subroutine

    !> Critical friction: the f at which yield jumps from below to the surface. It is 0 where yield is
    !> at the surface without friction already. (The smallest of these tips, a/b < 0.0026, yield
    !> below the surface again in an interval of f: lib/README.md.)   Fig. 4; new
    !>   alpha  0, or at least 1e-14; the sharp wedge yields at its apex: 0
    !> NaN outside the domain. Error below 1e-11 f, or 1e-14/f next to its zero, from which it rises
    !> like a square root.
    elemental function rwedge_critical_friction(alpha, nu) result(value)
        real(c_double), intent(in) :: alpha, nu
        real(c_double) :: value
        value = c_critical_friction(alpha, nu)
    end function

    ! ---- Validity -----------------------------------------------------------------------------------------------------

    !> What makes the results for such a contact doubtful, as a sum of bits: rwedge_validity_text()
    !> says what each means. The sum is 0 where nothing does. What is not known is given as NaN; it adds
    !> no doubt. Nor does a 0, except as safety.   new
    !>   theta     any number; the angle between flank and surface, rad
    !>   alpha     any number; a/b under the load; 0 is the sharp wedge
    !>   beta      any number; rwedge_dundurs_beta()
    !>   f         any number; the coefficient of friction
    !>   k_over_E  any number; yield stress in pure shear over Young's modulus of the half-plane
    !>   safety    any number; rwedge_yield_load() over P, or that of rwedge_contact_yield_factor()
    elemental function rwedge_validity(theta, alpha, beta, f, k_over_E, safety) result(value)
        real(c_double), intent(in) :: theta, alpha, beta, f, k_over_E, safety
        integer(c_int32_t) :: value
        value = c_validity(theta, alpha, beta, f, k_over_E, safety)
    end function

    !> What one bit of rwedge_validity() means, in English: a line for messages. Empty for any other
    !> number. To list all bits, go through 1, 2, 4 ... until the text is empty.
    !> Static text, never NULL.
    !>   doubt  any integer
    function rwedge_validity_text(doubt) result(text)
        integer(c_int32_t), intent(in) :: doubt
        character(:), allocatable :: text
        text = text_of(c_validity_text(doubt))
    end function

    ! ---- Dimensional quantities ---------------------------------------------------------------------------------------

    !> Radius of the rounding, R = a/theta, length.   Sec. 2
    elemental function rwedge_radius(theta, a) result(value)
        real(c_double), intent(in) :: theta, a
        real(c_double) :: value
        value = c_radius(theta, a)
    end function

    !> Half-width of the rounding from its radius, a = R theta, length.   Sec. 2
    !>   R  radius, length, finite, >= 0
    elemental function rwedge_rounding(theta, R) result(value)
        real(c_double), intent(in) :: theta, R
        real(c_double) :: value
        value = c_rounding(theta, R)
    end function

    !> Half-width b of the contact under the load P, length.   Eq. (7), (11), (15), inverse
    !>   P  finite, >= 0; 0 gives 0
    !> Relative error below 1e-14. Inverse: rwedge_normal_load().
    elemental function rwedge_half_width(theta, a, compliance, P) result(value)
        real(c_double), intent(in) :: theta, a, compliance, P
        real(c_double) :: value
        value = c_half_width(theta, a, compliance, P)
    end function

    !> The load P whose contact has the half-width b, force/length.   Eq. (7), (11), (15)
    !>   b  length, finite, >= 0; 0 gives 0
    !> Relative error below 1e-14. Inverse: rwedge_half_width().
    elemental function rwedge_normal_load(theta, a, compliance, b) result(value)
        real(c_double), intent(in) :: theta, a, compliance, b
        real(c_double) :: value
        value = c_normal_load(theta, a, compliance, b)
    end function

    !> The load P at which a given contact first yields in full sliding, or under a normal load (f =
    !> 0), force/length. The contact grows with P, and the elastic limit depends on a/b: P is the root
    !> of an equation.   Figs. 3 to 5
    !>   nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
    !> It is 0 for the sharp wedge. It is HUGE_VAL where the contact does not yield before it is 1e14
    !> a wide. For f = 0 and nu = 0.5 it never yields if k > (2/pi) theta/A: the deviator stays
    !> bounded however large the load. Relative error below 1e-11, and 1e-15 dlnP/dlnk, which is large
    !> for f = 0 and nu near 0.5.
    elemental function rwedge_yield_load(theta, a, compliance, f, nu, k) result(value)
        real(c_double), intent(in) :: theta, a, compliance, f, nu, k
        real(c_double) :: value
        value = c_yield_load(theta, a, compliance, f, nu, k)
    end function

    ! ---- A contact with a load history --------------------------------------------------------------------------------

    !> A contact without load, separated.
    !>   contact  receives the handle
    !> RWEDGE_EDOMAIN where theta/A leaves the domain too; RWEDGE_ENULL; RWEDGE_ENOMEM.
    subroutine contact_create(this, theta, a, compliance, f, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        real(c_double), intent(in) :: theta, a, compliance, f
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: created
        integer(c_int32_t) :: status
        status = c_contact_create(theta, a, compliance, f, created)
        if (status == rwedge_ok) call own_contact(this, created)
        call conclude(status, 'rwedge_contact%create(theta, a, compliance, f)', [theta, a, compliance, f], &
            '0 < theta < pi/2, at least 1e-60; a 0, or 1e-60 to 1e60; compliance 1e-60 to 1e60; 0 <= f <=' // &
            ' 1e6, 0 or at least 1e-60', stat, errmsg)
    end subroutine

    !> How much a bulk tension stretches the surface of the half-plane against that of the wedge: A/4 of
    !> the tension unless it is set. That is right for bodies of equal compliance. For others it is
    !> (1 - nu1^2)/E1 of the tension, E1 and nu1 being those of the half-plane.   new
    !>   strain_per_tension  strain over tension, 1/stress, finite, >= 0, also over A
    !> RWEDGE_EDOMAIN where the bodies touch: it is set before the first load, or when they are
    !> separated; RWEDGE_ENULL.
    subroutine contact_set_strain(this, strain_per_tension, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        real(c_double), intent(in) :: strain_per_tension
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_set_strain(own(this), strain_per_tension), 'rwedge_contact%set_strain(strain_per_tension)', &
            [strain_per_tension], &
            'strain_per_tension 0, or 1e-60 to 1e60', stat, errmsg)
    end subroutine

    !> An independent copy, history and all: to try a load and go back.
    !> RWEDGE_ENULL, RWEDGE_ENOMEM.
    subroutine contact_copy(this, from, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        type(rwedge_contact), intent(in) :: from
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: created
        integer(c_int32_t) :: status
        status = c_contact_copy(own(from), created)
        if (status == rwedge_ok) call own_contact(this, created)
        call conclude(status, 'rwedge_contact%copy()', [real(c_double) ::], '', stat, errmsg)
    end subroutine

    !> The next point of the history, reached in a straight line of the (P, Q) plane from the last one.
    !>    Sec. 3.2; new
    !>   P  0, or 1e-60 to 1e60; not below 1e-8 of the last P: but 0 may follow any load. It separates
    !>      the bodies (Q must then be 0 too), and all but the dissipated energy is forgotten
    !>   Q  |Q| <= f P; equality is full sliding, to 8 epsilon of f times the larger of P and the last
    !>      P, or the largest P since it slides: a ramp may be interpolated in any number of steps
    !> RWEDGE_ESLIDING where |Q| > f P. RWEDGE_EDOMAIN. RWEDGE_ERANGE where the half-width, a/b, the
    !> peak pressure or the energy leaves the domain. RWEDGE_ERANGE too where P is not 0 but below
    !> 1e-8 of the last P, whose rounding would blur what Q/(fP) is: go there in two loads. RWEDGE_EPATH
    !> after a moment or another tension, as rwedge_contact_apply(). RWEDGE_ENULL; RWEDGE_ENOMEM. Unless
    !> RWEDGE_OK, the contact is as before. It remembers at most two points of the history per load, and
    !> of them only those that its tractions or its slip still depend on.
    subroutine contact_load(this, P, Q, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        real(c_double), intent(in) :: P, Q
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_load(own(this), P, Q), 'rwedge_contact%load(P, Q)', [P, Q], &
            'P 0, or 1e-60 to 1e60, not below 1e-8 of the last P; 0, or 1e-60 to 1e60 in magnitude, |Q| ' // &
            '<= f P', stat, errmsg)
    end subroutine

    !> The next point of the history with a moment and a bulk tension, reached in a straight line of all
    !> four.   new
    !>   P      0, or at least 1e-8 of the last P: as for rwedge_contact_load()
    !>   M      moment about x = 0 per unit length, a force, finite; positive presses the right side; 0
    !>          where P is 0
    !>   Q      |Q| <= f P, as for rwedge_contact_load()
    !>   sigma  bulk tension of the half-plane, stress, finite: added to its sxx. It stretches the
    !>          surface against the wedge's, by A sigma/4 or as rwedge_contact_set_strain() says, and
    !>          so makes it slip. Apply it while P is 0 to have it without slip
    !> rwedge_contact_load() keeps M and sigma as they are, and drops M where P is 0. The result is
    !> exact without friction, and where |Q| = f P. It is exact without moment and under one sigma,
    !> whatever P and Q do. It is exact under constant P and M, where both edges slip the same way:
    !> |d sigma| <= 4 |dQ|/(pi s), s being the half-width of the contact, for a strain of A/4. It is
    !> exact where both edges of the contact move outwards, or both inwards, and both slip the same way
    !> or stick. Other loads have no closed form. Nor have loads that bring the front of slip between
    !> two patches of the memory at one edge, and between two others at the other edge, or that leave a
    !> part beyond the front that sticks: lib/README.md, "Moment and bulk tension".
    !> RWEDGE_EPATH where no closed form is shown: rwedge_contact_obstacle() says why. RWEDGE_EDOMAIN
    !> where M tilts the wedge by theta (1 - 1e-9) or more, so that a flank all but lies on the
    !> surface. The others as rwedge_contact_load(): RWEDGE_ESLIDING; RWEDGE_ERANGE; RWEDGE_ENULL;
    !> RWEDGE_ENOMEM.
    subroutine contact_apply(this, P, M, Q, sigma, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        real(c_double), intent(in) :: P, M, Q, sigma
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_apply(own(this), P, M, Q, sigma), 'rwedge_contact%apply(P, M, Q, sigma)', [P, M, Q, sigma], &
            'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
            'magnitude, 0 where P is 0; 0, or 1e-60 to 1e60 in magnitude, |Q| <= f P; sigma 0, or 1e-60 ' // &
            'to 1e60 in magnitude', stat, errmsg)
    end subroutine

    !> Why rwedge_contact_apply() would return RWEDGE_EPATH for these loads, and what to do instead, in
    !> English; empty where it would not.   new
    !>   arguments as for rwedge_contact_apply(); the contact stays as it is
    !> Static text, never NULL.
    function contact_obstacle(this, P, M, Q, sigma) result(text)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: P, M, Q, sigma
        character(:), allocatable :: text
        text = text_of(c_contact_obstacle(own(this), P, M, Q, sigma))
    end function

    !> The largest |d sigma| with which the present Q may change to another under constant P and M,
    !> stress: 4 |dQ|/(pi s), for a strain of A/4 per tension. HUGE_VAL without friction, and where a
    !> tension stretches nothing.   new
    !>   Q  finite
    !> NaN outside the domain; NaN for NULL; 0 when separated. Relative error as that of the edges.
    elemental function contact_largest_tension_step(this, Q) result(value)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: Q
        real(c_double) :: value
        value = c_contact_largest_tension_step(own(this), Q)
    end function

    !> The present loads.   new
    !>   P, M, Q, sigma  each receives one number
    !> RWEDGE_ENULL.
    impure elemental subroutine contact_loads(this, P, M, Q, sigma, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(inout) :: P, M, Q, sigma
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_loads(own(this), P, M, Q, sigma), 'rwedge_contact%loads()', [real(c_double) ::], &
            '', stat, errmsg)
    end subroutine

    !> The edges of the contact, left < x < right.   new
    !>   left, right  length
    !> RWEDGE_EABSENT when separated; RWEDGE_ENULL. Error below 1e-14 of the width, or of |x| where that
    !> is larger, over 1 - |tilt|/theta.
    impure elemental subroutine contact_edges(this, left, right, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(inout) :: left, right
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_edges(own(this), left, right), 'rwedge_contact%edges()', [real(c_double) ::], '', stat, errmsg)
    end subroutine

    !> The edges of the stick zone: between them and those of the contact friction is exhausted, |q| = f
    !> |p|. Those of the contact where there is no such zone.   new
    !>   left, right  length
    !> RWEDGE_EABSENT in full sliding, and when separated; RWEDGE_ENULL. After one step of Q and sigma
    !> the error is that of the contact's edges, over the root of the part of P that the zone carries,
    !> and with the zone's tilt where that is larger.
    impure elemental subroutine contact_stick_zone(this, left, right, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(inout) :: left, right
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_stick_zone(own(this), left, right), 'rwedge_contact%stick_zone()', [real(c_double) ::], &
            '', stat, errmsg)
    end subroutine

    !> The angle by which the moment tilts the wedge, rad: |tilt| < theta.   new
    !> 0 without a moment; NaN for NULL. Error below 1e-14 theta, where the edges have their relative
    !> error.
    pure function contact_tilt(this) result(value)
        class(rwedge_contact), intent(in) :: this
        real(c_double) :: value
        value = c_contact_tilt(own(this))
    end function

    !> How pressure and shear behave at the edges, at the distance r: |p| ~ K_N sqrt(r), and, as long as
    !> slip is short, q ~ -K_T/sqrt(r), which slips over the length 2 |K_T|/(f K_N): to 0.1 % at Q/(fP)
    !> = 0.001, 9 % at 0.1, 35 % at 0.5. Two contacts of the same K_N and K_T are alike at their edges:
    !> this is how a pad is matched to a specimen.   new
    !>   normal_left, normal_right  K_N, stress over the root of a length
    !>   shear_left, shear_right    K_T, stress times the root of a length, of the present Q and of
    !>                              the strain by sigma less what it was when the bodies touched
    !> RWEDGE_EABSENT when separated; RWEDGE_ENULL. K_N to 1e-14 of the larger one, of the edges that
    !> rwedge_contact_edges() gives.
    impure elemental subroutine contact_edge_asymptotes(this, normal_left, normal_right, shear_left, shear_right, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(inout) :: normal_left, normal_right, shear_left, shear_right
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_contact_edge_asymptotes(own(this), normal_left, normal_right, shear_left, shear_right), &
            'rwedge_contact%edge_asymptotes()', [real(c_double) ::], &
            '', stat, errmsg)
    end subroutine

    !> The zone that never slips while loads go to and fro between two points in a straight line, once
    !> the first cycles are over, whatever was before.   new
    !>   P1, P2          finite, >= 0, as for rwedge_contact_apply()
    !>   M1, M2          finite; 0 where P is 0
    !>   Q1, Q2          |Q| <= f P
    !>   sigma1, sigma2  finite
    !>   left, right     its edges, length
    !> The compliances are equal: a tension stretches the surface by A/4 of it.
    !> RWEDGE_EABSENT where all slides at times; RWEDGE_EPATH where the edges slip in opposite
    !> directions, or what sticks would reach beyond one of the contacts; RWEDGE_ESLIDING,
    !> RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Error as that of
    !> rwedge_contact_stick_zone().
    impure elemental subroutine rwedge_permanent_stick(theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2, left, &
        right, stat, errmsg)
        real(c_double), intent(in) :: theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2
        real(c_double), intent(inout) :: left, right
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_permanent_stick(theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2, left, right), &
            'rwedge_permanent_stick(theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2)', [theta, a, compliance, &
            f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2], &
            '0 < theta < pi/2, at least 1e-60; a 0, or 1e-60 to 1e60; compliance 1e-60 to 1e60; 0 <= f <=' // &
            ' 1e6, 0 or at least 1e-60; P1 0, or 1e-60 to 1e60; M1 0, or 1e-60 to 1e60 in magnitude, 0 ' // &
            'where P is 0; Q1 0, or 1e-60 to 1e60 in magnitude, |Q| <= f P; sigma1 0, or 1e-60 to 1e60 in' // &
            ' magnitude; P2 0, or 1e-60 to 1e60; M2 0, or 1e-60 to 1e60 in magnitude, 0 where P is 0; Q2 ' // &
            '0, or 1e-60 to 1e60 in magnitude, |Q| <= f P; sigma2 0, or 1e-60 to 1e60 in magnitude', stat, errmsg)
    end subroutine

    !> Half-width b of the contact, length; 0 when separated; NaN for NULL. Half its width where it is
    !> off the centre.
    !>    Eq. (7), (11), (15), inverse
    pure function contact_half_width(this) result(value)
        class(rwedge_contact), intent(in) :: this
        real(c_double) :: value
        value = c_contact_half_width(own(this))
    end function

    !> Half-width c of the stick zone, length. Outside it, c < |x| < b, friction is exhausted: |q| = f
    !> |p|. So it is in a ring that came into contact with |dQ| = f dP, to rounding, though it has not
    !> slipped. c is b where all sticks, 0 in full sliding and when separated; NaN for NULL.
    !>    Eq. (25); new
    pure function contact_stick_half_width(this) result(value)
        class(rwedge_contact), intent(in) :: this
        real(c_double) :: value
        value = c_contact_stick_half_width(own(this))
    end function

    !> How many points of its history the contact remembers: those that its tractions depend on, and
    !> those that its slip is measured from. At most two per load, and some tens after any number of
    !> loads that dither around one point; 0 when separated, and for NULL. The memory it takes grows in
    !> proportion; so does the time of its functions, at most, for each point of the half-plane.
    pure function contact_memory(this) result(value)
        class(rwedge_contact), intent(in) :: this
        integer(c_size_t) :: value
        value = c_contact_memory(own(this))
    end function

    !> Pressure p and shear traction q at n points of the surface, stress: compression negative; q =
    !> f p where it slips under Q > 0. Both are 0 for |x| >= b.   Eq. (8), (12), (14), (22) to (27)
    !>   x     length, finite; not the apex 0 of a loaded sharp wedge
    !>   p, q  each receives n numbers
    !> RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
    !> Error of p as rwedge_pressure(), of q below 1e-13 f (theta/A + |p|).
    subroutine contact_tractions(this, x, p, q, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: x(:)
        real(c_double), intent(inout) :: p(:), q(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double) :: s(2)
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(p), size(q)] == size(x))) &
            status = c_contact_tractions(own(this), size(x, kind=c_size_t), x, p, q)
        if (status == rwedge_edomain) then
            do i = 1, size(x)
                if (c_contact_tractions(own(this), 1_c_size_t, x(i:i), s(1:1), s(2:2)) == rwedge_ok) cycle
                call conclude(status, 'rwedge_contact%tractions(x)', [x(i)], &
                    'x 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge', stat, errmsg, i)
                return
            end do
        end if
        call conclude(status, 'rwedge_contact%tractions(...)', [real(c_double) ::], &
            'x 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge; arrays of one ' // &
            'size', stat, errmsg)
    end subroutine

    !> The same of arrays of rank 2.
    subroutine contact_tractions_of_grid(this, x, p, q, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: x(:, :)
        real(c_double), intent(inout) :: p(:, :), q(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double), allocatable :: list_p(:), list_q(:)
        if (.not. (all([size(p, 1), size(q, 1)] == size(x, 1)) .and. all([size(p, 2), size(q, 2)] == size(x, 2)))) then
            call conclude(rwedge_erange, 'rwedge_contact%tractions(...)', [real(c_double) ::], 'arrays of one shape', stat, &
                &errmsg)
            return
        end if
        list_p = reshape(p, [size(p)])
        list_q = reshape(q, [size(q)])
        call this%tractions(reshape(x, [size(x)]), list_p, list_q, stat, errmsg)
        p = reshape(list_p, shape(p))
        q = reshape(list_q, shape(q))
    end subroutine

    !> Stresses at n points (x, y) of the half-plane, tension positive.   Eq. (28), (32), (33); new
    !>   x, y           length, finite, y >= 0; not the apex (0, 0) of a loaded sharp wedge
    !>   sxx, syy, txy  each receives n numbers
    !> RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
    !> Error below 1e-13 of what rwedge_stress() says, for every remembered point of the history.
    subroutine contact_stresses(this, x, y, sxx, syy, txy, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: x(:), y(:)
        real(c_double), intent(inout) :: sxx(:), syy(:), txy(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double) :: s(3)
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(y), size(sxx), size(syy), size(txy)] == size(x))) &
            status = c_contact_stresses(own(this), size(x, kind=c_size_t), x, y, sxx, syy, txy)
        if (status == rwedge_edomain) then
            do i = 1, size(x)
                if (c_contact_stresses(own(this), 1_c_size_t, x(i:i), y(i:i), s(1:1), s(2:2), s(3:3)) == rwedge_ok) cycle
                call conclude(status, 'rwedge_contact%stresses(x, y)', [x(i), y(i)], &
                    'x 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y ' // &
                    '0, or 1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge', stat, errmsg, i)
                return
            end do
        end if
        call conclude(status, 'rwedge_contact%stresses(...)', [real(c_double) ::], &
            'x 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
            '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; arrays of one size', stat, errmsg)
    end subroutine

    !> The same of arrays of rank 2.
    subroutine contact_stresses_of_grid(this, x, y, sxx, syy, txy, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: x(:, :), y(:, :)
        real(c_double), intent(inout) :: sxx(:, :), syy(:, :), txy(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double), allocatable :: list_sxx(:), list_syy(:), list_txy(:)
        if (.not. (all([size(y, 1), size(sxx, 1), size(syy, 1), size(txy, 1)] == size(x, 1)) .and. all([size(y, 2), size(sxx, &
            2), size(syy, 2), size(txy, 2)] == size(x, 2)))) then
            call conclude(rwedge_erange, 'rwedge_contact%stresses(...)', [real(c_double) ::], 'arrays of one shape', stat, &
                &errmsg)
            return
        end if
        list_sxx = reshape(sxx, [size(sxx)])
        list_syy = reshape(syy, [size(syy)])
        list_txy = reshape(txy, [size(txy)])
        call this%stresses(reshape(x, [size(x)]), reshape(y, [size(y)]), list_sxx, list_syy, list_txy, stat, errmsg)
        sxx = reshape(list_sxx, shape(sxx))
        syy = reshape(list_syy, shape(syy))
        txy = reshape(list_txy, shape(txy))
    end subroutine

    !> Stresses at n points while the contact goes on through many loads: as rwedge_contact_apply() and
    !> rwedge_contact_stresses() after each, to the same bits. It is faster: what a load leaves as it
    !> was is not computed again.   new
    !>   P              0, or at least 1e-8 of the last P
    !>   M, Q, sigma    finite: loads numbers each, as P
    !>   x, y           length, finite, y >= 0: n numbers each
    !>   sxx, syy, txy  each receives loads * n numbers, the n of the first load first; not one of the
    !>                  inputs
    !> The contact then has the last of the loads. After an error the contact is as before and
    !> nothing is written. RWEDGE_EDOMAIN where one of both functions has it; RWEDGE_EPATH;
    !> RWEDGE_ESLIDING; RWEDGE_ERANGE; RWEDGE_ENULL; RWEDGE_ENOMEM.
    subroutine contact_stress_history(this, P, M, Q, sigma, x, y, sxx, syy, txy, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        real(c_double), intent(in) :: P(:), M(:), Q(:), sigma(:), x(:), y(:)
        real(c_double), intent(inout) :: sxx(:, :), syy(:, :), txy(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(M), size(Q), size(sigma)] == size(P)) .and. size(y) == size(x) .and. all(shape(sxx) == [size(x), &
            size(P)]) .and. all(shape(syy) == [size(x), size(P)]) .and. all(shape(txy) == [size(x), size(P)])) &
            status = c_contact_stress_history(own(this), size(P, kind=c_size_t), P, M, Q, sigma, size(x, kind=c_size_t), x, &
                y, sxx, syy, txy)
        i = first_outside(P, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%stress_history(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(M, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%stress_history(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(Q, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%stress_history(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(sigma, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%stress_history(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(x, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%stress_history(x, y)', [x(i), y(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(y, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%stress_history(x, y)', [x(i), y(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_contact%stress_history(size(P), size(x))', [real(size(P), c_double), real(size(x), &
            c_double)], &
            'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
            'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x 0, ' // &
            'or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to 1e60; arrays of one size', stat, errmsg)
    end subroutine

    !> How many numbers rwedge_contact_state() gives for the contact as it is; 0 for NULL.   new
    pure function contact_state_size(this) result(value)
        class(rwedge_contact), intent(in) :: this
        integer(c_size_t) :: value
        value = c_contact_state_size(own(this))
    end function

    !> The contact as numbers, for restarts and for other processes. A contact that is made of them
    !> gives the same bits from then on. They have no other use. Their form has a version: this library
    !> reads its own and those of older libraries.   new
    !>   n      rwedge_contact_state_size()
    !>   state  receives n numbers
    !> RWEDGE_ENULL; RWEDGE_ERANGE for another n.
    subroutine contact_state(this, state, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(inout) :: state(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        status = c_contact_state(own(this), size(state, kind=c_size_t), state)
        call conclude(status, 'rwedge_contact%state()', [real(c_double) ::], '', stat, errmsg)
    end subroutine

    !> The contact of such numbers.   new
    !>   state    not other than rwedge_contact_state() gave it: HUGE_VAL and NaN may be in it
    !>   contact  receives the handle
    !> RWEDGE_EDOMAIN where the numbers are not those of a contact, RWEDGE_ENULL, RWEDGE_ENOMEM. Free
    !> with rwedge_contact_destroy().
    subroutine contact_restore(this, state, stat, errmsg)
        class(rwedge_contact), intent(inout) :: this
        real(c_double), intent(in) :: state(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: created
        integer(c_int32_t) :: status
        integer :: i
        status = c_contact_restore(size(state, kind=c_size_t), state, created)
        if (status == rwedge_ok) call own_contact(this, created)
        i = first_outside(state, -huge(1.0_c_double), huge(1.0_c_double), 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%restore(state)', [state(i)], &
                'state not other than rwedge_contact_state() gave it', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_contact%restore(size(state))', [real(size(state), c_double)], &
            'state not other than rwedge_contact_state() gave it', stat, errmsg)
    end subroutine

    !> Slip at n points of the surface, length: how far the half-plane's surface has moved tangentially,
    !> relative to the wedge's, since the point last came into contact. It has the sign of q while it
    !> grows, so that q d(slip) is the heat. It is 0 where a point has stuck ever since. In full
    !> sliding the loads do not determine the rigid displacement. The slip is then the least that the
    !> loads need: the centre of the contact is on the verge of slip.
    !>    Eq. (17) to (21); new
    !>   x     length, |x| <= b: points outside have no partner
    !>   slip  receives n numbers
    !> RWEDGE_EPATH off the centre where rings of contact slipped at once when they came into contact,
    !> or slipped after they had been added to others that slipped before, and in full sliding.
    !> RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
    !> Error below 1e-12 f theta b, for loads that differ by 1 % or more.
    subroutine contact_slip(this, x, slip, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: x(:)
        real(c_double), intent(inout) :: slip(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double) :: s(1)
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (size(slip) == size(x)) &
            status = c_contact_slip(own(this), size(x, kind=c_size_t), x, slip)
        if (status == rwedge_edomain) then
            do i = 1, size(x)
                if (c_contact_slip(own(this), 1_c_size_t, x(i:i), s(1:1)) == rwedge_ok) cycle
                call conclude(status, 'rwedge_contact%slip(x)', [x(i)], &
                    '0, or 1e-60 to 1e60 in magnitude, |x| <= b', stat, errmsg, i)
                return
            end do
        end if
        call conclude(status, 'rwedge_contact%slip(...)', [real(c_double) ::], &
            '0, or 1e-60 to 1e60 in magnitude, |x| <= b; arrays of one size', stat, errmsg)
    end subroutine

    !> The same of arrays of rank 2.
    subroutine contact_slip_of_grid(this, x, slip, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: x(:, :)
        real(c_double), intent(inout) :: slip(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double), allocatable :: list_slip(:)
        if (.not. (all([size(slip, 1)] == size(x, 1)) .and. all([size(slip, 2)] == size(x, 2)))) then
            call conclude(rwedge_erange, 'rwedge_contact%slip(...)', [real(c_double) ::], 'arrays of one shape', stat, &
                &errmsg)
            return
        end if
        list_slip = reshape(slip, [size(slip)])
        call this%slip(reshape(x, [size(x)]), list_slip, stat, errmsg)
        slip = reshape(list_slip, shape(slip))
    end subroutine

    !> Energy dissipated by friction since the contact was created, per unit thickness (a force): the
    !> time integral of the traction times the rate of slip over the contact, without the rigid
    !> displacement in full sliding. It never falls. In a cycle under constant P it is the area of the
    !> loop of Q over the rigid displacement.   new
    !> NaN for NULL. A load off the centre that slips while P or M change, or slides, has no single
    !> integral: the energy is then NaN until the first load after the bodies have separated, from
    !> which it counts again. What was dissipated between is missing in the sum. Relative error of each
    !> load's share below 1e-12, and epsilon times P over the change of Q/f where that slip reaches an
    !> older layer. Off the centre it is below 1e-12 and 1e-14 times P over the change of Q/f. Both grow
    !> with 1/(1 - |tilt|/theta), and with |x| at the edges over the width where that is above 1.
    pure function contact_dissipated_energy(this) result(value)
        class(rwedge_contact), intent(in) :: this
        real(c_double) :: value
        value = c_contact_dissipated_energy(own(this))
    end function

    !> How far the present state is from first yield (von Mises, plane strain): k over the maximum of
    !> sqrt(J2) over the half-plane. Loads times this factor would not just yield, because the contact
    !> grows with them: see rwedge_yield_load().
    !>   nu      Poisson's ratio of the half-plane, 0 <= nu <= 0.5
    !>   factor  receives the factor: above 1 all is elastic; 0 where the stress is infinite, at the
    !>           apex of the sharp wedge
    !>   x, y    where the maximum is, length; each may be NULL
    !> The search is for the global maximum, around each remembered edge of slip, at every scale. It
    !> takes as long as the stresses at about 7000 points for a first load, and at 25 000 where
    !> rwedge_contact_memory() is 250. RWEDGE_EABSENT when separated: there is no stress.
    !> RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ERANGE where the factor leaves the domain. Relative error
    !> below 1e-12.
    subroutine contact_yield_factor(this, nu, k, factor, x, y, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: nu, k
        real(c_double), intent(inout) :: factor
        real(c_double), intent(inout), optional :: x, y
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        real(c_double) :: place(2)
        integer(c_int32_t) :: status
        status = c_contact_yield_factor(own(this), nu, k, factor, place(1), place(2))
        if (status == rwedge_ok .and. present(x)) x = place(1)
        if (status == rwedge_ok .and. present(y)) y = place(2)
        call conclude(status, 'rwedge_contact%yield_factor(nu, k)', [nu, k], '0 <= nu <= 0.5; k 1e-60 to 1e60', stat, errmsg)
    end subroutine

    ! ---- A cycle of loads ---------------------------------------------------------------------------------------------

    !> Fatigue parameters at n points of the half-plane, from the stresses after each load.   new
    !>   x, y            length, finite, y >= 0: n numbers each; not the apex (0, 0) of a loaded sharp
    !>                   wedge
    !>   stress_range    receives n numbers: largest less smallest sxx
    !>   swt, swt_angle  each receives n numbers: rwedge_smith_watson_topper()
    !>   fatemi_socie, fs_angle  each receives n numbers: rwedge_fatemi_socie()
    !> RWEDGE_EDOMAIN, RWEDGE_EPATH, RWEDGE_ESLIDING, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Errors
    !> as those of the functions that are named.
    subroutine contact_cycle_fatigue(this, P, M, Q, sigma, x, y, E, nu, k_over_sy, stress_range, swt, swt_angle, &
        fatemi_socie, fs_angle, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: P(:), M(:), Q(:), sigma(:), x(:), y(:), E, nu, k_over_sy
        real(c_double), intent(inout) :: stress_range(:), swt(:), swt_angle(:), fatemi_socie(:), fs_angle(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(M), size(Q), size(sigma)] == size(P)) .and. all([size(y), size(stress_range), size(swt), &
            size(swt_angle), size(fatemi_socie), size(fs_angle)] == size(x))) &
            status = c_contact_cycle_fatigue(own(this), size(P, kind=c_size_t), P, M, Q, sigma, size(x, kind=c_size_t), x, y, &
                E, nu, k_over_sy, stress_range, swt, swt_angle, fatemi_socie, fs_angle)
        i = first_outside(P, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_fatigue(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
                '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= ' // &
                '0.5; k_over_sy 0 or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(M, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_fatigue(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
                '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= ' // &
                '0.5; k_over_sy 0 or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(Q, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_fatigue(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
                '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= ' // &
                '0.5; k_over_sy 0 or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(sigma, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_fatigue(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
                '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= ' // &
                '0.5; k_over_sy 0 or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(x, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_fatigue(x, y)', [x(i), y(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
                '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= ' // &
                '0.5; k_over_sy 0 or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(y, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_fatigue(x, y)', [x(i), y(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or ' // &
                '1e-60 to 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= ' // &
                '0.5; k_over_sy 0 or 1e-60 to 1e60', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_contact%cycle_fatigue(size(P), size(x), E, nu, k_over_sy)', [real(size(P), c_double), &
            real(size(x), c_double), E, nu, k_over_sy], &
            'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
            'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x 0, ' // &
            'or 1e-60 to 1e60 in magnitude, not the apex (0, 0) of a loaded sharp wedge; y 0, or 1e-60 to' // &
            ' 1e60, not the apex (0, 0) of a loaded sharp wedge; E 1e-60 to 1e60; 0 <= nu <= 0.5; ' // &
            'k_over_sy 0 or 1e-60 to 1e60; arrays of one size', stat, errmsg)
    end subroutine

    !> What friction does at n places of the surface in the cycle. All is 0 where there is no contact.
    !> Slip counts from when a place came into contact. Where the contact leaves it and comes back, slip
    !> goes on from where it ended.   Ruiz, Boddington, Chen (1984), see lib/README.md; new
    !>   x           length, finite: n numbers; not the apex 0 of a loaded sharp wedge
    !>   slip_range  receives n numbers: largest less smallest slip, length
    !>   ruiz_f1     receives n numbers: largest |q| times slip range
    !>   ruiz_f2     receives n numbers: ruiz_f1 times the largest sxx after a load, 0 where that is not
    !>               tensile
    !>   energy      receives n numbers: dissipated per area, the integral of q d(slip)
    !> RWEDGE_EPATH where the slip has no closed form after one of the loads, or on the way to
    !> separation; RWEDGE_EDOMAIN, RWEDGE_ESLIDING, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Under
    !> constant P and M slip and energy are those of rwedge_contact_slip() and the tractions. Where they
    !> change, a step is cut into 32 parts: the energy of the contact then errs by 0.1 % in usual
    !> cycles, and by 1 % where little slips.
    subroutine contact_cycle_friction(this, P, M, Q, sigma, x, slip_range, ruiz_f1, ruiz_f2, energy, stat, errmsg)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: P(:), M(:), Q(:), sigma(:), x(:)
        real(c_double), intent(inout) :: slip_range(:), ruiz_f1(:), ruiz_f2(:), energy(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(M), size(Q), size(sigma)] == size(P)) .and. all([size(slip_range), size(ruiz_f1), size(ruiz_f2), &
            size(energy)] == size(x))) &
            status = c_contact_cycle_friction(own(this), size(P, kind=c_size_t), P, M, Q, sigma, size(x, kind=c_size_t), x, &
                slip_range, ruiz_f1, ruiz_f2, energy)
        i = first_outside(P, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_friction(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge', stat, errmsg, i)
            return
        end if
        i = first_outside(M, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_friction(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge', stat, errmsg, i)
            return
        end if
        i = first_outside(Q, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_friction(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge', stat, errmsg, i)
            return
        end if
        i = first_outside(sigma, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_friction(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge', stat, errmsg, i)
            return
        end if
        i = first_outside(x, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_friction(x)', [x(i)], &
                'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
                'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x' // &
                ' 0, or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_contact%cycle_friction(size(P), size(x))', [real(size(P), c_double), real(size(x), &
            c_double)], &
            'P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 to 1e60 in ' // &
            'magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in magnitude; x 0, ' // &
            'or 1e-60 to 1e60 in magnitude, not the apex 0 of a loaded sharp wedge; arrays of one size', stat, errmsg)
    end subroutine

    !> Where a measure of the cycle is largest on a line along x: at the places at which it is known, or
    !> between them, around its tops.   new
    !>   measure                 0 <= measure <= 6: RWEDGE_MEASURE_STRESS_RANGE to RWEDGE_MEASURE_ENERGY_PER_AREA
    !>   x                       length, finite; ascending: n numbers
    !>   value                   at least 0, finite: the measure there, n numbers, 0 where there is none
    !>   y                       depth, length, finite, y >= 0; 0 for slip, F1, F2 and energy
    !>   worst_x, worst_value    each receives one number
    !> RWEDGE_EDOMAIN where x does not ascend too; RWEDGE_ERANGE for n = 0; the others as in
    !> rwedge_contact_cycle_friction(). The place is found to 1e-10 of the distance of its neighbours
    !> where the top is not flat.
    subroutine contact_cycle_worst(this, measure, P, M, Q, sigma, x, value, y, E, nu, k_over_sy, worst_x, worst_value, stat, &
        errmsg)
        class(rwedge_contact), intent(in) :: this
        integer(c_int32_t), intent(in) :: measure
        real(c_double), intent(in) :: P(:), M(:), Q(:), sigma(:), x(:), value(:), y, E, nu, k_over_sy
        real(c_double), intent(inout) :: worst_x, worst_value
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(M), size(Q), size(sigma)] == size(P)) .and. size(value) == size(x)) &
            status = c_contact_cycle_worst(own(this), measure, size(P, kind=c_size_t), P, M, Q, sigma, size(x, &
                kind=c_size_t), x, value, y, E, nu, k_over_sy, worst_x, worst_value)
        i = first_outside(P, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_worst(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or ' // &
                '1e-60 to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to ' // &
                '1e60 in magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at ' // &
                'least 0; y 0, or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to' // &
                ' 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(M, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_worst(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or ' // &
                '1e-60 to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to ' // &
                '1e60 in magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at ' // &
                'least 0; y 0, or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to' // &
                ' 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(Q, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_worst(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or ' // &
                '1e-60 to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to ' // &
                '1e60 in magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at ' // &
                'least 0; y 0, or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to' // &
                ' 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(sigma, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_worst(P, M, Q, sigma)', [P(i), M(i), Q(i), sigma(i)], &
                '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or ' // &
                '1e-60 to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to ' // &
                '1e60 in magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at ' // &
                'least 0; y 0, or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to' // &
                ' 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(x, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_worst(x, value)', [x(i), value(i)], &
                '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or ' // &
                '1e-60 to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to ' // &
                '1e60 in magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at ' // &
                'least 0; y 0, or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to' // &
                ' 1e60', stat, errmsg, i)
            return
        end if
        i = first_outside(value, 0.0_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_contact%cycle_worst(x, value)', [x(i), value(i)], &
                '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or ' // &
                '1e-60 to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to ' // &
                '1e60 in magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at ' // &
                'least 0; y 0, or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to' // &
                ' 1e60', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_contact%cycle_worst(size(P), size(x), measure, y, E, nu, k_over_sy)', [real(size(P), &
            c_double), real(size(x), c_double), real(measure, c_double), y, E, nu, k_over_sy], &
            '0 <= measure <= 6; P 0, or 1e-60 to 1e60, 0, or at least 1e-8 of the last P; M 0, or 1e-60 ' // &
            'to 1e60 in magnitude; Q 0, or 1e-60 to 1e60 in magnitude; sigma 0, or 1e-60 to 1e60 in ' // &
            'magnitude; x 0, or 1e-60 to 1e60 in magnitude; value 0, or 1e-60 to 1e60, at least 0; y 0, ' // &
            'or 1e-60 to 1e60; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to 1e60; arrays of ' // &
            'one size', stat, errmsg)
    end subroutine

    !> How far remote points of the half-plane have moved along the surface against the wedge's, further
    !> than if the contact were bonded over |x| < b: what slip adds. Its loop over Q encloses the energy
    !> of a cycle under constant P. See lib/cycle/displacement.c.   new
    !>   b  length, > 0, finite
    !> NaN for NULL and when separated; NaN off the centre where the slip has no closed form, as in
    !> rwedge_contact_slip(). Relative error below 1e-12; off the centre 1e-6 of f theta times the
    !> half-width.
    elemental function contact_displacement(this, b) result(value)
        class(rwedge_contact), intent(in) :: this
        real(c_double), intent(in) :: b
        real(c_double) :: value
        value = c_contact_displacement(own(this), b)
    end function

    ! ---- Measures of a stress -----------------------------------------------------------------------------------------

    !> Von Mises' equivalent stress, sqrt(3 J2).   von Mises (1913)
    !> NaN outside the domain. Relative error below 4 epsilon.
    elemental function rwedge_von_mises(sxx, syy, txy, nu) result(value)
        real(c_double), intent(in) :: sxx, syy, txy, nu
        real(c_double) :: value
        value = c_von_mises(sxx, syy, txy, nu)
    end function

    !> The stress across the plane of x and y, szz = nu (sxx+syy). It is a principal stress.
    !> NaN outside the domain. Relative error below 4 epsilon.
    elemental function rwedge_out_of_plane_stress(sxx, syy, nu) result(value)
        real(c_double), intent(in) :: sxx, syy, nu
        real(c_double) :: value
        value = c_out_of_plane_stress(sxx, syy, nu)
    end function

    !> The largest shear stress on any plane: half of the difference between the largest and the
    !> smallest principal stress, szz among them.   Tresca (1864)
    !> NaN outside the domain. Relative error below 4 epsilon.
    elemental function rwedge_largest_shear(sxx, syy, txy, nu) result(value)
        real(c_double), intent(in) :: sxx, syy, txy, nu
        real(c_double) :: value
        value = c_largest_shear(sxx, syy, txy, nu)
    end function

    !> Principal stresses in the plane of x and y, s1 >= s2, and the plane on which s1 acts.
    !>   s1, s2  each receives one number
    !>   angle   receives the angle between that plane's normal and the surface's normal, the y axis,
    !>           rad, -pi/2 < angle <= pi/2. The plane's normal is (x, y) = (sin(angle), cos(angle)):
    !>           positive angles turn from +y towards +x. 0 where s1 = s2
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL. Error of s1 and s2 below 4 epsilon of the larger magnitude of the
    !> two, of the angle below 4 epsilon.
    impure elemental subroutine rwedge_principal_stresses(sxx, syy, txy, s1, s2, angle, stat, errmsg)
        real(c_double), intent(in) :: sxx, syy, txy
        real(c_double), intent(inout) :: s1, s2, angle
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_principal_stresses(sxx, syy, txy, s1, s2, angle), 'rwedge_principal_stresses(sxx, syy, txy)', [sxx, &
            syy, txy], &
            'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 in ' // &
            'magnitude', stat, errmsg)
    end subroutine

    !> Smith, Watson and Topper's parameter of a cycle of stresses at one point, a stress: the largest
    !> value of
    !>     sn_max den/2
    !> over the planes that contain z. In the cycle, sn_max is the plane's largest normal stress (0 for
    !> a plane that is never in tension), den the range of its normal strain. Strains are elastic and
    !> plane, exx = (1+nu)/E ((1-nu) sxx - nu syy). For plane stress give E (1+2nu)/(1+nu)^2 for E and
    !> nu/(1+nu) for nu.
    !>    Smith, Watson, Topper (1970); on planes Socie (1987); see lib/README.md; new
    !>   n              number of loads of the cycle, >= 1; their order does not matter
    !>   sxx, syy, txy  n stresses each
    !>   E              Young's modulus, stress, 1e-60 to 1e60
    !>   value, angle   each receives one number. The angle is that of the plane, as in
    !>                  rwedge_principal_stresses(); of one of them where several planes have the
    !>                  value, 0 where the value is 0
    !> RWEDGE_EDOMAIN; RWEDGE_ERANGE for n = 0; RWEDGE_ENULL. Error below 1e-14 s^2 (1+nu)/E, s being
    !> the largest principal stress of the cycle in magnitude: planes are not sampled, and none exceeds
    !> the value by more. The time grows like n; like n^2 where n is above 64 and many loads in turn
    !> are the worst for neighbouring planes, as on a circular path.
    subroutine rwedge_smith_watson_topper(sxx, syy, txy, E, nu, value, angle, stat, errmsg)
        real(c_double), intent(in) :: sxx(:), syy(:), txy(:), E, nu
        real(c_double), intent(inout) :: value, angle
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(syy), size(txy)] == size(sxx))) &
            status = c_smith_watson_topper(size(sxx, kind=c_size_t), sxx, syy, txy, E, nu, value, angle)
        i = first_outside(sxx, -1e+60_c_double, 1e+60_c_double, 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_smith_watson_topper(sxx, syy, txy)', [sxx(i), syy(i), txy(i)], &
                'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 ' // &
                'in magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; n >= 1', stat, errmsg, i)
            return
        end if
        i = first_outside(syy, -1e+60_c_double, 1e+60_c_double, 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_smith_watson_topper(sxx, syy, txy)', [sxx(i), syy(i), txy(i)], &
                'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 ' // &
                'in magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; n >= 1', stat, errmsg, i)
            return
        end if
        i = first_outside(txy, -1e+60_c_double, 1e+60_c_double, 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_smith_watson_topper(sxx, syy, txy)', [sxx(i), syy(i), txy(i)], &
                'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 ' // &
                'in magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; n >= 1', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_smith_watson_topper(size(sxx), E, nu)', [real(size(sxx), c_double), E, nu], &
            'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 in ' // &
            'magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; n >= 1; arrays of one size', stat, errmsg)
    end subroutine

    !> The same at n points.
    !>   loads          number of loads of the cycle, >= 1
    !>   sxx, syy, txy  loads * n stresses each: that of load i at point j is at [i n + j]
    !>   value, angle   each receives n numbers
    !> Nothing is written unless every stress is in the domain.
    subroutine rwedge_smith_watson_topper_field(sxx, syy, txy, E, nu, value, angle, stat, errmsg)
        real(c_double), intent(in) :: sxx(:, :), syy(:, :), txy(:, :), E, nu
        real(c_double), intent(inout) :: value(:), angle(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        status = rwedge_erange
        if (size(angle) == size(value) .and. all(shape(syy) == [size(value), size(sxx, &
            2)]) .and. all(shape(txy) == [size(value), size(sxx, 2)])) &
            status = c_smith_watson_topper_field(size(sxx, 2, kind=c_size_t), size(value, kind=c_size_t), sxx, syy, txy, E, &
                nu, value, angle)
        call conclude(status, 'rwedge_smith_watson_topper_field(size(sxx, 2), size(value), E, nu)', [real(size(sxx, 2), &
            c_double), real(size(value), c_double), E, nu], &
            'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 in ' // &
            'magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; loads >= 1; arrays of one size', stat, errmsg)
    end subroutine

    !> Fatemi and Socie's parameter of a cycle of stresses at one point, a strain: the largest value of
    !>     (dgamma/2) (1 + k sn_max/sy)
    !> over the planes that contain z. In the cycle, dgamma is the range of the plane's shear strain,
    !> 2(1+nu)/E times its shear stress, and sn_max its largest normal stress: where that is
    !> compressive it counts as it is, but no plane counts less than 0.
    !>    Fatemi and Socie (1988), see lib/README.md; new
    !>   k_over_sy  k over the yield stress in tension sy, 1/stress, 0 or 1e-60 to 1e60; k is 0.3 to 1
    !>              for most metals
    !>   others     as in rwedge_smith_watson_topper()
    !> RWEDGE_EDOMAIN; RWEDGE_ERANGE for n = 0; RWEDGE_ENULL. Error below 1e-14 (1 + s k/sy) s
    !> (1+nu)/E.
    subroutine rwedge_fatemi_socie(sxx, syy, txy, E, nu, k_over_sy, value, angle, stat, errmsg)
        real(c_double), intent(in) :: sxx(:), syy(:), txy(:), E, nu, k_over_sy
        real(c_double), intent(inout) :: value, angle
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (all([size(syy), size(txy)] == size(sxx))) &
            status = c_fatemi_socie(size(sxx, kind=c_size_t), sxx, syy, txy, E, nu, k_over_sy, value, angle)
        i = first_outside(sxx, -1e+60_c_double, 1e+60_c_double, 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_fatemi_socie(sxx, syy, txy)', [sxx(i), syy(i), txy(i)], &
                'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 ' // &
                'in magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to 1e60; n >= 1', stat, errmsg, i)
            return
        end if
        i = first_outside(syy, -1e+60_c_double, 1e+60_c_double, 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_fatemi_socie(sxx, syy, txy)', [sxx(i), syy(i), txy(i)], &
                'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 ' // &
                'in magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to 1e60; n >= 1', stat, errmsg, i)
            return
        end if
        i = first_outside(txy, -1e+60_c_double, 1e+60_c_double, 0.0_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_fatemi_socie(sxx, syy, txy)', [sxx(i), syy(i), txy(i)], &
                'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 ' // &
                'in magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to 1e60; n >= 1', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_fatemi_socie(size(sxx), E, nu, k_over_sy)', [real(size(sxx), c_double), E, nu, &
            k_over_sy], &
            'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 in ' // &
            'magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to 1e60; n >= 1; arrays of ' // &
            'one size', stat, errmsg)
    end subroutine

    !> The same at n points.
    !>   loads          number of loads of the cycle, >= 1
    !>   sxx, syy, txy  loads * n stresses each: that of load i at point j is at [i n + j]
    !>   value, angle   each receives n numbers
    !> Nothing is written unless every stress is in the domain.
    subroutine rwedge_fatemi_socie_field(sxx, syy, txy, E, nu, k_over_sy, value, angle, stat, errmsg)
        real(c_double), intent(in) :: sxx(:, :), syy(:, :), txy(:, :), E, nu, k_over_sy
        real(c_double), intent(inout) :: value(:), angle(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status
        status = rwedge_erange
        if (size(angle) == size(value) .and. all(shape(syy) == [size(value), size(sxx, &
            2)]) .and. all(shape(txy) == [size(value), size(sxx, 2)])) &
            status = c_fatemi_socie_field(size(sxx, 2, kind=c_size_t), size(value, kind=c_size_t), sxx, syy, txy, E, nu, &
                k_over_sy, value, angle)
        call conclude(status, 'rwedge_fatemi_socie_field(size(sxx, 2), size(value), E, nu, k_over_sy)', [real(size(sxx, 2), &
            c_double), real(size(value), c_double), E, nu, k_over_sy], &
            'sxx of at most 1e60 in magnitude; syy of at most 1e60 in magnitude; txy of at most 1e60 in ' // &
            'magnitude; E 1e-60 to 1e60; 0 <= nu <= 0.5; k_over_sy 0 or 1e-60 to 1e60; loads >= 1; arrays' // &
            ' of one size', stat, errmsg)
    end subroutine

    ! ---- The paper's series -------------------------------------------------------------------------------------------

    !> The rounded wedge's own series, cut after the first terms coefficients.
    !>    Eq. (29), (31) with E1; new
    !>   terms  1 <= terms <= 2^24
    !> RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Free with rwedge_series_destroy().
    subroutine series_create(this, alpha, terms, stat, errmsg)
        class(rwedge_series), intent(inout) :: this
        real(c_double), intent(in) :: alpha
        integer(c_int32_t), intent(in) :: terms
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: created
        integer(c_int32_t) :: status
        status = c_series_create(alpha, terms, created)
        if (status == rwedge_ok) call own_series(this, created)
        call conclude(status, 'rwedge_series%create(alpha, terms)', [alpha, real(terms, c_double)], &
            'alpha 0, or 1e-60 to 1e60; 1 <= terms <= 2^24', stat, errmsg)
    end subroutine

    !> Least-squares fit to samples of any pressure that vanishes at x = +-1, even or not.
    !>    Sec. 4 of the paper
    !>   samples  number of samples, >= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33; a
    !>            fit takes up to 1 GiB and half a minute
    !>   x, p     place and pressure, |x| < 1, finite; samples near Chebyshev's points (x = cos t, t
    !>            equally spaced) fit best
    !>   terms    >= 1
    !> RWEDGE_ERANK where the samples do not determine the coefficients to half the digits of a double
    !> (repeated or clustered points, or fewer than terms); RWEDGE_EDOMAIN, RWEDGE_ERANGE,
    !> RWEDGE_ENULL, RWEDGE_ENOMEM, RWEDGE_ENOCONV.
    subroutine series_fit(this, x, p, terms, stat, errmsg)
        class(rwedge_series), intent(inout) :: this
        real(c_double), intent(in) :: x(:), p(:)
        integer(c_int32_t), intent(in) :: terms
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: created
        integer(c_int32_t) :: status
        integer :: i
        status = rwedge_erange
        if (size(p) == size(x)) &
            status = c_series_fit(size(x, kind=c_size_t), x, p, terms, created)
        if (status == rwedge_ok) call own_series(this, created)
        i = first_outside(x, -1.0_c_double, 1.0_c_double, 1e-60_c_double, .true., .true., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_series%fit(x, p)', [x(i), p(i)], &
                '|x| < 1, 0 or at least 1e-60 in magnitude; p 0, or 1e-60 to 1e60 in magnitude; terms >= ' // &
                '1; samples >= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33', stat, errmsg, i)
            return
        end if
        i = first_outside(p, -1e+60_c_double, 1e+60_c_double, 1e-60_c_double, .false., .false., .false.)
        if (status == rwedge_edomain .and. i > 0) then
            call conclude(status, 'rwedge_series%fit(x, p)', [x(i), p(i)], &
                '|x| < 1, 0 or at least 1e-60 in magnitude; p 0, or 1e-60 to 1e60 in magnitude; terms >= ' // &
                '1; samples >= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33', stat, errmsg, i)
            return
        end if
        call conclude(status, 'rwedge_series%fit(size(x), terms)', [real(size(x), c_double), real(terms, c_double)], &
            '|x| < 1, 0 or at least 1e-60 in magnitude; p 0, or 1e-60 to 1e60 in magnitude; terms >= 1; ' // &
            'samples >= terms, samples * terms <= 2^27, samples * terms^2 <= 2^33; arrays of one size', stat, errmsg)
    end subroutine

    !> How many coefficients it holds; 0 for NULL.
    pure function series_terms(this) result(value)
        class(rwedge_series), intent(in) :: this
        integer(c_int32_t) :: value
        value = c_series_terms(own(this))
    end function

    !> a_k; 0 for k >= terms; NaN outside the domain or NULL.
    !>   k  index of the coefficient, >= 0
    elemental function series_coefficient(this, k) result(value)
        class(rwedge_series), intent(in) :: this
        integer(c_int32_t), intent(in) :: k
        real(c_double) :: value
        value = c_series_coefficient(own(this), k)
    end function

    !> Error of the series as a pressure. From rwedge_series_fit(): the root mean square of fit minus
    !> sample. From rwedge_series_create(): an upper bound of what is cut off, sum |a_k| for k >=
    !> terms, valid for the pressure and for |G| anywhere (HUGE_VAL for the sharp wedge, whose
    !> coefficients have no finite sum). NaN for NULL.
    pure function series_residual(this) result(value)
        class(rwedge_series), intent(in) :: this
        real(c_double) :: value
        value = c_series_residual(own(this))
    end function

    !> The pressure at x; 0 for |x| >= 1; NaN outside the domain or NULL.   Eq. (29)
    elemental function series_pressure(this, x) result(value)
        class(rwedge_series), intent(in) :: this
        real(c_double), intent(in) :: x
        real(c_double) :: value
        value = c_series_pressure(own(this), x)
    end function

    !> Muskhelishvili's potential Phi for q = f p: Phi = -((i+f)/2) sum a_k R^(k+1), R = z -
    !> sqrt(z^2-1).   Eq. (30), (34), E2, E3
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL.
    impure elemental subroutine series_potential(this, f, x, y, re, im, stat, errmsg)
        class(rwedge_series), intent(in) :: this
        real(c_double), intent(in) :: f, x, y
        real(c_double), intent(inout) :: re, im
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_series_potential(own(this), f, x, y, re, im), 'rwedge_series%potential(f, x, y)', [f, x, y], &
            '0 <= f <= 1e6, 0 or at least 1e-60; x 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to ' // &
            '1e60', stat, errmsg)
    end subroutine

    !> Stresses for q = f p.   Eq. (32), (33)
    !> RWEDGE_EDOMAIN, RWEDGE_ENULL. The derivative converges like the series of R^k at the edges:
    !> slowly.
    impure elemental subroutine series_stress(this, f, x, y, sxx, syy, txy, stat, errmsg)
        class(rwedge_series), intent(in) :: this
        real(c_double), intent(in) :: f, x, y
        real(c_double), intent(inout) :: sxx, syy, txy
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        call conclude(c_series_stress(own(this), f, x, y, sxx, syy, txy), 'rwedge_series%stress(f, x, y)', [f, x, y], &
            '0 <= f <= 1e6, 0 or at least 1e-60; x 0, or 1e-60 to 1e60 in magnitude; y 0, or 1e-60 to ' // &
            '1e60', stat, errmsg)
    end subroutine
end module

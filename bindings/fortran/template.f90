! SPDX-License-Identifier: GPL-3.0-or-later
! rwedge for Fortran: the contact of a wedge with a rounded apex and an elastic half-plane.
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
! - rwedge_contact, rwedge_cycle and rwedge_series are freed when they go out of scope. contact2 = contact1 copies the history: to try a
!   load and go back. Assign contacts themselves, not objects that hold them; do not ALLOCATE one with SOURCE=, and do not
!   return one from a function: compilers copy the handle there, not what it holds. Such a copy is noticed: it is as if it had
!   not been created. Arrays of rank 1 and 2 are assigned too, which may overlap; with "use rwedge, only: ..." name
!   assignment(=) for that. In OpenMP take private(c) and assign to it; firstprivate(c) makes such copies. README.md says more.
! - Where C says that a pointer is NULL, create() has not been called; HUGE_VAL is ieee_value(0d0, ieee_positive_inf).
module rwedge
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int32_t, c_null_ptr, c_ptr, c_size_t
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_fortran_env, only: error_unit
    implicit none
    private

    {statuses}

    public :: rwedge_version, rwedge_error_text
    {public}

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
        {contact procedures}
        procedure, private :: assign_contact
        generic :: assignment(=) => assign_contact
        final :: finalize_contact
    end type

    {shared types}

    ! Of arrays, which may overlap.
    interface assignment(=)
        module procedure assign_contacts, assign_contact_to_all, assign_grid_of_contacts, assign_contact_to_grid
        {shared assignments}
    end interface
    public :: assignment(=)

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

        {interfaces}
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
    ! may be, element is the one of its arrays that was refused, why when there is no result.
    subroutine conclude(status, call, values, allowed, stat, errmsg, element, why)
        integer(c_int32_t), intent(in) :: status
        character(*), intent(in) :: call, allowed
        real(c_double), intent(in) :: values(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer, intent(in), optional :: element
        character(*), intent(in), optional :: why
        if (present(stat)) stat = status
        if (status == rwedge_ok) return
        if (present(errmsg)) errmsg = message(status, call, values, allowed, element, why)
        if (present(stat)) return
        write (error_unit, '(a)') message(status, call, values, allowed, element, why)
        error stop 1
    end subroutine

    function message(status, call, values, allowed, element, why) result(text)
        integer(c_int32_t), intent(in) :: status
        character(*), intent(in) :: call, allowed
        real(c_double), intent(in) :: values(:)
        integer, intent(in), optional :: element
        character(*), intent(in), optional :: why
        character(:), allocatable :: text
        character(24) :: number
        integer :: i, first, last
        text = call
        if (present(element)) then
            write (number, '(i0)') element
            text = text // ', element ' // trim(number)
        end if
        text = text // ': ' // rwedge_error_text(status)
        if (status == rwedge_enull) text = text // ' (create it first; a copy by firstprivate or SOURCE= is none)'
        first = index(call, '(') + 1
        do i = 1, size(values)
            last = first - 2 + index(call(first:len(call) - 1) // ',', ',')
            write (number, '(g0.15)') values(i)
            text = text // merge(': ', ', ', i == 1) // call(first:last) // ' = ' // trim(number)
            first = last + 3
        end do
        if (any(status == [rwedge_edomain, rwedge_erange, rwedge_esliding])) text = text // '; allowed is ' // allowed
        if (present(why) .and. (status == rwedge_epath .or. status == rwedge_eabsent)) text = text // '; ' // why
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
    impure elemental subroutine own_contact(this, handle)
        class(rwedge_contact), intent(inout) :: this
        type(c_ptr), intent(in) :: handle
        call c_contact_destroy(own(this))
        call set(this, handle)
    end subroutine

    ! The handle of an independent copy; none where there is no contact.
    impure elemental function copy_of(from) result(created)
        type(rwedge_contact), intent(in) :: from
        type(c_ptr) :: held, created
        held = assigned(from)
        created = c_null_ptr
        if (c_associated(held)) call conclude(c_contact_copy(held, created), 'rwedge_contact%copy(...)', [real(c_double) ::], '')
    end function

    !> this = from, by copy(); both may be without a contact.
    subroutine assign_contact(this, from)
        class(rwedge_contact), intent(inout) :: this
        type(rwedge_contact), intent(in) :: from
        call own_contact(this, copy_of(from))
    end subroutine

    ! The same of arrays, which may overlap: all are copied before one is changed. What compilers make of an elemental assignment
    ! is of no use here: they may let it work on a copy of the left side.
    subroutine assign_contacts(this, from)
        type(rwedge_contact), intent(inout) :: this(:)
        type(rwedge_contact), intent(in) :: from(:)
        type(c_ptr) :: created(size(from))
        created = copy_of(from)
        call own_contact(this, created)
    end subroutine

    subroutine assign_contact_to_all(this, from)
        type(rwedge_contact), intent(inout) :: this(:)
        type(rwedge_contact), intent(in) :: from
        integer :: i
        call assign_contacts(this, [(from, i=1, size(this))])
    end subroutine

    subroutine assign_grid_of_contacts(this, from)
        type(rwedge_contact), intent(inout) :: this(:, :)
        type(rwedge_contact), intent(in) :: from(:, :)
        type(c_ptr) :: created(size(from, 1), size(from, 2))
        created = copy_of(from)
        call own_contact(this, created)
    end subroutine

    subroutine assign_contact_to_grid(this, from)
        type(rwedge_contact), intent(inout) :: this(:, :)
        type(rwedge_contact), intent(in) :: from
        integer :: k
        do k = 1, size(this, 2)
            call assign_contact_to_all(this(:, k), from)
        end do
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

    {shared life}

    {procedures}
end module

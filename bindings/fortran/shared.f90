! SPDX-License-Identifier: GPL-3.0-or-later
! The life of an object that never changes once made, so that copies share it, and count themselves: for each such kind.
subroutine own_{kind}(this, handle)
    class(rwedge_{kind}), intent(inout) :: this
    type(c_ptr), intent(in) :: handle
    call this%destroy()
    call set(this, handle)
    allocate (this%users)
    this%users = 1
end subroutine

! this = from, which share the {kind} from then on.
subroutine assign_{kind}(this, from)
    class(rwedge_{kind}), intent(inout) :: this
    type(rwedge_{kind}), intent(in) :: from
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

! The same of arrays, which may overlap: no {kind} that is shared goes before all are.
subroutine assign_several_of_{kind}(this, from)
    type(rwedge_{kind}), intent(inout) :: this(:)
    type(rwedge_{kind}), intent(in) :: from(:)
    type(rwedge_{kind}) :: shared(size(from))
    integer :: i
    do i = 1, size(from)
        call assign_{kind}(shared(i), from(i))
    end do
    do i = 1, size(from)
        call assign_{kind}(this(i), shared(i))
    end do
end subroutine

subroutine assign_{kind}_to_all(this, from)
    type(rwedge_{kind}), intent(inout) :: this(:)
    type(rwedge_{kind}), intent(in) :: from
    integer :: i
    do i = 1, size(this)
        call assign_{kind}(this(i), from)
    end do
end subroutine

!> Frees; NULL is allowed.
subroutine {kind}_destroy(this)
    class(rwedge_{kind}), intent(inout) :: this
    integer :: left
    if (c_associated(own(this))) then
        !$omp atomic capture
        this%users = this%users - 1
        left = this%users
        !$omp end atomic
        if (left == 0) then
            call c_{kind}_destroy(this%handle)
            deallocate (this%users)
        end if
    end if
    nullify (this%users)
    call set(this, c_null_ptr)
end subroutine

impure elemental subroutine finalize_{kind}(this)
    type(rwedge_{kind}), intent(inout) :: this
    call this%destroy()
end subroutine

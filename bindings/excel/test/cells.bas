' SPDX-License-Identifier: GPL-3.0-or-later
' Appended to rwedge.bas by run_cells.py: functions in place of the DLL's, whose results show what they were given, and what the
' worksheet functions must make of them.

Private library_is_there As Long, contacts_alive As Long, loads As Long
Private sum_of_P As Double, last_Q As Double, friction As Double
Private claims As Long, failures As String, last_note As String

' ---- In place of Windows and the DLL -------------------------------------------------------------------------------------

Function load_library(ByVal path As Long) As Long
    load_library = library_is_there
End Function

Function StrPtr(ByVal text As String) As Long
    StrPtr = 1
End Function

Function text_length(ByVal text As Long) As Long
    text_length = 0
End Function

Sub note(ByVal text As String)
    If Left(text, 8) <> "rwedge: " Then failures = failures & " a note without its beginning;"
    last_note = text
End Sub

' Stands for NaN: the double's upper half of bits.
Function high_half(ByVal value As Double) As Long
    If value = 1E+300 Then high_half = &H7FF80000 Else high_half = 1
End Function

Function c_strerror(ByVal status As Long) As Long
    c_strerror = 1
End Function

Function c_pressure(ByVal alpha As Double, ByVal x As Double) As Double
    If alpha < 0 Then c_pressure = 1E+300 Else c_pressure = alpha + 10 * x
End Function

Function c_stress(ByVal alpha As Double, ByVal f As Double, ByVal c As Double, ByVal x As Double, ByVal y As Double, _
        ByRef sxx As Double, ByRef syy As Double, ByRef txy As Double) As Long
    If alpha < 0 Then c_stress = RWEDGE_EDOMAIN
    If alpha = 99 Then c_stress = RWEDGE_EABSENT
    sxx = alpha + 10 * f + 100 * c + 1000 * x + 10000 * y
    syy = 2 * sxx
    txy = 3 * sxx
End Function

Function c_stresses(ByVal alpha As Double, ByVal f As Double, ByVal c As Double, ByVal n As Long, x, y, sxx, syy, txy) As Long
    Dim i As Long
    For i = 0 To n - 1
        c_stresses = c_stress(alpha, f, c, x(i), y(i), sxx(i), syy(i), txy(i))
    Next i
End Function

Function c_contact_create(ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByRef contact) As Long
    loads = 0
    sum_of_P = 0
    friction = f
    If theta + 10 * a + 100 * compliance + 1000 * f <> 4321 Then
        c_contact_create = RWEDGE_EDOMAIN
    Else
        contact = 7
        contacts_alive = contacts_alive + 1
    End If
End Function

Sub c_contact_destroy(ByVal contact As Long)
    If library_is_there = 0 Or contact <> 7 Then failures = failures & " destroys what is not there;"
    contacts_alive = contacts_alive - 1
End Sub

Function c_contact_load(ByVal contact As Long, ByVal P As Double, ByVal Q As Double) As Long
    If Abs(Q) > friction * P Then
        c_contact_load = RWEDGE_ESLIDING
    Else
        loads = loads + 1
        sum_of_P = sum_of_P + P
        last_Q = Q
    End If
End Function

Function c_contact_half_width(ByVal contact As Long) As Double
    c_contact_half_width = sum_of_P
End Function

Function c_contact_stick_half_width(ByVal contact As Long) As Double
    c_contact_stick_half_width = last_Q
End Function

Function c_contact_dissipated_energy(ByVal contact As Long) As Double
    c_contact_dissipated_energy = loads
End Function

Function c_contact_slip(ByVal contact As Long, ByVal n As Long, x, slip) As Long
    Dim i As Long
    If x(0) = 99 Then c_contact_slip = RWEDGE_EPATH
    If x(0) = 98 Then c_contact_slip = RWEDGE_EDOMAIN
    For i = 0 To n - 1
        slip(i) = x(i) + sum_of_P
    Next i
End Function

' ---- Claims --------------------------------------------------------------------------------------------------------------

Private Sub expect(ByVal truth As Boolean, ByVal claim As String)
    claims = claims + 1
    If Not truth Then failures = failures & " " & claim & ";"
End Sub

Private Function is_error(ByVal value As Variant, ByVal number As Long) As Boolean
    If IsError(value) Then is_error = CStr(value) = CStr(CVErr(number))
End Function

Private Sub without_the_library()
    expect is_error(RWEDGE_PRESSURE(1, 2), 2029), "a number without the library is #NAME?"
    expect is_error(RWEDGE_STRESS(1, 2, 3, 4, 5), 2029), "a row without the library is #NAME?"
    expect is_error(RWEDGE_CONTACT_HALF_WIDTH(1, 2, 3, 4, 5, 6), 2029), "a contact without the library is #NAME?"
    expect is_error(RWEDGE_CONTACT_HISTORY(1, 2, 3, 4, 5, 6), 2029), "a history without the library is #NAME?"
    expect RWEDGE_VERSION() Like "not found: *rwedge.dll", "the version says where the library is not"
End Sub

Private Sub numbers_and_rows()
    Dim row As Variant
    expect RWEDGE_PRESSURE(1, 2) = 21, "a number"
    expect is_error(RWEDGE_PRESSURE(-1, 2), 2036), "NaN is #NUM!"
    row = RWEDGE_STRESS(1, 2, 3, 4, 5)
    expect UBound(row) = 2 And row(0) = 54321 And row(1) = 2 * 54321 And row(2) = 3 * 54321#, "a row"
    expect is_error(RWEDGE_STRESS(-1, 2, 3, 4, 5), 2036), "outside the domain is #NUM!"
    expect is_error(RWEDGE_STRESS(99, 2, 3, 4, 5), 2042), "what does not exist is #N/A"
End Sub

Private Sub columns()
    Dim table As Variant
    table = RWEDGE_STRESSES(1, 2, 3, Array(4, 5, 6), Array(7#, 8#, 9#))
    expect UBound(table, 1) = 3 And UBound(table, 2) = 3, "three points have three rows"
    expect table(1, 1) = 74321 And table(3, 1) = 96321 And table(3, 3) = 3 * 96321#, "each in its place"
    expect is_error(RWEDGE_STRESSES(1, 2, 3, Array(4, 5), Array(7)), 2015), "a shorter second column is #VALUE!"
    expect is_error(RWEDGE_STRESSES(1, 2, 3, Array(4), Array(7, 8)), 2015), "a longer second column is #VALUE!"
    expect is_error(RWEDGE_STRESSES(1, 2, 3, Array(4, "5"), Array(7, 8)), 2015), "a text is #VALUE!"
    expect is_error(RWEDGE_STRESSES(1, 2, 3, Array(4, Empty), Array(7, 8)), 2015), "an empty cell is #VALUE!"
    table = RWEDGE_STRESSES(1, 2, 3, 4, 5)
    expect table(1, 1) = 54321, "a single number is a column of one"
    ActiveSheet.Range("A1").Value = 4
    ActiveSheet.Range("A2").Value = 5
    ActiveSheet.Range("B1").Value = 7
    ActiveSheet.Range("B2").Value = 8
    table = RWEDGE_STRESSES(1, 2, 3, ActiveSheet.Range("A1:A2"), ActiveSheet.Range("B1:B2"))
    expect table(1, 1) = 74321 And table(2, 1) = 85321, "ranges of cells"
    expect is_error(RWEDGE_STRESSES(1, 2, 3, ActiveSheet.Range("A1:A3"), ActiveSheet.Range("B1:B3")), 2015), "empty cells"
End Sub

Private Sub contacts()
    Dim table As Variant
    expect RWEDGE_CONTACT_HALF_WIDTH(1, 2, 3, 4, Array(10, 20), Array(1, 2)) = 30, "a contact after its loads"
    expect is_error(RWEDGE_CONTACT_HALF_WIDTH(1, 2, 3, 4, Array(10, 20), Array(1, 100)), 2036), "a load that cannot be"
    expect is_error(RWEDGE_CONTACT_HALF_WIDTH(0, 2, 3, 4, Array(10, 20), Array(1, 2)), 2036), "a contact that cannot be"
    table = RWEDGE_CONTACT_SLIP(1, 2, 3, 4, Array(10, 20), Array(1, 2), Array(0.25, 0.5, 0.75))
    expect UBound(table, 1) = 3 And table(3, 1) = 30.75, "points of a contact"
    expect is_error(RWEDGE_CONTACT_SLIP(1, 2, 3, 4, Array(10, 20), Array(1, 2), "x"), 2015), "points that are none"
    expect is_error(RWEDGE_CONTACT_SLIP(1, 2, 3, 4, 10, 1, 99), 2036), "a path without a closed form is #NUM!"
    expect last_note Like "rwedge: : off the centre once *", "and the note says why"
    expect is_error(RWEDGE_CONTACT_SLIP(1, 2, 3, 4, 10, 1, 98), 2036) And last_note = "rwedge: ", "which no other has"
    table = RWEDGE_CONTACT_HISTORY(1, 2, 3, 4, Array(10, 20, 30), Array(1, 2, 500))
    expect UBound(table, 1) = 3 And UBound(table, 2) = 3, "a history has a row for each load"
    expect table(1, 1) = 10 And table(2, 1) = 30 And table(2, 2) = 2 And table(2, 3) = 2, "each load in its row"
    expect is_error(table(3, 1), 2036) And is_error(table(3, 3), 2036), "a load that cannot be shows its error"
    expect contacts_alive = 0, "every contact is freed"
End Sub

Function all_claims() As String
    On Error GoTo trouble
    library_is_there = 0
    without_the_library
    library_is_there = 1
    numbers_and_rows
    columns
    contacts
    If failures = "" Then all_claims = "ok " & claims Else all_claims = "FAILED:" & failures
    Exit Function
trouble:
    all_claims = "FAILED: after " & claims & " claims line " & Erl & ": " & Error$ & failures
End Function

Attribute VB_Name = "rwedge"
' SPDX-License-Identifier: GPL-3.0-or-later
' Written by bindings/interface/generate.py from include/rwedge.h and template.bas: change those, not this.
'
' rwedge for Excel, 64-bit, on Windows: worksheet functions RWEDGE_..., which call rwedge.dll. It is looked for in the folder
' of the workbook or add-in that holds this module, and nowhere else.
'
' In a cell:  #NUM!    outside the domain, or no such equilibrium (the reason is in the Immediate window, Ctrl+G)
'             #N/A     what was asked for does not exist for these arguments
'             #VALUE!  not a number, or columns of different lengths
'             #NAME?   rwedge.dll was not found: =RWEDGE_VERSION() says where it was looked for
' Where the text below says that a function gives NaN, the cell shows #NUM!; so it does where a result is infinite. Of a rigid
' body E is 1E+60, for lack of an infinity in cells. An empty cell is 0, as everywhere in Excel, but not in a range: #VALUE!.
'
' The header's introduction:
'
{introduction}
'
' Not for LibreOffice Calc: on Linux its Basic passes over declarations of DLLs without a word, and the cells stay empty.
' There take tables/rounded-wedge.xlsx, which is plain formulas, or Python.
'
' The module is not private (Option Private Module), as the functions would then be missing in Insert Function.
Option Explicit

Private Enum rwedge_status
    LIBRARY_MISSING = -2
    NOT_A_COLUMN = -1
    {statuses}
End Enum

Private Type one_double
    value As Double
End Type

Private Type two_longs
    low As Long
    high As Long
End Type

Private Declare PtrSafe Function load_library Lib "kernel32" Alias "LoadLibraryW" (ByVal path As LongPtr) As LongPtr
Private Declare PtrSafe Function text_length Lib "kernel32" Alias "lstrlenA" (ByVal text As LongPtr) As Long
Private Declare PtrSafe Sub copy_bytes Lib "kernel32" Alias "RtlMoveMemory" ( _
    ByRef target As Byte, ByVal source As LongPtr, ByVal count As LongPtr)

{declares}

' ---- What the functions below share --------------------------------------------------------------------------------

Private Function library_path() As String
    library_path = ThisWorkbook.path & "\rwedge.dll"
End Function

' Windows knows a library by its file's name once it is loaded: loaded from its full path first, "rwedge.dll" in the
' declarations above is that one, whatever the current folder is.
Private Function find_library() As Long
    Static handle As LongPtr
    If handle = 0 Then handle = load_library(StrPtr(library_path()))
    If handle = 0 Then find_library = LIBRARY_MISSING Else find_library = RWEDGE_OK
End Function

Private Function text_at(ByVal address As LongPtr) As String
    Dim bytes() As Byte, length As Long
    length = text_length(address)
    If length = 0 Then Exit Function
    ReDim bytes(0 To length - 1)
    copy_bytes bytes(0), address, length
    text_at = StrConv(bytes, vbUnicode)
End Function

' The path is why it has no closed form, where the function can tell.
Private Function failure(ByVal status As Long, ByVal path As String) As Variant
    Select Case status
        Case LIBRARY_MISSING
            failure = CVErr(xlErrName)
        Case NOT_A_COLUMN
            failure = CVErr(xlErrValue)
        Case Else
            If status = RWEDGE_EPATH Then path = ": " & path Else path = ""
            Debug.Print "rwedge: " & text_at(c_strerror(status)) & path
            If status = RWEDGE_EABSENT Then failure = CVErr(xlErrNA) Else failure = CVErr(xlErrNum)
    End Select
End Function

' A number for a cell. NaN and infinity are told by their bits: Basic's comparisons with them may raise an error.
Private Function finite(ByVal value As Double) As Variant
    Dim number As one_double, bits As two_longs
    number.value = value
    LSet bits = number
    If (bits.high And &H7FF00000) = &H7FF00000 Then finite = CVErr(xlErrNum) Else finite = value
End Function

Private Function is_number(ByVal item As Variant) As Boolean
    Select Case VarType(item)
        Case vbDouble, vbSingle, vbInteger, vbLong, vbByte, vbCurrency, vbDecimal
            is_number = True
    End Select
End Function

' What is in the cells of a range; Empty where it has several areas.
Private Function values_of(ByVal cells As Object) As Variant
    If cells.Areas.count = 1 Then values_of = cells.Value2
End Function

' The numbers of a range, an array or a single number, of which there must be n, or any number of them where n is 0.
Private Function read_list(ByVal given As Variant, ByRef list() As Double, ByRef n As Long) As Long
    Dim items As Variant, item As Variant, count As Long
    read_list = NOT_A_COLUMN
    If IsObject(given) Then items = values_of(given) Else items = given
    If Not IsArray(items) Then items = Array(items)
    For Each item In items
        If Not is_number(item) Then Exit Function
        count = count + 1
    Next item
    If count = 0 Or (n > 0 And n <> count) Then Exit Function
    n = count
    ReDim list(0 To n - 1)
    count = 0
    For Each item In items
        list(count) = item
        count = count + 1
    Next item
    read_list = RWEDGE_OK
End Function

' n rows; each list is a column.
Private Function table_of(ByVal n As Long, ParamArray lists() As Variant) As Variant
    Dim table() As Variant, i As Long, j As Long
    ReDim table(1 To n, 1 To UBound(lists) + 1)
    For j = 0 To UBound(lists)
        For i = 1 To n
            table(i, j + 1) = lists(j)(i - 1)
        Next i
    Next j
    table_of = table
End Function

' A contact before its loads P, Q, of which there are n; to be freed by who asked for it.
Private Function contact_before(ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, _
        ByRef P() As Double, ByRef Q() As Double, ByRef n As Long, ByRef contact As LongPtr) As Long
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = read_list(P_history, P, n)
    If status = RWEDGE_OK Then status = read_list(Q_history, Q, n)
    If status = RWEDGE_OK Then status = c_contact_create(theta, a, compliance, f, contact)
    contact_before = status
End Function

' A contact after its loads, for the functions below.
Private Function contact_after(ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByRef contact As LongPtr) As Long
    Dim P() As Double, Q() As Double, n As Long, i As Long, status As Long
    status = contact_before(theta, a, compliance, f, P_history, Q_history, P, Q, n, contact)
    For i = 0 To n - 1
        If status = RWEDGE_OK Then status = c_contact_load(contact, P(i), Q(i))
    Next i
    contact_after = status
End Function

' A cycle of loads of a contact after its history, for the functions below; to be freed by who asked for it.
Private Function cycle_after(ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal P As Variant, ByVal M As Variant, ByVal Q As Variant, _
        ByVal sigma As Variant, ByRef cycle As LongPtr) As Long
    Dim P_list() As Double, M_list() As Double, Q_list() As Double, sigma_list() As Double
    Dim contact As LongPtr, n As Long, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(P, P_list, n)
    If status = RWEDGE_OK Then status = read_list(M, M_list, n)
    If status = RWEDGE_OK Then status = read_list(Q, Q_list, n)
    If status = RWEDGE_OK Then status = read_list(sigma, sigma_list, n)
    If status = RWEDGE_OK Then status = c_cycle_create(contact, n, P_list(0), M_list(0), Q_list(0), sigma_list(0), cycle)
    If contact <> 0 Then c_contact_destroy contact
    cycle_after = status
End Function

' A series fitted to samples of a pressure, for the functions below; to be freed by who asked for it.
Private Function series_through(ByVal x_samples As Variant, ByVal p_samples As Variant, ByVal terms As Long, _
        ByRef series As LongPtr) As Long
    Dim x() As Double, p() As Double, n As Long, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = read_list(x_samples, x, n)
    If status = RWEDGE_OK Then status = read_list(p_samples, p, n)
    If status = RWEDGE_OK Then status = c_series_fit(n, x(0), p(0), terms, series)
    series_through = status
End Function

' ---- Worksheet functions ---------------------------------------------------------------------------------------------

' The version of the library; or where it was looked for and is not.
Public Function RWEDGE_VERSION() As String
Attribute RWEDGE_VERSION.VB_Description = "The version of rwedge.dll; or where it was looked for and is not."
    If find_library() = RWEDGE_OK Then
        RWEDGE_VERSION = text_at(c_version())
    Else
        RWEDGE_VERSION = "not found: " & library_path()
    End If
End Function

' A contact through its history of loads: half-width, half-width of the stick zone and energy dissipated so far, a row for each
' load. From a load on that cannot be (|Q| > f P, for one), the rows show its error.
'   P_history, Q_history  columns of as many normal and tangential forces per unit length
'   and as for RWEDGE_HALF_WIDTH
Public Function RWEDGE_CONTACT_HISTORY(ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, _
        ByVal f As Double, ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_HISTORY.VB_Description = "Half-width, half-width of the stick zone and energy dissipated so far, a row for each load of a history of P and Q."
    Dim P() As Double, Q() As Double, n As Long, i As Long, j As Long, status As Long, contact As LongPtr, table() As Variant
    status = contact_before(theta, a, compliance, f, P_history, Q_history, P, Q, n, contact)
    If contact = 0 Then
        RWEDGE_CONTACT_HISTORY = failure(status, "")
        Exit Function
    End If
    ReDim table(1 To n, 1 To 3)
    For i = 1 To n
        If status = RWEDGE_OK Then status = c_contact_load(contact, P(i - 1), Q(i - 1))
        If status = RWEDGE_OK Then
            table(i, 1) = finite(c_contact_half_width(contact))
            table(i, 2) = finite(c_contact_stick_half_width(contact))
            table(i, 3) = finite(c_contact_dissipated_energy(contact))
        Else
            For j = 1 To 3
                table(i, j) = failure(status, "")
            Next j
        End If
    Next i
    c_contact_destroy contact
    RWEDGE_CONTACT_HISTORY = table
End Function

{functions}

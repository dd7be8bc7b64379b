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
' body E is 1E+300, for lack of an infinity in cells. An empty cell is 0, as everywhere in Excel, but not in a range: #VALUE!.
'
' The header's introduction:
'
' rwedge: the contact of a wedge with a rounded apex and an elastically similar half-plane.
'
' Source: M. Ciavarella, D. A. Hills, G. Monno, "Contact problems for a wedge with rounded
' apex", Int. J. Mech. Sci. 40 (1998) 977-988. "Eq. (n)" is that paper's numbering, "E1" ... its
' errata as listed in lib/README.md, where every formula is written out; "new" marks what the
' paper does not have.
'
' Geometry and units. Plane strain. x runs along the surface, y >= 0 into the half-plane. The
' flanks of the wedge leave the surface at the small angle theta. Its apex is rounded over |x| <
' a with the radius R = a/theta. The contact is |x| < b. The functions of a/b use natural units:
' lengths in b, stresses in theta/A, where A is the composite compliance, Eq. (2). Stresses and
' pressures are negative in compression. P and Q are positive forces per unit length. k is the
' yield stress in pure shear. In sliding q = f p: the half-plane is dragged towards +x, and the
' trailing edge is x = -b. For plane stress take nu = 0 in the functions of strength, and A =
' 2/E1 + 2/E2.
'
' Domain. Whatever has a size is 0, where that is allowed, or 1e-60 to 1e60 in magnitude:
' lengths, loads, moduli, stresses, the compliance, friction, the angle theta, and ratios of
' lengths such as a/b and x/b. A result that would leave this range is an error. Without a size
' are nu, nu1, nu2, Q_over_fP, AP_over_theta_a.
'
' Arguments that return everywhere:
'   alpha  a/b, rounding over contact half-width, finite, >= 0; 0 is the sharp wedge, >= 1 is
'          Hertz' contact
'   f      coefficient of friction, 0 <= f <= 1e6
'   nu     Poisson's ratio of the half-plane, 0 <= nu <= 0.5
'   c      half-width of the stick zone over b, 0 <= c <= 1; 0 is full sliding
'   x      place along the surface, in b, finite
'   y      depth below it, in b, finite, >= 0
'
' Errors, two rules. A pure formula returns its value, and NaN outside its domain, like sqrt().
' A function that iterates, allocates or has several results returns a status: RWEDGE_OK or a
' reason. It leaves its outputs untouched on failure. RWEDGE_OK implies finite outputs. No
' function prints, exits, aborts, sets errno or keeps state between calls. Only _create, _fit,
' _copy, _load, _apply, _stress_history, _restore, _cycle_... and rwedge_permanent_stick() allocate.
'
' Threads: every function may be called from any number of threads. A handle may be read by many
' at a time. Output arrays may be the same as input arrays, but may not overlap them in part.
'
' Not for LibreOffice Calc: on Linux its Basic passes over declarations of DLLs without a word, and the cells stay empty.
' There take tables/rounded-wedge.xlsx, which is plain formulas, or Python.
'
' The module is not private (Option Private Module), as the functions would then be missing in Insert Function.
Option Explicit

Private Enum rwedge_status
    LIBRARY_MISSING = -2
    NOT_A_COLUMN = -1
    RWEDGE_OK = 0
    RWEDGE_EDOMAIN = 1
    RWEDGE_ENULL = 2
    RWEDGE_ERANGE = 3
    RWEDGE_ENOCONV = 4
    RWEDGE_ENOMEM = 5
    RWEDGE_ESLIDING = 6
    RWEDGE_ERANK = 7
    RWEDGE_EABSENT = 8
    RWEDGE_EPATH = 9
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

Private Declare PtrSafe Function c_version Lib "rwedge.dll" Alias "rwedge_version" () As LongPtr
Private Declare PtrSafe Function c_strerror Lib "rwedge.dll" Alias "rwedge_strerror" (ByVal status As Long) As LongPtr
Private Declare PtrSafe Function c_compliance Lib "rwedge.dll" Alias "rwedge_compliance" ( _
    ByVal E1 As Double, ByVal nu1 As Double, ByVal E2 As Double, ByVal nu2 As Double) As Double
Private Declare PtrSafe Function c_dundurs_beta Lib "rwedge.dll" Alias "rwedge_dundurs_beta" ( _
    ByVal E1 As Double, ByVal nu1 As Double, ByVal E2 As Double, ByVal nu2 As Double) As Double
Private Declare PtrSafe Function c_load Lib "rwedge.dll" Alias "rwedge_load" (ByVal alpha As Double) As Double
Private Declare PtrSafe Function c_a_over_b Lib "rwedge.dll" Alias "rwedge_a_over_b" (ByVal AP_over_theta_a As Double) As Double
Private Declare PtrSafe Function c_pressure Lib "rwedge.dll" Alias "rwedge_pressure" ( _
    ByVal alpha As Double, ByVal x As Double) As Double
Private Declare PtrSafe Function c_peak_pressure Lib "rwedge.dll" Alias "rwedge_peak_pressure" (ByVal alpha As Double) As Double
Private Declare PtrSafe Function c_transition_pressure Lib "rwedge.dll" Alias "rwedge_transition_pressure" ( _
    ByVal alpha As Double) As Double
Private Declare PtrSafe Function c_coefficient Lib "rwedge.dll" Alias "rwedge_coefficient" ( _
    ByVal alpha As Double, ByVal n As Long) As Double
Private Declare PtrSafe Function c_stick_width Lib "rwedge.dll" Alias "rwedge_stick_width" ( _
    ByVal alpha As Double, ByVal Q_over_fP As Double) As Double
Private Declare PtrSafe Function c_shear_ratio Lib "rwedge.dll" Alias "rwedge_shear_ratio" ( _
    ByVal alpha As Double, ByVal c As Double) As Double
Private Declare PtrSafe Function c_shear Lib "rwedge.dll" Alias "rwedge_shear" ( _
    ByVal alpha As Double, ByVal c As Double, ByVal x As Double) As Double
Private Declare PtrSafe Function c_stress Lib "rwedge.dll" Alias "rwedge_stress" ( _
    ByVal alpha As Double, ByVal f As Double, ByVal c As Double, ByVal x As Double, ByVal y As Double, _
    ByRef sxx As Double, ByRef syy As Double, ByRef txy As Double) As Long
Private Declare PtrSafe Function c_stresses Lib "rwedge.dll" Alias "rwedge_stresses" ( _
    ByVal alpha As Double, ByVal f As Double, ByVal c As Double, ByVal n As LongPtr, ByRef x As Double, _
    ByRef y As Double, ByRef sxx As Double, ByRef syy As Double, ByRef txy As Double) As Long
Private Declare PtrSafe Function c_max_tension Lib "rwedge.dll" Alias "rwedge_max_tension" (ByVal alpha As Double) As Double
Private Declare PtrSafe Function c_elastic_limit Lib "rwedge.dll" Alias "rwedge_elastic_limit" ( _
    ByVal alpha As Double, ByVal f As Double, ByVal nu As Double) As Double
Private Declare PtrSafe Function c_elastic_limits Lib "rwedge.dll" Alias "rwedge_elastic_limits" ( _
    ByVal n As LongPtr, ByRef alpha As Double, ByRef f As Double, ByVal nu As Double, ByRef limit As Double) As Long
Private Declare PtrSafe Function c_yield_point Lib "rwedge.dll" Alias "rwedge_yield_point" ( _
    ByVal alpha As Double, ByVal f As Double, ByVal nu As Double, ByRef limit As Double, ByRef x As Double, _
    ByRef y As Double) As Long
Private Declare PtrSafe Function c_subsurface_yield Lib "rwedge.dll" Alias "rwedge_subsurface_yield" ( _
    ByVal alpha As Double, ByVal f As Double, ByVal nu As Double, ByRef limit As Double, ByRef x As Double, _
    ByRef y As Double) As Long
Private Declare PtrSafe Function c_surface_yield Lib "rwedge.dll" Alias "rwedge_surface_yield" ( _
    ByVal alpha As Double, ByVal f As Double, ByVal nu As Double, ByRef limit As Double, ByRef x As Double) As Long
Private Declare PtrSafe Function c_critical_friction Lib "rwedge.dll" Alias "rwedge_critical_friction" ( _
    ByVal alpha As Double, ByVal nu As Double) As Double
Private Declare PtrSafe Function c_validity Lib "rwedge.dll" Alias "rwedge_validity" ( _
    ByVal theta As Double, ByVal alpha As Double, ByVal beta As Double, ByVal f As Double, ByVal k_over_E As Double, _
    ByVal safety As Double) As Long
Private Declare PtrSafe Function c_validity_text Lib "rwedge.dll" Alias "rwedge_validity_text" (ByVal doubt As Long) As LongPtr
Private Declare PtrSafe Function c_radius Lib "rwedge.dll" Alias "rwedge_radius" ( _
    ByVal theta As Double, ByVal a As Double) As Double
Private Declare PtrSafe Function c_rounding Lib "rwedge.dll" Alias "rwedge_rounding" ( _
    ByVal theta As Double, ByVal R As Double) As Double
Private Declare PtrSafe Function c_half_width Lib "rwedge.dll" Alias "rwedge_half_width" ( _
    ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal P As Double) As Double
Private Declare PtrSafe Function c_normal_load Lib "rwedge.dll" Alias "rwedge_normal_load" ( _
    ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal b As Double) As Double
Private Declare PtrSafe Function c_yield_load Lib "rwedge.dll" Alias "rwedge_yield_load" ( _
    ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, ByVal nu As Double, _
    ByVal k As Double) As Double
Private Declare PtrSafe Function c_contact_create Lib "rwedge.dll" Alias "rwedge_contact_create" ( _
    ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, ByRef contact As LongPtr) As Long
Private Declare PtrSafe Sub c_contact_destroy Lib "rwedge.dll" Alias "rwedge_contact_destroy" (ByVal contact As LongPtr)
Private Declare PtrSafe Function c_contact_load Lib "rwedge.dll" Alias "rwedge_contact_load" ( _
    ByVal contact As LongPtr, ByVal P As Double, ByVal Q As Double) As Long
Private Declare PtrSafe Function c_contact_largest_tension_step Lib "rwedge.dll" Alias "rwedge_contact_largest_tension_step" ( _
    ByVal contact As LongPtr, ByVal Q As Double) As Double
Private Declare PtrSafe Function c_contact_loads Lib "rwedge.dll" Alias "rwedge_contact_loads" ( _
    ByVal contact As LongPtr, ByRef P As Double, ByRef M As Double, ByRef Q As Double, ByRef sigma As Double) As Long
Private Declare PtrSafe Function c_contact_edges Lib "rwedge.dll" Alias "rwedge_contact_edges" ( _
    ByVal contact As LongPtr, ByRef left As Double, ByRef right As Double) As Long
Private Declare PtrSafe Function c_contact_stick_zone Lib "rwedge.dll" Alias "rwedge_contact_stick_zone" ( _
    ByVal contact As LongPtr, ByRef left As Double, ByRef right As Double) As Long
Private Declare PtrSafe Function c_contact_tilt Lib "rwedge.dll" Alias "rwedge_contact_tilt" ( _
    ByVal contact As LongPtr) As Double
Private Declare PtrSafe Function c_contact_edge_asymptotes Lib "rwedge.dll" Alias "rwedge_contact_edge_asymptotes" ( _
    ByVal contact As LongPtr, ByRef normal_left As Double, ByRef normal_right As Double, ByRef shear_left As Double, _
    ByRef shear_right As Double) As Long
Private Declare PtrSafe Function c_permanent_stick Lib "rwedge.dll" Alias "rwedge_permanent_stick" ( _
    ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, ByVal P1 As Double, _
    ByVal M1 As Double, ByVal Q1 As Double, ByVal sigma1 As Double, ByVal P2 As Double, ByVal M2 As Double, _
    ByVal Q2 As Double, ByVal sigma2 As Double, ByRef left As Double, ByRef right As Double) As Long
Private Declare PtrSafe Function c_contact_half_width Lib "rwedge.dll" Alias "rwedge_contact_half_width" ( _
    ByVal contact As LongPtr) As Double
Private Declare PtrSafe Function c_contact_stick_half_width Lib "rwedge.dll" Alias "rwedge_contact_stick_half_width" ( _
    ByVal contact As LongPtr) As Double
Private Declare PtrSafe Function c_contact_tractions Lib "rwedge.dll" Alias "rwedge_contact_tractions" ( _
    ByVal contact As LongPtr, ByVal n As LongPtr, ByRef x As Double, ByRef p As Double, ByRef q As Double) As Long
Private Declare PtrSafe Function c_contact_stresses Lib "rwedge.dll" Alias "rwedge_contact_stresses" ( _
    ByVal contact As LongPtr, ByVal n As LongPtr, ByRef x As Double, ByRef y As Double, ByRef sxx As Double, _
    ByRef syy As Double, ByRef txy As Double) As Long
Private Declare PtrSafe Function c_contact_slip Lib "rwedge.dll" Alias "rwedge_contact_slip" ( _
    ByVal contact As LongPtr, ByVal n As LongPtr, ByRef x As Double, ByRef slip As Double) As Long
Private Declare PtrSafe Function c_contact_dissipated_energy Lib "rwedge.dll" Alias "rwedge_contact_dissipated_energy" ( _
    ByVal contact As LongPtr) As Double
Private Declare PtrSafe Function c_contact_yield_factor Lib "rwedge.dll" Alias "rwedge_contact_yield_factor" ( _
    ByVal contact As LongPtr, ByVal nu As Double, ByVal k As Double, ByRef factor As Double, ByRef x As Double, _
    ByRef y As Double) As Long
Private Declare PtrSafe Function c_contact_cycle_fatigue Lib "rwedge.dll" Alias "rwedge_contact_cycle_fatigue" ( _
    ByVal contact As LongPtr, ByVal loads As LongPtr, ByRef P As Double, ByRef M As Double, ByRef Q As Double, _
    ByRef sigma As Double, ByVal n As LongPtr, ByRef x As Double, ByRef y As Double, ByVal E As Double, _
    ByVal nu As Double, ByVal k_over_sy As Double, ByRef stress_range As Double, ByRef swt As Double, _
    ByRef swt_angle As Double, ByRef fatemi_socie As Double, ByRef fs_angle As Double) As Long
Private Declare PtrSafe Function c_contact_cycle_friction Lib "rwedge.dll" Alias "rwedge_contact_cycle_friction" ( _
    ByVal contact As LongPtr, ByVal loads As LongPtr, ByRef P As Double, ByRef M As Double, ByRef Q As Double, _
    ByRef sigma As Double, ByVal n As LongPtr, ByRef x As Double, ByRef slip_range As Double, ByRef ruiz_f1 As Double, _
    ByRef ruiz_f2 As Double, ByRef energy As Double) As Long
Private Declare PtrSafe Function c_contact_cycle_worst Lib "rwedge.dll" Alias "rwedge_contact_cycle_worst" ( _
    ByVal contact As LongPtr, ByVal measure As Long, ByVal loads As LongPtr, ByRef P As Double, ByRef M As Double, _
    ByRef Q As Double, ByRef sigma As Double, ByVal n As LongPtr, ByRef x As Double, ByRef value As Double, _
    ByVal y As Double, ByVal E As Double, ByVal nu As Double, ByVal k_over_sy As Double, ByRef worst_x As Double, _
    ByRef worst_value As Double) As Long
Private Declare PtrSafe Function c_contact_displacement Lib "rwedge.dll" Alias "rwedge_contact_displacement" ( _
    ByVal contact As LongPtr, ByVal b As Double) As Double
Private Declare PtrSafe Function c_von_mises Lib "rwedge.dll" Alias "rwedge_von_mises" ( _
    ByVal sxx As Double, ByVal syy As Double, ByVal txy As Double, ByVal nu As Double) As Double
Private Declare PtrSafe Function c_out_of_plane_stress Lib "rwedge.dll" Alias "rwedge_out_of_plane_stress" ( _
    ByVal sxx As Double, ByVal syy As Double, ByVal nu As Double) As Double
Private Declare PtrSafe Function c_largest_shear Lib "rwedge.dll" Alias "rwedge_largest_shear" ( _
    ByVal sxx As Double, ByVal syy As Double, ByVal txy As Double, ByVal nu As Double) As Double
Private Declare PtrSafe Function c_principal_stresses Lib "rwedge.dll" Alias "rwedge_principal_stresses" ( _
    ByVal sxx As Double, ByVal syy As Double, ByVal txy As Double, ByRef s1 As Double, ByRef s2 As Double, _
    ByRef angle As Double) As Long
Private Declare PtrSafe Function c_smith_watson_topper Lib "rwedge.dll" Alias "rwedge_smith_watson_topper" ( _
    ByVal n As LongPtr, ByRef sxx As Double, ByRef syy As Double, ByRef txy As Double, ByVal E As Double, _
    ByVal nu As Double, ByRef value As Double, ByRef angle As Double) As Long
Private Declare PtrSafe Function c_fatemi_socie Lib "rwedge.dll" Alias "rwedge_fatemi_socie" ( _
    ByVal n As LongPtr, ByRef sxx As Double, ByRef syy As Double, ByRef txy As Double, ByVal E As Double, _
    ByVal nu As Double, ByVal k_over_sy As Double, ByRef value As Double, ByRef angle As Double) As Long
Private Declare PtrSafe Function c_series_fit Lib "rwedge.dll" Alias "rwedge_series_fit" ( _
    ByVal samples As LongPtr, ByRef x As Double, ByRef p As Double, ByVal terms As Long, ByRef series As LongPtr) As Long
Private Declare PtrSafe Sub c_series_destroy Lib "rwedge.dll" Alias "rwedge_series_destroy" (ByVal series As LongPtr)
Private Declare PtrSafe Function c_series_coefficient Lib "rwedge.dll" Alias "rwedge_series_coefficient" ( _
    ByVal series As LongPtr, ByVal k As Long) As Double
Private Declare PtrSafe Function c_series_residual Lib "rwedge.dll" Alias "rwedge_series_residual" ( _
    ByVal series As LongPtr) As Double
Private Declare PtrSafe Function c_series_pressure Lib "rwedge.dll" Alias "rwedge_series_pressure" ( _
    ByVal series As LongPtr, ByVal x As Double) As Double
Private Declare PtrSafe Function c_series_potential Lib "rwedge.dll" Alias "rwedge_series_potential" ( _
    ByVal series As LongPtr, ByVal f As Double, ByVal x As Double, ByVal y As Double, ByRef re As Double, _
    ByRef im As Double) As Long
Private Declare PtrSafe Function c_series_stress Lib "rwedge.dll" Alias "rwedge_series_stress" ( _
    ByVal series As LongPtr, ByVal f As Double, ByVal x As Double, ByVal y As Double, ByRef sxx As Double, _
    ByRef syy As Double, ByRef txy As Double) As Long

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

Private Function failure(ByVal status As Long) As Variant
    Select Case status
        Case LIBRARY_MISSING
            failure = CVErr(xlErrName)
        Case NOT_A_COLUMN
            failure = CVErr(xlErrValue)
        Case Else
            Debug.Print "rwedge: " & text_at(c_strerror(status))
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
        RWEDGE_CONTACT_HISTORY = failure(status)
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
                table(i, j) = failure(status)
            Next j
        End If
    Next i
    c_contact_destroy contact
    RWEDGE_CONTACT_HISTORY = table
End Function

' ---- Materials ---------------------------------------------------------------------------------

' Composite compliance A = 2(1-nu1^2)/E1 + 2(1-nu2^2)/E2, in 1/unit of E.                   Eq. (2)
'   E1, E2    Young's moduli, > 0; HUGE_VAL is a rigid body (one of the two at most)
'   nu1, nu2  Poisson's ratios, -1 < nu <= 0.5
' NaN outside the domain, or where A leaves it. Relative error below 4 epsilon.
Public Function RWEDGE_COMPLIANCE(ByVal E1 As Double, ByVal nu1 As Double, ByVal E2 As Double, ByVal nu2 As Double) As Variant
Attribute RWEDGE_COMPLIANCE.VB_Description = "Composite compliance A = 2(1-nu1^2)/E1 + 2(1-nu2^2)/E2, in 1/unit of E."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_COMPLIANCE = finite(c_compliance(E1, nu1, E2, nu2))
    Else
        RWEDGE_COMPLIANCE = failure(status)
    End If
End Function

' Dundurs' second constant for plane strain. It couples the normal and the tangential problem: the
' theory with friction is exact where it is 0 (elastically similar bodies).
'                                                                 Dundurs (1969), see lib/README.md
'   arguments as for rwedge_compliance(); beta changes sign when the bodies are exchanged;
'   |beta| <= 1/2 for nu >= 0
' NaN outside the domain. Error below 4 epsilon, absolutely.
Public Function RWEDGE_DUNDURS_BETA(ByVal E1 As Double, ByVal nu1 As Double, ByVal E2 As Double, ByVal nu2 As Double) As Variant
Attribute RWEDGE_DUNDURS_BETA.VB_Description = "Dundurs' second constant for plane strain. It couples the normal and the tangential problem: the theory with friction is exact where it is 0 (elastically similar bodies)."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_DUNDURS_BETA = finite(c_dundurs_beta(E1, nu1, E2, nu2))
    Else
        RWEDGE_DUNDURS_BETA = failure(status)
    End If
End Function

' ---- Contact law -------------------------------------------------------------------------------

' Load of a contact of half-width b, as A P/(theta b): 2 for the sharp wedge, (pi/2)/alpha for
' Hertz.                                                                  Eq. (7), (11), (13), (15)
' NaN outside the domain of alpha. Relative error below 4 epsilon. Inverse: rwedge_a_over_b().
Public Function RWEDGE_LOAD(ByVal alpha As Double) As Variant
Attribute RWEDGE_LOAD.VB_Description = "Load of a contact of half-width b, as A P/(theta b): 2 for the sharp wedge, (pi/2)/alpha for Hertz. NaN outside the domain of alpha. Relative error below 4 epsilon. Inverse: rwedge_a_over_b()."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_LOAD = finite(c_load(alpha))
    Else
        RWEDGE_LOAD = failure(status)
    End If
End Function

' The contact law solved for its half-width: a/b from A P/(theta a), over the whole range, Hertz
' (a/b >= 1) included.                                                       Eq. (7), (11), inverse
'   AP_over_theta_a  > 0, finite
' NaN outside the domain, or where a/b leaves it. Relative error below 1e-14.
Public Function RWEDGE_A_OVER_B(ByVal AP_over_theta_a As Double) As Variant
Attribute RWEDGE_A_OVER_B.VB_Description = "The contact law solved for its half-width: a/b from A P/(theta a), over the whole range, Hertz (a/b >= 1) included."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_A_OVER_B = finite(c_a_over_b(AP_over_theta_a))
    Else
        RWEDGE_A_OVER_B = failure(status)
    End If
End Function

' ---- Pressure ----------------------------------------------------------------------------------

' Contact pressure A p/theta at x, compression negative; 0 for |x| >= 1.        Eq. (8), (12), (14)
' NaN outside the domain, and at the apex of the sharp wedge (alpha = 0, x = 0), where it is
' infinite. Relative error below 1e-12, up to the zeros at x = +-1.
Public Function RWEDGE_PRESSURE(ByVal alpha As Double, ByVal x As Double) As Variant
Attribute RWEDGE_PRESSURE.VB_Description = "Contact pressure A p/theta at x, compression negative; 0 for |x| >= 1. NaN outside the domain, and at the apex of the sharp wedge (alpha = 0, x = 0), where it is infinite. Relative error below 1e-12, up to the zeros at x = +-1."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_PRESSURE = finite(c_pressure(alpha, x))
    Else
        RWEDGE_PRESSURE = failure(status)
    End If
End Function

' Magnitude of the peak pressure, at x = 0, as A p0/theta.                           Eq. (10), (16)
' NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14.
Public Function RWEDGE_PEAK_PRESSURE(ByVal alpha As Double) As Variant
Attribute RWEDGE_PEAK_PRESSURE.VB_Description = "Magnitude of the peak pressure, at x = 0, as A p0/theta. NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_PEAK_PRESSURE = finite(c_peak_pressure(alpha))
    Else
        RWEDGE_PEAK_PRESSURE = failure(status)
    End If
End Function

' Magnitude of the pressure where the rounding meets the flank, x = +-a, as A p/theta; 0 for
' alpha >= 1, where x = a is not inside the contact.                                        Eq. (9)
' NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14.
Public Function RWEDGE_TRANSITION_PRESSURE(ByVal alpha As Double) As Variant
Attribute RWEDGE_TRANSITION_PRESSURE.VB_Description = "Magnitude of the pressure where the rounding meets the flank, x = +-a, as A p/theta; 0 for alpha >= 1, where x = a is not inside the contact. NaN outside the domain, and for alpha = 0, where it is infinite. Relative error below 1e-14."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_TRANSITION_PRESSURE = finite(c_transition_pressure(alpha))
    Else
        RWEDGE_TRANSITION_PRESSURE = failure(status)
    End If
End Function

' Coefficient b_n of the paper's series p = -sqrt(1-x^2) sum b_n U_2n(x).
'                                                                       Eq. (29), (31) with E1; new
'   n  index of the coefficient, >= 0
' NaN outside the domain; 0 for alpha >= 1 and n >= 1. Error below the larger of 1e-14,
' relatively, and 1e-22 of the values around: this counts next to a zero of b_n.
Public Function RWEDGE_COEFFICIENT(ByVal alpha As Double, ByVal n As Long) As Variant
Attribute RWEDGE_COEFFICIENT.VB_Description = "Coefficient b_n of the paper's series p = -sqrt(1-x^2) sum b_n U_2n(x)."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_COEFFICIENT = finite(c_coefficient(alpha, n))
    Else
        RWEDGE_COEFFICIENT = failure(status)
    End If
End Function

' ---- Partial slip ------------------------------------------------------------------------------

' Half-width of the stick zone c/b, under a tangential force Q < fP that grew from zero under
' constant P.                                                                              Eq. (25)
'   Q_over_fP  0 <= Q/(fP) <= 1; 0 sticks everywhere (1), 1 slides (0)
' NaN outside the domain. Relative error below 1e-14. Inverse: rwedge_shear_ratio().
Public Function RWEDGE_STICK_WIDTH(ByVal alpha As Double, ByVal Q_over_fP As Double) As Variant
Attribute RWEDGE_STICK_WIDTH.VB_Description = "Half-width of the stick zone c/b, under a tangential force Q < fP that grew from zero under constant P."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_STICK_WIDTH = finite(c_stick_width(alpha, Q_over_fP))
    Else
        RWEDGE_STICK_WIDTH = failure(status)
    End If
End Function

' Q/(fP) from the half-width of the stick zone.                                            Eq. (25)
' NaN outside the domain. Relative error below 1e-14, also where it goes to 0 (c near 1).
Public Function RWEDGE_SHEAR_RATIO(ByVal alpha As Double, ByVal c As Double) As Variant
Attribute RWEDGE_SHEAR_RATIO.VB_Description = "Q/(fP) from the half-width of the stick zone. NaN outside the domain. Relative error below 1e-14, also where it goes to 0 (c near 1)."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_SHEAR_RATIO = finite(c_shear_ratio(alpha, c))
    Else
        RWEDGE_SHEAR_RATIO = failure(status)
    End If
End Function

' Shear traction A q/(f theta) at x, with a stick zone |x| < c; it has the sign of the pressure
' (q = f p where it slips); 0 for |x| >= 1.                                    Eq. (23), (26), (27)
' NaN outside the domain, and for alpha = c = x = 0. Error below 1e-14 (1 + |A p/theta|).
Public Function RWEDGE_SHEAR(ByVal alpha As Double, ByVal c As Double, ByVal x As Double) As Variant
Attribute RWEDGE_SHEAR.VB_Description = "Shear traction A q/(f theta) at x, with a stick zone |x| < c; it has the sign of the pressure (q = f p where it slips); 0 for |x| >= 1. NaN outside the domain, and for alpha = c = x = 0. Error below 1e-14 (1 + |A p/theta|)."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_SHEAR = finite(c_shear(alpha, c, x))
    Else
        RWEDGE_SHEAR = failure(status)
    End If
End Function

' ---- Interior stresses -------------------------------------------------------------------------

' Stresses at the point (x, y), in theta/A, tension positive; closed form.
'                                                             Eq. (28), (32), (33) with E4, E8; new
'   x, y           in b, finite, y >= 0; not the apex (0, 0) of the sharp wedge
'   sxx, syy, txy  each receives one number
' RWEDGE_EDOMAIN, RWEDGE_ENULL.
' Error below 1e-13 of the larger of the tensor's norm and max(1, f)/(1+|z|), z = x + iy.
' In a cell: the row sxx, syy, txy.
Public Function RWEDGE_STRESS( _
        ByVal alpha As Double, ByVal f As Double, ByVal c As Double, ByVal x As Double, ByVal y As Double) As Variant
Attribute RWEDGE_STRESS.VB_Description = "Stresses at the point (x, y), in theta/A, tension positive; closed form."
    Dim sxx As Double, syy As Double, txy As Double, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = c_stress(alpha, f, c, x, y, sxx, syy, txy)
    If status = RWEDGE_OK Then
        RWEDGE_STRESS = Array(sxx, syy, txy)
    Else
        RWEDGE_STRESS = failure(status)
    End If
End Function

' The same at n points: x[i], y[i] -> sxx[i], syy[i], txy[i]. Nothing is written unless every
' point is in the domain.
' In a cell: a row for each point: sxx, syy, txy.
Public Function RWEDGE_STRESSES( _
        ByVal alpha As Double, ByVal f As Double, ByVal c As Double, ByVal x As Variant, ByVal y As Variant) As Variant
Attribute RWEDGE_STRESSES.VB_Description = "As RWEDGE_STRESS at n points: x[i], y[i] -> sxx[i], syy[i], txy[i]. Nothing is written unless every point is in the domain."
    Dim x_list() As Double, y_list() As Double, sxx() As Double, syy() As Double, txy() As Double, n As Long, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then status = read_list(y, y_list, n)
    If status = RWEDGE_OK Then
        ReDim sxx(0 To n - 1), syy(0 To n - 1), txy(0 To n - 1)
        status = c_stresses(alpha, f, c, n, x_list(0), y_list(0), sxx(0), syy(0), txy(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_STRESSES = table_of(n, sxx, syy, txy)
    Else
        RWEDGE_STRESSES = failure(status)
    End If
End Function

' ---- Strength ----------------------------------------------------------------------------------

' Maximum tension b s1/(fP), at the trailing edge in full sliding: 1 for the sharp wedge, 4/pi
' for Hertz.                                                                          Eq. (38); new
' NaN outside the domain. Relative error below 1e-14.
Public Function RWEDGE_MAX_TENSION(ByVal alpha As Double) As Variant
Attribute RWEDGE_MAX_TENSION.VB_Description = "Maximum tension b s1/(fP), at the trailing edge in full sliding: 1 for the sharp wedge, 4/pi for Hertz. NaN outside the domain. Relative error below 1e-14."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_MAX_TENSION = finite(c_max_tension(alpha))
    Else
        RWEDGE_MAX_TENSION = failure(status)
    End If
End Function

' Elastic limit P/(bk): the load at first yield (von Mises, plane strain) in full sliding, or
' under a normal load (f = 0).                                                         Figs. 3 to 5
' It belongs to the global maximum of J2 over the half-plane. It is 0 for the sharp wedge, whose
' stresses are infinite; but pi for nu = 0.5 and f = 0.
'   alpha  0, or at least 1e-14: the J2 of smaller tips can be too flat for its maximum to be found
' NaN outside the domain. Relative error below 1e-12.
Public Function RWEDGE_ELASTIC_LIMIT(ByVal alpha As Double, ByVal f As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_ELASTIC_LIMIT.VB_Description = "Elastic limit P/(bk): the load at first yield (von Mises, plane strain) in full sliding, or under a normal load (f = 0). It belongs to the global maximum of J2 over the half-plane. It is 0 for the sharp wedge, whose stresses are infinite"
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_ELASTIC_LIMIT = finite(c_elastic_limit(alpha, f, nu))
    Else
        RWEDGE_ELASTIC_LIMIT = failure(status)
    End If
End Function

' The same for n pairs alpha[i], f[i]. Nothing is written unless every pair is in the domain.
' In a cell: a row for each point: limit.
Public Function RWEDGE_ELASTIC_LIMITS(ByVal alpha As Variant, ByVal f As Variant, ByVal nu As Double) As Variant
Attribute RWEDGE_ELASTIC_LIMITS.VB_Description = "As RWEDGE_ELASTIC_LIMIT for n pairs alpha[i], f[i]. Nothing is written unless every pair is in the domain."
    Dim alpha_list() As Double, f_list() As Double, limit() As Double, n As Long, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = read_list(alpha, alpha_list, n)
    If status = RWEDGE_OK Then status = read_list(f, f_list, n)
    If status = RWEDGE_OK Then
        ReDim limit(0 To n - 1)
        status = c_elastic_limits(n, alpha_list(0), f_list(0), nu, limit(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_ELASTIC_LIMITS = table_of(n, limit)
    Else
        RWEDGE_ELASTIC_LIMITS = failure(status)
    End If
End Function

' The elastic limit and where it yields: y = 0 is at the surface.                            Fig. 5
'   alpha  0, or at least 1e-14
' The sharp wedge yields at its apex. For nu = 0.5 and alpha >= 1 the whole surface of the
' contact is equally stressed.
' RWEDGE_EDOMAIN, RWEDGE_ENULL. Error of the place about 1e-12 where the maximum is not flat.
' In a cell: the row limit, x, y.
Public Function RWEDGE_YIELD_POINT(ByVal alpha As Double, ByVal f As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_YIELD_POINT.VB_Description = "The elastic limit and where it yields: y = 0 is at the surface."
    Dim limit As Double, x As Double, y As Double, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = c_yield_point(alpha, f, nu, limit, x, y)
    If status = RWEDGE_OK Then
        RWEDGE_YIELD_POINT = Array(limit, x, y)
    Else
        RWEDGE_YIELD_POINT = failure(status)
    End If
End Function

' The elastic limit has two branches, below the surface and at it. It is the smaller of the two,
' and the cusps of Fig. 4 are where they cross. Each branch is smooth in alpha, f and nu, so that
' each can be interpolated.                                                             Fig. 4; new
'
' Below the surface: the local maximum of J2 that is on the axis for f = 0. Large f and small
' alpha have none: RWEDGE_EABSENT.
'   alpha  0, or at least 1e-14
' RWEDGE_EDOMAIN, RWEDGE_ENULL.
' In a cell: the row limit, x, y.
Public Function RWEDGE_SUBSURFACE_YIELD(ByVal alpha As Double, ByVal f As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_SUBSURFACE_YIELD.VB_Description = "The elastic limit has two branches, below the surface and at it. It is the smaller of the two, and the cusps of Fig. 4 are where they cross. Each branch is smooth in alpha, f and nu, so that each can be interpolated."
    Dim limit As Double, x As Double, y As Double, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = c_subsurface_yield(alpha, f, nu, limit, x, y)
    If status = RWEDGE_OK Then
        RWEDGE_SUBSURFACE_YIELD = Array(limit, x, y)
    Else
        RWEDGE_SUBSURFACE_YIELD = failure(status)
    End If
End Function

' At the surface: the maximum of J2 over y = 0. It is at 0 <= x <= min(alpha, 1). RWEDGE_EABSENT
' for nu = 0.5 and f = 0, where J2 is 0 on the surface.
'   alpha  0, or at least 1e-14
' RWEDGE_EDOMAIN, RWEDGE_ENULL.                                                      Fig. 4; new
' In a cell: the row limit, x.
Public Function RWEDGE_SURFACE_YIELD(ByVal alpha As Double, ByVal f As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_SURFACE_YIELD.VB_Description = "At the surface: the maximum of J2 over y = 0. It is at 0 <= x <= min(alpha, 1). RWEDGE_EABSENT for nu = 0.5 and f = 0, where J2 is 0 on the surface."
    Dim limit As Double, x As Double, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = c_surface_yield(alpha, f, nu, limit, x)
    If status = RWEDGE_OK Then
        RWEDGE_SURFACE_YIELD = Array(limit, x)
    Else
        RWEDGE_SURFACE_YIELD = failure(status)
    End If
End Function

' Critical friction: the f at which yield jumps from below to the surface. It is 0 where yield is
' at the surface without friction already. (The smallest of these tips, a/b < 0.0026, yield
' below the surface again in an interval of f: lib/README.md.)                          Fig. 4; new
'   alpha  0, or at least 1e-14; the sharp wedge yields at its apex: 0
' NaN outside the domain. Error below 1e-11 f, or 1e-14/f next to its zero, from which it rises
' like a square root.
Public Function RWEDGE_CRITICAL_FRICTION(ByVal alpha As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_CRITICAL_FRICTION.VB_Description = "Critical friction: the f at which yield jumps from below to the surface. It is 0 where yield is at the surface without friction already. (The smallest of these tips, a/b < 0.0026, yield below the surface again in an interval of f: lib/README.md.)"
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_CRITICAL_FRICTION = finite(c_critical_friction(alpha, nu))
    Else
        RWEDGE_CRITICAL_FRICTION = failure(status)
    End If
End Function

' ---- Validity ----------------------------------------------------------------------------------

' What makes results doubtful: the bits of rwedge_validity(). Values never change; new ones are
' added at the end.

' What makes the results for such a contact doubtful, as a sum of bits: rwedge_validity_text()
' says what each means. The sum is 0 where nothing does. What is not known is given as NaN; it adds
' no doubt. Nor does a 0, except as safety.                                                     new
'   theta     any number; the angle between flank and surface, rad
'   alpha     any number; a/b under the load; 0 is the sharp wedge
'   beta      any number; rwedge_dundurs_beta()
'   f         any number; the coefficient of friction
'   k_over_E  any number; yield stress in pure shear over Young's modulus of the half-plane
'   safety    any number; rwedge_yield_load() over P, or that of rwedge_contact_yield_factor()
Public Function RWEDGE_VALIDITY( _
        ByVal theta As Double, ByVal alpha As Double, ByVal beta As Double, ByVal f As Double, _
        ByVal k_over_E As Double, ByVal safety As Double) As Variant
Attribute RWEDGE_VALIDITY.VB_Description = "What makes the results for such a contact doubtful, as a sum of bits: rwedge_validity_text() says what each means. The sum is 0 where nothing does. What is not known is given as NaN; it adds no doubt. Nor does a 0, except as safety."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_VALIDITY = c_validity(theta, alpha, beta, f, k_over_E, safety)
    Else
        RWEDGE_VALIDITY = failure(status)
    End If
End Function

' What one bit of rwedge_validity() means, in English: a line for messages. Empty for any other
' number. To list all bits, go through 1, 2, 4 ... until the text is empty.
' Static text, never NULL.
'   doubt  any integer
Public Function RWEDGE_VALIDITY_TEXT(ByVal doubt As Long) As Variant
Attribute RWEDGE_VALIDITY_TEXT.VB_Description = "What one bit of rwedge_validity() means, in English: a line for messages. Empty for any other number. To list all bits, go through 1, 2, 4 ... until the text is empty. Static text, never NULL."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_VALIDITY_TEXT = text_at(c_validity_text(doubt))
    Else
        RWEDGE_VALIDITY_TEXT = failure(status)
    End If
End Function

' ---- Dimensional quantities --------------------------------------------------------------------

' From here to the series, any consistent set of units. Arguments that return:
'   theta  angle between flank and surface, rad, 0 < theta < pi/2; the theory is that of small
'          angles
'   a      half-width of the rounding, length, finite, >= 0; 0 is the sharp wedge
'   A      composite compliance, 1/stress, finite, > 0: rwedge_compliance()
'   f      coefficient of friction, 0 <= f <= 1e6
'   k      yield stress in pure shear, stress, finite, > 0
'   P, Q   normal and tangential force per unit length
' The functions that return a double give NaN outside the domain, and where the result or a/b
' leaves it.

' Radius of the rounding, R = a/theta, length.                                            Sec. 2
Public Function RWEDGE_RADIUS(ByVal theta As Double, ByVal a As Double) As Variant
Attribute RWEDGE_RADIUS.VB_Description = "Radius of the rounding, R = a/theta, length."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_RADIUS = finite(c_radius(theta, a))
    Else
        RWEDGE_RADIUS = failure(status)
    End If
End Function

' Half-width of the rounding from its radius, a = R theta, length.                           Sec. 2
'   R  radius, length, finite, >= 0
Public Function RWEDGE_ROUNDING(ByVal theta As Double, ByVal R As Double) As Variant
Attribute RWEDGE_ROUNDING.VB_Description = "Half-width of the rounding from its radius, a = R theta, length."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_ROUNDING = finite(c_rounding(theta, R))
    Else
        RWEDGE_ROUNDING = failure(status)
    End If
End Function

' Half-width b of the contact under the load P, length.                Eq. (7), (11), (15), inverse
'   P  finite, >= 0; 0 gives 0
' Relative error below 1e-14. Inverse: rwedge_normal_load().
Public Function RWEDGE_HALF_WIDTH( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal P As Double) As Variant
Attribute RWEDGE_HALF_WIDTH.VB_Description = "Half-width b of the contact under the load P, length."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_HALF_WIDTH = finite(c_half_width(theta, a, compliance, P))
    Else
        RWEDGE_HALF_WIDTH = failure(status)
    End If
End Function

' The load P whose contact has the half-width b, force/length.                  Eq. (7), (11), (15)
'   b  length, finite, >= 0; 0 gives 0
' Relative error below 1e-14. Inverse: rwedge_half_width().
Public Function RWEDGE_NORMAL_LOAD( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal b As Double) As Variant
Attribute RWEDGE_NORMAL_LOAD.VB_Description = "The load P whose contact has the half-width b, force/length."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_NORMAL_LOAD = finite(c_normal_load(theta, a, compliance, b))
    Else
        RWEDGE_NORMAL_LOAD = failure(status)
    End If
End Function

' The load P at which a given contact first yields in full sliding, or under a normal load (f =
' 0), force/length. The contact grows with P, and the elastic limit depends on a/b: P is the root
' of an equation.                                                                      Figs. 3 to 5
'   nu  Poisson's ratio of the half-plane, 0 <= nu <= 0.5
' It is 0 for the sharp wedge. It is HUGE_VAL where the contact does not yield before it is 1e14
' a wide. For f = 0 and nu = 0.5 it never yields if k > (2/pi) theta/A: the deviator stays
' bounded however large the load. Relative error below 1e-11, and 1e-15 dlnP/dlnk, which is large
' for f = 0 and nu near 0.5.
Public Function RWEDGE_YIELD_LOAD( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, ByVal nu As Double, _
        ByVal k As Double) As Variant
Attribute RWEDGE_YIELD_LOAD.VB_Description = "The load P at which a given contact first yields in full sliding, or under a normal load (f = 0), force/length. The contact grows with P, and the elastic limit depends on a/b: P is the root of an equation."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_YIELD_LOAD = finite(c_yield_load(theta, a, compliance, f, nu, k))
    Else
        RWEDGE_YIELD_LOAD = failure(status)
    End If
End Function

' ---- A contact with a load history -------------------------------------------------------------

' The largest |d sigma| with which the present Q may change to another under constant P and M,
' stress: 4 |dQ|/(pi s), for a strain of A/4 per tension. HUGE_VAL without friction, and where a
' tension stretches nothing.                                                                    new
'   Q  finite
' NaN outside the domain; NaN for NULL; 0 when separated. Relative error as that of the edges.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
Public Function RWEDGE_CONTACT_LARGEST_TENSION_STEP( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal Q As Double) As Variant
Attribute RWEDGE_CONTACT_LARGEST_TENSION_STEP.VB_Description = "The largest |d sigma| with which the present Q may change to another under constant P and M, stress: 4 |dQ|/(pi s), for a strain of A/4 per tension. HUGE_VAL without friction, and where a tension stretches nothing."
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_LARGEST_TENSION_STEP = finite(c_contact_largest_tension_step(contact, Q))
    Else
        RWEDGE_CONTACT_LARGEST_TENSION_STEP = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' The present loads.                                                                            new
'   P, M, Q, sigma  each receives one number
' RWEDGE_ENULL.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: the row P, M, Q, sigma.
Public Function RWEDGE_CONTACT_LOADS( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_LOADS.VB_Description = "The present loads."
    Dim P As Double, M As Double, Q As Double, sigma As Double, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = c_contact_loads(contact, P, M, Q, sigma)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_LOADS = Array(P, M, Q, sigma)
    Else
        RWEDGE_CONTACT_LOADS = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' The edges of the contact, left < x < right.                                                   new
'   left, right  length
' RWEDGE_EABSENT when separated; RWEDGE_ENULL. Error below 1e-14 of the width, or of |x| where that
' is larger, over 1 - |tilt|/theta.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: the row left, right.
Public Function RWEDGE_CONTACT_EDGES( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_EDGES.VB_Description = "The edges of the contact, left < x < right."
    Dim left As Double, right As Double, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = c_contact_edges(contact, left, right)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_EDGES = Array(left, right)
    Else
        RWEDGE_CONTACT_EDGES = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' The edges of the stick zone: between them and those of the contact friction is exhausted, |q| = f
' |p|. Those of the contact where there is no such zone.                                        new
'   left, right  length
' RWEDGE_EABSENT in full sliding, and when separated; RWEDGE_ENULL. After one step of Q and sigma
' the error is that of the contact's edges, over the root of the part of P that the zone carries,
' and with the zone's tilt where that is larger.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: the row left, right.
Public Function RWEDGE_CONTACT_STICK_ZONE( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_STICK_ZONE.VB_Description = "The edges of the stick zone: between them and those of the contact friction is exhausted, |q| = f |p|. Those of the contact where there is no such zone."
    Dim left As Double, right As Double, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = c_contact_stick_zone(contact, left, right)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_STICK_ZONE = Array(left, right)
    Else
        RWEDGE_CONTACT_STICK_ZONE = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' The angle by which the moment tilts the wedge, rad: |tilt| < theta.                           new
' 0 without a moment; NaN for NULL. Error below 1e-14 theta, where the edges have their relative
' error.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
Public Function RWEDGE_CONTACT_TILT( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_TILT.VB_Description = "The angle by which the moment tilts the wedge, rad: |tilt| < theta. 0 without a moment; NaN for NULL. Error below 1e-14 theta, where the edges have their relative error."
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_TILT = finite(c_contact_tilt(contact))
    Else
        RWEDGE_CONTACT_TILT = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' How pressure and shear behave at the edges, at the distance r: |p| ~ K_N sqrt(r), and, as long as
' slip is short, q ~ -K_T/sqrt(r), which slips over the length 2 |K_T|/(f K_N): to 0.1 % at Q/(fP)
' = 0.001, 9 % at 0.1, 35 % at 0.5. Two contacts of the same K_N and K_T are alike at their edges:
' this is how a pad is matched to a specimen.                                                   new
'   normal_left, normal_right  K_N, stress over the root of a length
'   shear_left, shear_right    K_T, stress times the root of a length, of the present Q and of
'                              the strain by sigma less what it was when the bodies touched
' RWEDGE_EABSENT when separated; RWEDGE_ENULL. K_N to 1e-14 of the larger one, of the edges that
' rwedge_contact_edges() gives.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: the row normal_left, normal_right, shear_left, shear_right.
Public Function RWEDGE_CONTACT_EDGE_ASYMPTOTES( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_EDGE_ASYMPTOTES.VB_Description = "How pressure and shear behave at the edges, at the distance r: |p| ~ K_N sqrt(r), and, as long as slip is short, q ~ -K_T/sqrt(r), which slips over the length 2 |K_T|/(f K_N): to 0.1 % at Q/(fP) = 0.001, 9 % at 0.1, 35 % at 0.5."
    Dim normal_left As Double, normal_right As Double, shear_left As Double, shear_right As Double, contact As LongPtr
    Dim status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = c_contact_edge_asymptotes(contact, normal_left, normal_right, shear_left, shear_right)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_EDGE_ASYMPTOTES = Array(normal_left, normal_right, shear_left, shear_right)
    Else
        RWEDGE_CONTACT_EDGE_ASYMPTOTES = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' The zone that never slips while loads go to and fro between two points in a straight line, once
' the first cycles are over, whatever was before.                                               new
'   P1, P2          finite, >= 0, as for rwedge_contact_apply()
'   M1, M2          finite; 0 where P is 0
'   Q1, Q2          |Q| <= f P
'   sigma1, sigma2  finite
'   left, right     its edges, length
' The compliances are equal: a tension stretches the surface by A/4 of it.
' RWEDGE_EABSENT where all slides at times; RWEDGE_EPATH where the edges slip in opposite
' directions, or what sticks would reach beyond one of the contacts; RWEDGE_ESLIDING,
' RWEDGE_EDOMAIN, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Error as that of
' rwedge_contact_stick_zone().
' In a cell: the row left, right.
Public Function RWEDGE_PERMANENT_STICK( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, ByVal P1 As Double, _
        ByVal M1 As Double, ByVal Q1 As Double, ByVal sigma1 As Double, ByVal P2 As Double, ByVal M2 As Double, _
        ByVal Q2 As Double, ByVal sigma2 As Double) As Variant
Attribute RWEDGE_PERMANENT_STICK.VB_Description = "The zone that never slips while loads go to and fro between two points in a straight line, once the first cycles are over, whatever was before."
    Dim left As Double, right As Double, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = c_permanent_stick(theta, a, compliance, f, P1, M1, Q1, sigma1, P2, M2, Q2, sigma2, left, right)
    If status = RWEDGE_OK Then
        RWEDGE_PERMANENT_STICK = Array(left, right)
    Else
        RWEDGE_PERMANENT_STICK = failure(status)
    End If
End Function

' Half-width b of the contact, length; 0 when separated; NaN for NULL. Half its width where it is
' off the centre.
'                                                                   Eq. (7), (11), (15), inverse
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
Public Function RWEDGE_CONTACT_HALF_WIDTH( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_HALF_WIDTH.VB_Description = "Half-width b of the contact, length; 0 when separated; NaN for NULL. Half its width where it is off the centre."
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_HALF_WIDTH = finite(c_contact_half_width(contact))
    Else
        RWEDGE_CONTACT_HALF_WIDTH = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' Half-width c of the stick zone, length. Outside it, c < |x| < b, friction is exhausted: |q| = f
' |p|. So it is in a ring that came into contact with |dQ| = f dP, to rounding, though it has not
' slipped. c is b where all sticks, 0 in full sliding and when separated; NaN for NULL.
'                                                                                  Eq. (25); new
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
Public Function RWEDGE_CONTACT_STICK_HALF_WIDTH( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_STICK_HALF_WIDTH.VB_Description = "Half-width c of the stick zone, length. Outside it, c < |x| < b, friction is exhausted: |q| = f |p|. So it is in a ring that came into contact with |dQ| = f dP, to rounding, though it has not slipped."
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_STICK_HALF_WIDTH = finite(c_contact_stick_half_width(contact))
    Else
        RWEDGE_CONTACT_STICK_HALF_WIDTH = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' Pressure p and shear traction q at n points of the surface, stress: compression negative; q =
' f p where it slips under Q > 0. Both are 0 for |x| >= b.        Eq. (8), (12), (14), (22) to (27)
'   x     length, finite; not the apex 0 of a loaded sharp wedge
'   p, q  each receives n numbers
' RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
' Error of p as rwedge_pressure(), of q below 1e-13 f (theta/A + |p|).
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: a row for each point: p, q.
Public Function RWEDGE_CONTACT_TRACTIONS( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal x As Variant) As Variant
Attribute RWEDGE_CONTACT_TRACTIONS.VB_Description = "Pressure p and shear traction q at n points of the surface, stress: compression negative; q = f p where it slips under Q > 0. Both are 0 for |x| >= b."
    Dim x_list() As Double, p() As Double, q() As Double, n As Long, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then
        ReDim p(0 To n - 1), q(0 To n - 1)
        status = c_contact_tractions(contact, n, x_list(0), p(0), q(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_TRACTIONS = table_of(n, p, q)
    Else
        RWEDGE_CONTACT_TRACTIONS = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' Stresses at n points (x, y) of the half-plane, tension positive.        Eq. (28), (32), (33); new
'   x, y           length, finite, y >= 0; not the apex (0, 0) of a loaded sharp wedge
'   sxx, syy, txy  each receives n numbers
' RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
' Error below 1e-13 of what rwedge_stress() says, for every remembered point of the history.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: a row for each point: sxx, syy, txy.
Public Function RWEDGE_CONTACT_STRESSES( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal x As Variant, ByVal y As Variant) As Variant
Attribute RWEDGE_CONTACT_STRESSES.VB_Description = "Stresses at n points (x, y) of the half-plane, tension positive."
    Dim x_list() As Double, y_list() As Double, sxx() As Double, syy() As Double, txy() As Double, n As Long
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then status = read_list(y, y_list, n)
    If status = RWEDGE_OK Then
        ReDim sxx(0 To n - 1), syy(0 To n - 1), txy(0 To n - 1)
        status = c_contact_stresses(contact, n, x_list(0), y_list(0), sxx(0), syy(0), txy(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_STRESSES = table_of(n, sxx, syy, txy)
    Else
        RWEDGE_CONTACT_STRESSES = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' Slip at n points of the surface, length: how far the half-plane's surface has moved tangentially,
' relative to the wedge's, since the point last came into contact. It has the sign of q while it
' grows, so that q d(slip) is the heat. It is 0 where a point has stuck ever since. In full
' sliding the loads do not determine the rigid displacement. The slip is then the least that the
' loads need: the centre of the contact is on the verge of slip.
'                                                                             Eq. (17) to (21); new
'   x     length, |x| <= b: points outside have no partner
'   slip  receives n numbers
' RWEDGE_EPATH off the centre where rings of contact slipped at once when they came into contact,
' or slipped after they had been added to others that slipped before, and in full sliding.
' RWEDGE_EDOMAIN; RWEDGE_ENULL. Nothing is written unless every point is in the domain.
' Error below 1e-12 f theta b, for loads that differ by 1 % or more.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: a row for each point: slip.
Public Function RWEDGE_CONTACT_SLIP( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal x As Variant) As Variant
Attribute RWEDGE_CONTACT_SLIP.VB_Description = "Slip at n points of the surface, length: how far the half-plane's surface has moved tangentially, relative to the wedge's, since the point last came into contact. It has the sign of q while it grows, so that q d(slip) is the heat."
    Dim x_list() As Double, slip() As Double, n As Long, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then
        ReDim slip(0 To n - 1)
        status = c_contact_slip(contact, n, x_list(0), slip(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_SLIP = table_of(n, slip)
    Else
        RWEDGE_CONTACT_SLIP = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' Energy dissipated by friction since the contact was created, per unit thickness (a force): the
' time integral of the traction times the rate of slip over the contact, without the rigid
' displacement in full sliding. It never falls. In a cycle under constant P it is the area of the
' loop of Q over the rigid displacement.                                                        new
' NaN for NULL. A load off the centre that slips while P or M change, or slides, has no single
' integral: the energy is then NaN until the first load after the bodies have separated, from
' which it counts again. What was dissipated between is missing in the sum. Relative error of each
' load's share below 1e-12, and epsilon times P over the change of Q/f where that slip reaches an
' older layer. Off the centre it is below 1e-12 and 1e-14 times P over the change of Q/f. Both grow
' with 1/(1 - |tilt|/theta), and with |x| at the edges over the width where that is above 1.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
Public Function RWEDGE_CONTACT_DISSIPATED_ENERGY( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant) As Variant
Attribute RWEDGE_CONTACT_DISSIPATED_ENERGY.VB_Description = "Energy dissipated by friction since the contact was created, per unit thickness (a force): the time integral of the traction times the rate of slip over the contact, without the rigid displacement in full sliding. It never falls."
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_DISSIPATED_ENERGY = finite(c_contact_dissipated_energy(contact))
    Else
        RWEDGE_CONTACT_DISSIPATED_ENERGY = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' How far the present state is from first yield (von Mises, plane strain): k over the maximum of
' sqrt(J2) over the half-plane. Loads times this factor would not just yield, because the contact
' grows with them: see rwedge_yield_load().
'   nu      Poisson's ratio of the half-plane, 0 <= nu <= 0.5
'   factor  receives the factor: above 1 all is elastic; 0 where the stress is infinite, at the
'           apex of the sharp wedge
'   x, y    where the maximum is, length; each may be NULL
' The search is for the global maximum, around each remembered edge of slip, at every scale. It
' takes as long as the stresses at about 7000 points for a first load, and at 25 000 where
' rwedge_contact_memory() is 250. RWEDGE_EABSENT when separated: there is no stress.
' RWEDGE_EDOMAIN; RWEDGE_ENULL; RWEDGE_ERANGE where the factor leaves the domain. Relative error
' below 1e-12.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: the row factor, x, y.
Public Function RWEDGE_CONTACT_YIELD_FACTOR( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal nu As Double, ByVal k As Double) As Variant
Attribute RWEDGE_CONTACT_YIELD_FACTOR.VB_Description = "How far the present state is from first yield (von Mises, plane strain): k over the maximum of sqrt(J2) over the half-plane. Loads times this factor would not just yield, because the contact grows with them: see rwedge_yield_load()."
    Dim factor As Double, x As Double, y As Double, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = c_contact_yield_factor(contact, nu, k, factor, x, y)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_YIELD_FACTOR = Array(factor, x, y)
    Else
        RWEDGE_CONTACT_YIELD_FACTOR = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' ---- A cycle of loads --------------------------------------------------------------------------

' What a contact undergoes when it goes through a cycle of loads, in straight steps, as
' rwedge_contact_apply() goes to each. The contact is the one before the cycle, and stays as it is.
' For a steady state let it go through the loads first: once under constant P and M, twice where
' they change.
'   loads          number of loads of the cycle, >= 1
'   P              0, or at least 1e-8 of the last P
'   M, Q, sigma    finite: loads numbers each, as P
'   E              Young's modulus, stress, 1e-60 to 1e60
'   nu             Poisson's ratio of the half-plane, 0 <= nu <= 0.5
'   k_over_sy      as in rwedge_fatemi_socie(), 1/stress, 0 or 1e-60 to 1e60

' The measures of a cycle. Values never change; new ones are added at the end.

' Fatigue parameters at n points of the half-plane, from the stresses after each load.          new
'   x, y            length, finite, y >= 0: n numbers each; not the apex (0, 0) of a loaded sharp
'                   wedge
'   stress_range    receives n numbers: largest less smallest sxx
'   swt, swt_angle  each receives n numbers: rwedge_smith_watson_topper()
'   fatemi_socie, fs_angle  each receives n numbers: rwedge_fatemi_socie()
' RWEDGE_EDOMAIN, RWEDGE_EPATH, RWEDGE_ESLIDING, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Errors
' as those of the functions that are named.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: a row for each point: stress_range, swt, swt_angle, fatemi_socie, fs_angle.
Public Function RWEDGE_CONTACT_CYCLE_FATIGUE( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal P As Variant, ByVal M As Variant, _
        ByVal Q As Variant, ByVal sigma As Variant, ByVal x As Variant, ByVal y As Variant, ByVal E As Double, _
        ByVal nu As Double, ByVal k_over_sy As Double) As Variant
Attribute RWEDGE_CONTACT_CYCLE_FATIGUE.VB_Description = "Fatigue parameters at n points of the half-plane, from the stresses after each load."
    Dim P_list() As Double, M_list() As Double, Q_list() As Double, sigma_list() As Double, x_list() As Double
    Dim y_list() As Double, stress_range() As Double, swt() As Double, swt_angle() As Double, fatemi_socie() As Double
    Dim fs_angle() As Double, loads As Long, n As Long, contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(P, P_list, loads)
    If status = RWEDGE_OK Then status = read_list(M, M_list, loads)
    If status = RWEDGE_OK Then status = read_list(Q, Q_list, loads)
    If status = RWEDGE_OK Then status = read_list(sigma, sigma_list, loads)
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then status = read_list(y, y_list, n)
    If status = RWEDGE_OK Then
        ReDim stress_range(0 To n - 1), swt(0 To n - 1), swt_angle(0 To n - 1), fatemi_socie(0 To n - 1), fs_angle(0 To n - 1)
        status = c_contact_cycle_fatigue(contact, loads, P_list(0), M_list(0), Q_list(0), sigma_list(0), n, x_list(0), y_list(0), E, nu, k_over_sy, stress_range(0), swt(0), swt_angle(0), fatemi_socie(0), fs_angle(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_CYCLE_FATIGUE = table_of(n, stress_range, swt, swt_angle, fatemi_socie, fs_angle)
    Else
        RWEDGE_CONTACT_CYCLE_FATIGUE = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' What friction does at n places of the surface in the cycle. All is 0 where there is no contact.
' Slip counts from when a place came into contact. Where the contact leaves it and comes back, slip
' goes on from where it ended.                Ruiz, Boddington, Chen (1984), see lib/README.md; new
'   x           length, finite: n numbers; not the apex 0 of a loaded sharp wedge
'   slip_range  receives n numbers: largest less smallest slip, length
'   ruiz_f1     receives n numbers: largest |q| times slip range
'   ruiz_f2     receives n numbers: ruiz_f1 times the largest sxx after a load, 0 where that is not
'               tensile
'   energy      receives n numbers: dissipated per area, the integral of q d(slip)
' RWEDGE_EPATH where the slip has no closed form after one of the loads, or on the way to
' separation; RWEDGE_EDOMAIN, RWEDGE_ESLIDING, RWEDGE_ERANGE, RWEDGE_ENULL, RWEDGE_ENOMEM. Under
' constant P and M slip and energy are those of rwedge_contact_slip() and the tractions. Where they
' change, a step is cut into 32 parts: the energy of the contact then errs by 0.1 % in usual
' cycles, and by 1 % where little slips.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: a row for each point: slip_range, ruiz_f1, ruiz_f2, energy.
Public Function RWEDGE_CONTACT_CYCLE_FRICTION( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal P As Variant, ByVal M As Variant, _
        ByVal Q As Variant, ByVal sigma As Variant, ByVal x As Variant) As Variant
Attribute RWEDGE_CONTACT_CYCLE_FRICTION.VB_Description = "What friction does at n places of the surface in the cycle. All is 0 where there is no contact. Slip counts from when a place came into contact. Where the contact leaves it and comes back, slip goes on from where it ended."
    Dim P_list() As Double, M_list() As Double, Q_list() As Double, sigma_list() As Double, x_list() As Double
    Dim slip_range() As Double, ruiz_f1() As Double, ruiz_f2() As Double, energy() As Double, loads As Long, n As Long
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(P, P_list, loads)
    If status = RWEDGE_OK Then status = read_list(M, M_list, loads)
    If status = RWEDGE_OK Then status = read_list(Q, Q_list, loads)
    If status = RWEDGE_OK Then status = read_list(sigma, sigma_list, loads)
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then
        ReDim slip_range(0 To n - 1), ruiz_f1(0 To n - 1), ruiz_f2(0 To n - 1), energy(0 To n - 1)
        status = c_contact_cycle_friction(contact, loads, P_list(0), M_list(0), Q_list(0), sigma_list(0), n, x_list(0), slip_range(0), ruiz_f1(0), ruiz_f2(0), energy(0))
    End If
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_CYCLE_FRICTION = table_of(n, slip_range, ruiz_f1, ruiz_f2, energy)
    Else
        RWEDGE_CONTACT_CYCLE_FRICTION = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' Where a measure of the cycle is largest on a line along x: at the places at which it is known, or
' between them, around its tops.                                                                new
'   measure                 0 <= measure <= 6: RWEDGE_MEASURE_STRESS_RANGE to RWEDGE_MEASURE_ENERGY_PER_AREA
'   x                       length, finite; ascending: n numbers
'   value                   at least 0, finite: the measure there, n numbers, 0 where there is none
'   y                       depth, length, finite, y >= 0; 0 for slip, F1, F2 and energy
'   worst_x, worst_value    each receives one number
' RWEDGE_EDOMAIN where x does not ascend too; RWEDGE_ERANGE for n = 0; the others as in
' rwedge_contact_cycle_friction(). The place is found to 1e-10 of the distance of its neighbours
' where the top is not flat.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
' In a cell: the row worst_x, worst_value.
Public Function RWEDGE_CONTACT_CYCLE_WORST( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal measure As Long, ByVal P As Variant, _
        ByVal M As Variant, ByVal Q As Variant, ByVal sigma As Variant, ByVal x As Variant, ByVal value As Variant, _
        ByVal y As Double, ByVal E As Double, ByVal nu As Double, ByVal k_over_sy As Double) As Variant
Attribute RWEDGE_CONTACT_CYCLE_WORST.VB_Description = "Where a measure of the cycle is largest on a line along x: at the places at which it is known, or between them, around its tops."
    Dim worst_x As Double, worst_value As Double, P_list() As Double, M_list() As Double, Q_list() As Double
    Dim sigma_list() As Double, x_list() As Double, value_list() As Double, loads As Long, n As Long, contact As LongPtr
    Dim status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then status = read_list(P, P_list, loads)
    If status = RWEDGE_OK Then status = read_list(M, M_list, loads)
    If status = RWEDGE_OK Then status = read_list(Q, Q_list, loads)
    If status = RWEDGE_OK Then status = read_list(sigma, sigma_list, loads)
    If status = RWEDGE_OK Then status = read_list(x, x_list, n)
    If status = RWEDGE_OK Then status = read_list(value, value_list, n)
    If status = RWEDGE_OK Then status = c_contact_cycle_worst(contact, measure, loads, P_list(0), M_list(0), Q_list(0), sigma_list(0), n, x_list(0), value_list(0), y, E, nu, k_over_sy, worst_x, worst_value)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_CYCLE_WORST = Array(worst_x, worst_value)
    Else
        RWEDGE_CONTACT_CYCLE_WORST = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' How far remote points of the half-plane have moved along the surface against the wedge's, further
' than if the contact were bonded over |x| < b: what slip adds. Its loop over Q encloses the energy
' of a cycle under constant P. See lib/cycle/displacement.c.                                     new
'   b  length, > 0, finite
' NaN for NULL and when separated; NaN off the centre where the slip has no closed form, as in
' rwedge_contact_slip(). Relative error below 1e-12; off the centre 1e-6 of f theta times the
' half-width.
' In a cell: the contact is made of theta, a, compliance, f, P_history, Q_history.
Public Function RWEDGE_CONTACT_DISPLACEMENT( _
        ByVal theta As Double, ByVal a As Double, ByVal compliance As Double, ByVal f As Double, _
        ByVal P_history As Variant, ByVal Q_history As Variant, ByVal b As Double) As Variant
Attribute RWEDGE_CONTACT_DISPLACEMENT.VB_Description = "How far remote points of the half-plane have moved along the surface against the wedge's, further than if the contact were bonded over |x| < b: what slip adds. Its loop over Q encloses the energy of a cycle under constant P. See lib/cycle/displacement.c."
    Dim contact As LongPtr, status As Long
    status = contact_after(theta, a, compliance, f, P_history, Q_history, contact)
    If status = RWEDGE_OK Then
        RWEDGE_CONTACT_DISPLACEMENT = finite(c_contact_displacement(contact, b))
    Else
        RWEDGE_CONTACT_DISPLACEMENT = failure(status)
    End If
    If contact <> 0 Then c_contact_destroy contact
End Function

' ---- Measures of a stress ----------------------------------------------------------------------

' Of stresses from anywhere, in any unit; tension positive, y into the half-plane.
'   sxx, syy, txy  stresses, of at most 1e60 in magnitude
'   nu             Poisson's ratio, 0 <= nu <= 0.5: plane strain, szz = nu (sxx+syy); for plane
'                  stress, szz = 0, give nu = 0
' What is said of accuracy holds where the largest of the stresses is at least 1e-60.

' Von Mises' equivalent stress, sqrt(3 J2).                                       von Mises (1913)
' NaN outside the domain. Relative error below 4 epsilon.
Public Function RWEDGE_VON_MISES(ByVal sxx As Double, ByVal syy As Double, ByVal txy As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_VON_MISES.VB_Description = "Von Mises' equivalent stress, sqrt(3 J2). NaN outside the domain. Relative error below 4 epsilon."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_VON_MISES = finite(c_von_mises(sxx, syy, txy, nu))
    Else
        RWEDGE_VON_MISES = failure(status)
    End If
End Function

' The stress across the plane of x and y, szz = nu (sxx+syy). It is a principal stress.
' NaN outside the domain. Relative error below 4 epsilon.
Public Function RWEDGE_OUT_OF_PLANE_STRESS(ByVal sxx As Double, ByVal syy As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_OUT_OF_PLANE_STRESS.VB_Description = "The stress across the plane of x and y, szz = nu (sxx+syy). It is a principal stress. NaN outside the domain. Relative error below 4 epsilon."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_OUT_OF_PLANE_STRESS = finite(c_out_of_plane_stress(sxx, syy, nu))
    Else
        RWEDGE_OUT_OF_PLANE_STRESS = failure(status)
    End If
End Function

' The largest shear stress on any plane: half of the difference between the largest and the
' smallest principal stress, szz among them.                                         Tresca (1864)
' NaN outside the domain. Relative error below 4 epsilon.
Public Function RWEDGE_LARGEST_SHEAR( _
        ByVal sxx As Double, ByVal syy As Double, ByVal txy As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_LARGEST_SHEAR.VB_Description = "The largest shear stress on any plane: half of the difference between the largest and the smallest principal stress, szz among them. NaN outside the domain. Relative error below 4 epsilon."
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then
        RWEDGE_LARGEST_SHEAR = finite(c_largest_shear(sxx, syy, txy, nu))
    Else
        RWEDGE_LARGEST_SHEAR = failure(status)
    End If
End Function

' Principal stresses in the plane of x and y, s1 >= s2, and the plane on which s1 acts.
'   s1, s2  each receives one number
'   angle   receives the angle between that plane's normal and the surface's normal, the y axis,
'           rad, -pi/2 < angle <= pi/2. The plane's normal is (x, y) = (sin(angle), cos(angle)):
'           positive angles turn from +y towards +x. 0 where s1 = s2
' RWEDGE_EDOMAIN, RWEDGE_ENULL. Error of s1 and s2 below 4 epsilon of the larger magnitude of the
' two, of the angle below 4 epsilon.
' In a cell: the row s1, s2, angle.
Public Function RWEDGE_PRINCIPAL_STRESSES(ByVal sxx As Double, ByVal syy As Double, ByVal txy As Double) As Variant
Attribute RWEDGE_PRINCIPAL_STRESSES.VB_Description = "Principal stresses in the plane of x and y, s1 >= s2, and the plane on which s1 acts."
    Dim s1 As Double, s2 As Double, angle As Double, status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = c_principal_stresses(sxx, syy, txy, s1, s2, angle)
    If status = RWEDGE_OK Then
        RWEDGE_PRINCIPAL_STRESSES = Array(s1, s2, angle)
    Else
        RWEDGE_PRINCIPAL_STRESSES = failure(status)
    End If
End Function

' Smith, Watson and Topper's parameter of a cycle of stresses at one point, a stress: the largest
' value of
'     sn_max den/2
' over the planes that contain z. In the cycle, sn_max is the plane's largest normal stress (0 for
' a plane that is never in tension), den the range of its normal strain. Strains are elastic and
' plane, exx = (1+nu)/E ((1-nu) sxx - nu syy). For plane stress give E (1+2nu)/(1+nu)^2 for E and
' nu/(1+nu) for nu.
'                     Smith, Watson, Topper (1970); on planes Socie (1987); see lib/README.md; new
'   n              number of loads of the cycle, >= 1; their order does not matter
'   sxx, syy, txy  n stresses each
'   E              Young's modulus, stress, 1e-60 to 1e60
'   value, angle   each receives one number. The angle is that of the plane, as in
'                  rwedge_principal_stresses(); of one of them where several planes have the
'                  value, 0 where the value is 0
' RWEDGE_EDOMAIN; RWEDGE_ERANGE for n = 0; RWEDGE_ENULL. Error below 1e-14 s^2 (1+nu)/E, s being
' the largest principal stress of the cycle in magnitude: planes are not sampled, and none exceeds
' the value by more. The time grows like n; like n^2 where n is above 64 and many loads in turn
' are the worst for neighbouring planes, as on a circular path.
' In a cell: the row value, angle.
Public Function RWEDGE_SMITH_WATSON_TOPPER( _
        ByVal sxx As Variant, ByVal syy As Variant, ByVal txy As Variant, ByVal E As Double, ByVal nu As Double) As Variant
Attribute RWEDGE_SMITH_WATSON_TOPPER.VB_Description = "Smith, Watson and Topper's parameter of a cycle of stresses at one point, a stress: the largest value of"
    Dim value As Double, angle As Double, sxx_list() As Double, syy_list() As Double, txy_list() As Double, n As Long
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = read_list(sxx, sxx_list, n)
    If status = RWEDGE_OK Then status = read_list(syy, syy_list, n)
    If status = RWEDGE_OK Then status = read_list(txy, txy_list, n)
    If status = RWEDGE_OK Then status = c_smith_watson_topper(n, sxx_list(0), syy_list(0), txy_list(0), E, nu, value, angle)
    If status = RWEDGE_OK Then
        RWEDGE_SMITH_WATSON_TOPPER = Array(value, angle)
    Else
        RWEDGE_SMITH_WATSON_TOPPER = failure(status)
    End If
End Function

' Fatemi and Socie's parameter of a cycle of stresses at one point, a strain: the largest value of
'     (dgamma/2) (1 + k sn_max/sy)
' over the planes that contain z. In the cycle, dgamma is the range of the plane's shear strain,
' 2(1+nu)/E times its shear stress, and sn_max its largest normal stress: where that is
' compressive it counts as it is, but no plane counts less than 0.
'                                                 Fatemi and Socie (1988), see lib/README.md; new
'   k_over_sy  k over the yield stress in tension sy, 1/stress, 0 or 1e-60 to 1e60; k is 0.3 to 1
'              for most metals
'   others     as in rwedge_smith_watson_topper()
' RWEDGE_EDOMAIN; RWEDGE_ERANGE for n = 0; RWEDGE_ENULL. Error below 1e-14 (1 + s k/sy) s
' (1+nu)/E.
' In a cell: the row value, angle.
Public Function RWEDGE_FATEMI_SOCIE( _
        ByVal sxx As Variant, ByVal syy As Variant, ByVal txy As Variant, ByVal E As Double, ByVal nu As Double, _
        ByVal k_over_sy As Double) As Variant
Attribute RWEDGE_FATEMI_SOCIE.VB_Description = "Fatemi and Socie's parameter of a cycle of stresses at one point, a strain: the largest value of"
    Dim value As Double, angle As Double, sxx_list() As Double, syy_list() As Double, txy_list() As Double, n As Long
    Dim status As Long
    status = find_library()
    If status = RWEDGE_OK Then status = read_list(sxx, sxx_list, n)
    If status = RWEDGE_OK Then status = read_list(syy, syy_list, n)
    If status = RWEDGE_OK Then status = read_list(txy, txy_list, n)
    If status = RWEDGE_OK Then status = c_fatemi_socie(n, sxx_list(0), syy_list(0), txy_list(0), E, nu, k_over_sy, value, angle)
    If status = RWEDGE_OK Then
        RWEDGE_FATEMI_SOCIE = Array(value, angle)
    Else
        RWEDGE_FATEMI_SOCIE = failure(status)
    End If
End Function

' ---- The paper's series ------------------------------------------------------------------------

' a_k; 0 for k >= terms; NaN outside the domain or NULL.
'   k  index of the coefficient, >= 0
' In a cell: the series is made of x_samples, p_samples, terms.
Public Function RWEDGE_SERIES_COEFFICIENT( _
        ByVal x_samples As Variant, ByVal p_samples As Variant, ByVal terms As Long, ByVal k As Long) As Variant
Attribute RWEDGE_SERIES_COEFFICIENT.VB_Description = "a_k; 0 for k >= terms; NaN outside the domain or NULL."
    Dim series As LongPtr, status As Long
    status = series_through(x_samples, p_samples, terms, series)
    If status = RWEDGE_OK Then
        RWEDGE_SERIES_COEFFICIENT = finite(c_series_coefficient(series, k))
    Else
        RWEDGE_SERIES_COEFFICIENT = failure(status)
    End If
    If series <> 0 Then c_series_destroy series
End Function

' Error of the series as a pressure. From rwedge_series_fit(): the root mean square of fit minus
' sample. From rwedge_series_create(): an upper bound of what is cut off, sum |a_k| for k >=
' terms, valid for the pressure and for |G| anywhere (HUGE_VAL for the sharp wedge, whose
' coefficients have no finite sum). NaN for NULL.
' In a cell: the series is made of x_samples, p_samples, terms.
Public Function RWEDGE_SERIES_RESIDUAL(ByVal x_samples As Variant, ByVal p_samples As Variant, ByVal terms As Long) As Variant
Attribute RWEDGE_SERIES_RESIDUAL.VB_Description = "Error of the series as a pressure. From rwedge_series_fit(): the root mean square of fit minus sample."
    Dim series As LongPtr, status As Long
    status = series_through(x_samples, p_samples, terms, series)
    If status = RWEDGE_OK Then
        RWEDGE_SERIES_RESIDUAL = finite(c_series_residual(series))
    Else
        RWEDGE_SERIES_RESIDUAL = failure(status)
    End If
    If series <> 0 Then c_series_destroy series
End Function

' The pressure at x; 0 for |x| >= 1; NaN outside the domain or NULL.                    Eq. (29)
' In a cell: the series is made of x_samples, p_samples, terms.
Public Function RWEDGE_SERIES_PRESSURE( _
        ByVal x_samples As Variant, ByVal p_samples As Variant, ByVal terms As Long, ByVal x As Double) As Variant
Attribute RWEDGE_SERIES_PRESSURE.VB_Description = "The pressure at x; 0 for |x| >= 1; NaN outside the domain or NULL."
    Dim series As LongPtr, status As Long
    status = series_through(x_samples, p_samples, terms, series)
    If status = RWEDGE_OK Then
        RWEDGE_SERIES_PRESSURE = finite(c_series_pressure(series, x))
    Else
        RWEDGE_SERIES_PRESSURE = failure(status)
    End If
    If series <> 0 Then c_series_destroy series
End Function

' Muskhelishvili's potential Phi for q = f p: Phi = -((i+f)/2) sum a_k R^(k+1), R = z -
' sqrt(z^2-1).                                                           Eq. (30), (34), E2, E3
' RWEDGE_EDOMAIN, RWEDGE_ENULL.
' In a cell: the series is made of x_samples, p_samples, terms.
' In a cell: the row re, im.
Public Function RWEDGE_SERIES_POTENTIAL( _
        ByVal x_samples As Variant, ByVal p_samples As Variant, ByVal terms As Long, ByVal f As Double, _
        ByVal x As Double, ByVal y As Double) As Variant
Attribute RWEDGE_SERIES_POTENTIAL.VB_Description = "Muskhelishvili's potential Phi for q = f p: Phi = -((i+f)/2) sum a_k R^(k+1), R = z - sqrt(z^2-1)."
    Dim re As Double, im As Double, series As LongPtr, status As Long
    status = series_through(x_samples, p_samples, terms, series)
    If status = RWEDGE_OK Then status = c_series_potential(series, f, x, y, re, im)
    If status = RWEDGE_OK Then
        RWEDGE_SERIES_POTENTIAL = Array(re, im)
    Else
        RWEDGE_SERIES_POTENTIAL = failure(status)
    End If
    If series <> 0 Then c_series_destroy series
End Function

' Stresses for q = f p.                                                              Eq. (32), (33)
' RWEDGE_EDOMAIN, RWEDGE_ENULL. The derivative converges like the series of R^k at the edges:
' slowly.
' In a cell: the series is made of x_samples, p_samples, terms.
' In a cell: the row sxx, syy, txy.
Public Function RWEDGE_SERIES_STRESS( _
        ByVal x_samples As Variant, ByVal p_samples As Variant, ByVal terms As Long, ByVal f As Double, _
        ByVal x As Double, ByVal y As Double) As Variant
Attribute RWEDGE_SERIES_STRESS.VB_Description = "Stresses for q = f p."
    Dim sxx As Double, syy As Double, txy As Double, series As LongPtr, status As Long
    status = series_through(x_samples, p_samples, terms, series)
    If status = RWEDGE_OK Then status = c_series_stress(series, f, x, y, sxx, syy, txy)
    If status = RWEDGE_OK Then
        RWEDGE_SERIES_STRESS = Array(sxx, syy, txy)
    Else
        RWEDGE_SERIES_STRESS = failure(status)
    End If
    If series <> 0 Then c_series_destroy series
End Function

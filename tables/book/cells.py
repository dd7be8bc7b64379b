# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells of a case, each once: what is typed in, what comes out, and the working cells.

Names that begin with rw_ are for the user; those of the working cells begin with rwt_. Where a case has no sound inputs, the
working cells go on with harmless numbers, and the results are empty: so no cell ever has an error."""
import re
from dataclasses import dataclass

from formulas import (
    at_every_f, at_row, at_rows, cosine, every_f, every_row, every_there, f2_at, first_guess, gap, give_one, if_row, if_rows,
    is_there, lagrange, limit_at, listed, m_at, newton, not_above_0, not_poisson, of_material, ok, one_missing, product, weigh, when,
    wrong_input)


@dataclass
class Cell:
    name: str
    label: str
    formula: str = ""
    column: str = ""  # in Batch, as in "rwedge solve"
    unit: str = ""
    hint: str = ""
    wrong: str = ""  # of an input: the condition that it is not what it must be
    must: str = ""
    needed: str = ""  # of an input that must be given: the cell that has it, or what stands for it


def typed(column, label, unit, hint, wrong, must, needed=""):
    return Cell("rw_" + column, label, "", column, unit, hint, wrong, must, needed)


ABOVE_0, POISSON, NOT_BELOW_0 = "a number above 0", "a number from 0 to 0.5", "a number, 0 or above"
# A text is above every number, and so is wrong.
INPUTS = [
    typed("E1", "Young's modulus, half-plane", "MPa", "half-plane: the body that may yield", not_above_0("rw_E1"), ABOVE_0, "rwt_E1"),
    typed("nu1", "Poisson's ratio, half-plane", "-", "tables: 0 to 0.5", not_poisson("rw_nu1"), POISSON, "rwt_nu1"),
    typed("E2", "Young's modulus, wedge", "MPa", "wedge; leave both empty for one material",
          f'AND(rw_E2<>"inf",{not_above_0("rw_E2")})', "a number above 0, or inf for a rigid wedge"),
    typed("nu2", "Poisson's ratio, wedge", "-", "a rigid wedge: inf for E2", not_poisson("rw_nu2"), POISSON),
    typed("theta", "Angle of the flank, radians", "rad", "this, or the angle in degrees", "OR(rw_theta<1E-60,rw_theta>=PI()/2)",
          "a number above 0, below pi/2"),
    typed("theta_deg", "or in degrees", "deg", "small: up to about 6 degrees", "OR(rw_theta_deg<1E-60,rw_theta_deg>=90)",
          "a number above 0, below 90"),
    typed("a", "Half-width of the rounding, a", "mm", "0: sharp; this, or the radius", "OR(rw_a<0,rw_a>1E+60)", NOT_BELOW_0),
    typed("radius", "or its radius, R", "mm", "R = a/theta", "OR(rw_radius<0,rw_radius>1E+60)", NOT_BELOW_0),
    typed("P", "Normal load P", "N/mm", "per unit length", not_above_0("rw_P"), ABOVE_0, "rw_P"),
    typed("Q", "Tangential load Q", "N/mm", "empty: 0; |Q| up to f P", "OR(rw_Q<-1E+60,rw_Q>1E+60)", "a number"),
    typed("f", "Coefficient of friction f", "-", "tables: up to 0.8", "OR(rw_f<0,rw_f>1E+6)", NOT_BELOW_0, "rw_f"),
    typed("k", "Yield stress in shear, half-plane, k", "MPa", "shear; this, or the tensile one", not_above_0("rw_k"), ABOVE_0),
    typed("yield_stress", "or in tension, Y", "MPa", "Y = k sqrt(3), von Mises", not_above_0("rw_yield_stress"), ABOVE_0),
]

# In place of constants of the half-plane; of the calculator alone.
MATERIAL = typed("material", "Material of the half-plane, by name", "", "of the sheet Materials; or type below", "",
                 "a name of the sheet Materials")

# Of the calculator alone: of the stress at many places.
YIELD_FACTOR = Cell(
    "rw_yield_factor", "Safety on strength under this Q",
    'IF(AND(rwt_has_k=1,rwt_slides=0,rwt_a>0,rwt_ok_tip=1),rwt_k*rwt_comp/rwt_theta/SQRT(rwt_fl_J2),"")', "yield_factor", "-",
    "the factor on the stress; within 2 %")

# What the calculator shows first: two steel bodies, a/b = 0.29, and yield at half as much load again.
EXAMPLE = dict(E1=210000, nu1=0.3, E2=210000, nu2=0.3, theta=0.01, a=0.05, P=190, Q=20, f=0.2, k=400)
BATCH_EXAMPLES = [
    ("steel on steel", dict(E1=210000, nu1=0.3, theta_deg=2, radius=10, P=300, Q=40, f=0.3, yield_stress=900)),
    ("a sharper one", dict(E1=210000, nu1=0.3, theta_deg=2, radius=2, P=70, Q=15, f=0.3, yield_stress=900)),
    ("steel on aluminium", dict(E1=72000, nu1=0.33, E2=210000, nu2=0.3, theta=0.02, a=0.3, P=10, f=0, k=300)),
]

SOUND_FRICTION = "AND(rwt_ok=1,rwt_fr>0,rwt_slides=0)"
AT_APEX = "rwt_theta/rwt_comp*2/PI()*"
# The place of first yield, in a or b; x also in f.
PLACE_X, PLACE_Y = at_rows("rwt_wp", "rwt_place", "rwt_pr"), at_rows("rwt_wp", "rwt_place", "rwt_pr+26")
# The first five remarks have the thresholds and the words of rwedge_validity(): a test compares.
REMARKS = [
    ("rwt_theta>0.1", "theta is above 0.1 rad: the wedge is hardly a half-plane"),
    ("AND(ABS(rw_beta)>1E-12,rwt_fr>0)", "Dundurs' beta is not 0: with friction its coupling is neglected"),
    ("AND(ISNUMBER(rw_safety),N(rw_safety)<1)", "P is above P_yield: the contact yields in full sliding"),
    ("AND(rwt_a>0,OR(rwt_ratio<0.01,rwt_ratio>10000))", "a/b is below 0.01 or above 10000: are the units consistent?"),
    ("IF(rwt_has_k=1,OR(rwt_k/rwt_E1<0.00001,rwt_k/rwt_E1>0.1))",
     "k/E is below 0.00001 or above 0.1: are the stresses in one unit?"),
    ("rw_f>0.8", "f is above 0.8, outside the tables: no yield"),
    ("rwt_ok_tip=0", "a/b is below 0.003, outside the tables: no elastic limit"),
    ('AND(rwt_ok_f=1,rwt_has_k=1,rwt_slides=0,rw_P_yield="",rwt_bound<1)', "yield is outside the tables: no safety"),
]

# In the order of "rwedge solve".
RESULTS = [
    Cell("rw_compliance", "Composite compliance A", ok("rwt_comp"), "A", "1/MPa", "2(1-nu1^2)/E1 + 2(1-nu2^2)/E2"),
    Cell("rw_beta", "Dundurs' beta",
         ok("0.5*(rwt_E1/(1+rwt_nu1)*(1-2*rwt_nu2)-rwt_em2/(1+rwt_nu2)*(1-2*rwt_nu1))"
            "/(rwt_E1/(1+rwt_nu1)*(1-rwt_nu2)+rwt_em2/(1+rwt_nu2)*(1-rwt_nu1))"),
         "dundurs_beta", "-", "0 for elastically similar bodies"),
    Cell("rw_b", "Half-width of the contact b", ok("rwt_b"), "b", "mm", "the contact is |x| < b"),
    Cell("rw_a_over_b", "Rounding over contact a/b", ok("rwt_ratio"), "a_over_b", "-", "1 and more: Hertz' contact; 0: sharp"),
    Cell("rw_load_number", "Load AP/(theta b)", ok("rwt_comp*rwt_load/(rwt_theta*rwt_b)"), "AP_over_theta_b", "-",
         "2 for a sharp wedge"),
    Cell("rw_p0", "Peak pressure p0, at x = 0",
         "IF(AND(rwt_ok=1,rwt_a>0),rwt_theta/rwt_comp*IF(rwt_ratio<1,2/PI()*(ASIN(rwt_n5)/rwt_n5+LN((1+rwt_cos)/rwt_n5)),"
         '1/MAX(1,rwt_ratio)),"")', "p0", "MPa", "infinite, so empty, for a sharp wedge"),
    Cell("rw_p_transition", "Pressure at x = a and -a",
         f'IF(AND(rwt_ok=1,rwt_a>0),IF(rwt_ratio<1,{AT_APEX}(ASIN(rwt_n5)*rwt_cos/rwt_n5-LN(rwt_n5)),0),"")',
         "p_transition", "MPa", "where rounding meets flank; 0 beyond b"),
    Cell("rw_p_mean", "Mean pressure P/(2b)", ok("rwt_load/(2*rwt_b)"), "p_mean", "MPa"),
    Cell("rw_Q_over_fP", "Tangential load Q/(fP)", 'IF(AND(rwt_ok=1,rwt_fr>0),N(rw_Q)/MAX(1E-90,rwt_fr*rwt_load),"")', "Q_over_fP",
         "-", "1 and more: it slides"),
    Cell("rw_c", "Half-width of the stick zone c", f'IF({SOUND_FRICTION},rwt_cc,"")', "c", "mm",
         "sticks in |x| < c, slips in c < |x| < b"),
    Cell("rw_c_over_b", "Stick zone over contact c/b", f'IF({SOUND_FRICTION},rwt_cc/rwt_b,"")', "c_over_b", "-"),
    Cell("rw_tension", "Tension under this Q",
         'IF(AND(rwt_ok=1,rwt_slides=0),IF(rwt_q=0,0,2*rwt_fr*rwt_theta/rwt_comp*(1/MAX(1,rwt_ratio)-rwt_g)),"")', "max_tension",
         "MPa", "Q grown from 0 under constant P"),
    Cell("rw_max_tension", "Tension in full sliding", ok("2*rwt_fr*rwt_theta/rwt_comp/MAX(1,rwt_ratio)"), "max_tension_sliding",
         "MPa", "Q = f P"),
    Cell("rw_von_mises", "Largest von Mises stress, sliding", 'IF(N(rw_P_over_bk)>0,SQRT(3)*rwt_load/rwt_b/rw_P_over_bk,"")',
         "von_mises_sliding", "MPa", "under this P"),
    Cell("rw_f_critical", "Critical friction",
         "IF(AND(rwt_ok_tip=1,rwt_ok=1,rwt_a>0),IF(rwt_gaps=0,0,SQRT(INDEX(rwt_f,rwt_gn)^2"
         '+(INDEX(rwt_f,rwt_gn+1)^2-INDEX(rwt_f,rwt_gn)^2)*rwt_g1/(rwt_g1-rwt_g2))),"")',
         "f_critical", "-", "above it, yield starts at the surface"),
    Cell("rw_load_over_bk", "Load P/(bk)", 'IF(rwt_has_k=1,rwt_load/(rwt_b*rwt_k),"")', "load_over_bk", "-", "of the load given"),
    Cell("rw_P_over_bk", "Elastic limit P/(bk)", 'IF(AND(rwt_ok_f=1,rwt_ok_tip=1),rwt_limit,"")', "P_over_bk", "-",
         "at this a/b: it yields above"),
    Cell("rw_P_yield", "Load at first yield",
         'IF(AND(rwt_ok_f=1,rwt_has_k=1,OR(rwt_a=0,rwt_y<1E+98)),IF(rwt_a=0,0,rwt_y*rwt_theta*rwt_a/rwt_comp),"")', "P_yield",
         "N/mm", "with the contact that it makes"),
    Cell("rw_safety", "Safety on load P_yield/P",
         "IF(AND(rwt_ok_f=1,rwt_has_k=1,rwt_slides=0),IF(ISNUMBER(rw_P_yield),rw_P_yield/rwt_load,"
         'IF(rwt_bound<1,"","> "&rwt_bound)),"")',
         "safety", "-", "P may grow so far, the contact with it"),
    Cell("rw_safety_strength", "Safety on strength, of k or Y",
         'IF(AND(rwt_has_k=1,rwt_slides=0,ISNUMBER(rw_P_over_bk)),rw_P_over_bk*rwt_b*rwt_k/rwt_load,"")', "safety_strength", "-",
         "k or Y may fall by this factor under this P"),
    Cell("rw_yield_x", "Place of first yield, x", f'IF(ISNUMBER(rw_P_yield),IF(N(rw_Q)<0,-1,1)*rwt_unit*rwt_ft*({PLACE_X}),"")',
         "yield_x", "mm", "from the middle; Q > 0: to the leading edge"),
    Cell("rw_yield_y", "its depth y", f'IF(ISNUMBER(rw_P_yield),IF(rw_branch="surface",0,rwt_unit*({PLACE_Y})),"")', "yield_y", "mm",
         "0: at the surface"),
    Cell("rw_branch", "Yields first", 'IF(ISNUMBER(rw_P_yield),IF(OR(rwt_a=0,rwt_s_y<=rwt_b_y),"surface","subsurface"),"")',
         "yield_branch", "", "where, at that load"),
    Cell("rw_P_over_bk_shakedown", "Shakedown limit P/(bk)",
         f'IF(AND(rwt_ok_f=1,rwt_ok_nu=1,rwt_ratio>=0.1*(1-1E-9)),{limit_at("rwt_shakedown", "rwt_lwa", "rwt_ln")},"")',
         "P_over_bk_shakedown", "-", "carried in sliding, pass after pass"),
    Cell("rw_safety_shakedown", "Safety on strength, pass after pass",
         'IF(AND(rwt_has_k=1,rwt_slides=0,ISNUMBER(rw_P_over_bk_shakedown)),rw_P_over_bk_shakedown*rwt_b*rwt_k/rwt_load,"")',
         "safety_strength_shakedown", "-", "perfect plasticity; below 1 it goes on yielding"),
    Cell("rw_remarks", "Remarks", f'IF(rwt_ok=0,"",{listed(*(when(*remark) for remark in REMARKS))})', "warnings"),
    Cell("rw_error", "What is wrong",
         'IF(rwt_bad<>"",rwt_bad,IF(rwt_slides=1,"Q is above f P: it slides, there is no equilibrium",""))', "error"),
]
SHOWN = INPUTS + RESULTS


def half_width(tip, x):
    """b, or c, by its a/b: that of Hertz' contact where the rounding alone touches."""
    return f"IF({x}>=2/PI(),SQRT(PI()/2*{x}),{tip})"


def contact(tip, x, names):
    """Five Newton steps to a/b, or to a/c."""
    steps = [Cell(f"rwt_{tip}0", "a/b, first guess", first_guess(x))]
    for i in range(1, 6):
        label = "a/b, 1 for Hertz" if i == 5 else "a Newton step"
        steps.append(Cell(f"rwt_{tip}{i}", label, newton(f"rwt_{tip}{i - 1}", x)))
    return steps + [Cell(names, "cos(phi0)", cosine(f"rwt_{tip}5"))]


def three(name, label, *formulas):
    """Three cells side by side, which have a name together."""
    labels = label if isinstance(label, tuple) else (label, "", "")
    return [Cell(f"{name}{i + 1}", labels[i], formulas[i]) for i in range(3)]


def parabola(place):
    """Its weights at three nodes, by the place from the first."""
    return f"({place}-1)*({place}-2)/2", f"{place}*(2-{place})", f"{place}*({place}-1)/2"


def branch(name, reached, values):
    """The load at which a branch yields: the tip between nodes of the table where J2 is k^2, by the parabola through three; and
    the load that makes this tip, 1E+99 where the branch does not yield in the table."""
    count, node, t = f"rwt_{name}_reached", f"rwt_{name}_node", f"rwt_{name}_t"
    k, g, d = f"rwt_{name}_k", f"rwt_{name}_g", f"rwt_{name}_d"
    bend = f"({k}3-2*{k}2+{k}1)"
    return [
        Cell(count, "tips that yield before", reached), Cell(node, "first of three nodes", f"MIN(MAX({count},1),49)"),
        *three(k, ("J2 at the nodes", "the second", "the third"), *values),
        Cell(g, "above k^2", f"INDEX({k},MIN(3,MAX({count},1)-{node}+1))-rwt_k2"),
        Cell(d, "slope", f"{k}2-{k}1+{bend}*(MAX({count},1)-{node}-0.5)"),
        Cell(t, "t at yield",
             f"INDEX(rwt_ts,1)*(1-IF(OR({count}=0,{count}=51,MIN({k})<=0),0,"
             f"{count}-1+2*{g}/(SQRT(MAX(0,{d}^2-2*{bend}*{g}))-{d}))/50)"),
        Cell(f"rwt_{name}_y", "AP/(theta a) at yield",
             f"IF(OR({count}=0,MIN({k})<=0),1E+99,IF({count}=51,PI()/2*rwt_k2/{k}3,"
             f"(ASIN(1/COSH({t}))-TANH({t})/COSH({t}))*COSH({t})^2))"),
    ]


def rows_of(table, node):
    return [at_row(table, node + step) for step in ("", "+1", "+2")]


def unknown_material():
    return when('AND(rw_material<>"",NOT(ISNUMBER(MATCH(rw_material,rw_material_names,0))))', "material: none of that name on the sheet Materials")


def of_both(constant, column):
    """What the material has must not be typed."""
    return when(f'AND(rwt_m{constant}<>"",rw_{column}<>"")', f"material and {column}: give one of the two")


ALL_BELOW = f"({product(lambda nu: every_there('rwt_below', nu))}>0)"
WORKING = [
    Cell("rwt_mE", "E of the material", of_material("rw_material_E")),
    Cell("rwt_mnu", "its nu", of_material("rw_material_nu")),
    Cell("rwt_mY", "its yield stress", of_material("rw_material_yield_stress")),
    Cell("rwt_E1", "E1", 'IF(rw_E1="",rwt_mE,rw_E1)'),
    Cell("rwt_nu1", "nu1", 'IF(rw_nu1="",rwt_mnu,rw_nu1)'),
    Cell("rwt_any", "cells that are typed into", f"COUNTA({','.join(cell.name for cell in INPUTS)})"),
    Cell("rwt_bad", "what is wrong with the inputs", 'IF(rwt_any=0,"",' + listed(
        *map(wrong_input, INPUTS), 'IF(OR((rw_E2="")=(rw_nu2=""),rw_E2="inf"),"","; E2 and nu2: give both, or neither")',
        one_missing("theta", "theta_deg"), give_one("theta", "theta_deg"), one_missing("a", "radius"), give_one("a", "radius"),
        give_one("k", "yield_stress"), unknown_material(), of_both("E", "E1"), of_both("nu", "nu1"), of_both("Y", "k"),
        of_both("Y", "yield_stress")) + ")"),
    Cell("rwt_ok", "1: the inputs are sound", 'IF(AND(rwt_any>0,rwt_bad=""),1,0)'),
    Cell("rwt_theta", "theta", 'IF(rwt_ok=1,IF(rw_theta="",N(rw_theta_deg)*PI()/180,rw_theta),0.1)'),
    Cell("rwt_a", "a", 'IF(rwt_ok=1,IF(rw_a="",N(rw_radius)*rwt_theta,rw_a),1)'),
    Cell("rwt_em2", "E2", 'IF(rwt_ok=1,IF(rw_E2="",rwt_E1,IF(ISNUMBER(rw_E2),rw_E2,1E+99)),1)'),
    Cell("rwt_nu2", "nu2", 'IF(rwt_ok=1,IF(rw_E2="",rwt_nu1,N(rw_nu2)),0)'),
    Cell("rwt_comp", "A", "IF(rwt_ok=1,2*(1-rwt_nu1^2)/rwt_E1+2*(1-rwt_nu2^2)/rwt_em2,1)"),
    Cell("rwt_load", "P", "IF(rwt_ok=1,rw_P,1)"),
    Cell("rwt_fr", "f", "IF(rwt_ok=1,rw_f,0)"),
    Cell("rwt_q", "|Q|", "IF(rwt_ok=1,ABS(N(rw_Q)),0)"),
    Cell("rwt_slides", "1: no equilibrium", "IF(rwt_q>rwt_fr*rwt_load*(1+1E-12),1,0)"),
    Cell("rwt_has_k", "1: a strength is given", "IF(rwt_ok=1,COUNT(rw_k,rw_yield_stress,rwt_mY),0)"),
    Cell("rwt_k", "k", 'IF(rwt_has_k=1,IF(rw_k="",IF(rw_yield_stress="",N(rwt_mY),rw_yield_stress)/SQRT(3),rw_k),1)'),

    Cell("rwt_x", "theta a/(A P)", "MAX(1E-60,rwt_theta*rwt_a/(rwt_comp*rwt_load))"),
    Cell("rwt_x1", "not beyond Hertz", "MIN(rwt_x,2/PI())"),
    *contact("n", "rwt_x1", "rwt_cos"),
    Cell("rwt_ratio", "a/b", f"IF(rwt_a=0,0,{half_width('rwt_n5', 'rwt_x')})"),
    Cell("rwt_b", "b", "IF(rwt_a=0,rwt_comp*rwt_load/(2*rwt_theta),rwt_a/MAX(1E-60,rwt_ratio))"),
    Cell("rwt_lc", "load of the stick zone",
         "IF(rwt_q=0,rwt_load,IF(rwt_slides=1,0,MAX(0,rwt_load-rwt_q/MAX(1E-60,rwt_fr))))"),
    Cell("rwt_xc", "theta a/(A P)", "IF(rwt_lc>0,MAX(1E-60,rwt_theta*rwt_a/(rwt_comp*MAX(1E-90,rwt_lc))),1)"),
    Cell("rwt_xc1", "not beyond Hertz", "MIN(rwt_xc,2/PI())"),
    *contact("c", "rwt_xc1", "rwt_cosc"),
    Cell("rwt_cc", "c", "IF(rwt_lc=0,0,IF(rwt_q=0,rwt_b,IF(rwt_a=0,rwt_comp*rwt_lc/(2*rwt_theta),"
         f"rwt_a/{half_width('rwt_c5', 'rwt_xc')})))"),
    Cell("rwt_root", "sqrt((b/c)^2-1)",
         "IF(rwt_cc>0,SQRT(MAX(0,(rwt_b/MAX(1E-90,rwt_cc)-1)*(rwt_b/MAX(1E-90,rwt_cc)+1))),0)"),
    # Re G of the stick zone's own contact at the edge x = b; 0 where there is none
    Cell("rwt_g", "G of the stick zone at b",
         "IF(rwt_q*rwt_cc=0,0,IF(rwt_cc<=rwt_a,rwt_cc/rwt_a/(rwt_b/rwt_cc+rwt_root),2/PI()*(ATAN2(rwt_root,rwt_cosc)"
         "+rwt_b/rwt_cc/rwt_c5*ATAN(rwt_c5/rwt_cosc*rwt_root*rwt_cc/rwt_b)-ASIN(rwt_c5)*rwt_root/rwt_c5)))"),

    # the patch of the table
    Cell("rwt_nut", "nu1 in the table", "IF(rwt_ok=1,rwt_nu1,0.3)"),
    Cell("rwt_ft", "f in the table", "MIN(rwt_fr,0.8)"),
    Cell("rwt_kn", "first node of nu", "MIN(MATCH(rwt_nut,rwt_nu,1),14)"),
    Cell("rwt_fn", "first node of f", "MIN(MAX(MATCH(rwt_ft,rwt_f,1)-1,1),19)"),
    Cell("rwt_m", "(1-2 nu)^2/3", "(1-2*rwt_nut)^2/3"),
    *three("rwt_wn", "weights of nu", *(lagrange("rwt_m", *(m_at((i + step) % 3) for step in range(3))) for i in range(3))),
    *three("rwt_wf", "weights of f", *(lagrange("rwt_ft^2", *(f2_at((i + step) % 3) for step in range(3))) for i in range(3))),
    Cell("rwt_col", "first column of the patch", "(rwt_kn-1)*21+rwt_fn"),

    # the limit at this a/b
    Cell("rwt_t", "ln tan(phi0/2), in the table", "MAX(LN(rwt_n5/(1+rwt_cos)),INDEX(rwt_ts,1))"),
    Cell("rwt_node", "first node of a/b", "MIN(MATCH(rwt_t,rwt_ts,1),49)"),
    Cell("rwt_u", "place among the nodes", "(1-rwt_t/INDEX(rwt_ts,1))*50-(rwt_node-1)"),
    *three("rwt_wt", "weights of a/b", *parabola("rwt_u")),
    Cell("rwt_js", "J2, surface", at_rows("rwt_wt", "rwt_surface", "rwt_node")),
    Cell("rwt_jb", "J2, below; 0: none", if_rows(at_rows("rwt_wt", "rwt_below", "rwt_node"))),
    Cell("rwt_limit", "P/(bk)", "IF(rwt_a=0,0,(ASIN(rwt_n5)/rwt_n5+rwt_cos)/SQRT(MAX(rwt_js,rwt_jb)))"),
    Cell("rwt_ok_f", "1: f is in the table", "IF(rwt_ok=1,IF(rw_f<=0.8,1,0),0)"),
    Cell("rwt_ok_tip", "1: a/b is in the table", "IF(OR(rwt_a=0,rwt_ratio>=0.003*(1-1E-9)),1,0)"),

    # the load at yield, on the surface and below it
    Cell("rwt_k2", "(k A/theta)^2", "(rwt_k*rwt_comp/rwt_theta)^2"),
    *branch("s", f"51-SUMPRODUCT(--({weigh(lambda nu: every_row('rwt_surface', nu))}<rwt_k2))",
            rows_of("rwt_surface", "rwt_s_node")),
    # below the surface there may be none at some tips: these count neither as yielding nor as not
    *branch("b", f"SUMPRODUCT(MAX(({weigh(lambda nu: every_row('rwt_below', nu))}>=rwt_k2)*{ALL_BELOW}*rwt_count))",
            [if_row("rwt_b_node" + step, value)
             for step, value in zip(("", "+1", "+2"), rows_of("rwt_below", "rwt_b_node"))]),
    Cell("rwt_y", "AP/(theta a) at yield", "MIN(rwt_s_y,rwt_b_y)"),
    Cell("rwt_bound", "load at the table's end over P", "ROUNDDOWN(rwt_end*rwt_x,IF(rwt_end*rwt_x>=10,0,1))"),

    # the place of first yield
    Cell("rwt_ty", "t at yield", "IF(rwt_y<=PI()/2,0,IF(rwt_s_y<=rwt_b_y,rwt_s_t,rwt_b_t))"),
    Cell("rwt_pu", "place among the tips", "(1-rwt_ty/INDEX(rwt_ts,1))*25"),
    Cell("rwt_pn", "tips before the first of three", "MIN(ROUNDDOWN(rwt_pu,0),23)"),
    *three("rwt_wp", "weights of a/b at yield", "(rwt_pu-rwt_pn-1)*(rwt_pu-rwt_pn-2)/2", "(rwt_pu-rwt_pn)*(2-rwt_pu+rwt_pn)",
           "(rwt_pu-rwt_pn)*(rwt_pu-rwt_pn-1)/2"),
    Cell("rwt_pr", "first row of the place", "rwt_pn+1+IF(rwt_s_y<=rwt_b_y,0,26)"),
    Cell("rwt_unit", "a, or b for Hertz, at yield", "rwt_a*SQRT(MIN(1,2/PI()*rwt_y))"),

    # a table of limits, and that of shakedown
    Cell("rwt_ok_nu", "1: nu1 is 0.25 to 0.35", "IF(AND(rwt_nut>0.25-1E-9,rwt_nut<0.35+1E-9),1,0)"),
    Cell("rwt_lf", "first node of f", "MIN(ROUNDDOWN(rwt_ft*80+1E-9,0)+1,63)"),
    *three("rwt_lwf", "weights of f", *(lagrange("rwt_ft^2", *(f"((rwt_lf-1+{(i + step) % 3})/80)^2" for step in range(3)))
                                       for i in range(3))),
    *three("rwt_lwm", "weights of nu", *(lagrange("rwt_m", *(f"(1-2*{(0.25, 0.3, 0.35)[(i + step) % 3]})^2/3" for step in range(3)))
                                        for i in range(3))),
    Cell("rwt_la", "a/b in the table", "MIN(1,MAX(0.1,rwt_ratio))"),
    Cell("rwt_ln", "first node of a/b", "MIN(MATCH(rwt_la+1E-9,rwt_shakedown_tips,1),8)"),
    *three("rwt_lwa", "weights of a/b", *(lagrange("LN(rwt_la)", *(f"LN(INDEX(rwt_shakedown_tips,rwt_ln+{(i + step) % 3}))"
                                                                   for step in range(3))) for i in range(3))),

    # critical friction
    Cell("rwt_gaps", "f that yield below",
         f"SUMPRODUCT(({at_every_f('rwt_surface')}<{at_every_f('rwt_below')})"
         f"*(MMULT(rwt_ones,{product(lambda nu: '(' + every_f('rwt_below', nu) + '>0)')})=3))"),
    Cell("rwt_gn", "node before the cusp",
         f"IF(rwt_gaps>1,IF({is_there('rwt_gaps+1')}<3,rwt_gaps-1,rwt_gaps),MAX(1,rwt_gaps))"),
    Cell("rwt_g1", "surface less below there", gap("rwt_gn")),
    Cell("rwt_g2", "and at the next", gap("rwt_gn+1")),
]
# Three cells side by side that formulas take together.
GROUPS = ("rwt_wn", "rwt_wf", "rwt_wt", "rwt_s_k", "rwt_b_k", "rwt_wp", "rwt_lwf", "rwt_lwa")
CASE = SHOWN + WORKING


def cell_of(column):
    return next(cell for cell in SHOWN if cell.column == column)


WORD = re.compile(r'"[^"]*"|\w+')


def in_row(formula, places):
    """With the places of cells in place of their names; texts in quotes stay."""
    return WORD.sub(lambda word: places.get(word[0], word[0]), formula)

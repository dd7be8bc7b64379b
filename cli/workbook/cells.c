/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names that begin with rw_ are for the user; those of the working cells begin with rwt_. Where a
 * case has no sound inputs, the working cells go on with harmless numbers, and the results are
 * empty: so no cell ever has an error. */
#include "workbook.h"

/* The table has 51 tips, 16 nu, 21 f, so the next nu is 21 columns on; places have 26 tips. */
typedef char
    table_is_as_wide[TIPS == 51 && FRICTIONS == 21 && NUS == 16 && PLACE_TIPS == 26 ? 1 : -1];

/* ---- Inputs ---------------------------------------------------------------------------------- */

#define ABOVE_0 "a number above 0"
#define NOT_BELOW_0 "a number, 0 or above"
#define POISSON "a number from 0 to 0.5"

/* A text is above every number, and so is wrong. */
const input_rule input_rules[INPUT_CELLS] = {
    [CELL_E1] = {"not_above_0(rw_E1)", ABOVE_0, "half-plane: the body that may yield", true},
    [CELL_NU1] = {"not_poisson(rw_nu1)", POISSON, "tables: 0 to 0.5", true},
    [CELL_E2] = {"AND(rw_E2<>\"inf\",not_above_0(rw_E2))", ABOVE_0 ", or inf for a rigid wedge",
                 "wedge; leave both empty for one material", false},
    [CELL_NU2] = {"not_poisson(rw_nu2)", POISSON, "a rigid wedge: inf for E2", false},
    [CELL_THETA] = {"OR(rw_theta<1E-60,rw_theta>=PI()/2)", "a number above 0, below pi/2",
                    "this, or the angle in degrees", false},
    [CELL_THETA_DEG] = {"OR(rw_theta_deg<1E-60,rw_theta_deg>=90)", "a number above 0, below 90",
                        "small: up to about 6 degrees", false},
    [CELL_ROUNDING] = {"OR(rw_a<0,rw_a>1E+60)", NOT_BELOW_0, "0: sharp; this, or the radius",
                       false},
    [CELL_RADIUS] = {"OR(rw_radius<0,rw_radius>1E+60)", NOT_BELOW_0, "R = a/theta", false},
    [CELL_LOAD] = {"not_above_0(rw_P)", ABOVE_0, "per unit length", true},
    [CELL_Q] = {"OR(rw_Q<-1E+60,rw_Q>1E+60)", "a number", "empty: 0; |Q| up to f P", false},
    [CELL_F] = {"OR(rw_f<0,rw_f>1E+6)", NOT_BELOW_0, "tables: up to 0.8", true},
    [CELL_K] = {"not_above_0(rw_k)", ABOVE_0, "shear; this, or the tensile one", false},
    [CELL_YIELD_STRESS] = {"not_above_0(rw_yield_stress)", ABOVE_0, "Y = k sqrt(3), von Mises",
                           false},
};

/* ---- Templates ------------------------------------------------------------------------------- */

const formula_template formula_templates[] = {
    /* conditions and texts; each of a list begins with "; ", which the first one loses */
    {"input_checks", NULL}, /* of the inputs' rules */
    {"ok", "IF(rwt_ok=1,$1,\"\")"},
    {"not_above_0", "OR($1<1E-60,$1>1E+60)"},
    {"not_poisson", "OR($1<0,$1>0.5)"},
    {"listed", "MID(\"\"$1,3,2000)"},
    {"when", "&IF($1,$2,\"\")"},
    {"give_one", "&IF(OR(rw_$1=\"\",rw_$2=\"\"),\"\",\"; $1 and $2: give one of the two\")"},
    {"one_of", "&IF(AND(rw_$1=\"\",rw_$2=\"\"),\"; $1 or $2 is missing\",\"\")give_one($1,$2)"},
    /* so many significant digits of a text; spreadsheets round to 20 places at most */
    {"short", "ROUND($1,MAX(-20,MIN(20,$2-1-INT(LOG10(MAX(1E-99,ABS($1)))))))"},

    /* a/b from x = theta a/(AP): Newton on a^2/(phi0 + a c0) = x, nearly a straight line; the
     * parabola that it starts from is exact at both ends */
    {"load_at", "(ASIN($1)+$1*SQRT((1-$1)*(1+$1)))"},
    {"guess", "$1*(2-(4/PI()-1)*PI()^2/4*$1)"},
    {"newton", "MIN(1,$1-($1^2*load_at($1)-$2*load_at($1)^2)/(2*ASIN($1)*$1))"},
    {"cosine", "SQRT((1-$1)*(1+$1))"},

    /* weights of a parabola; the three nodes of nu */
    {"lagrange", "($1-$3)*($1-$4)/(($2-$3)*($2-$4))"},
    {"m_at", "INDEX(rwt_ms,rwt_kn+$1)"},
    {"f2_at", "INDEX(rwt_f,rwt_fn+$1)^2"},
    {"weigh", "rwt_wn1*$1{}+rwt_wn2*$1{+21}+rwt_wn3*$1{+42}"},
    {"sum", "$1{}+$1{+21}+$1{+42}"},
    {"product", "$1{}*$1{+21}*$1{+42}"},

    /* cells of a table: three f of one row; of three rows; of all rows */
    {"row", "INDEX($1,$2,rwt_col$3):INDEX($1,$2,rwt_col+2$3)"},
    {"rows", "INDEX($1,$2,rwt_col$3):INDEX($1,$2+2,rwt_col+2$3)"},
    {"every_row", "(rwt_wf1*INDEX($1,0,rwt_col$2)+rwt_wf2*INDEX($1,0,rwt_col+1$2)+"
                  "rwt_wf3*INDEX($1,0,rwt_col+2$2))"},
    {"every_there", "INDEX($1,0,rwt_col$2)*INDEX($1,0,rwt_col+1$2)*INDEX($1,0,rwt_col+2$2)"},
    {"at_row", "weigh(SUMPRODUCT(row($1,$2,#)*rwt_wf))"},
    /* three tips, weighted by $1; MMULT takes no empty cells, but those plus 0 */
    {"at_rows", "weigh(SUMPRODUCT(MMULT($1,rows($2,$3,#)+0)*rwt_wf))"},
    {"if_row", "IF(sum(SUMPRODUCT(--(row(rwt_below,$1,#)>0)))=9,$2,0)"},
    {"if_rows", "IF(sum(SUMPRODUCT(--(rows(rwt_below,rwt_node,#)>0)))=27,$1,0)"},

    /* of a branch, whose cells begin with $1: the tip that yields at k, between nodes of the table,
     * by the parabola through three; and the load that makes this tip, 1E+99 where the branch does
     * not yield in the table */
    {"yield_node", "MIN(MAX($1_reached,1),49)"},
    {"yield_g", "INDEX($1_k,MIN(3,MAX($1_reached,1)-$1_node+1))-rwt_k2"},
    {"yield_d", "$1_k2-$1_k1+($1_k3-2*$1_k2+$1_k1)*(MAX($1_reached,1)-$1_node-0.5)"},
    {"yield_t", "INDEX(rwt_ts,1)*(1-IF(OR($1_reached=0,$1_reached=51,MIN($1_k)<=0),0,$1_reached-1+"
                "2*$1_g/(SQRT(MAX(0,$1_d^2-2*($1_k3-2*$1_k2+$1_k1)*$1_g))-$1_d))/50)"},
    {"yield_load", "IF(OR($1_reached=0,MIN($1_k)<=0),1E+99,IF($1_reached=51,PI()/2*rwt_k2/$1_k3,"
                   "(ASIN(1/COSH($1_t))-TANH($1_t)/COSH($1_t))*COSH($1_t)^2))"},

    /* all f, or the one at node $2, at this a/b and nu: J2, and whether the branch is whole */
    {"every_f", "INDEX($1,rwt_node,rwt_col-rwt_fn+1$2):INDEX($1,rwt_node+2,rwt_col-rwt_fn+21$2)"},
    {"at_every_f", "weigh(MMULT(rwt_wt,every_f($1,#)+0))"},
    {"column", "INDEX($1,rwt_node,rwt_col-rwt_fn+$2$3):INDEX($1,rwt_node+2,rwt_col-rwt_fn+$2$3)"},
    {"at_f", "SUMPRODUCT(MMULT(rwt_wt,column($1,$2,$3)+0))"},
    {"gap", "weigh((at_f(rwt_surface,$1,#)-at_f(rwt_below,$1,#)))"},
    {"is_there", "SUMPRODUCT(product((column(rwt_below,$1,#)>0)))"},
    {NULL, NULL},
};

/* ---- The cells ------------------------------------------------------------------------------- */

#define WORK(NAME, LABEL, FORMULA)                                                                 \
    {                                                                                              \
        NAME, LABEL, FORMULA, NULL, NULL, XLSX_PLAIN                                               \
    }

const case_cell case_cells[] = {
    {"rw_E1", "Young's modulus, half-plane", NULL, "E1", "MPa", XLSX_INPUT},
    {"rw_nu1", "Poisson's ratio, half-plane", NULL, "nu1", "-", XLSX_INPUT},
    {"rw_E2", "Young's modulus, wedge", NULL, "E2", "MPa", XLSX_INPUT},
    {"rw_nu2", "Poisson's ratio, wedge", NULL, "nu2", "-", XLSX_INPUT},
    {"rw_theta", "Angle of the flank, radians", NULL, "theta", "rad", XLSX_INPUT},
    {"rw_theta_deg", "or in degrees", NULL, "theta_deg", "deg", XLSX_INPUT},
    {"rw_a", "Half-width of the rounding, a", NULL, "a", "mm", XLSX_INPUT},
    {"rw_radius", "or its radius, R", NULL, "radius", "mm", XLSX_INPUT},
    {"rw_P", "Normal load P", NULL, "P", "N/mm", XLSX_INPUT},
    {"rw_Q", "Tangential load Q", NULL, "Q", "N/mm", XLSX_INPUT},
    {"rw_f", "Coefficient of friction f", NULL, "f", "-", XLSX_INPUT},
    {"rw_k", "Yield stress in shear, half-plane, k", NULL, "k", "MPa", XLSX_INPUT},
    {"rw_yield_stress", "or in tension, Y", NULL, "yield_stress", "MPa", XLSX_INPUT},

    {"rw_compliance", "Composite compliance A", "ok(rwt_comp)", "A", "1/MPa", XLSX_RESULT},
    {"rw_beta", "Dundurs' beta",
     "ok(0.5*(rw_E1/(1+rw_nu1)*(1-2*rwt_nu2)-rwt_em2/(1+rwt_nu2)*(1-2*rw_nu1))/(rw_E1/"
     "(1+rw_nu1)*(1-rwt_nu2)+rwt_em2/(1+rwt_nu2)*(1-rw_nu1)))",
     "dundurs_beta", "-", XLSX_SIGNED},
    {"rw_b", "Half-width of the contact b", "ok(rwt_b)", "b", "mm", XLSX_RESULT},
    {"rw_a_over_b", "Rounding over contact a/b", "ok(rwt_ratio)", "a_over_b", "-", XLSX_RESULT},
    {"rw_load_number", "Load AP/(theta b)", "ok(rwt_comp*rwt_load/(rwt_theta*rwt_b))",
     "AP_over_theta_b", "-", XLSX_RESULT},
    {"rw_p0", "Peak pressure p0, at x = 0",
     "IF(AND(rwt_ok=1,rwt_a>0),rwt_theta/rwt_comp*IF(rwt_ratio<1,2/PI()*(ASIN(rwt_n5)/"
     "rwt_n5+LN((1+rwt_cos)/rwt_n5)),1/MAX(1,rwt_ratio)),\"\")",
     "p0", "MPa", XLSX_RESULT},
    {"rw_p_transition", "Pressure at x = a and -a",
     "IF(AND(rwt_ok=1,rwt_a>0),IF(rwt_ratio<1,rwt_theta/rwt_comp*2/PI()*(ASIN(rwt_n5)*"
     "rwt_cos/rwt_n5-LN(rwt_n5)),0),\"\")",
     "p_transition", "MPa", XLSX_RESULT},
    {"rw_p_mean", "Mean pressure P/(2b)", "ok(rwt_load/(2*rwt_b))", "p_mean", "MPa", XLSX_RESULT},
    {"rw_Q_over_fP", "Tangential load Q/(fP)",
     "IF(AND(rwt_ok=1,rwt_fr>0),N(rw_Q)/MAX(1E-90,rwt_fr*rwt_load),\"\")", "Q_over_fP", "-",
     XLSX_SIGNED},
    {"rw_c", "Half-width of the stick zone c",
     "IF(AND(rwt_ok=1,rwt_fr>0,rwt_slides=0),rwt_cc,\"\")", "c", "mm", XLSX_RESULT},
    {"rw_c_over_b", "Stick zone over contact c/b",
     "IF(AND(rwt_ok=1,rwt_fr>0,rwt_slides=0),rwt_cc/rwt_b,\"\")", "c_over_b", "-", XLSX_RESULT},
    {"rw_tension", "Tension under this Q",
     "IF(AND(rwt_ok=1,rwt_slides=0),IF(rwt_q=0,0,2*rwt_fr*rwt_theta/rwt_comp*(1/"
     "MAX(1,rwt_ratio)-rwt_g)),\"\")",
     "max_tension", "MPa", XLSX_RESULT},
    {"rw_max_tension", "Tension in full sliding",
     "ok(2*rwt_fr*rwt_theta/rwt_comp/MAX(1,rwt_ratio))", "max_tension_sliding", "MPa", XLSX_RESULT},
    {"rw_von_mises", "Largest von Mises stress, sliding",
     "IF(N(rw_P_over_bk)>0,SQRT(3)*rwt_load/rwt_b/rw_P_over_bk,\"\")", "von_mises_sliding", "MPa",
     XLSX_RESULT},
    {"rw_f_critical", "Critical friction",
     "IF(AND(rwt_ok_tip=1,rwt_ok=1,rwt_a>0),IF(rwt_gaps=0,0,SQRT(INDEX("
     "rwt_f,rwt_gn)^2+(INDEX(rwt_f,rwt_gn+1)^2-INDEX(rwt_f,rwt_gn)^2)*rwt_g1/"
     "(rwt_g1-rwt_g2))),\"\")",
     "f_critical", "-", XLSX_RESULT},
    {"rw_load_over_bk", "Load P/(bk)", "IF(rwt_has_k=1,rwt_load/(rwt_b*rwt_k),\"\")",
     "load_over_bk", "-", XLSX_RESULT},
    {"rw_P_over_bk", "Elastic limit P/(bk)", "IF(AND(rwt_ok_f=1,rwt_ok_tip=1),rwt_limit,\"\")",
     "P_over_bk", "-", XLSX_RESULT},
    {"rw_P_yield", "Load at first yield",
     "IF(AND(rwt_ok_f=1,rwt_has_k=1,OR(rwt_a=0,rwt_y<1E+98)),IF(rwt_a=0,0,rwt_y*rwt_theta*"
     "rwt_a/rwt_comp),\"\")",
     "P_yield", "N/mm", XLSX_RESULT},
    {"rw_safety", "Safety on load P_yield/P",
     "IF(AND(rwt_ok_f=1,rwt_has_k=1,rwt_slides=0),IF(ISNUMBER(rw_P_yield),rw_P_yield/"
     "rwt_load,IF(rwt_bound<1,\"\",\"> \"&rwt_bound)),\"\")",
     "safety", "-", XLSX_RESULT},
    {"rw_safety_strength", "Safety on strength, of k or Y",
     "IF(AND(rwt_has_k=1,rwt_slides=0,ISNUMBER(rw_P_over_bk)),rw_P_over_bk*rwt_b*rwt_k/"
     "rwt_load,\"\")",
     "safety_strength", "-", XLSX_RESULT},
    {"rw_yield_x", "Place of first yield, x",
     "IF(ISNUMBER(rw_P_yield),IF(N(rw_Q)<0,-1,1)*rwt_unit*rwt_ft*(at_rows(rwt_wp,rwt_place,"
     "rwt_pr)),\"\")",
     "yield_x", "mm", XLSX_SIGNED},
    {"rw_yield_y", "its depth y",
     "IF(ISNUMBER(rw_P_yield),IF(rw_branch=\"surface\",0,rwt_unit*(at_rows(rwt_wp,rwt_place,"
     "rwt_pr+26))),\"\")",
     "yield_y", "mm", XLSX_RESULT},
    {"rw_branch", "Yields first",
     "IF(ISNUMBER(rw_P_yield),IF(OR(rwt_a=0,rwt_s_y<=rwt_b_y),\"surface\",\"subsurface\"),\"\")",
     "yield_branch", "", XLSX_RESULT},
    /* the first five have the thresholds and the words of rwedge_validity(): a test compares */
    {"rw_remarks", "Remarks",
     "IF(rwt_ok=0,\"\",listed("
     "when(rwt_theta>0.1,\"; theta is above 0.1 rad: the wedge is hardly a half-plane\")"
     "when(AND(ABS(rw_beta)>1E-12,rwt_fr>0),"
     "\"; Dundurs' beta is not 0: with friction its coupling is neglected\")"
     "when(AND(ISNUMBER(rw_safety),N(rw_safety)<1),"
     "\"; P is above P_yield: the contact yields in full sliding\")"
     "when(AND(rwt_a>0,OR(rwt_ratio<0.01,rwt_ratio>10000)),"
     "\"; a/b is below 0.01 or above 10000: are the units consistent?\")"
     "when(IF(rwt_has_k=1,OR(rwt_k/rw_E1<0.00001,rwt_k/rw_E1>0.1)),"
     "\"; k/E is below 0.00001 or above 0.1: are the stresses in one unit?\")"
     "when(rw_f>0.8,\"; f is above 0.8, outside the tables: no yield\")"
     "when(rwt_ok_tip=0,\"; a/b is below 0.003, outside the tables: no elastic limit\")"
     "when(AND(rwt_ok_f=1,rwt_has_k=1,rwt_slides=0,rw_P_yield=\"\",rwt_bound<1),"
     "\"; yield is outside the tables: no safety\")))",
     "warnings", "", XLSX_CHECK},
    {"rw_error", "What is wrong",
     "IF(rwt_bad<>\"\",rwt_bad,IF(rwt_slides=1,\"Q is above f P: it slides, there is no "
     "equilibrium\",\"\"))",
     "error", "", XLSX_CHECK},

    WORK("rwt_any", "cells that are typed into",
         "COUNTA(rw_E1,rw_nu1,rw_E2,rw_nu2,rw_theta,rw_theta_deg,rw_a,rw_radius,rw_P,rw_Q,rw_f,"
         "rw_k,rw_yield_stress)"),
    WORK("rwt_bad", "what is wrong with the inputs",
         "IF(rwt_any=0,\"\",listed(input_checks()&IF(OR((rw_E2=\"\")=(rw_nu2=\"\"),rw_E2=\"inf\"),"
         "\"\","
         "\"; E2 and nu2: give both, or neither\")one_of(theta,theta_deg)one_of(a,radius)"
         "give_one(k,yield_stress)))"),
    WORK("rwt_ok", "1: the inputs are sound", "IF(AND(rwt_any>0,rwt_bad=\"\"),1,0)"),
    WORK("rwt_theta", "theta",
         "IF(rwt_ok=1,IF(rw_theta=\"\",N(rw_theta_deg)*PI()/180,rw_theta),0.1)"),
    WORK("rwt_a", "a", "IF(rwt_ok=1,IF(rw_a=\"\",N(rw_radius)*rwt_theta,rw_a),1)"),
    WORK("rwt_em2", "E2", "IF(rwt_ok=1,IF(rw_E2=\"\",rw_E1,IF(ISNUMBER(rw_E2),rw_E2,1E+99)),1)"),
    WORK("rwt_nu2", "nu2", "IF(rwt_ok=1,IF(rw_E2=\"\",rw_nu1,N(rw_nu2)),0)"),
    WORK("rwt_comp", "A", "IF(rwt_ok=1,2*(1-rw_nu1^2)/rw_E1+2*(1-rwt_nu2^2)/rwt_em2,1)"),
    WORK("rwt_load", "P", "IF(rwt_ok=1,rw_P,1)"),
    WORK("rwt_fr", "f", "IF(rwt_ok=1,rw_f,0)"),
    WORK("rwt_q", "|Q|", "IF(rwt_ok=1,ABS(N(rw_Q)),0)"),
    WORK("rwt_slides", "1: no equilibrium", "IF(rwt_q>rwt_fr*rwt_load*(1+1E-12),1,0)"),
    WORK("rwt_has_k", "1: a strength is given", "IF(rwt_ok=1,COUNT(rw_k,rw_yield_stress),0)"),
    WORK("rwt_k", "k", "IF(rwt_has_k=1,IF(rw_k=\"\",N(rw_yield_stress)/SQRT(3),rw_k),1)"),

    WORK("rwt_x", "theta a/(A P)", "MAX(1E-60,rwt_theta*rwt_a/(rwt_comp*rwt_load))"),
    WORK("rwt_x1", "not beyond Hertz", "MIN(rwt_x,2/PI())"),
    WORK("rwt_n0", "a/b, first guess", "guess(rwt_x1)"),
    WORK("rwt_n1", "a Newton step", "newton(rwt_n0,rwt_x1)"),
    WORK("rwt_n2", "a Newton step", "newton(rwt_n1,rwt_x1)"),
    WORK("rwt_n3", "a Newton step", "newton(rwt_n2,rwt_x1)"),
    WORK("rwt_n4", "a Newton step", "newton(rwt_n3,rwt_x1)"),
    WORK("rwt_n5", "a/b, 1 for Hertz", "newton(rwt_n4,rwt_x1)"),
    WORK("rwt_cos", "cos(phi0)", "cosine(rwt_n5)"),
    WORK("rwt_ratio", "a/b", "IF(rwt_a=0,0,IF(rwt_x>=2/PI(),SQRT(PI()/2*rwt_x),rwt_n5))"),
    WORK("rwt_b", "b", "IF(rwt_a=0,rwt_comp*rwt_load/(2*rwt_theta),rwt_a/MAX(1E-60,rwt_ratio))"),
    WORK("rwt_lc", "load of the stick zone",
         "IF(rwt_q=0,rwt_load,IF(rwt_slides=1,0,MAX(0,rwt_load-rwt_q/MAX(1E-60,rwt_fr))))"),
    WORK("rwt_xc", "theta a/(A P)",
         "IF(rwt_lc>0,MAX(1E-60,rwt_theta*rwt_a/(rwt_comp*MAX(1E-90,rwt_lc))),1)"),
    WORK("rwt_xc1", "not beyond Hertz", "MIN(rwt_xc,2/PI())"),
    WORK("rwt_c0", "a/b, first guess", "guess(rwt_xc1)"),
    WORK("rwt_c1", "a Newton step", "newton(rwt_c0,rwt_xc1)"),
    WORK("rwt_c2", "a Newton step", "newton(rwt_c1,rwt_xc1)"),
    WORK("rwt_c3", "a Newton step", "newton(rwt_c2,rwt_xc1)"),
    WORK("rwt_c4", "a Newton step", "newton(rwt_c3,rwt_xc1)"),
    WORK("rwt_c5", "a/b, 1 for Hertz", "newton(rwt_c4,rwt_xc1)"),
    WORK("rwt_cosc", "cos(phi0)", "cosine(rwt_c5)"),
    WORK("rwt_cc", "c",
         "IF(rwt_lc=0,0,IF(rwt_q=0,rwt_b,IF(rwt_a=0,rwt_comp*rwt_lc/(2*rwt_theta),rwt_a/"
         "IF(rwt_xc>=2/PI(),SQRT(PI()/2*rwt_xc),rwt_c5))))"),
    WORK("rwt_root", "sqrt((b/c)^2-1)",
         "IF(rwt_cc>0,SQRT(MAX(0,(rwt_b/MAX(1E-90,rwt_cc)-1)*(rwt_b/MAX(1E-90,rwt_cc)+1))),0)"),
    /* Re G of the stick zone's own contact at the edge x = b; 0 where there is none */
    WORK("rwt_g", "G of the stick zone at b",
         "IF(rwt_q*rwt_cc=0,0,IF(rwt_cc<=rwt_a,rwt_cc/rwt_a/(rwt_b/rwt_cc+rwt_root),2/PI()*(ATAN2("
         "rwt_root,rwt_cosc)+rwt_b/rwt_cc/rwt_c5*ATAN(rwt_c5/rwt_cosc*rwt_root*rwt_cc/rwt_b)-"
         "ASIN(rwt_c5)*rwt_root/rwt_c5)))"),

    /* the patch of the table */
    WORK("rwt_nut", "nu1 in the table", "IF(rwt_ok=1,rw_nu1,0.3)"),
    WORK("rwt_ft", "f in the table", "MIN(rwt_fr,0.8)"),
    WORK("rwt_kn", "first node of nu", "MIN(MATCH(rwt_nut,rwt_nu,1),14)"),
    WORK("rwt_fn", "first node of f", "MIN(MAX(MATCH(rwt_ft,rwt_f,1)-1,1),19)"),
    WORK("rwt_m", "(1-2 nu)^2/3", "(1-2*rwt_nut)^2/3"),
    WORK("rwt_wn1", "weights of nu", "lagrange(rwt_m,m_at(0),m_at(1),m_at(2))"),
    WORK("rwt_wn2", "", "lagrange(rwt_m,m_at(1),m_at(2),m_at(0))"),
    WORK("rwt_wn3", "", "lagrange(rwt_m,m_at(2),m_at(0),m_at(1))"),
    WORK("rwt_wf1", "weights of f", "lagrange(rwt_ft^2,f2_at(0),f2_at(1),f2_at(2))"),
    WORK("rwt_wf2", "", "lagrange(rwt_ft^2,f2_at(1),f2_at(2),f2_at(0))"),
    WORK("rwt_wf3", "", "lagrange(rwt_ft^2,f2_at(2),f2_at(0),f2_at(1))"),
    WORK("rwt_col", "first column of the patch", "(rwt_kn-1)*21+rwt_fn"),

    /* the limit at this a/b */
    WORK("rwt_t", "ln tan(phi0/2), in the table", "MAX(LN(rwt_n5/(1+rwt_cos)),INDEX(rwt_ts,1))"),
    WORK("rwt_node", "first node of a/b", "MIN(MATCH(rwt_t,rwt_ts,1),49)"),
    WORK("rwt_u", "place among the nodes", "(1-rwt_t/INDEX(rwt_ts,1))*50-(rwt_node-1)"),
    WORK("rwt_wt1", "weights of a/b", "(rwt_u-1)*(rwt_u-2)/2"),
    WORK("rwt_wt2", "", "rwt_u*(2-rwt_u)"),
    WORK("rwt_wt3", "", "rwt_u*(rwt_u-1)/2"),
    WORK("rwt_js", "J2, surface", "at_rows(rwt_wt,rwt_surface,rwt_node)"),
    WORK("rwt_jb", "J2, below; 0: none", "if_rows(at_rows(rwt_wt,rwt_below,rwt_node))"),
    WORK("rwt_limit", "P/(bk)",
         "IF(rwt_a=0,0,(ASIN(rwt_n5)/rwt_n5+rwt_cos)/SQRT(MAX(rwt_js,rwt_jb)))"),
    WORK("rwt_ok_f", "1: f is in the table", "IF(rwt_ok=1,IF(rw_f<=0.8,1,0),0)"),
    WORK("rwt_ok_tip", "1: a/b is in the table", "IF(OR(rwt_a=0,rwt_ratio>=0.003*(1-1E-9)),1,0)"),

    /* the load at yield, on the surface and below it */
    WORK("rwt_k2", "(k A/theta)^2", "(rwt_k*rwt_comp/rwt_theta)^2"),
    WORK("rwt_s_reached", "tips that yield before",
         "51-SUMPRODUCT(--(weigh(every_row(rwt_surface,#))<rwt_k2))"),
    WORK("rwt_s_node", "first of three nodes", "yield_node(rwt_s)"),
    WORK("rwt_s_k1", "J2 at the nodes", "at_row(rwt_surface,rwt_s_node)"),
    WORK("rwt_s_k2", "the second", "at_row(rwt_surface,rwt_s_node+1)"),
    WORK("rwt_s_k3", "the third", "at_row(rwt_surface,rwt_s_node+2)"),
    WORK("rwt_s_g", "above k^2", "yield_g(rwt_s)"),
    WORK("rwt_s_d", "slope", "yield_d(rwt_s)"),
    WORK("rwt_s_t", "t at yield", "yield_t(rwt_s)"),
    WORK("rwt_s_y", "AP/(theta a) at yield", "yield_load(rwt_s)"),
    WORK("rwt_b_reached", "tips that yield before",
         "51-SUMPRODUCT((weigh(every_row(rwt_below,#))<rwt_k2)*(product(every_there(rwt_below,#))>"
         "0))"),
    WORK("rwt_b_node", "first of three nodes", "yield_node(rwt_b)"),
    WORK("rwt_b_k1", "J2 at the nodes", "if_row(rwt_b_node,at_row(rwt_below,rwt_b_node))"),
    WORK("rwt_b_k2", "the second", "if_row(rwt_b_node+1,at_row(rwt_below,rwt_b_node+1))"),
    WORK("rwt_b_k3", "the third", "if_row(rwt_b_node+2,at_row(rwt_below,rwt_b_node+2))"),
    WORK("rwt_b_g", "above k^2", "yield_g(rwt_b)"),
    WORK("rwt_b_d", "slope", "yield_d(rwt_b)"),
    WORK("rwt_b_t", "t at yield", "yield_t(rwt_b)"),
    WORK("rwt_b_y", "AP/(theta a) at yield", "yield_load(rwt_b)"),
    WORK("rwt_y", "AP/(theta a) at yield", "MIN(rwt_s_y,rwt_b_y)"),
    WORK("rwt_bound", "load at the table's end over P",
         "ROUNDDOWN(rwt_end*rwt_x,IF(rwt_end*rwt_x>=10,0,1))"),

    /* the place of first yield */
    WORK("rwt_ty", "t at yield", "IF(rwt_y<=PI()/2,0,IF(rwt_s_y<=rwt_b_y,rwt_s_t,rwt_b_t))"),
    WORK("rwt_pu", "place among the tips", "(1-rwt_ty/INDEX(rwt_ts,1))*25"),
    WORK("rwt_pn", "tips before the first of three", "MIN(ROUNDDOWN(rwt_pu,0),23)"),
    WORK("rwt_wp1", "weights of a/b at yield", "(rwt_pu-rwt_pn-1)*(rwt_pu-rwt_pn-2)/2"),
    WORK("rwt_wp2", "", "(rwt_pu-rwt_pn)*(2-rwt_pu+rwt_pn)"),
    WORK("rwt_wp3", "", "(rwt_pu-rwt_pn)*(rwt_pu-rwt_pn-1)/2"),
    WORK("rwt_pr", "first row of the place", "rwt_pn+1+IF(rwt_s_y<=rwt_b_y,0,26)"),
    WORK("rwt_unit", "a, or b for Hertz, at yield", "rwt_a*SQRT(MIN(1,2/PI()*rwt_y))"),

    /* critical friction */
    WORK("rwt_gaps", "f that yield below",
         "SUMPRODUCT((at_every_f(rwt_surface)<at_every_f(rwt_below))*(MMULT(rwt_ones,"
         "product((every_f(rwt_below,#)>0)))=3))"),
    WORK("rwt_gn", "node before the cusp",
         "IF(rwt_gaps>1,IF(is_there(rwt_gaps+1)<3,rwt_gaps-1,rwt_gaps),MAX(1,rwt_gaps))"),
    WORK("rwt_g1", "surface less below there", "gap(rwt_gn)"),
    WORK("rwt_g2", "and at the next", "gap(rwt_gn+1)"),
};
const int case_cell_count = sizeof case_cells / sizeof case_cells[0];

const char limit_at_tip[] = "IF(rwt_ok_f=1,(ASIN(INDEX(rwt_tips,rwt_i))/INDEX(rwt_tips,rwt_i)+"
                            "cosine(INDEX(rwt_tips,rwt_i)))/SQRT(MAX(at_row(rwt_surface,rwt_i),"
                            "if_row(rwt_i,at_row(rwt_below,rwt_i)))),NA())";
const char limit_at_friction[] =
    "IF(AND(rwt_ok_f=1,rwt_ok_tip=1,rwt_a>0),(ASIN(rwt_n5)/rwt_n5+rwt_cos)/"
    "SQRT(MAX(weigh(at_f(rwt_surface,rwt_i,#)),IF(is_there(rwt_i)=3,"
    "weigh(at_f(rwt_below,rwt_i,#)),0))),NA())";

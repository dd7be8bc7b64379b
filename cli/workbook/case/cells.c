/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names that begin with rw_ are for the user; those of the working cells begin with rwt_. Where a
 * case has no sound inputs, the working cells go on with harmless numbers, and the results are
 * empty: so no cell ever has an error. */
#include "cells.h"

#include "yield_table.h"

/* ---- Conditions ------------------------------------------------------------------------------ */

#define ABOVE_0(N) "OR(" N "<1E-60," N ">1E+60)"
#define POISSON(N) "OR(" N "<0," N ">0.5)"
#define MUST_BE_ABOVE_0 "a number above 0"
#define MUST_BE_POISSON "a number from 0 to 0.5"

/* name, column, words where it is empty, condition that it is wrong, words for it, hint. A text is
 * above every number, and so is wrong. */
#define INPUTS(X)                                                                                  \
    X(E1, "rw_E1", "E1", "; E1 is missing", ABOVE_0("rw_E1"), MUST_BE_ABOVE_0,                     \
      "half-plane: the body that may yield")                                                       \
    X(NU1, "rw_nu1", "nu1", "; nu1 is missing", POISSON("rw_nu1"), MUST_BE_POISSON,                \
      "tables: 0 to 0.5")                                                                          \
    X(E2, "rw_E2", "E2", "", "AND(rw_E2<>\"inf\"," ABOVE_0("rw_E2") ")",                           \
      MUST_BE_ABOVE_0 ", or inf for a rigid wedge", "wedge; leave both empty for one material")    \
    X(NU2, "rw_nu2", "nu2", "", POISSON("rw_nu2"), MUST_BE_POISSON, "a rigid wedge: inf for E2")   \
    X(THETA, "rw_theta", "theta", "", "OR(rw_theta<1E-60,rw_theta>=PI()/2)",                       \
      "a number above 0, below pi/2", "this, or the angle in degrees")                             \
    X(THETA_DEG, "rw_theta_deg", "theta_deg", "", "OR(rw_theta_deg<1E-60,rw_theta_deg>=90)",       \
      "a number above 0, below 90", "small: up to about 6 degrees")                                \
    X(ROUNDING, "rw_a", "a", "", "OR(rw_a<0,rw_a>1E+60)", "a number, 0 or above",                  \
      "0: sharp; this, or the radius")                                                             \
    X(RADIUS, "rw_radius", "radius", "", "OR(rw_radius<0,rw_radius>1E+60)",                        \
      "a number, 0 or above", "R = a/theta")                                                       \
    X(LOAD, "rw_P", "P", "; P is missing", ABOVE_0("rw_P"), MUST_BE_ABOVE_0, "per unit length")    \
    X(Q, "rw_Q", "Q", "", "OR(rw_Q<-1E+60,rw_Q>1E+60)", "a number", "empty: 0; |Q| up to f P")     \
    X(F, "rw_f", "f", "; f is missing", "OR(rw_f<0,rw_f>1E+6)", "a number, 0 or above",            \
      "tables: up to 0.8")                                                                         \
    X(K, "rw_k", "k", "", ABOVE_0("rw_k"), MUST_BE_ABOVE_0, "shear; this, or the tensile one")     \
    X(YIELD_STRESS, "rw_yield_stress", "yield_stress", "", ABOVE_0("rw_yield_stress"),             \
      MUST_BE_ABOVE_0, "Y = k sqrt(3), von Mises")

#define RULE(ID, NAME, COLUMN, EMPTY, WRONG, MUST, HINT) [CELL_##ID] = {WRONG, MUST, HINT},
const input_rule input_rules[INPUT_CELLS] = {INPUTS(RULE)};

#define CHECK(ID, NAME, COLUMN, EMPTY, WRONG, MUST, HINT)                                          \
    "&IF(" NAME "=\"\",\"" EMPTY "\",IF(" WRONG ",\"; " COLUMN " must be " MUST "\",\"\"))"

#define ONE_OF(N1, C1, N2, C2)                                                                     \
    "&IF(AND(" N1 "=\"\"," N2 "=\"\"),\"; " C1 " or " C2 " is missing\",\"\")" TWICE(N1, C1, N2, C2)
#define TWICE(N1, C1, N2, C2)                                                                      \
    "&IF(OR(" N1 "=\"\"," N2 "=\"\"),\"\",\"; " C1 " and " C2 ": give one of the two\")"
#define SECOND_BODY                                                                                \
    "&IF(OR((rw_E2=\"\")=(rw_nu2=\"\"),rw_E2=\"inf\"),\"\",\"; E2 and nu2: give both, or "         \
    "neither\")"
/* Each begins with "; ", which the first one loses. */
#define LISTED(TEXTS) "MID(\"\"" TEXTS ",3,2000)"
#define BAD                                                                                        \
    "=IF(rwt_any=0,\"\"," LISTED(                                                                  \
        INPUTS(CHECK) SECOND_BODY ONE_OF("rw_theta", "theta", "rw_theta_deg", "theta_deg")         \
            ONE_OF("rw_a", "a", "rw_radius", "radius")                                             \
                TWICE("rw_k", "k", "rw_yield_stress", "yield_stress")) ")"

/* ---- The contact ----------------------------------------------------------------------------- */

/* a/b from x = theta a/(AP): Newton on a^2/(phi0 + a c0) = x, nearly a straight line; the parabola
 * that it starts from is exact at both ends. */
#define LOAD_AT(N) "(ASIN(" N ")+" N "*SQRT((1-" N ")*(1+" N ")))"
#define GUESS(X) "=" X "*(2-(4/PI()-1)*PI()^2/4*" X ")"
#define NEWTON(N, X)                                                                               \
    "=MIN(1," N "-(" N "^2*" LOAD_AT(N) "-" X "*" LOAD_AT(N) "^2)/(2*ASIN(" N ")*" N "))"
#define NEWTON_CELLS(FIRST, P, X)                                                                  \
    [FIRST] = {P "0", NULL, "a/b, first guess", "", GUESS(X), XLSX_PLAIN},                         \
    [FIRST + 1] = {P "1", NULL, "a Newton step", "", NEWTON(P "0", X), XLSX_PLAIN},                \
    [FIRST + 2] = {P "2", NULL, "a Newton step", "", NEWTON(P "1", X), XLSX_PLAIN},                \
    [FIRST + 3] = {P "3", NULL, "a Newton step", "", NEWTON(P "2", X), XLSX_PLAIN},                \
    [FIRST + 4] = {P "4", NULL, "a Newton step", "", NEWTON(P "3", X), XLSX_PLAIN},                \
    [FIRST + 5] = {P "5", NULL, "a/b, 1 for Hertz", "", NEWTON(P "4", X), XLSX_PLAIN}

/* Re G of the stick zone's own contact at the edge x = b; 0 where there is none. */
#define STICK_G                                                                                    \
    "=IF(rwt_q*rwt_cc=0,0,IF(rwt_cc<=rwt_a,rwt_cc/rwt_a/(rwt_b/rwt_cc+rwt_root),2/PI()*(ATAN2("    \
    "rwt_root,rwt_cosc)+rwt_b/rwt_cc/rwt_c5*ATAN(rwt_c5/rwt_cosc*rwt_root*rwt_cc/rwt_b)-"          \
    "ASIN(rwt_c5)*rwt_root/rwt_c5)))"

/* ---- The table ------------------------------------------------------------------------------- */

#define N_TIPS "51"
#define N_STEPS "50"
#define N_LAST "49" /* the last node of a patch of three */
#define N_FRICTIONS "21"
#define N_PLACES "26" /* tips of the tables of the place */
#define N_PLACE_STEPS "25"
#define N_PLACE_LAST "24"
typedef char
    table_is_as_wide[TIPS == 51 && FRICTIONS == 21 && NUS == 16 && PLACE_TIPS == 26 ? 1 : -1];

#define LAGRANGE(AT, V0, V1, V2)                                                                   \
    "=(" AT "-" V1 ")*(" AT "-" V2 ")/((" V0 "-" V1 ")*(" V0 "-" V2 "))"
#define MS(I) "INDEX(rwt_ms,rwt_kn+" I ")"
#define FS(I) "INDEX(rwt_f,rwt_fn+" I ")^2"

/* Cells of a table: of one row; of three rows; of all rows. D is the offset of the next nu. */
#define PATCH_1(T, N, D) "INDEX(" T "," N ",rwt_col" D "):INDEX(" T "," N ",rwt_col+2" D ")"
#define PATCH_3(T, N, D) "INDEX(" T "," N ",rwt_col" D "):INDEX(" T "," N "+2,rwt_col+2" D ")"
#define ALL(T, D)                                                                                  \
    "(rwt_wf1*INDEX(" T ",0,rwt_col" D ")+rwt_wf2*INDEX(" T ",0,rwt_col+1" D ")+rwt_wf3*INDEX(" T  \
    ",0,rwt_col+2" D "))"
#define PRODUCT(T, D)                                                                              \
    "INDEX(" T ",0,rwt_col" D ")*INDEX(" T ",0,rwt_col+1" D ")*INDEX(" T ",0,rwt_col+2" D ")"

#define AT_TIP(T, N)                                                                               \
    "rwt_wn1*SUMPRODUCT(" PATCH_1(T, N, "") "*rwt_wf)+rwt_wn2*SUMPRODUCT(" PATCH_1(                \
        T, N, "+21") "*rwt_wf)+rwt_wn3*SUMPRODUCT(" PATCH_1(T, N, "+42") "*rwt_wf)"
/* Three tips, weighted by W, from node N on. MMULT takes no empty cells, but those plus 0. */
#define PATCH_SUM(W, T, N, D) "SUMPRODUCT(MMULT(" W "," PATCH_3(T, N, D) "+0)*rwt_wf)"
#define AT_TIPS(W, T, N)                                                                           \
    "rwt_wn1*" PATCH_SUM(W, T, N, "") "+rwt_wn2*" PATCH_SUM(W, T, N, "+21") "+rwt_wn3*" PATCH_SUM( \
        W, T, N, "+42")
#define AT_T(T) AT_TIPS("rwt_wt", T, "rwt_node")
#define AT_PLACE(N) "(" AT_TIPS("rwt_wp", "rwt_place", N) ")" /* its tables are below each other */
#define ALL_TIPS(T) "rwt_wn1*" ALL(T, "") "+rwt_wn2*" ALL(T, "+21") "+rwt_wn3*" ALL(T, "+42")

#define SURFACE "rwt_surface"
#define BELOW "rwt_below"
#define IF_THERE_1(N, VALUE)                                                                       \
    "IF(SUMPRODUCT(--(" PATCH_1(BELOW, N, "") ">0))+SUMPRODUCT(--(" PATCH_1(                       \
        BELOW, N, "+21") ">0))+SUMPRODUCT(--(" PATCH_1(BELOW, N, "+42") ">0))=9," VALUE ",0)"
#define IF_THERE_3(VALUE)                                                                          \
    "=IF(SUMPRODUCT(--(" PATCH_3(BELOW, "rwt_node", "") ">0))+SUMPRODUCT(--(" PATCH_3(             \
        BELOW, "rwt_node", "+21") ">0))+SUMPRODUCT(--(" PATCH_3(BELOW, "rwt_node",                 \
                                                                "+42") ">0))=27," VALUE ",0)"

/* The tip that yields at k, between nodes of the table, by the parabola through three; and the
 * load that makes this tip. 1E+99 where the branch does not yield in the table. */
#define YIELD_FORMULAS(FIRST, P, REACHED, AT_0, AT_1, AT_2)                                        \
    [FIRST +                                                                                       \
        YIELD_REACHED] = {P "reached", NULL, "tips that yield before", "", REACHED, XLSX_PLAIN},   \
        [FIRST + YIELD_NODE] = {P "node",                                                          \
                                NULL,                                                              \
                                "first of three nodes",                                            \
                                "",                                                                \
                                "=MIN(MAX(" P "reached,1)," N_LAST ")",                            \
                                XLSX_PLAIN},                                                       \
        [FIRST + YIELD_K] = {P "k1", NULL, "J2 at the nodes", "", AT_0, XLSX_PLAIN},               \
        [FIRST + YIELD_K + 1] = {P "k2", NULL, "the second", "", AT_1, XLSX_PLAIN},                \
        [FIRST + YIELD_K + 2] = {P "k3", NULL, "the third", "", AT_2, XLSX_PLAIN},                 \
        [FIRST + YIELD_G] = {P "g",                                                                \
                             NULL,                                                                 \
                             "above k^2",                                                          \
                             "",                                                                   \
                             "=INDEX(" P "ks,MIN(3,MAX(" P "reached,1)-" P "node+1))-rwt_k2",      \
                             XLSX_PLAIN},                                                          \
        [FIRST + YIELD_D] = {P "d",                                                                \
                             NULL,                                                                 \
                             "slope",                                                              \
                             "",                                                                   \
                             "=" P "k2-" P "k1+(" P "k3-2*" P "k2+" P "k1)*(MAX(" P                \
                             "reached,1)-" P "node-0.5)",                                          \
                             XLSX_PLAIN},                                                          \
        [FIRST + YIELD_U] = {P "t",                                                                \
                             NULL,                                                                 \
                             "t at yield",                                                         \
                             "",                                                                   \
                             "=INDEX(rwt_ts,1)*(1-IF(OR(" P "reached=0," P "reached=" N_TIPS       \
                             ",MIN(" P "ks)<=0),0," P "reached-1+2*" P "g/(SQRT(MAX(0," P          \
                             "d^2-2*(" P "k3-2*" P "k2+" P "k1)*" P "g))-" P "d))/" N_STEPS ")",   \
                             XLSX_PLAIN},                                                          \
        [FIRST + YIELD_LOAD] = {P "y",                                                             \
                                NULL,                                                              \
                                "AP/(theta a) at yield",                                           \
                                "",                                                                \
                                "=IF(OR(" P "reached=0,MIN(" P "ks)<=0),1E+99,IF(" P               \
                                "reached=" N_TIPS ",PI()/2*rwt_k2/" P "k3,(ASIN(1/COSH(" P         \
                                "t))-TANH(" P "t)/COSH(" P "t))*COSH(" P "t)^2))",                 \
                                XLSX_PLAIN}

/* ---- Critical friction ----------------------------------------------------------------------- */

/* All frictions at this a/b and nu: the branches' J2, and whether the branch below is whole. */
#define ROW_3(T, D)                                                                                \
    "INDEX(" T ",rwt_node,rwt_col-rwt_fn+1" D "):INDEX(" T                                         \
    ",rwt_node+2,rwt_col-rwt_fn+" N_FRICTIONS D ")"
#define ALL_F(T)                                                                                   \
    "rwt_wn1*MMULT(rwt_wt," ROW_3(T, "") "+0)+rwt_wn2*MMULT(rwt_wt," ROW_3(                        \
        T, "+21") "+0)+rwt_wn3*MMULT(rwt_wt," ROW_3(T, "+42") "+0)"
#define WHOLE                                                                                      \
    "MMULT(rwt_ones,(" ROW_3(BELOW, "") ">0)*(" ROW_3(BELOW, "+21") ">0)*(" ROW_3(BELOW,           \
                                                                                  "+42") ">0))=3"
#define ONE_F(T, I, D)                                                                             \
    "SUMPRODUCT(MMULT(rwt_wt,INDEX(" T ",rwt_node,rwt_col-rwt_fn+" I D "):INDEX(" T                \
    ",rwt_node+2,rwt_col-rwt_fn+" I D ")+0))"
#define GAP_AT(I)                                                                                  \
    "=rwt_wn1*(" ONE_F(SURFACE, I, "") "-" ONE_F(BELOW, I, "") ")+rwt_wn2*(" ONE_F(                \
        SURFACE, I, "+21") "-" ONE_F(BELOW, I,                                                     \
                                     "+21") ")+rwt_wn3*(" ONE_F(SURFACE, I,                        \
                                                                "+42") "-" ONE_F(BELOW, I,         \
                                                                                 "+42") ")"
#define THERE(I, D)                                                                                \
    "(INDEX(" BELOW ",rwt_node,rwt_col-rwt_fn+" I D "):INDEX(" BELOW                               \
    ",rwt_node+2,rwt_col-rwt_fn+" I D ")>0)"

/* ---- Warnings -------------------------------------------------------------------------------- */

/* The first five have the thresholds and the words of rwedge_validity(): a test compares. */
#define WHEN(CONDITION, TEXT) "&IF(" CONDITION ",\"; " TEXT "\",\"\")"
#define OF_LIBRARY                                                                                 \
    WHEN("rwt_theta>0.1", "theta is above 0.1 rad: the wedge is hardly a half-plane")              \
    WHEN("AND(ABS(rw_beta)>1E-12,rwt_fr>0)",                                                       \
         "Dundurs' beta is not 0: with friction its coupling is neglected")                        \
    WHEN("AND(ISNUMBER(rw_safety),N(rw_safety)<1)",                                                \
         "P is above P_yield: the contact yields in full sliding")                                 \
    WHEN("AND(rwt_a>0,OR(rwt_ratio<0.01,rwt_ratio>10000))",                                        \
         "a/b is below 0.01 or above 10000: are the units consistent?")                            \
    WHEN("IF(rwt_has_k=1,OR(rwt_k/rw_E1<0.00001,rwt_k/rw_E1>0.1))",                                \
         "k/E is below 0.00001 or above 0.1: are the stresses in one unit?")
#define OF_TABLES                                                                                  \
    WHEN("rw_f>0.8", "f is above 0.8, outside the tables: no yield")                               \
    WHEN("rwt_ok_tip=0", "a/b is below 0.003, outside the tables: no elastic limit")               \
    WHEN("AND(rwt_ok_f=1,rwt_has_k=1,rwt_slides=0,rw_P_yield=\"\",rwt_bound<1)",                   \
         "yield is outside the tables: no safety")
#define WARNINGS "=IF(rwt_ok=0,\"\"," LISTED(OF_LIBRARY OF_TABLES) ")"

#define ERROR                                                                                      \
    "=IF(rwt_bad<>\"\",rwt_bad,IF(rwt_slides=1,\"Q is above f P: it slides, there is no "          \
    "equilibrium\",\"\"))"

/* ---- The cells ------------------------------------------------------------------------------- */

#define RESULT(FORMULA) "=IF(rwt_ok=1," FORMULA ",\"\")"

#define INPUT(ID, NAME, COLUMN, WHAT, UNIT) [ID] = {NAME, COLUMN, WHAT, UNIT, NULL, XLSX_INPUT}
#define SHOWN(ID, NAME, COLUMN, WHAT, UNIT, FORMULA)                                               \
    [ID] = {NAME, COLUMN, WHAT, UNIT, FORMULA, XLSX_RESULT}
#define SIGNED(ID, NAME, COLUMN, WHAT, UNIT, FORMULA)                                              \
    [ID] = {NAME, COLUMN, WHAT, UNIT, FORMULA, XLSX_SIGNED}
#define WORK(ID, NAME, WHAT, FORMULA) [ID] = {NAME, NULL, WHAT, "", FORMULA, XLSX_PLAIN}

const case_cell case_cells[CELL_COUNT] = {
    INPUT(CELL_E1, "rw_E1", "E1", "Young's modulus, half-plane", "MPa"),
    INPUT(CELL_NU1, "rw_nu1", "nu1", "Poisson's ratio, half-plane", "-"),
    INPUT(CELL_E2, "rw_E2", "E2", "Young's modulus, wedge", "MPa"),
    INPUT(CELL_NU2, "rw_nu2", "nu2", "Poisson's ratio, wedge", "-"),
    INPUT(CELL_THETA, "rw_theta", "theta", "Angle of the flank, radians", "rad"),
    INPUT(CELL_THETA_DEG, "rw_theta_deg", "theta_deg", "or in degrees", "deg"),
    INPUT(CELL_ROUNDING, "rw_a", "a", "Half-width of the rounding, a", "mm"),
    INPUT(CELL_RADIUS, "rw_radius", "radius", "or its radius, R", "mm"),
    INPUT(CELL_LOAD, "rw_P", "P", "Normal load P", "N/mm"),
    INPUT(CELL_Q, "rw_Q", "Q", "Tangential load Q", "N/mm"),
    INPUT(CELL_F, "rw_f", "f", "Coefficient of friction f", "-"),
    INPUT(CELL_K, "rw_k", "k", "Yield stress in shear, half-plane, k", "MPa"),
    INPUT(CELL_YIELD_STRESS, "rw_yield_stress", "yield_stress", "or in tension, Y", "MPa"),

    SHOWN(CELL_COMPLIANCE, "rw_compliance", "A", "Composite compliance A", "1/MPa",
          RESULT("rwt_comp")),
    SIGNED(CELL_BETA, "rw_beta", "dundurs_beta", "Dundurs' beta", "-",
           RESULT("0.5*(rw_E1/(1+rw_nu1)*(1-2*rwt_nu2)-rwt_em2/(1+rwt_nu2)*(1-2*rw_nu1))/(rw_E1/"
                  "(1+rw_nu1)*(1-rwt_nu2)+rwt_em2/(1+rwt_nu2)*(1-rw_nu1))")),
    SHOWN(CELL_B, "rw_b", "b", "Half-width of the contact b", "mm", RESULT("rwt_b")),
    SHOWN(CELL_A_OVER_B, "rw_a_over_b", "a_over_b", "Rounding over contact a/b", "-",
          RESULT("rwt_ratio")),
    SHOWN(CELL_LOAD_NUMBER, "rw_load_number", "AP_over_theta_b", "Load AP/(theta b)", "-",
          RESULT("rwt_comp*rwt_load/(rwt_theta*rwt_b)")),
    SHOWN(CELL_P0, "rw_p0", "p0", "Peak pressure p0, at x = 0", "MPa",
          "=IF(AND(rwt_ok=1,rwt_a>0),rwt_theta/rwt_comp*IF(rwt_ratio<1,2/PI()*(ASIN(rwt_n5)/"
          "rwt_n5+LN((1+rwt_cos)/rwt_n5)),1/MAX(1,rwt_ratio)),\"\")"),
    SHOWN(CELL_P_TRANSITION, "rw_p_transition", "p_transition", "Pressure at x = a and -a", "MPa",
          "=IF(AND(rwt_ok=1,rwt_a>0),IF(rwt_ratio<1,rwt_theta/rwt_comp*2/PI()*(ASIN(rwt_n5)*"
          "rwt_cos/rwt_n5-LN(rwt_n5)),0),\"\")"),
    SHOWN(CELL_P_MEAN, "rw_p_mean", "p_mean", "Mean pressure P/(2b)", "MPa",
          RESULT("rwt_load/(2*rwt_b)")),
    SIGNED(CELL_Q_OVER_FP, "rw_Q_over_fP", "Q_over_fP", "Tangential load Q/(fP)", "-",
           "=IF(AND(rwt_ok=1,rwt_fr>0),N(rw_Q)/MAX(1E-90,rwt_fr*rwt_load),\"\")"),
    SHOWN(CELL_C, "rw_c", "c", "Half-width of the stick zone c", "mm",
          "=IF(AND(rwt_ok=1,rwt_fr>0,rwt_slides=0),rwt_cc,\"\")"),
    SHOWN(CELL_C_OVER_B, "rw_c_over_b", "c_over_b", "Stick zone over contact c/b", "-",
          "=IF(AND(rwt_ok=1,rwt_fr>0,rwt_slides=0),rwt_cc/rwt_b,\"\")"),
    SHOWN(CELL_TENSION, "rw_tension", "max_tension", "Tension under this Q", "MPa",
          "=IF(AND(rwt_ok=1,rwt_slides=0),IF(rwt_q=0,0,2*rwt_fr*rwt_theta/rwt_comp*(1/"
          "MAX(1,rwt_ratio)-rwt_g)),\"\")"),
    SHOWN(CELL_TENSION_SLIDING, "rw_max_tension", "max_tension_sliding", "Tension in full sliding",
          "MPa", RESULT("2*rwt_fr*rwt_theta/rwt_comp/MAX(1,rwt_ratio)")),
    SHOWN(CELL_VON_MISES, "rw_von_mises", "von_mises_sliding", "Largest von Mises stress, sliding",
          "MPa", "=IF(N(rw_P_over_bk)>0,SQRT(3)*rwt_load/rwt_b/rw_P_over_bk,\"\")"),
    SHOWN(CELL_F_CRITICAL, "rw_f_critical", "f_critical", "Critical friction", "-",
          "=IF(AND(rwt_ok_tip=1,rwt_ok=1,rwt_a>0),IF(rwt_gaps=0,0,SQRT(INDEX("
          "rwt_f,rwt_gn)^2+(INDEX(rwt_f,rwt_gn+1)^2-INDEX(rwt_f,rwt_gn)^2)*rwt_g1/"
          "(rwt_g1-rwt_g2))),\"\")"),
    SHOWN(CELL_LOAD_OVER_BK, "rw_load_over_bk", "load_over_bk", "Load P/(bk)", "-",
          "=IF(rwt_has_k=1,rwt_load/(rwt_b*rwt_k),\"\")"),
    SHOWN(CELL_P_OVER_BK, "rw_P_over_bk", "P_over_bk", "Elastic limit P/(bk)", "-",
          "=IF(AND(rwt_ok_f=1,rwt_ok_tip=1),rwt_limit,\"\")"),
    SHOWN(CELL_P_YIELD, "rw_P_yield", "P_yield", "Load at first yield", "N/mm",
          "=IF(AND(rwt_ok_f=1,rwt_has_k=1,OR(rwt_a=0,rwt_y<1E+98)),IF(rwt_a=0,0,rwt_y*rwt_theta*"
          "rwt_a/rwt_comp),\"\")"),
    SHOWN(CELL_SAFETY, "rw_safety", "safety", "Safety on load P_yield/P", "-",
          "=IF(AND(rwt_ok_f=1,rwt_has_k=1,rwt_slides=0),IF(ISNUMBER(rw_P_yield),rw_P_yield/"
          "rwt_load,IF(rwt_bound<1,\"\",\"> \"&rwt_bound)),\"\")"),
    SHOWN(CELL_SAFETY_STRENGTH, "rw_safety_strength", "safety_strength",
          "Safety on strength, of k or Y", "-",
          "=IF(AND(rwt_has_k=1,rwt_slides=0,ISNUMBER(rw_P_over_bk)),rw_P_over_bk*rwt_b*rwt_k/"
          "rwt_load,\"\")"),
    SIGNED(
        CELL_YIELD_X, "rw_yield_x", "yield_x", "Place of first yield, x", "mm",
        "=IF(ISNUMBER(rw_P_yield),IF(N(rw_Q)<0,-1,1)*rwt_unit*rwt_ft*" AT_PLACE("rwt_pr") ",\"\")"),
    SHOWN(CELL_YIELD_Y, "rw_yield_y", "yield_y", "its depth y", "mm",
          "=IF(ISNUMBER(rw_P_yield),IF(rw_branch=\"surface\",0,rwt_unit*" AT_PLACE(
              "rwt_pr+" N_PLACES) "),\"\")"),
    SHOWN(CELL_BRANCH, "rw_branch", "yield_branch", "Yields first", "",
          "=IF(ISNUMBER(rw_P_yield),IF(OR(rwt_a=0,rwt_s_y<=rwt_b_y),\"surface\",\"subsurface\"),"
          "\"\")"),
    [CELL_WARNINGS] = {"rw_remarks", "warnings", "Remarks", "", WARNINGS, XLSX_CHECK},
    [CELL_ERROR] = {"rw_error", "error", "What is wrong", "", ERROR, XLSX_CHECK},

    WORK(WORK_ANY, "rwt_any", "cells that are typed into",
         "=COUNTA(rw_E1,rw_nu1,rw_E2,rw_nu2,rw_theta,rw_theta_deg,rw_a,rw_radius,rw_P,rw_Q,rw_f,"
         "rw_k,rw_yield_stress)"),
    WORK(WORK_BAD, "rwt_bad", "what is wrong with the inputs", BAD),
    WORK(WORK_OK, "rwt_ok", "1: the inputs are sound", "=IF(AND(rwt_any>0,rwt_bad=\"\"),1,0)"),
    WORK(WORK_THETA, "rwt_theta", "theta",
         "=IF(rwt_ok=1,IF(rw_theta=\"\",N(rw_theta_deg)*PI()/180,rw_theta),0.1)"),
    WORK(WORK_ROUNDING, "rwt_a", "a", "=IF(rwt_ok=1,IF(rw_a=\"\",N(rw_radius)*rwt_theta,rw_a),1)"),
    WORK(WORK_E2, "rwt_em2", "E2",
         "=IF(rwt_ok=1,IF(rw_E2=\"\",rw_E1,IF(ISNUMBER(rw_E2),rw_E2,1E+99)),1)"),
    WORK(WORK_NU2, "rwt_nu2", "nu2", "=IF(rwt_ok=1,IF(rw_E2=\"\",rw_nu1,N(rw_nu2)),0)"),
    WORK(WORK_COMPLIANCE, "rwt_comp", "A",
         "=IF(rwt_ok=1,2*(1-rw_nu1^2)/rw_E1+2*(1-rwt_nu2^2)/rwt_em2,1)"),
    WORK(WORK_LOAD, "rwt_load", "P", "=IF(rwt_ok=1,rw_P,1)"),
    WORK(WORK_F, "rwt_fr", "f", "=IF(rwt_ok=1,rw_f,0)"),
    WORK(WORK_Q, "rwt_q", "|Q|", "=IF(rwt_ok=1,ABS(N(rw_Q)),0)"),
    WORK(WORK_SLIDES, "rwt_slides", "1: no equilibrium",
         "=IF(rwt_q>rwt_fr*rwt_load*(1+1E-12),1,0)"),
    WORK(WORK_HAS_K, "rwt_has_k", "1: a strength is given",
         "=IF(rwt_ok=1,COUNT(rw_k,rw_yield_stress),0)"),
    WORK(WORK_K, "rwt_k", "k", "=IF(rwt_has_k=1,IF(rw_k=\"\",N(rw_yield_stress)/SQRT(3),rw_k),1)"),

    WORK(WORK_X, "rwt_x", "theta a/(A P)", "=MAX(1E-60,rwt_theta*rwt_a/(rwt_comp*rwt_load))"),
    WORK(WORK_X1, "rwt_x1", "not beyond Hertz", "=MIN(rwt_x,2/PI())"),
    NEWTON_CELLS(WORK_N0, "rwt_n", "rwt_x1"),
    WORK(WORK_COS, "rwt_cos", "cos(phi0)", "=SQRT((1-rwt_n5)*(1+rwt_n5))"),
    WORK(WORK_RATIO, "rwt_ratio", "a/b",
         "=IF(rwt_a=0,0,IF(rwt_x>=2/PI(),SQRT(PI()/2*rwt_x),rwt_n5))"),
    WORK(WORK_B, "rwt_b", "b",
         "=IF(rwt_a=0,rwt_comp*rwt_load/(2*rwt_theta),rwt_a/MAX(1E-60,rwt_ratio))"),
    WORK(WORK_STICK_LOAD, "rwt_lc", "load of the stick zone",
         "=IF(rwt_q=0,rwt_load,IF(rwt_slides=1,0,MAX(0,rwt_load-rwt_q/MAX(1E-60,rwt_fr))))"),
    WORK(WORK_XC, "rwt_xc", "theta a/(A P)",
         "=IF(rwt_lc>0,MAX(1E-60,rwt_theta*rwt_a/(rwt_comp*MAX(1E-90,rwt_lc))),1)"),
    WORK(WORK_XC1, "rwt_xc1", "not beyond Hertz", "=MIN(rwt_xc,2/PI())"),
    NEWTON_CELLS(WORK_C0, "rwt_c", "rwt_xc1"),
    WORK(WORK_COS_C, "rwt_cosc", "cos(phi0)", "=SQRT((1-rwt_c5)*(1+rwt_c5))"),
    WORK(WORK_C, "rwt_cc", "c",
         "=IF(rwt_lc=0,0,IF(rwt_q=0,rwt_b,IF(rwt_a=0,rwt_comp*rwt_lc/(2*rwt_theta),rwt_a/"
         "IF(rwt_xc>=2/PI(),SQRT("
         "PI()/2*rwt_xc),rwt_c5))))"),
    WORK(WORK_ROOT_C, "rwt_root", "sqrt((b/c)^2-1)",
         "=IF(rwt_cc>0,SQRT(MAX(0,(rwt_b/MAX(1E-90,rwt_cc)-1)*(rwt_b/MAX(1E-90,rwt_cc)+1))),0)"),
    WORK(WORK_G, "rwt_g", "G of the stick zone at b", STICK_G),

    WORK(WORK_NU_TABLE, "rwt_nut", "nu1 in the table", "=IF(rwt_ok=1,rw_nu1,0.3)"),
    WORK(WORK_F_TABLE, "rwt_ft", "f in the table", "=MIN(rwt_fr,0.8)"),
    WORK(WORK_NU_NODE, "rwt_kn", "first node of nu", "=MIN(MATCH(rwt_nut,rwt_nu,1),14)"),
    WORK(WORK_F_NODE, "rwt_fn", "first node of f", "=MIN(MAX(MATCH(rwt_ft,rwt_f,1)-1,1),19)"),
    WORK(WORK_M, "rwt_m", "(1-2 nu)^2/3", "=(1-2*rwt_nut)^2/3"),
    WORK(WORK_WEIGHT_NU, "rwt_wn1", "weights of nu", LAGRANGE("rwt_m", MS("0"), MS("1"), MS("2"))),
    WORK(WORK_WEIGHT_NU + 1, "rwt_wn2", "", LAGRANGE("rwt_m", MS("1"), MS("2"), MS("0"))),
    WORK(WORK_WEIGHT_NU + 2, "rwt_wn3", "", LAGRANGE("rwt_m", MS("2"), MS("0"), MS("1"))),
    WORK(WORK_WEIGHT_F, "rwt_wf1", "weights of f", LAGRANGE("rwt_ft^2", FS("0"), FS("1"), FS("2"))),
    WORK(WORK_WEIGHT_F + 1, "rwt_wf2", "", LAGRANGE("rwt_ft^2", FS("1"), FS("2"), FS("0"))),
    WORK(WORK_WEIGHT_F + 2, "rwt_wf3", "", LAGRANGE("rwt_ft^2", FS("2"), FS("0"), FS("1"))),
    WORK(WORK_COLUMN, "rwt_col", "first column of the patch", "=(rwt_kn-1)*" N_FRICTIONS "+rwt_fn"),

    WORK(WORK_T, "rwt_t", "ln tan(phi0/2), in the table",
         "=MAX(LN(rwt_n5/(1+rwt_cos)),INDEX(rwt_ts,1))"),
    WORK(WORK_TIP_NODE, "rwt_node", "first node of a/b", "=MIN(MATCH(rwt_t,rwt_ts,1)," N_LAST ")"),
    WORK(WORK_U, "rwt_u", "place among the nodes",
         "=(1-rwt_t/INDEX(rwt_ts,1))*" N_STEPS "-(rwt_node-1)"),
    WORK(WORK_WEIGHT_T, "rwt_wt1", "weights of a/b", "=(rwt_u-1)*(rwt_u-2)/2"),
    WORK(WORK_WEIGHT_T + 1, "rwt_wt2", "", "=rwt_u*(2-rwt_u)"),
    WORK(WORK_WEIGHT_T + 2, "rwt_wt3", "", "=rwt_u*(rwt_u-1)/2"),
    WORK(WORK_SURFACE, "rwt_js", "J2, surface", "=" AT_T(SURFACE)),
    WORK(WORK_BELOW, "rwt_jb", "J2, below; 0: none", IF_THERE_3(AT_T(BELOW))),
    WORK(WORK_LIMIT, "rwt_limit", "P/(bk)",
         "=IF(rwt_a=0,0,(ASIN(rwt_n5)/rwt_n5+rwt_cos)/SQRT(MAX(rwt_js,rwt_jb)))"),
    WORK(WORK_OK_F, "rwt_ok_f", "1: f is in the table", "=IF(rwt_ok=1,IF(rw_f<=0.8,1,0),0)"),
    WORK(WORK_OK_TIP, "rwt_ok_tip", "1: a/b is in the table",
         "=IF(OR(rwt_a=0,rwt_ratio>=0.003*(1-1E-9)),1,0)"),

    WORK(WORK_STRENGTH, "rwt_k2", "(k A/theta)^2", "=(rwt_k*rwt_comp/rwt_theta)^2"),
    YIELD_FORMULAS(WORK_YIELD_S, "rwt_s_",
                   "=" N_TIPS "-SUMPRODUCT(--(" ALL_TIPS(SURFACE) "<rwt_k2))",
                   "=" AT_TIP(SURFACE, "rwt_s_node"), "=" AT_TIP(SURFACE, "rwt_s_node+1"),
                   "=" AT_TIP(SURFACE, "rwt_s_node+2")),
    YIELD_FORMULAS(WORK_YIELD_B, "rwt_b_",
                   "=" N_TIPS "-SUMPRODUCT((" ALL_TIPS(BELOW) "<rwt_k2)*(" PRODUCT(
                       BELOW, "") "*" PRODUCT(BELOW, "+21") "*" PRODUCT(BELOW, "+42") ">0))",
                   "=" IF_THERE_1("rwt_b_node", AT_TIP(BELOW, "rwt_b_node")),
                   "=" IF_THERE_1("rwt_b_node+1", AT_TIP(BELOW, "rwt_b_node+1")),
                   "=" IF_THERE_1("rwt_b_node+2", AT_TIP(BELOW, "rwt_b_node+2"))),
    WORK(WORK_YIELD, "rwt_y", "AP/(theta a) at yield", "=MIN(rwt_s_y,rwt_b_y)"),
    WORK(WORK_BOUND, "rwt_bound", "load at the table's end over P",
         "=ROUNDDOWN(rwt_end*rwt_x,IF(rwt_end*rwt_x>=10,0,1))"),

    WORK(WORK_YIELD_T, "rwt_ty", "t at yield",
         "=IF(rwt_y<=PI()/2,0,IF(rwt_s_y<=rwt_b_y,rwt_s_t,rwt_b_t))"),
    WORK(WORK_PLACE_U, "rwt_pu", "place among the tips",
         "=(1-rwt_ty/INDEX(rwt_ts,1))*" N_PLACE_STEPS),
    WORK(WORK_PLACE_NODE, "rwt_pn", "tips before the first of three",
         "=MIN(ROUNDDOWN(rwt_pu,0)," N_PLACE_LAST "-1)"),
    WORK(WORK_WEIGHT_PLACE, "rwt_wp1", "weights of a/b at yield",
         "=(rwt_pu-rwt_pn-1)*(rwt_pu-rwt_pn-2)/2"),
    WORK(WORK_WEIGHT_PLACE + 1, "rwt_wp2", "", "=(rwt_pu-rwt_pn)*(2-rwt_pu+rwt_pn)"),
    WORK(WORK_WEIGHT_PLACE + 2, "rwt_wp3", "", "=(rwt_pu-rwt_pn)*(rwt_pu-rwt_pn-1)/2"),
    WORK(WORK_PLACE_ROW, "rwt_pr", "first row of the place",
         "=rwt_pn+1+IF(rwt_s_y<=rwt_b_y,0," N_PLACES ")"),
    WORK(WORK_PLACE_UNIT, "rwt_unit", "a, or b for Hertz, at yield",
         "=rwt_a*SQRT(MIN(1,2/PI()*rwt_y))"),

    WORK(WORK_GAPS, "rwt_gaps", "f that yield below",
         "=SUMPRODUCT((" ALL_F(SURFACE) "<" ALL_F(BELOW) ")*(" WHOLE "))"),
    WORK(WORK_GAP_NODE, "rwt_gn", "node before the cusp",
         "=IF(rwt_gaps>1,IF(SUMPRODUCT(" THERE("rwt_gaps+1", "") "*" THERE(
             "rwt_gaps+1", "+21") "*" THERE("rwt_gaps+1", "+42") ")<3,rwt_gaps-1,rwt_gaps),MAX(1,"
                                                                 "rwt_gaps))"),
    WORK(WORK_GAP_1, "rwt_g1", "surface less below there", GAP_AT("rwt_gn")),
    WORK(WORK_GAP_2, "rwt_g2", "and at the next", GAP_AT("rwt_gn+1")),
};

#define ONE_F_NU(T)                                                                                \
    "rwt_wn1*" ONE_F(T, "rwt_i", "") "+rwt_wn2*" ONE_F(T, "rwt_i",                                 \
                                                       "+21") "+rwt_wn3*" ONE_F(T, "rwt_i", "+42")

const char limit_at_tip[] =
    "=IF(rwt_ok_f=1,(ASIN(INDEX(rwt_tips,rwt_i))/INDEX(rwt_tips,rwt_i)+SQRT((1-INDEX(rwt_tips,"
    "rwt_i))*(1+INDEX(rwt_tips,rwt_i))))/SQRT(MAX(" AT_TIP(SURFACE, "rwt_i") "," IF_THERE_1(
        "rwt_i", AT_TIP(BELOW, "rwt_i")) ")),NA())";
const char limit_at_friction[] =
    "=IF(AND(rwt_ok_f=1,rwt_ok_tip=1,rwt_a>0),(ASIN(rwt_n5)/rwt_n5+rwt_cos)/"
    "SQRT(MAX(" ONE_F_NU(SURFACE) ",IF(SUMPRODUCT(" THERE("rwt_i", "") "*" THERE(
        "rwt_i", "+21") "*" THERE("rwt_i", "+42") ")=3," ONE_F_NU(BELOW) ",0))),NA())";

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "measures/catalogue.h"

#include "measures/mesoscopic.h"

#include <math.h>

/* ---- Constants ---- */

#define STRENGTH RW_SMALLEST, RW_LARGEST, NAN
#define SHARE 0, RW_LARGEST, NAN
#define EXPONENT -2, -0.01, NAN
#define NONE_UNLESS_GIVEN 0, RW_LARGEST, 0

static const rw_constant
    E = {"E", "Young's modulus", "stress", STRENGTH},
    fs_k = {"fs_k", "Fatemi and Socie's k, beside a yield stress", "none", 0, RW_LARGEST, 1},
    yield_stress = {"yield_stress", "yield stress in tension", "stress", STRENGTH},
    findley_k = {"findley_k", "Findley's k", "none", SHARE},
    kappa = {"kappa", "kappa of the modified Woehler curve", "stress", SHARE},
    lambda = {"lambda", "lambda of the modified Woehler curve", "stress", STRENGTH},
    rho_lim = {"rho_lim",
               "largest rho of the modified Woehler curve that counts; 0 for lambda/(2 kappa)",
               "none", NONE_UNLESS_GIVEN},
    t_A = {"t_A", "McDiarmid's fully reversed limit in torsion", "stress", STRENGTH},
    su = {"su", "McDiarmid's tensile strength", "stress", STRENGTH},
    crossland_alpha = {"crossland_alpha", "Crossland's share of the hydrostatic stress", "none",
                       SHARE},
    dang_van_alpha = {"dang_van_alpha", "Dang Van's share of the hydrostatic stress", "none",
                      SHARE},
    sf = {"sf", "fatigue strength coefficient", "stress", STRENGTH},
    b = {"b", "fatigue strength exponent", "none", EXPONENT},
    ef = {"ef", "fatigue ductility coefficient", "none", STRENGTH},
    c = {"c", "fatigue ductility exponent", "none", EXPONENT},
    swt_limit = {"swt_limit", "below it Smith, Watson and Topper's parameter does no damage",
                 "stress", NONE_UNLESS_GIVEN},
    G = {"G", "shear modulus", "stress", STRENGTH},
    tf = {"tf", "shear fatigue strength coefficient", "stress", STRENGTH},
    b0 = {"b0", "shear fatigue strength exponent", "none", EXPONENT},
    gf = {"gf", "shear fatigue ductility coefficient", "none", STRENGTH},
    c0 = {"c0", "shear fatigue ductility exponent", "none", EXPONENT},
    fs_limit = {"fs_limit", "below it Fatemi and Socie's parameter does no damage", "none",
                NONE_UNLESS_GIVEN};

/* ---- Measures ---- */

static const rw_measure measures[] = {
    [RWEDGE_MEASURE_STRESS_RANGE] = {.name = "stress_range",
                                     .title = "Range of the stress along the surface",
                                     .text = "largest less smallest sxx",
                                     .unit = "stress",
                                     .limit = "",
                                     .degree = 1,
                                     .of_field = rw_stress_range},
    [RWEDGE_MEASURE_SWT] = {.name = "swt",
                            .title = "Smith-Watson-Topper parameter",
                            .text = "Smith, Watson and Topper's parameter, strain amplitude",
                            .unit = "stress",
                            .limit = "swt_limit",
                            .degree = 2,
                            .of_planes = rw_smith_watson_topper,
                            .own = 1,
                            .constants = {&E, &sf, &b, &ef, &c, &swt_limit}},
    [RWEDGE_MEASURE_FATEMI_SOCIE] = {.name = "fatemi_socie",
                                     .title = "Fatemi-Socie parameter",
                                     .text =
                                         "Fatemi and Socie's, amplitude too; needs a yield stress",
                                     .unit = "none",
                                     .limit = "fs_limit",
                                     .of_planes = rw_fatemi_socie,
                                     .own = 3,
                                     .constants = {&E, &fs_k, &yield_stress, &G, &tf, &b0, &gf, &c0,
                                                   &fs_limit}},
    [RWEDGE_MEASURE_SLIP_RANGE] = {.name = "slip_range",
                                   .title = "Range of slip",
                                   .text = "largest less smallest slip",
                                   .unit = "length",
                                   .limit = ""},
    [RWEDGE_MEASURE_RUIZ_F1] = {.name = "ruiz_f1",
                                .title = "Ruiz parameter F1",
                                .text = "largest |q| * slip range",
                                .unit = "force/length",
                                .limit = ""},
    [RWEDGE_MEASURE_RUIZ_F2] = {.name = "ruiz_f2",
                                .title = "Ruiz parameter F2",
                                .text = "F1 * largest sxx; 0 in compression",
                                .unit = "force*stress/length",
                                .limit = ""},
    [RWEDGE_MEASURE_ENERGY_PER_AREA] = {.name = "energy_per_area",
                                        .title = "Energy dissipated per area",
                                        .text = "dissipated by friction in a pass of the loads",
                                        .unit = "force/length",
                                        .limit = ""},
    [RWEDGE_MEASURE_FINDLEY] = {.name = "findley",
                                .title = "Findley parameter",
                                .text =
                                    "Findley's largest shear amplitude + k largest normal stress",
                                .unit = "stress",
                                .limit = "findley_limit",
                                .degree = 1,
                                .of_planes = rw_findley,
                                .counts_mean = true,
                                .own = 1,
                                .constants = {&findley_k}},
    [RWEDGE_MEASURE_MODIFIED_WOHLER] =
        {.name = "modified_wohler",
         .title = "Modified Woehler parameter",
         .text = "shear amplitude + kappa min(normal stress/shear, rho_lim)",
         .unit = "stress",
         .limit = "lambda",
         .of_planes = rw_modified_wohler,
         .counts_mean = true,
         .own = 3,
         .constants = {&kappa, &lambda, &rho_lim}},
    [RWEDGE_MEASURE_MCDIARMID] = {.name = "mcdiarmid",
                                  .title = "McDiarmid parameter",
                                  .text = "shear amplitude/t-a + largest normal stress/(2 su)",
                                  .unit = "none",
                                  .limit = "1",
                                  .degree = 1,
                                  .of_planes = rw_mcdiarmid,
                                  .counts_mean = true,
                                  .own = 2,
                                  .constants = {&t_A, &su}},
    [RWEDGE_MEASURE_CROSSLAND] = {.name = "crossland",
                                  .title = "Crossland parameter",
                                  .text =
                                      "amplitude of sqrt(J2) + alpha largest hydrostatic stress",
                                  .unit = "stress",
                                  .limit = "crossland_limit",
                                  .degree = 1,
                                  .of_field = rw_crossland,
                                  .counts_mean = true,
                                  .own = 1,
                                  .constants = {&crossland_alpha}},
    [RWEDGE_MEASURE_DANG_VAN] = {.name = "dang_van",
                                 .title = "Dang Van parameter",
                                 .text = "largest shear amplitude + alpha hydrostatic stress",
                                 .unit = "stress",
                                 .limit = "dang_van_limit",
                                 .degree = 1,
                                 .of_field = rw_dang_van,
                                 .counts_mean = true,
                                 .own = 1,
                                 .constants = {&dang_van_alpha}},
    [RWEDGE_MEASURE_SWT_IN_PLANE] = {.name = "swt_in_plane",
                                     .title = "Smith-Watson-Topper parameter in the plane",
                                     .text = "swt of the planes that contain z",
                                     .unit = "stress",
                                     .limit = "",
                                     .degree = 2,
                                     .of_field = rw_smith_watson_topper_in_plane,
                                     .own = 1,
                                     .constants = {&E}},
    [RWEDGE_MEASURE_FATEMI_SOCIE_IN_PLANE] = {.name = "fatemi_socie_in_plane",
                                              .title = "Fatemi-Socie parameter in the plane",
                                              .text = "fatemi_socie of the planes that contain z",
                                              .unit = "none",
                                              .limit = "",
                                              .of_field = rw_fatemi_socie_in_plane,
                                              .own = 3,
                                              .constants = {&E, &fs_k, &yield_stress}},
};
enum { MEASURES = sizeof measures / sizeof measures[0] };

const rw_measure *rw_measure_of(int32_t criterion)
{
    return criterion >= 0 && criterion < MEASURES ? &measures[criterion] : NULL;
}

int rw_all_constants(const rw_measure *measure)
{
    int count = 0;
    while (count < RW_CONSTANTS && measure->constants[count])
        count++;
    return count;
}

static bool is_in_range(const rw_constant *constant, double value)
{
    return isgreaterequal(value, constant->low) && islessequal(value, constant->high) &&
           (value == 0 || fabs(value) >= RW_SMALLEST);
}

bool rw_are_constants(const rw_measure *measure, int count, const double constants[])
{
    for (int j = 0; j < count; j++)
        if (!is_in_range(measure->constants[j], constants[j]))
            return false;
    return true;
}

/* ---- What the library tells of them ---- */

int32_t rwedge_criterion_count(void)
{
    return MEASURES;
}

const char *rwedge_criterion_name(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->name : "";
}

const char *rwedge_criterion_title(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->title : "";
}

const char *rwedge_criterion_text(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->text : "";
}

const char *rwedge_criterion_unit(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->unit : "";
}

const char *rwedge_criterion_limit(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->limit : "";
}

int32_t rwedge_criterion_degree(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->degree : 0;
}

int32_t rwedge_criterion_constants(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure ? measure->own : 0;
}

int32_t rwedge_damage_constants(int32_t criterion)
{
    const rw_measure *measure = rw_measure_of(criterion);
    const int all = measure ? rw_all_constants(measure) : 0;
    return measure && all > measure->own ? all : 0;
}

/* NULL where there are not so many. */
static const rw_constant *constant_of(int32_t criterion, int32_t j)
{
    const rw_measure *measure = rw_measure_of(criterion);
    return measure && j >= 0 && j < RW_CONSTANTS ? measure->constants[j] : NULL;
}

const char *rwedge_constant_name(int32_t criterion, int32_t j)
{
    const rw_constant *constant = constant_of(criterion, j);
    return constant ? constant->name : "";
}

const char *rwedge_constant_text(int32_t criterion, int32_t j)
{
    const rw_constant *constant = constant_of(criterion, j);
    return constant ? constant->text : "";
}

const char *rwedge_constant_unit(int32_t criterion, int32_t j)
{
    const rw_constant *constant = constant_of(criterion, j);
    return constant ? constant->unit : "";
}

int32_t rwedge_constant_range(int32_t criterion, int32_t j, double *low, double *high)
{
    if (!low || !high)
        return RWEDGE_ENULL;
    if (!rw_measure_of(criterion) || j < 0)
        return RWEDGE_EDOMAIN;
    const rw_constant *constant = constant_of(criterion, j);
    if (!constant)
        return RWEDGE_EABSENT;
    *low = constant->low;
    *high = constant->high;
    return RWEDGE_OK;
}

double rwedge_constant_usual(int32_t criterion, int32_t j)
{
    const rw_constant *constant = constant_of(criterion, j);
    return constant ? constant->usual : NAN;
}

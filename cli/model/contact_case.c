/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <math.h>

static const double RADIANS_PER_DEGREE = 0.017453292519943295;

/* What may be needed; some have an alternative. */
static const int ways[] = {INPUT_E1, INPUT_NU1, INPUT_THETA, INPUT_A, INPUT_P, INPUT_F, INPUT_K};
/* Inputs of different shapes, and moment and tilt, which exclude each other. */
static const struct {
    int input, alternative;
} shapes[] = {
    {INPUT_THETA, INPUT_FLAT},     {INPUT_THETA_DEG, INPUT_FLAT},    {INPUT_A, INPUT_FLAT},
    {INPUT_THETA, INPUT_PROFILE},  {INPUT_THETA_DEG, INPUT_PROFILE}, {INPUT_A, INPUT_PROFILE},
    {INPUT_RADIUS, INPUT_PROFILE}, {INPUT_FLAT, INPUT_PROFILE},      {INPUT_A, INPUT_RADIUS1},
    {INPUT_RADIUS, INPUT_RADIUS1}, {INPUT_PROFILE, INPUT_RADIUS1},   {INPUT_A, INPUT_RADIUS2},
    {INPUT_RADIUS, INPUT_RADIUS2}, {INPUT_PROFILE, INPUT_RADIUS2},   {INPUT_M, INPUT_TILT},
};
enum { WAY_COUNT = sizeof ways / sizeof ways[0] };

static bool excluded(const input_texts *texts, int input, int alternative, complaint *why)
{
    char number[NUMBER_SIZE];
    return complain(why, "%s %.60s: given together with %s; allowed: one of the two",
                    input_name(texts, alternative), input_text(texts, alternative, number),
                    input_name(texts, input));
}

static bool has_radius(const input_texts *texts)
{
    return input_is_given(texts, INPUT_RADIUS) || input_is_given(texts, INPUT_RADIUS1);
}

/* A radius is that of a cylinder where no angle is given. */
static bool needs_of_shape(const input_texts *texts, int input)
{
    const bool has_profile = input_is_given(texts, INPUT_PROFILE);
    if (input == INPUT_A || has_profile || input_is_given(texts, INPUT_FLAT))
        return input == INPUT_A && !has_profile && !input_is_given(texts, INPUT_RADIUS1);
    return !has_radius(texts);
}

static bool is_needed(const input_texts *texts, int input, case_needs needs)
{
    if (input == INPUT_K)
        return false;
    if (input == INPUT_THETA || input == INPUT_A)
        return needs_of_shape(texts, input);
    if (input == INPUT_P)
        return needs == CASE_WITH_LOADS || needs == CASE_OF_SOLVE;
    if (input == INPUT_F && needs == CASE_OF_HISTORY)
        return true;
    if (input == INPUT_F)
        return needs == CASE_OF_SOLVE &&
               (input_is_given(texts, INPUT_Q) || input_is_given(texts, INPUT_SIGMA) ||
                input_is_given(texts, INPUT_K) || input_is_given(texts, INPUT_YIELD_STRESS));
    return true;
}

/* Adds it to the list of what is missing. */
static void add_missing(const input_texts *texts, int input, complaint *why)
{
    const int other = input_alternative(input);
    const bool is_flat = input == INPUT_A && input_is_given(texts, INPUT_FLAT);
    const bool two = other >= 0 && !is_flat;
    list_add(why->text, sizeof why->text, why->text[0] == '\0' ? "" : ", ", "%s%s%s%s",
             why->text[0] == '\0' ? "missing: " : "", input_name(texts, is_flat ? other : input),
             two ? " or " : "", two ? input_name(texts, other) : "");
}

/* Body 2 is given whole or not at all: a guess would look like a result. */
static bool second_body_is_whole(const input_texts *texts, complaint *why)
{
    const bool E2 = input_is_given(texts, INPUT_E2), nu2 = input_is_given(texts, INPUT_NU2);
    if (E2 == nu2)
        return true;
    double value;
    char number[NUMBER_SIZE];
    if (E2 && !input_read(texts, INPUT_E2, &value, why))
        return false;
    if (E2 && isinf(value)) /* a rigid body has no Poisson's ratio */
        return true;
    const int there = E2 ? INPUT_E2 : INPUT_NU2, absent = E2 ? INPUT_NU2 : INPUT_E2;
    return complain(
        why, "%s %.60s: needs %s; allowed: both, or neither for two bodies of one material",
        input_name(texts, there), input_text(texts, there, number), input_name(texts, absent));
}

/* A pad that is held by a rig has no moment of its own, and its tilt is not free. */
static bool rotation_fits(const input_texts *texts, complaint *why)
{
    const int input = texts->rotation == ROTATION_HELD   ? INPUT_M
                      : texts->rotation == ROTATION_FREE ? INPUT_TILT
                                                         : INPUT_COUNT;
    char number[NUMBER_SIZE];
    return input == INPUT_COUNT || !input_is_given(texts, input) ||
           complain(why,
                    "%s %.60s: given together with a rotation that is %s; allowed: one of the two",
                    input_name(texts, input), input_text(texts, input, number),
                    input == INPUT_M ? "held" : "free");
}

/* Neither is a guess: a plane has no radius. */
static bool radii_are_two(const input_texts *texts, complaint *why)
{
    const bool first = input_is_given(texts, INPUT_RADIUS1),
               second = input_is_given(texts, INPUT_RADIUS2);
    const int there = first ? INPUT_RADIUS1 : INPUT_RADIUS2,
              absent = first ? INPUT_RADIUS2 : INPUT_RADIUS1;
    return first == second ||
           complain(why, "%s %.60s: needs %s; of a body that is plane, the other's is %s alone",
                    input_name(texts, there), texts->text[there], input_name(texts, absent),
                    input_kinds[INPUT_RADIUS].column);
}

bool case_is_complete(const input_texts *texts, case_needs needs, complaint *why)
{
    bool cells = false, friction = false;
    why->text[0] = '\0';
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++)
        if (input_is_given(texts, shapes[i].input) && input_is_given(texts, shapes[i].alternative))
            return excluded(texts, shapes[i].input, shapes[i].alternative, why);
    for (int i = 0; i < WAY_COUNT; i++) {
        const int input = ways[i], other = input_alternative(input);
        const bool is_given = input_is_given(texts, input);
        const bool is_given_otherwise = other >= 0 && input_is_given(texts, other);
        if (is_given && is_given_otherwise)
            return excluded(texts, input, other, why);
        if (is_given || is_given_otherwise || !is_needed(texts, input, needs))
            continue;
        add_missing(texts, input, why);
        cells = cells || texts->is_cell[input];
        friction = friction || input == INPUT_F;
    }
    if (friction)
        list_add(why->text, sizeof why->text, "; ", "friction has no default %s",
                 needs == CASE_OF_HISTORY ? "here" : "where Q, sigma or a yield stress is given");
    if (cells && texts->where_else != NULL)
        list_add(why->text, sizeof why->text, "; ", "allowed: %s", texts->where_else);
    return why->text[0] == '\0' && radii_are_two(texts, why) && second_body_is_whole(texts, why) &&
           rotation_fits(texts, why);
}

static double either(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

double case_radius(double radius1, double radius2)
{
    return 1 / (1 / radius1 + 1 / radius2);
}

static const double usual_tolerance_of_unlike = 1e-3;

double case_tolerance(const input_texts *texts, bool is_coupled)
{
    return either(texts->tolerance, is_coupled ? usual_tolerance_of_unlike : usual_tolerance);
}

/* Whether there is anything to neglect. */
static bool is_coupled(const contact_case *setup)
{
    return (rwedge_validity(NAN, NAN, setup->beta, setup->f, NAN, NAN) & RWEDGE_DOUBT_COUPLING) !=
           0;
}

/* But for the shape of a profile. In plane stress nothing else depends on Poisson's ratio. */
static void fill(const input_texts *texts, const double value[INPUT_COUNT], contact_case *setup)
{
    const double radius =
        either(value[INPUT_RADIUS], case_radius(value[INPUT_RADIUS1], value[INPUT_RADIUS2]));
    const double theta = either(value[INPUT_THETA], value[INPUT_THETA_DEG] * RADIANS_PER_DEGREE);
    setup->E1 = value[INPUT_E1];
    setup->nu1 = value[INPUT_NU1];
    setup->E2 = either(value[INPUT_E2], setup->E1);
    setup->nu2 = either(value[INPUT_NU2], setup->nu1); /* of no effect where body 2 is rigid */
    setup->shape = !isnan(value[INPUT_FLAT]) ? pad_flat(value[INPUT_FLAT], radius)
                   : isnan(theta)
                       ? pad_cylinder(radius)
                       : pad_wedge(theta, either(value[INPUT_A], rwedge_rounding(theta, radius)));
    setup->P = either(value[INPUT_P], 0);
    setup->M = either(value[INPUT_M], 0);
    setup->Q = either(value[INPUT_Q], 0);
    setup->sigma = either(value[INPUT_SIGMA], 0);
    setup->f = either(value[INPUT_F], 0);
    setup->rotation = texts->rotation;
    setup->is_held = !isnan(value[INPUT_TILT]) || setup->rotation == ROTATION_HELD;
    setup->tilt = either(value[INPUT_TILT], 0);
    setup->k = either(value[INPUT_K], value[INPUT_YIELD_STRESS] / SQRT_3);
    setup->beta =
        texts->is_plane_stress
            ? rwedge_dundurs_beta_plane_stress(setup->E1, setup->nu1, setup->E2, setup->nu2)
            : rwedge_dundurs_beta(setup->E1, setup->nu1, setup->E2, setup->nu2);
    if (texts->is_plane_stress)
        setup->nu1 = setup->nu2 = 0;
    setup->A = rwedge_compliance(setup->E1, setup->nu1, setup->E2, setup->nu2);
    setup->is_coupled = is_coupled(setup) && !texts->takes_as_similar;
    setup->tolerance = case_tolerance(texts, setup->is_coupled);
    setup->is_plane_stress = texts->is_plane_stress;
}

int32_t case_contact(const contact_case *setup, rwedge_contact **contact)
{
    /* how much a tension stretches body 1; of two bodies of one material it is the library's A/4 */
    const double own_strain = (1 - setup->nu1 * setup->nu1) / setup->E1;
    int32_t status = pad_contact(&setup->shape, setup->A, setup->f, contact);
    if (status == RWEDGE_OK && (setup->E2 != setup->E1 || setup->nu2 != setup->nu1))
        status = rwedge_contact_set_strain(*contact, own_strain);
    if (status == RWEDGE_OK && setup->is_coupled)
        status = rwedge_contact_set_beta(*contact, setup->beta);
    if (status == RWEDGE_OK)
        status = rwedge_contact_allow_error(*contact, setup->tolerance);
    if (status == RWEDGE_OK && setup->is_held)
        status = loads_hold(setup->tilt, *contact);
    return status;
}

/* A pad that is held and one that is free swing to opposite sides: a default would be a guess. */
static bool rotation_is_known(const input_texts *texts, const contact_case *setup, complaint *why)
{
    return !setup->is_coupled || setup->is_held || setup->rotation != ROTATION_UNSAID ||
           complain(why,
                    "unlike bodies, Dundurs' beta %.3g, with friction: whether the pad may turn "
                    "must be said; %s",
                    setup->beta, texts->how_rotation);
}

/* Results beyond the range of numbers are refused later. */
static bool apply_loads(const input_texts *texts, contact_case *setup, complaint *why)
{
    const load to = {.P = setup->P, .M = setup->M, .Q = setup->Q, .sigma = setup->sigma};
    char number[NUMBER_SIZE];
    setup->status = loads_apply_monotonic(to, setup->contact);
    if (setup->status == RWEDGE_OK)
        setup->M = loads_of(setup->contact).M; /* of a held pad it is a result */
    if (setup->status == RWEDGE_OK)
        return true;
    const load_fault fault = loads_fault(setup->status, to, setup->f, setup->contact);
    setup->at_fault = fault.input;
    if (fault.input == INPUT_COUNT)
        return true;
    if (!input_is_given(texts, fault.input)) /* the path has no one to blame */
        return complain(why, "the loads: %s", fault.why.text);
    const bool lacks_friction = fault.input == INPUT_Q && !input_is_given(texts, INPUT_F);
    return complain(why, "%s %.60s: %s%s", input_name(texts, fault.input),
                    input_text(texts, fault.input, number), fault.why.text,
                    lacks_friction ? "; f is missing" : "");
}

bool case_read(const input_texts *texts, case_needs needs, contact_case *setup, complaint *why)
{
    double value[INPUT_COUNT];
    char number[NUMBER_SIZE];
    *setup = (contact_case){.at_fault = INPUT_COUNT};
    if (!case_is_complete(texts, needs, why))
        return false;
    for (int i = 0; i < INPUT_COUNT; i++) {
        value[i] = NAN;
        if (input_is_given(texts, i) && !input_read(texts, i, &value[i], why))
            return false;
    }
    const double R1 = value[INPUT_RADIUS1], R2 = value[INPUT_RADIUS2];
    if (!isnan(R1) && !isnan(R2) && !(1 / R1 + 1 / R2 > 0 && isfinite(1 / R1 + 1 / R2)))
        return complain(why,
                        "%s %.6g, %s %.6g: 1/R1 + 1/R2 must be above 0: a concave body has "
                        "the larger radius, and neither is 0",
                        input_name(texts, INPUT_RADIUS1), R1, input_name(texts, INPUT_RADIUS2), R2);
    fill(texts, value, setup);
    if (!rotation_is_known(texts, setup, why))
        return false;
    if (input_is_given(texts, INPUT_PROFILE))
        setup->shape = pad_of_profile(texts->profile_named(texts->text[INPUT_PROFILE], why));
    if (setup->shape.kind != PAD_WEDGE && setup->shape.radius == 0) /* only its tip may be sharp */
        return complain(why, "%s %.60s: the radius must be a number above 0%s",
                        input_name(texts, INPUT_RADIUS), input_text(texts, INPUT_RADIUS, number),
                        setup->shape.kind == PAD_CYLINDER ? ", or an angle is missing" : "");
    setup->status = case_contact(setup, &setup->contact);
    if (setup->status == RWEDGE_EDOMAIN && setup->is_held && setup->contact != NULL)
        return complain(why, "%s %.60s: so large a tilt lays a flank on the surface",
                        input_name(texts, INPUT_TILT), input_text(texts, INPUT_TILT, number));
    if (setup->status == RWEDGE_EDOMAIN)
        return complain(
            why,
            "the moduli and the rounding are so large or small that results leave 1e-60 to 1e60");
    return setup->status != RWEDGE_OK ||
           (apply_loads(texts, setup, why) &&
            (setup->status != RWEDGE_OK || loads_spare_flanks(&setup->shape, setup->contact, why)));
}

double case_peak_pressure(const contact_case *setup, const pad_profile *places)
{
    contact_case other = *setup;
    double pressure = NAN, x;
    other.shape = pad_of_profile(places);
    other.contact = NULL;
    other.is_coupled = false;
    if (case_contact(&other, &other.contact) == RWEDGE_OK &&
        loads_apply((load){.P = setup->P, .M = setup->M}, other.contact) == RWEDGE_OK)
        rwedge_contact_peak_pressure(other.contact, &pressure, &x);
    rwedge_contact_destroy(other.contact);
    return pressure;
}

double case_shear_ratio(const contact_case *setup)
{
    const double limit = setup->f * setup->P;
    return setup->Q == 0 || limit == 0 ? 0 : fmax(-1, fmin(1, setup->Q / limit));
}

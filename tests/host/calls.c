/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "calls.h"

#include "rwedge.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* ---- Arguments ---- */

static bool is_positive(double v)
{
    return isfinite(v) && v >= 1e-60 && v <= 1e60;
}

/* What the header's first page says. */
static bool is_magnitude(double v)
{
    return v == 0 || is_positive(v);
}

static bool is_between(double v, double least, double most)
{
    return isfinite(v) && v >= least && v <= most;
}

static bool is_of_kind(char kind, double v)
{
    switch (kind) {
    case 'a': /* a/b */
    case 'y': /* depth */
    case 'w': /* a length, a load, a friction of dimensional quantities */
        return is_magnitude(v);
    case 't': /* a/b where strength is concerned */
        return is_magnitude(v) && (v == 0 || v >= 1e-14);
    case '+': /* a stress, a compliance */
        return is_positive(v);
    case 'l': /* A P/(theta a) */
        return isfinite(v) && v > 0;
    case 'f': /* friction */
        return is_magnitude(v) && v <= 1e6;
    case 'n': /* Poisson's ratio of the half-plane */
        return is_between(v, 0, 0.5);
    case 'm': /* Poisson's ratio of a body */
        return isfinite(v) && v > -1 && v <= 0.5;
    case 'c': /* a stick zone */
        return is_magnitude(v) && v <= 1;
    case 'q': /* a ratio of loads */
        return is_between(v, 0, 1);
    case 'h': /* the angle theta */
        return is_positive(v) && v < 1.57079632679489661923;
    case 'E': /* Young's modulus */
        return is_positive(v) || v == INFINITY;
    case 'i': /* the number of a coefficient */
        return v >= 0;
    case 'g': /* a given stress */
        return isfinite(v) && fabs(v) <= 1e60;
    case 's': /* the factor of a sample */
        return isfinite(v);
    case 'z': /* a status */
    case 'r': /* a tangential force over f P: it may be refused */
    case 'v': /* any number */
        return true;
    default: /* 'x', a coordinate */
        return is_magnitude(fabs(v));
    }
}

static const double anything[] = {
    0,         -0.0,
    5e-324,    1e-310,
    1e-200,    9.9e-61,
    1e-60,     3e-60,
    1e-40,     1e-16,
    1e-14,     9.9e-15,
    3e-9,      1e-6,
    1e-3,      0.01,
    0.1,       0.25,
    0.3,       0.5,
    0.9999,    1 - DBL_EPSILON / 2,
    1,         1 + DBL_EPSILON,
    1.5,       2,
    2.5,       100,
    1e5,       1e6,
    1.1e8,     1e10,
    1e18,      1e30,
    1e60,      1.1e60,
    1e200,     DBL_MAX,
    INFINITY,  NAN,
    -5e-324,   -1e-300,
    -1e-60,    -1e-9,
    -0.3,      -0.9999,
    -1,        -2,
    -1e9,      -DBL_MAX,
    -INFINITY,
};
static const double fractions[] = {
    0,
    -0.0,
    5e-324,
    1e-200,
    1e-60,
    1e-16,
    1e-8,
    0.1,
    0.25,
    0.3,
    0.3605,
    0.49,
    0.5 - 1e-9,
    0.5 - DBL_EPSILON / 4,
    0.5,
    0.5 + DBL_EPSILON,
    0.9999,
    1 - DBL_EPSILON / 2,
    1,
    1 + DBL_EPSILON,
    2,
    DBL_MAX,
    INFINITY,
    NAN,
    -5e-324,
    -0.3,
    -1 + DBL_EPSILON,
    -1,
    -INFINITY,
};
static const double numbers[] = {0,     1,       2,          3,         7,  50,       1001,
                                 65535, 1 << 20, 1073741823, INT32_MAX, -1, INT32_MIN};

static const double *edges(char kind, size_t *count)
{
    if (strchr("ncqm", kind) != NULL) {
        *count = COUNT(fractions);
        return fractions;
    }
    if (kind == 'i' || kind == 'z') {
        *count = COUNT(numbers);
        return numbers;
    }
    *count = COUNT(anything);
    return anything;
}

size_t edge_count(char kind)
{
    size_t count;
    edges(kind, &count);
    return count;
}

double edge(char kind, size_t i)
{
    size_t count;
    return edges(kind, &count)[i];
}

/* A product that raises no exception of its own; volatile, for else clang converts it before it
 * looks whether it may. */
static double product(double a, double b, double c)
{
    if (!isfinite(a) || !isfinite(b) || !isfinite(c))
        return NAN;
    const volatile long double exact = (long double)a * b * c;
    return exact > DBL_MAX ? INFINITY : exact < -DBL_MAX ? -INFINITY : (double)exact;
}

/* ---- Pure formulas ---- */

static int32_t value(double got, double out[])
{
    if (isnan(got))
        return RWEDGE_EDOMAIN;
    out[0] = got;
    return RWEDGE_OK;
}

#define CALL(name, ...)                                                                            \
    static int32_t name(const double v[], double out[])                                            \
    {                                                                                              \
        return value(rwedge_##name(__VA_ARGS__), out);                                             \
    }
#define FORMULA_1(name) CALL(name, v[0])
#define FORMULA_2(name) CALL(name, v[0], v[1])
#define FORMULA_3(name) CALL(name, v[0], v[1], v[2])
#define FORMULA_4(name) CALL(name, v[0], v[1], v[2], v[3])

FORMULA_4(compliance)
FORMULA_4(dundurs_beta)
FORMULA_1(load)
FORMULA_1(a_over_b)
FORMULA_2(pressure)
FORMULA_1(peak_pressure)
FORMULA_1(transition_pressure)
FORMULA_2(stick_width)
FORMULA_2(shear_ratio)
FORMULA_3(shear)
FORMULA_1(max_tension)
FORMULA_3(elastic_limit)
FORMULA_2(critical_friction)
FORMULA_2(radius)
FORMULA_2(rounding)
FORMULA_4(half_width)
FORMULA_4(normal_load)
FORMULA_4(von_mises)
FORMULA_3(out_of_plane_stress)
FORMULA_4(largest_shear)

static int32_t coefficient(const double v[], double out[])
{
    return value(rwedge_coefficient(v[0], (int32_t)v[1]), out);
}

static int32_t yield_load(const double v[], double out[])
{
    return value(rwedge_yield_load(v[0], v[1], v[2], v[3], v[4], v[5]), out);
}

/* Here and below: in long double, which neither overflows nor raises anything on the way. */
static long double share(double E, double nu)
{
    return isinf(E) ? 0 : 2 * (1 - (long double)nu) * (1 + (long double)nu) / E;
}

static bool has_compliance(const double v[])
{
    const long double A = share(v[0], v[1]) + share(v[2], v[3]);
    return A >= 1e-60 && A <= 1e60;
}

static bool has_radius(const double v[])
{
    return is_magnitude(v[1] / v[0]);
}

static bool has_rounding(const double v[])
{
    return is_magnitude(v[1] * v[0]);
}

static bool has_a_over_b(const double v[])
{
    return v[0] < 1 ? v[0] >= 1.5708e-120 : v[0] <= 2e60;
}

/* Whether a contact of that size is in the domain. */
static bool is_size(double a, double b)
{
    return is_positive(b) && is_magnitude(a / b);
}

/* v: theta, a, A, P. */
static bool has_half_width(const double v[])
{
    const double a = v[1], length = v[2] * v[3] / v[0];
    if (length == 0)
        return true;
    if (length < 1.57 * a)
        return is_size(a, sqrt(length / 1.57079632679489662 * a));
    return is_size(a, length < 1e30 * a ? a / rwedge_a_over_b(length / a) : length / 2);
}

/* v: theta, a, A, b. */
static bool has_load(const double v[])
{
    const double a = v[1], b = v[3], width = v[0] / v[2] * b;
    if (b == 0)
        return true;
    return is_size(a, b) && is_magnitude(width * rwedge_load(a / b));
}

static bool is_not_sharp(const double v[])
{
    return v[0] > 0;
}

static bool is_not_apex_of_surface(const double v[])
{
    return v[0] > 0 || v[1] != 0;
}

static bool is_not_apex_of_shear(const double v[])
{
    return v[0] > 0 || v[1] > 0 || v[2] != 0;
}

/* ---- Texts ---- */

static int32_t version(const double v[], double out[])
{
    (void)v;
    out[0] = strcmp(rwedge_version(), RWEDGE_VERSION) == 0 ? 0 : NAN;
    return RWEDGE_OK;
}

static int32_t texts(const double v[], double out[])
{
    const char *text = rwedge_strerror((int32_t)v[0]);
    out[0] = text != NULL && text[0] != '\0' ? 0 : NAN;
    return RWEDGE_OK;
}

/* ---- Validity ---- */

static int32_t validity(const double v[], double out[])
{
    return value(rwedge_validity(v[0], v[1], v[2], v[3], v[4], v[5]), out);
}

static int32_t validity_text(const double v[], double out[])
{
    const char *text = rwedge_validity_text((int32_t)v[0]);
    out[0] = text != NULL && strlen(text) < 100 ? 0 : NAN;
    return RWEDGE_OK;
}

/* ---- Stresses and strength ---- */

static int32_t stress(const double v[], double out[])
{
    return rwedge_stress(v[0], v[1], v[2], v[3], v[4], &out[0], &out[1], &out[2]);
}

/* Three points, in and beside the contact and far away, the outputs in place of the inputs where
 * there is room. */
static int32_t stresses(const double v[], double out[])
{
    const double x[] = {v[3], -v[3], v[3] / 3}, y[] = {v[4], v[4], v[4] / 3};
    return rwedge_stresses(v[0], v[1], v[2], 3, x, y, &out[0], &out[3], &out[6]);
}

static bool is_not_apex(const double v[])
{
    return v[0] > 0 || v[3] != 0 || v[4] != 0;
}

static bool are_points(const double v[])
{
    return is_not_apex(v) && is_magnitude(fabs(v[3] / 3)) && is_magnitude(v[4] / 3);
}

static int32_t elastic_limits(const double v[], double out[])
{
    const double alpha[] = {v[0], v[0]}, f[] = {v[1], 0};
    return rwedge_elastic_limits(2, alpha, f, v[2], out);
}

static int32_t yield_point(const double v[], double out[])
{
    return rwedge_yield_point(v[0], v[1], v[2], &out[0], &out[1], &out[2]);
}

static int32_t subsurface_yield(const double v[], double out[])
{
    return rwedge_subsurface_yield(v[0], v[1], v[2], &out[0], &out[1], &out[2]);
}

static int32_t surface_yield(const double v[], double out[])
{
    return rwedge_surface_yield(v[0], v[1], v[2], &out[0], &out[1]);
}

/* ---- A contact after two loads ---- */

enum { SEEN = 12 };

static int32_t look(const rwedge_contact *contact, const double v[], double out[])
{
    double seen[SEEN];
    const double x = v[8], y = v[9], b = rwedge_contact_half_width(contact);
    seen[0] = b;
    seen[1] = rwedge_contact_stick_half_width(contact);
    seen[2] = rwedge_contact_dissipated_energy(contact);
    seen[3] = (double)rwedge_contact_memory(contact);
    int32_t status = rwedge_contact_tractions(contact, 1, &x, &seen[4], &seen[5]);
    if (status == RWEDGE_OK)
        status = rwedge_contact_stresses(contact, 1, &x, &y, &seen[6], &seen[7], &seen[8]);
    const double inside = isfinite(x) && fabs(x) <= b ? x : b / 2;
    if (status == RWEDGE_OK)
        status = rwedge_contact_slip(contact, 1, &inside, &seen[9]);
    seen[10] = seen[11] = 0;
    if (status == RWEDGE_OK)
        memcpy(out, seen, sizeof seen);
    return status;
}

/* v: theta, a, A, f, P, Q/(fP), P, Q/(fP), x, y. */
static int32_t contact(const double v[], double out[])
{
    rwedge_contact *made = NULL, *copy = NULL;
    int32_t status = rwedge_contact_create(v[0], v[1], v[2], v[3], &made);
    for (int i = 4; i < 8 && status == RWEDGE_OK; i += 2)
        status = rwedge_contact_load(made, v[i], product(v[3], v[i], v[i + 1]));
    if (status == RWEDGE_OK)
        status = rwedge_contact_copy(made, &copy);
    if (status == RWEDGE_OK)
        status = look(copy, v, out);
    rwedge_contact_destroy(copy);
    rwedge_contact_destroy(made);
    return status;
}

/* v: theta, a, A, f, P, M/(P b), Q/(fP), part of the largest tension. First no Q and no tension. */
static int32_t off_centre(const double v[], double out[])
{
    double edges[4], state[256], stress[3], loads[4];
    rwedge_contact *made = NULL, *restored = NULL;
    int32_t status = rwedge_contact_create(v[0], v[1], v[2], v[3], &made);
    const double M = product(v[5], v[4], rwedge_half_width(v[0], v[1], v[2], v[4]));
    const double Q = product(v[3], v[4], v[6]);
    if (status == RWEDGE_OK)
        status = rwedge_contact_apply(made, v[4], M, 0, 0);
    const double largest = rwedge_contact_largest_tension_step(made, Q);
    const double sigma = isinf(largest) ? v[7] : product(largest, v[7], 1), x = 0, y = 1;
    const bool is_obstructed = *rwedge_contact_obstacle(made, v[4], M, Q, sigma) != '\0';
    if (status == RWEDGE_OK)
        status = rwedge_contact_stress_history(made, 1, &v[4], &M, &Q, &sigma, 1, &x, &y,
                                               &stress[0], &stress[1], &stress[2]);
    if (is_obstructed && status == RWEDGE_OK)
        status = RWEDGE_ENOCONV; /* which is not allowed */
    if (status == RWEDGE_OK)
        status = rwedge_contact_loads(made, &loads[0], &loads[1], &loads[2], &loads[3]);
    if (status == RWEDGE_OK)
        status = rwedge_contact_edges(made, &edges[0], &edges[1]);
    if (status == RWEDGE_OK)
        status = rwedge_contact_stick_zone(made, &edges[2], &edges[3]);
    if (status == RWEDGE_OK)
        status = rwedge_contact_edge_asymptotes(made, &loads[0], &loads[1], &loads[2], &loads[3]);
    if (status == RWEDGE_OK)
        status = rwedge_permanent_stick(v[0], v[1], v[2], v[3], v[4], M, 0, 0, v[4], M, Q, sigma,
                                        &loads[0], &loads[1]);
    const size_t n = rwedge_contact_state_size(made);
    if (status == RWEDGE_OK)
        status = n <= 256 ? rwedge_contact_state(made, n, state) : RWEDGE_ENOCONV;
    if (status == RWEDGE_OK)
        status = rwedge_contact_restore(n, state, &restored);
    if (status == RWEDGE_OK) {
        memcpy(out, edges, sizeof edges);
        out[4] = rwedge_contact_tilt(restored);
    }
    rwedge_contact_destroy(restored);
    rwedge_contact_destroy(made);
    return status;
}

/* v: theta, a, A, f, P, Q/(fP), nu, k. */
static int32_t yield_factor(const double v[], double out[])
{
    rwedge_contact *made = NULL;
    int32_t status = rwedge_contact_create(v[0], v[1], v[2], v[3], &made);
    if (status == RWEDGE_OK)
        status = rwedge_contact_load(made, v[4], 0);
    if (status == RWEDGE_OK)
        status = rwedge_contact_load(made, v[4], product(v[3], v[4], v[5]));
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(made, v[6], v[7], &out[0], &out[1], &out[2]);
    rwedge_contact_destroy(made);
    return status;
}

/* ---- Measures of a stress ---- */

static int32_t principal_stresses(const double v[], double out[])
{
    return rwedge_principal_stresses(v[0], v[1], v[2], &out[0], &out[1], &out[2]);
}

enum { LOADS = 3 };

/* v: one stress, as if it came to and fro and with its components exchanged. At two points the
 * loads are the same, in another order. */
typedef struct {
    double sxx[2 * LOADS], syy[2 * LOADS], txy[2 * LOADS];
} cycle;

static cycle cycle_of(const double v[], int points)
{
    cycle c;
    for (int i = 0; i < LOADS; i++)
        for (int j = 0; j < points; j++) {
            const int load = (i + j) % LOADS;
            c.sxx[i * points + j] = load == 0 ? v[0] : load == 1 ? -v[0] : v[1];
            c.syy[i * points + j] = load == 0 ? v[1] : load == 1 ? -v[1] : v[2];
            c.txy[i * points + j] = load == 0 ? v[2] : load == 1 ? -v[2] : v[0];
        }
    return c;
}

static int32_t smith_watson_topper(const double v[], double out[])
{
    const cycle c = cycle_of(v, 1);
    return rwedge_smith_watson_topper(LOADS, c.sxx, c.syy, c.txy, v[3], v[4], &out[0], &out[1]);
}

static int32_t smith_watson_topper_field(const double v[], double out[])
{
    const cycle c = cycle_of(v, 2);
    return rwedge_smith_watson_topper_field(LOADS, 2, c.sxx, c.syy, c.txy, v[3], v[4], &out[0],
                                            &out[2]);
}

static int32_t fatemi_socie(const double v[], double out[])
{
    const cycle c = cycle_of(v, 1);
    return rwedge_fatemi_socie(LOADS, c.sxx, c.syy, c.txy, v[3], v[4], v[5], &out[0], &out[1]);
}

static int32_t fatemi_socie_field(const double v[], double out[])
{
    const cycle c = cycle_of(v, 2);
    return rwedge_fatemi_socie_field(LOADS, 2, c.sxx, c.syy, c.txy, v[3], v[4], v[5], &out[0],
                                     &out[2]);
}

/* ---- The series ---- */

/* The pressure, potential and stress, and then the residual and two coefficients. */
static int32_t sum_up(const rwedge_series *series, double f, double x, double y, double out[])
{
    double sums[9];
    sums[0] = rwedge_series_pressure(series, x);
    sums[1] = rwedge_series_coefficient(series, 0);
    sums[2] = rwedge_series_coefficient(series, rwedge_series_terms(series));
    sums[3] = isinf(rwedge_series_residual(series)) ? 0 : rwedge_series_residual(series);
    int32_t status = rwedge_series_potential(series, f, x, y, &sums[4], &sums[5]);
    if (status == RWEDGE_OK)
        status = rwedge_series_stress(series, f, x, y, &sums[6], &sums[7], &sums[8]);
    if (status == RWEDGE_OK)
        memcpy(out, sums, sizeof sums);
    return status;
}

/* v: alpha, terms, f, x, y. */
static int32_t series_create(const double v[], double out[])
{
    const int32_t terms = v[1] > 1001 ? INT32_MAX : (int32_t)v[1]; /* more would take seconds */
    rwedge_series *series = NULL;
    int32_t status = rwedge_series_create(v[0], terms, &series);
    if (status == RWEDGE_OK)
        status = sum_up(series, v[2], v[3], v[4], out);
    rwedge_series_destroy(series);
    return status;
}

enum { SAMPLES = 24, TERMS = 7 };

/* v: alpha, a factor of the pressure, f, x, y. */
static int32_t series_fit(const double v[], double out[])
{
    double at[SAMPLES], p[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        at[i] = cos((i + 0.5) * 3.14159265358979323846 / SAMPLES);
        p[i] = product(rwedge_pressure(v[0], at[i]), v[1], 1);
    }
    rwedge_series *series = NULL;
    int32_t status = rwedge_series_fit(SAMPLES, at, p, TERMS, &series);
    if (status == RWEDGE_OK)
        status = sum_up(series, v[2], v[3], v[4], out);
    rwedge_series_destroy(series);
    return status;
}

/* ---- All of them ---- */

#define BIT(status) (1u << (status))
#define BY_STATUS(name, kinds, outputs, allowed, also)                                             \
    {                                                                                              \
#name, kinds, outputs, false, allowed, name, also                                          \
    }
#define FORMULA(name, kinds, also)                                                                 \
    {                                                                                              \
#name, kinds, 1, false, 0, name, also                                                      \
    }

const public_call public_calls[] = {
    FORMULA(version, "", NULL),
    {"strerror", "z", 1, false, 0, texts, NULL},
    FORMULA(compliance, "EmEm", has_compliance),
    FORMULA(dundurs_beta, "EmEm", has_compliance),
    FORMULA(load, "a", NULL),
    FORMULA(a_over_b, "l", has_a_over_b),
    FORMULA(pressure, "ax", is_not_apex_of_surface),
    FORMULA(peak_pressure, "a", is_not_sharp),
    FORMULA(transition_pressure, "a", is_not_sharp),
    FORMULA(coefficient, "ai", NULL),
    FORMULA(stick_width, "aq", NULL),
    FORMULA(shear_ratio, "ac", NULL),
    FORMULA(shear, "acx", is_not_apex_of_shear),
    BY_STATUS(stress, "afcxy", 3, 0, is_not_apex),
    BY_STATUS(stresses, "afcxy", 9, 0, are_points),
    FORMULA(max_tension, "a", NULL),
    FORMULA(elastic_limit, "tfn", NULL),
    BY_STATUS(elastic_limits, "tfn", 2, 0, NULL),
    BY_STATUS(yield_point, "tfn", 3, 0, NULL),
    BY_STATUS(subsurface_yield, "tfn", 3, BIT(RWEDGE_EABSENT), NULL),
    BY_STATUS(surface_yield, "tfn", 2, BIT(RWEDGE_EABSENT), NULL),
    FORMULA(critical_friction, "tn", NULL),
    FORMULA(validity, "vvvvvv", NULL),
    FORMULA(validity_text, "z", NULL),
    FORMULA(radius, "hw", has_radius),
    FORMULA(rounding, "hw", has_rounding),
    FORMULA(half_width, "hw+w", has_half_width),
    FORMULA(normal_load, "hw+w", has_load),
    {"yield_load", "hw+fn+", 1, true, BIT(RWEDGE_EDOMAIN), yield_load, NULL},
    BY_STATUS(contact, "hw+fwrwrxy", SEEN,
              BIT(RWEDGE_ERANGE) | BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ESLIDING), NULL),
    BY_STATUS(off_centre, "hw+fwrrr", 5,
              BIT(RWEDGE_ERANGE) | BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ESLIDING) |
                  BIT(RWEDGE_EABSENT) | BIT(RWEDGE_EPATH),
              NULL),
    BY_STATUS(yield_factor, "hw+fwrn+", 3,
              BIT(RWEDGE_ERANGE) | BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ESLIDING) | BIT(RWEDGE_EABSENT),
              NULL),
    FORMULA(von_mises, "gggn", NULL),
    FORMULA(out_of_plane_stress, "ggn", NULL),
    FORMULA(largest_shear, "gggn", NULL),
    BY_STATUS(principal_stresses, "ggg", 3, 0, NULL),
    BY_STATUS(smith_watson_topper, "ggg+n", 2, 0, NULL),
    BY_STATUS(smith_watson_topper_field, "ggg+n", 4, 0, NULL),
    BY_STATUS(fatemi_socie, "ggg+nw", 2, 0, NULL),
    BY_STATUS(fatemi_socie_field, "ggg+nw", 4, 0, NULL),
    BY_STATUS(series_create, "aifxy", 9, BIT(RWEDGE_ERANGE), NULL),
    BY_STATUS(series_fit, "asfxy", 9, BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ENOCONV), NULL),
};
const size_t public_call_count = COUNT(public_calls);

bool is_in_domain(const public_call *call, const double v[])
{
    for (size_t i = 0; call->kinds[i] != '\0'; i++)
        if (!is_of_kind(call->kinds[i], v[i]))
            return false;
    return call->also_in_domain == NULL || call->also_in_domain(v);
}

bool is_sound(char kind, double v)
{
    return is_of_kind(kind, v) && (kind != 'r' || is_between(v, -1, 1));
}

static const double MARK = -6.02214076e23; /* what an output is before: no result is that */

const char *complaint_of(const public_call *call, const double v[], double out[], int32_t *status)
{
    for (int i = 0; i < CALL_OUTPUTS; i++)
        out[i] = MARK;
    *status = call->make(v, out);
    const bool valid = is_in_domain(call, v);
    if (valid && *status != RWEDGE_OK && (call->also_allowed & BIT(*status)) == 0)
        return "an error, though all arguments are in the domain";
    if (!valid && *status == RWEDGE_OK)
        return "a result, though an argument is outside the domain";
    for (int i = 0; i < CALL_OUTPUTS; i++) {
        const bool wanted = *status == RWEDGE_OK && i < call->outputs;
        if (wanted && !isfinite(out[i]) && !(call->may_be_infinite && isinf(out[i])))
            return "a result that is not finite";
        if (!wanted && out[i] != MARK)
            return "an output was touched that should not be";
    }
    return NULL;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "every_function.h"

#include <math.h>
#include <stddef.h>

/* Arguments, spread over their domains: u, v, w in [0, 1), alpha from 1e-9 to 1.2. */
typedef struct {
    double u, v, w, alpha;
    receiver *receive;
    void *context;
} sample;

static sample sample_of(int number, receiver *receive, void *context)
{
    sample s = {.u = fmod(number * 0.6180339887498949, 1),
                .v = fmod(number * 0.7548776662466927, 1),
                .w = fmod(number * 0.5698402909980532, 1),
                .receive = receive,
                .context = context};
    s.alpha = number % 2 ? s.u * 1.2 : s.u * s.u * s.u * s.u * 1e-2 + 1e-9;
    return s;
}

static void give(const sample *s, const char *what, double value)
{
    s->receive(s->context, what, value);
}

/* The results of a call, if it had any. */
static void give_all(const sample *s, const char *what, int32_t status, int count,
                     const double values[])
{
    give(s, what, status);
    for (int i = 0; i < count && status == RWEDGE_OK; i++)
        give(s, what, values[i]);
}

static void formulas(const sample *s)
{
    const double alpha = s->alpha, v = s->v, w = s->w, theta = 0.01 + 0.2 * w;
    give(s, "version", rwedge_version()[0]);
    give(s, "strerror", rwedge_strerror((int32_t)(10 * v))[0]);
    give(s, "compliance", rwedge_compliance(1 + v, w / 2, 2 + w, v / 2));
    give(s, "dundurs", rwedge_dundurs_beta(1 + v, w / 2, 2 + w, v / 2));
    give(s, "load", rwedge_load(alpha));
    give(s, "a_over_b", rwedge_a_over_b(alpha * 3 + 1e-3));
    give(s, "pressure", rwedge_pressure(alpha, v));
    give(s, "peak", rwedge_peak_pressure(alpha));
    give(s, "transition", rwedge_transition_pressure(alpha));
    give(s, "coefficient", rwedge_coefficient(alpha, (int32_t)(1000 * v)));
    give(s, "stick", rwedge_stick_width(alpha, v));
    give(s, "ratio", rwedge_shear_ratio(alpha, v));
    give(s, "shear", rwedge_shear(alpha, v, v / 2));
    give(s, "tension", rwedge_max_tension(alpha));
    give(s, "validity", rwedge_validity(theta, alpha, v - 0.5, w, v / 5, 2 * w));
    give(s, "validity text", rwedge_validity_text((int32_t)(20 * w))[0]);
    give(s, "radius", rwedge_radius(theta, alpha));
    give(s, "rounding", rwedge_rounding(theta, 1 + v));
    give(s, "half_width", rwedge_half_width(theta, alpha, 1e-5, 1000 * v + 1));
    give(s, "normal_load", rwedge_normal_load(theta, alpha, 1e-5, v + 0.1));
}

static void stresses(const sample *s)
{
    enum { N = 21 };
    double x[N], y[N], t[3][N], one[3];
    give_all(s, "stress",
             rwedge_stress(s->alpha, s->v, s->w, 3 * s->v - 1.5, s->w * s->w * 3, &one[0], &one[1],
                           &one[2]),
             3, one);
    for (int i = 0; i < N; i++) {
        x[i] = 5 * fmod(s->u + i * 0.381966, 1) - 2.5;
        y[i] = i % 4 ? 3 * fmod(s->v + i * 0.245122, 1) : 0;
    }
    const int32_t status = rwedge_stresses(s->alpha, s->v, s->w, N, x, y, t[0], t[1], t[2]);
    for (int k = 0; k < 3; k++)
        give_all(s, "stresses", status, N, t[k]);
}

static void strength(const sample *s)
{
    const double alpha = s->alpha, f = s->v * s->w, nu = s->w / 2;
    double r[3], limit[2];
    give(s, "elastic_limit", rwedge_elastic_limit(alpha, f, nu));
    give_all(s, "elastic_limits",
             rwedge_elastic_limits(2, (double[]){alpha, s->u + 0.01}, (double[]){f, 0}, nu, limit),
             2, limit);
    give_all(s, "yield_point", rwedge_yield_point(alpha, f, nu, &r[0], &r[1], &r[2]), 3, r);
    give_all(s, "subsurface", rwedge_subsurface_yield(alpha, f, nu, &r[0], &r[1], &r[2]), 3, r);
    give_all(s, "surface", rwedge_surface_yield(alpha, f, nu, &r[0], &r[1]), 2, r);
}

static void measures(const sample *s)
{
    enum { LOADS = 9, N = 2 };
    double t[3][LOADS * N], r[3], value[N], angle[N];
    for (int i = 0; i < LOADS * N; i++)
        for (int k = 0; k < 3; k++)
            t[k][i] = fmod(s->u + (i + 1) * (k + 1) * 0.381966, 1) - s->w;
    give(s, "von_mises", rwedge_von_mises(t[0][0], t[1][0], t[2][0], s->w / 2));
    give(s, "szz", rwedge_out_of_plane_stress(t[0][0], t[1][0], s->w / 2));
    give(s, "largest_shear", rwedge_largest_shear(t[0][0], t[1][0], t[2][0], s->w / 2));
    give_all(s, "principal",
             rwedge_principal_stresses(t[0][0], t[1][0], t[2][0], &r[0], &r[1], &r[2]), 3, r);
    give_all(s, "swt",
             rwedge_smith_watson_topper(LOADS, t[0], t[1], t[2], 2, s->w / 2, &r[0], &r[1]), 2, r);
    give_all(s, "fs", rwedge_fatemi_socie(LOADS, t[0], t[1], t[2], 2, s->w / 2, s->v, &r[0], &r[1]),
             2, r);
    const int32_t swt =
        rwedge_smith_watson_topper_field(LOADS, N, t[0], t[1], t[2], 2, s->w / 2, value, angle);
    give_all(s, "swt field", swt, N, value);
    give_all(s, "swt angles", swt, N, angle);
    const int32_t fs =
        rwedge_fatemi_socie_field(LOADS, N, t[0], t[1], t[2], 2, s->w / 2, s->v, value, angle);
    give_all(s, "fs field", fs, N, value);
    give_all(s, "fs angles", fs, N, angle);
}

static void slow_strength(const sample *s)
{
    give(s, "critical_friction", rwedge_critical_friction(s->alpha, s->w / 2));
    give(s, "yield_load", rwedge_yield_load(0.05, s->alpha, 1e-5, s->v, s->w / 2, 100));
}

/* What a contact tells without being changed. */
static void read_contact(const sample *s, const rwedge_contact *contact)
{
    enum { N = 7 };
    const double b = rwedge_contact_half_width(contact);
    double x[N], y[N], r[3][N];
    for (int i = 0; i < N; i++) {
        x[i] = b * (2 * fmod(s->u + 0.618 * i, 1) - 1);
        y[i] = b * s->v * i / 4;
    }
    give(s, "contact b", b);
    give(s, "contact c", rwedge_contact_stick_half_width(contact));
    give(s, "memory", (double)rwedge_contact_memory(contact));
    give(s, "energy", rwedge_contact_dissipated_energy(contact));
    const int32_t tractions = rwedge_contact_tractions(contact, N, x, r[0], r[1]);
    give_all(s, "tractions p", tractions, N, r[0]);
    give_all(s, "tractions q", tractions, N, r[1]);
    give_all(s, "slip", rwedge_contact_slip(contact, N, x, r[0]), N, r[0]);
    const int32_t status = rwedge_contact_stresses(contact, N, x, y, r[0], r[1], r[2]);
    for (int k = 0; k < 3; k++)
        give_all(s, "contact stresses", status, N, r[k]);
}

static void yield_factor(const sample *s, const rwedge_contact *contact)
{
    double r[3];
    give_all(s, "yield_factor",
             rwedge_contact_yield_factor(contact, s->w / 2, 200, &r[0], &r[1], &r[2]), 3, r);
}

/* Moment and tension. */
static void off_centre(const sample *s)
{
    enum { LOADS = 3, N = 9, NUMBERS = 512 };
    const double P[] = {1000, 1000, 1000}, M[] = {200 * s->u, 200 * s->u, 200 * s->u};
    const double Q[] = {0, 400 * s->v, -300 * s->u}, sigma[] = {0, 10 * s->v, -5 * s->w};
    double x[N], y[N], r[3][LOADS * N], v[4], numbers[NUMBERS];
    rwedge_contact *contact = NULL, *again = NULL;
    if (rwedge_contact_create(0.02, s->alpha, 1e-5, 0.5, &contact) != RWEDGE_OK)
        return;
    for (int i = 0; i < N; i++) {
        x[i] = 2 * fmod(s->u + 0.618 * i, 1) - 1;
        y[i] = s->v * i / 4 + 0.01;
    }
    const int32_t status =
        rwedge_contact_stress_history(contact, LOADS, P, M, Q, sigma, N, x, y, r[0], r[1], r[2]);
    for (int k = 0; k < 3; k++)
        give_all(s, "history of stresses", status, LOADS * N, r[k]);
    give(s, "apply", rwedge_contact_apply(contact, 1000, 200 * s->u, 100, 0));
    give(s, "obstacle", *rwedge_contact_obstacle(contact, 1000, 200 * s->u, 100, 50));
    give(s, "largest tension", rwedge_contact_largest_tension_step(contact, 300 * s->v));
    give(s, "tilt", rwedge_contact_tilt(contact));
    give_all(s, "loads", rwedge_contact_loads(contact, &v[0], &v[1], &v[2], &v[3]), 4, v);
    give_all(s, "edges", rwedge_contact_edges(contact, &v[0], &v[1]), 2, v);
    give_all(s, "stick zone", rwedge_contact_stick_zone(contact, &v[0], &v[1]), 2, v);
    give_all(s, "asymptotes", rwedge_contact_edge_asymptotes(contact, &v[0], &v[1], &v[2], &v[3]),
             4, v);
    give_all(s, "permanent stick",
             rwedge_permanent_stick(0.02, s->alpha, 1e-5, 0.5, 1000, 100, 0, 0, 1000, 100,
                                    400 * s->v, 10 * s->v, &v[0], &v[1]),
             2, v);
    const size_t n = rwedge_contact_state_size(contact);
    if (n <= NUMBERS && rwedge_contact_state(contact, n, numbers) == RWEDGE_OK)
        give(s, "restore", rwedge_contact_restore(n, numbers, &again));
    rwedge_contact_destroy(again);
    rwedge_contact_destroy(contact);
}

static void load(rwedge_contact *contact, double u, double v)
{
    const double f = 0.5;
    rwedge_contact_load(contact, 1000, 0);
    rwedge_contact_load(contact, 1000, f * 1000 * u);
    rwedge_contact_load(contact, 1500 + 500 * v, f * 1200 * (2 * v - 1));
    rwedge_contact_load(contact, 1200, -f * 1200 * u);
}

static void own_contact(const sample *s)
{
    rwedge_contact *contact = NULL, *copy = NULL;
    if (rwedge_contact_create(0.02, s->alpha, 1e-5, 0.5, &contact) != RWEDGE_OK)
        return;
    load(contact, s->u, s->v);
    if (rwedge_contact_copy(contact, &copy) == RWEDGE_OK) {
        rwedge_contact_load(copy, 1100, 0);
        read_contact(s, copy);
    }
    read_contact(s, contact);
    rwedge_contact_destroy(copy);
    rwedge_contact_destroy(contact);
}

static void read_series(const sample *s, const rwedge_series *series)
{
    double r[3];
    give(s, "series terms", rwedge_series_terms(series));
    give(s, "series coefficient", rwedge_series_coefficient(series, (int32_t)(60 * s->v)));
    give(s, "series residual", rwedge_series_residual(series));
    give(s, "series pressure", rwedge_series_pressure(series, 2 * s->u - 1));
    give_all(s, "series potential",
             rwedge_series_potential(series, s->v, 3 * s->u - 1.5, s->w, &r[0], &r[1]), 2, r);
    give_all(s, "series stress",
             rwedge_series_stress(series, s->v, 3 * s->u - 1.5, s->w, &r[0], &r[1], &r[2]), 3, r);
}

static void own_series(const sample *s)
{
    rwedge_series *series = NULL;
    if (rwedge_series_create(s->alpha, 40, &series) == RWEDGE_OK)
        read_series(s, series);
    rwedge_series_destroy(series);
}

static void fitted_series(const sample *s)
{
    enum { SAMPLES = 60, TERMS = 20 };
    double x[SAMPLES], p[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
        x[i] = (2 * i + 1.0) / SAMPLES - 1;
        p[i] = -(1 - x[i] * x[i]) * (1 + s->u * x[i]);
    }
    rwedge_series *series = NULL;
    if (rwedge_series_fit(SAMPLES, x, p, TERMS, &series) == RWEDGE_OK)
        for (int k = 0; k < TERMS; k++)
            give(s, "fit", rwedge_series_coefficient(series, k));
    rwedge_series_destroy(series);
}

bool shared_create(shared_handles *shared)
{
    *shared = (shared_handles){NULL, NULL};
    if (rwedge_contact_create(0.02, 0.3, 1e-5, 0.5, &shared->contact) != RWEDGE_OK ||
        rwedge_series_create(0.3, 60, &shared->series) != RWEDGE_OK) {
        shared_destroy(shared);
        return false;
    }
    load(shared->contact, 0.7, 0.3);
    return true;
}

void shared_destroy(shared_handles *shared)
{
    rwedge_contact_destroy(shared->contact);
    rwedge_series_destroy(shared->series);
}

void every_function(const shared_handles *shared, int number, receiver *receive, void *context)
{
    enum { RARELY = 40 };
    const sample s = sample_of(number, receive, context);
    formulas(&s);
    stresses(&s);
    strength(&s);
    measures(&s);
    read_contact(&s, shared->contact);
    own_contact(&s);
    off_centre(&s);
    read_series(&s, shared->series);
    own_series(&s);
    if (number % RARELY != 0)
        return;
    slow_strength(&s);
    yield_factor(&s, shared->contact);
    fitted_series(&s);
}

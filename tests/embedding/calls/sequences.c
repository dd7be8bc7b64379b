/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls one after the other, as a host makes them: a contact through its loads. A letter for each
 * number says what it is. */
#include "parts.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define HALF_PI 1.57079632679489661923

static const entry_argument ratio = {.name = "Q/(fP)", .low = -1, .high = 1, .finite = 1};

/* The domain of a number. */
static const struct {
    char letter;
    entry_argument domain;
} letters[] = {
    {'h', {"theta", "", 0, HALF_PI, 1e-60, 1, 1, 0, 1, 0, 0, {-1, -1}}},
    {'w', {"size", "", 0, 1e60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}},
    {'+', {"positive", "", 0, 1e60, 1e-60, 1, 0, 0, 1, 0, 0, {-1, -1}}},
    {'x', {"place", "", -1e60, 1e60, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}},
    {'f', {"friction", "", 0, 1e6, 1e-60, 0, 0, 0, 1, 0, 0, {-1, -1}}},
    {'n', {"Poisson's ratio", "", 0, 0.5, 0, 0, 0, 0, 1, 0, 0, {-1, -1}}},
};

const entry_argument *argument_of_letter(char letter)
{
    for (size_t i = 0; i < sizeof letters / sizeof letters[0]; i++)
        if (letters[i].letter == letter)
            return &letters[i].domain;
    return &ratio;
}

bool may_be_anything(const entry_argument *a)
{
    return a == &ratio || a == &which_object;
}

/* ---- A contact after two loads ---- */

/* A product that raises no exception of its own; volatile, for else clang converts it before it
 * looks whether it may. */
static double product(double a, double b, double c)
{
    if (!isfinite(a) || !isfinite(b) || !isfinite(c))
        return NAN;
    const volatile long double exact = (long double)a * b * c;
    return exact > DBL_MAX ? INFINITY : exact < -DBL_MAX ? -INFINITY : (double)exact;
}

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

/* ---- All of them ---- */

#define BIT(status) (1u << (status))
#define BY_STATUS(name, kinds, outputs, allowed)                                                   \
    {                                                                                              \
#name, kinds, outputs, allowed, name                                                       \
    }

const sequence sequences[] = {
    BY_STATUS(contact, "hw+fwrwrxw", SEEN,
              BIT(RWEDGE_ERANGE) | BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ESLIDING)),
    BY_STATUS(off_centre, "hw+fwrrr", 5,
              BIT(RWEDGE_ERANGE) | BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ESLIDING) |
                  BIT(RWEDGE_EABSENT) | BIT(RWEDGE_EPATH)),
    BY_STATUS(yield_factor, "hw+fwrn+", 3,
              BIT(RWEDGE_ERANGE) | BIT(RWEDGE_EDOMAIN) | BIT(RWEDGE_ESLIDING) |
                  BIT(RWEDGE_EABSENT)),
    {NULL, NULL, 0, 0, NULL},
};

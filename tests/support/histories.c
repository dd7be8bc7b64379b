/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "histories.h"

#include <stdlib.h>
#include <string.h>

static void destroy(void *contact)
{
    rwedge_contact_destroy(contact);
}

rwedge_contact *owned(rwedge_contact *contact)
{
    free_after_claim(contact, destroy);
    return contact;
}

rwedge_contact *create_wedge(double theta, double a, double compliance, double f)
{
    rwedge_contact *contact = NULL;
    assert_ok(rwedge_contact_create(theta, a, compliance, f, &contact));
    return owned(contact);
}

rwedge_contact *create(double a, double f)
{
    return create_wedge(THETA, a, A, f);
}

rwedge_contact *create_flat(double a, double R, double compliance, double f)
{
    rwedge_contact *contact = NULL;
    assert_ok(rwedge_contact_create_flat(a, R, compliance, f, &contact));
    return owned(contact);
}

rwedge_contact *create_profile(size_t n, const double x[], const double slope[], double f)
{
    rwedge_contact *contact = NULL;
    assert_ok(rwedge_contact_create_profile(n, x, slope, A, f, &contact));
    return owned(contact);
}

rwedge_contact *copy_of(const rwedge_contact *contact)
{
    rwedge_contact *copy = NULL;
    assert_ok(rwedge_contact_copy(contact, &copy));
    return owned(copy);
}

rwedge_contact *allowing(rwedge_contact *contact, double tolerance)
{
    assert_ok(rwedge_contact_allow_error(contact, tolerance));
    return contact;
}

contact_state state_of(const rwedge_contact *contact)
{
    const size_t size = rwedge_contact_state_size(contact);
    const contact_state state = {size, calloc(size + 1, sizeof(double))};
    free_after_claim(state.number, free);
    assert_ok(rwedge_contact_state(contact, size, state.number));
    return state;
}

rwedge_contact *restored(contact_state state)
{
    rwedge_contact *contact = NULL;
    assert_ok(rwedge_contact_restore(state.size, state.number, &contact));
    return owned(contact);
}

void assert_state(const rwedge_contact *contact, contact_state expected)
{
    const contact_state state = state_of(contact);
    assert_int_equal(state.size, expected.size);
    assert_memory_equal(state.number, expected.number, state.size * sizeof(double));
}

void load(rwedge_contact *contact, double P, double Q)
{
    assert_ok(rwedge_contact_load(contact, P, Q));
}

rwedge_contact *recorded(const double wedge[], const double loads[])
{
    rwedge_contact *contact = create_wedge(wedge[0], wedge[2], wedge[1], wedge[3]);
    for (int i = 0; i < loads[0]; i++)
        load(contact, loads[2 * i + 1], loads[2 * i + 2]);
    return contact;
}

int32_t try_load(rwedge_contact *contact, rw_loads to)
{
    return rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
}

int32_t try_parts(rwedge_contact *contact, rw_loads to, int n, const double ends[])
{
    const rw_loads from = contact->loads;
    int32_t status = RWEDGE_OK;
    for (int i = 1; i <= n && status == RWEDGE_OK; i++)
        status = try_load(contact, rw_loads_between(from, to, ends ? ends[i - 1] : (double)i / n));
    return status;
}

void apply(rwedge_contact *contact, double P, double M, double Q, double sigma)
{
    assert_ok(rwedge_contact_apply(contact, P, M, Q, sigma));
}

void refuse(rwedge_contact *contact, double P, double M, double Q, double sigma, int32_t status)
{
    const contact_state before = state_of(contact);
    assert_int_equal(rwedge_contact_apply(contact, P, M, Q, sigma), status);
    const bool is_explained = strlen(rwedge_contact_obstacle(contact, P, M, Q, sigma)) > 0;
    assert_true(is_explained == (status == RWEDGE_EPATH));
    assert_state(contact, before);
}

rwedge_contact *apply_all(rwedge_contact *contact, size_t count, const rw_loads loads[])
{
    for (size_t i = 0; i < count; i++)
        assert_ok(try_load(contact, loads[i]));
    return contact;
}

static void destroy_cycle(void *cycle)
{
    rwedge_cycle_destroy(cycle);
}

rwedge_cycle *cycle_of(const rwedge_contact *contact, size_t loads, const rw_loads load[])
{
    double P[CYCLE_LOADS], M[CYCLE_LOADS], Q[CYCLE_LOADS], sigma[CYCLE_LOADS];
    rwedge_cycle *cycle;
    assert_true(loads <= CYCLE_LOADS);
    for (size_t i = 0; i < loads; i++) {
        P[i] = load[i].P;
        M[i] = load[i].M;
        Q[i] = load[i].Q;
        sigma[i] = load[i].sigma;
    }
    assert_ok(rwedge_cycle_create(contact, loads, P, M, Q, sigma, &cycle));
    free_after_claim(cycle, destroy_cycle);
    return cycle;
}

rw_patch edges_of(const rwedge_contact *contact)
{
    rw_patch patch;
    assert_ok(rwedge_contact_edges(contact, &patch.left, &patch.right));
    return patch;
}

rw_patch stick_zone_of(const rwedge_contact *contact)
{
    rw_patch patch;
    assert_ok(rwedge_contact_stick_zone(contact, &patch.left, &patch.right));
    return patch;
}

double shear(const rwedge_contact *contact, double x)
{
    double p, q;
    assert_ok(rwedge_contact_tractions(contact, 1, &x, &p, &q));
    return q;
}

double pressure(const rwedge_contact *contact, double x)
{
    double p, q;
    assert_ok(rwedge_contact_tractions(contact, 1, &x, &p, &q));
    return p;
}

double slip(const rwedge_contact *contact, double x)
{
    double s;
    assert_ok(rwedge_contact_slip(contact, 1, &x, &s));
    return s;
}

void assert_same_shear(const rwedge_contact *actual, const rwedge_contact *expected, double within)
{
    enum { PLACES = 199 };
    const rw_patch edges = edges_of(expected);
    double x[PLACES], p[PLACES], q[2][PLACES];
    for (int i = 0; i < PLACES; i++)
        x[i] = edges.left + (edges.right - edges.left) * (i + 1) / (PLACES + 1);
    assert_ok(rwedge_contact_tractions(actual, PLACES, x, p, q[0]));
    assert_ok(rwedge_contact_tractions(expected, PLACES, x, p, q[1]));
    for (int i = 0; i < PLACES; i++)
        assert_within(q[0][i], q[1][i], within);
}

stresses stress_at(const rwedge_contact *contact, double x, double y)
{
    stresses s;
    assert_ok(rwedge_contact_stresses(contact, 1, &x, &y, &s.xx, &s.yy, &s.xy));
    return s;
}

double apart(stresses a, stresses b)
{
    const double xx = fabs(a.xx - b.xx), yy = fabs(a.yy - b.yy), xy = fabs(a.xy - b.xy);
    return isnan(xx + yy + xy) ? NAN : fmax(xx, fmax(yy, xy));
}

rwedge_contact *begin(random_history *h, int number)
{
    *h = (random_history){.seed = (uint64_t)number};
    for (int i = 0; i < 4; i++)
        random_fraction(&h->seed);
    h->f = 0.1 + 0.7 * random_fraction(&h->seed);
    const double a = number % 4 == 0 ? 0 : number % 4 == 1 ? 20 : 0.5 * random_fraction(&h->seed);
    return create(a, h->f);
}

void go_on(random_history *h, rwedge_contact *contact)
{
    if (h->P == 0 || random_fraction(&h->seed) < 0.7)
        h->P = 0.02 + 0.2 * random_fraction(&h->seed);
    const double kind = random_fraction(&h->seed);
    h->Q = h->f * h->P * (kind < 0.1 ? 1 : kind < 0.2 ? -1 : 2 * random_fraction(&h->seed) - 1);
    load(contact, h->P, h->Q);
}

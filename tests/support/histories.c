/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "histories.h"

rwedge_contact *create(double a, double f)
{
    rwedge_contact *contact = NULL;
    assert_ok(rwedge_contact_create(THETA, a, A, f, &contact));
    return contact;
}

void load(rwedge_contact *contact, double P, double Q)
{
    assert_ok(rwedge_contact_load(contact, P, Q));
}

void apply(rwedge_contact *contact, double P, double M, double Q, double sigma)
{
    assert_ok(rwedge_contact_apply(contact, P, M, Q, sigma));
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

size_t breakpoints(const rwedge_contact *contact, double points[])
{
    const rw_memory *path = &contact->memory;
    const double a = contact->geometry.a;
    size_t n = 0;
    points[n++] = 0;
    for (size_t i = 1; i < path->count; i++) {
        const double s = path->corners[i].patch.right;
        if (points[n - 1] < a && a < s)
            points[n++] = a;
        points[n++] = s;
        assert_true(n + 2 < POINTS_MAX);
    }
    return n - 1;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses at many points through many loads. */
#include "histories.h"

enum { LOADS = 24, POINTS = 77 };

typedef struct {
    double P[LOADS], M[LOADS], Q[LOADS], sigma[LOADS];
    double x[POINTS], y[POINTS];
    double sxx[LOADS * POINTS], syy[LOADS * POINTS], txy[LOADS * POINTS];
} history;

static void fill(history *h, double M, double tension)
{
    for (int i = 0; i < LOADS; i++) {
        h->P[i] = 0.5;
        h->M[i] = M;
        h->Q[i] = i == 0 ? 0 : 0.2 * sin(0.7 * i);
        h->sigma[i] = i == 0 ? 0 : tension * sin(0.7 * i);
    }
    for (int i = 0; i < POINTS; i++) {
        h->x[i] = 6.0 * i / POINTS - 3;
        h->y[i] = i % 4 ? 0.1 * (i % 11) + 0.01 : 0;
    }
}

static int32_t run(history *h, rwedge_contact *contact)
{
    return rwedge_contact_stress_history(contact, LOADS, h->P, h->M, h->Q, h->sigma, POINTS, h->x,
                                         h->y, h->sxx, h->syy, h->txy);
}

/* The stresses after the load of that number are those of the contact. */
static void assert_bits(const history *h, int load, const rwedge_contact *contact)
{
    double sxx[POINTS], syy[POINTS], txy[POINTS];
    assert_ok(rwedge_contact_stresses(contact, POINTS, h->x, h->y, sxx, syy, txy));
    assert_memory_equal(sxx, h->sxx + load * POINTS, sizeof sxx);
    assert_memory_equal(syy, h->syy + load * POINTS, sizeof syy);
    assert_memory_equal(txy, h->txy + load * POINTS, sizeof txy);
}

/* Every load of the history, and the state that it leaves. */
static void assert_as_by_single_calls(history *h, rwedge_contact *contact)
{
    rwedge_contact *single = copy_of(contact);
    assert_ok(run(h, contact));
    for (int i = 0; i < LOADS; i++) {
        apply(single, h->P[i], h->M[i], h->Q[i], h->sigma[i]);
        assert_bits(h, i, single);
    }
    assert_state(contact, state_of(single));
}

/* The last tension is too great for a closed form. */
CLAIM(gives_the_bits_of_single_calls)
{
    static history h;
    static const double cases[][3] = {{0.4, 0, 0},    {0.4, 0, 0.02}, {0.4, 0.1, 0.02},
                                      {0, 0.1, 0.02}, {9, 0.1, 0},    {0.4, 0, 0.9}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const bool is_computed = cases[k][2] > 0.5;
        rwedge_contact *contact = allowing(create(cases[k][0], 0.5), is_computed ? 1e-3 : 0);
        fill(&h, cases[k][1], cases[k][2]);
        assert_as_by_single_calls(&h, contact);
        assert_true((rwedge_contact_error(contact) > 0) == is_computed);
    }
}

/* Of P and Q. */
CLAIM(gives_the_bits_of_single_calls_along_random_histories)
{
    static history h;
    fill(&h, 0, 0);
    for (int number = 0; number < 60; number++) {
        random_history random;
        rwedge_contact *ahead = begin(&random, number), *contact = copy_of(ahead);
        for (int i = 0; i < LOADS; i++) {
            go_on(&random, ahead);
            h.P[i] = random.P;
            h.Q[i] = random.Q;
        }
        if (contact->geometry.a == 0)
            h.x[POINTS / 2] = 0.01; /* not the apex */
        assert_as_by_single_calls(&h, contact);
    }
}

CLAIM(a_load_that_is_refused_leaves_all_as_it_was)
{
    static history h, before;
    fill(&h, 0.1, 0.02);
    h.Q[LOADS - 1] = 0.3;
    before = h;
    rwedge_contact *contact = create(0.4, 0.5);
    assert_int_equal(run(&h, contact), RWEDGE_ESLIDING);
    h.Q[LOADS - 1] = 0;
    h.y[3] = -1;
    assert_int_equal(run(&h, contact), RWEDGE_EDOMAIN);
    assert_memory_equal(h.sxx, before.sxx, sizeof h.sxx);
    assert_true(rwedge_contact_half_width(contact) == 0);
    assert_ok(rwedge_contact_stress_history(contact, 0, NULL, NULL, NULL, NULL, 0, NULL, NULL, NULL,
                                            NULL, NULL));
}

/* Separated there is only the tension. */
CLAIM(separated_bodies_are_stretched)
{
    static const double P[] = {0, 0.5, 0}, M[] = {0, 0.1, 0}, Q[] = {0, 0, 0}, sigma[] = {2, 2, 3};
    const double x = 0.1, y = 0.2, deep = -1;
    double sxx[3], syy[3], txy[3];
    rwedge_contact *contact = create(0.4, 0.5);
    assert_int_equal(
        rwedge_contact_stress_history(contact, 3, P, M, Q, sigma, 1, &x, &deep, sxx, syy, txy),
        RWEDGE_EDOMAIN);
    assert_ok(rwedge_contact_stress_history(contact, 3, P, M, Q, sigma, 1, &x, &y, sxx, syy, txy));
    assert_true(sxx[0] == 2 && syy[0] == 0 && txy[0] == 0);
    assert_true(sxx[2] == 3 && syy[2] == 0 && txy[2] == 0);
    assert_true(syy[1] < 0);
    assert_ok(rwedge_contact_stress_history(contact, 0, NULL, NULL, NULL, NULL, 1, &x, &y, NULL,
                                            NULL, NULL));
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Edges in a cycle, and places at which to measure it. */
#include "histories.h"

#include <string.h>

enum { ROOM = 1024, LOADS = 300 };

typedef struct {
    size_t n;
    double x[ROOM];
} places;

typedef struct {
    size_t count;
    double P[LOADS], M[LOADS], Q[LOADS], sigma[LOADS];
} loads;

static void destroy_cycle(void *cycle)
{
    rwedge_cycle_destroy(cycle);
}

/* It lives to the end of the claim. */
static const rwedge_cycle *cycle_from(const rwedge_contact *contact, const loads *c)
{
    rwedge_cycle *cycle = NULL;
    assert_ok(rwedge_cycle_create(contact, c->count, c->P, c->M, c->Q, c->sigma, &cycle));
    free_after_claim(cycle, destroy_cycle);
    return cycle;
}

static places edges_in(const rwedge_cycle *cycle)
{
    places edges = {.n = rwedge_cycle_edge_count(cycle)};
    assert_in_range(edges.n, 0, ROOM);
    assert_ok(rwedge_cycle_edges(cycle, edges.n, edges.x));
    return edges;
}

static places places_in(const rwedge_cycle *cycle)
{
    places all = {.n = rwedge_cycle_place_count(cycle)};
    assert_in_range(all.n, 0, ROOM);
    assert_ok(rwedge_cycle_places(cycle, all.n, all.x));
    return all;
}

static bool has(const places *all, double x, double within)
{
    for (size_t i = 0; i < all->n; i++)
        if (fabs(all->x[i] - x) <= within)
            return true;
    return false;
}

static void assert_ascending(const places *all, double apart)
{
    for (size_t i = 1; i < all->n; i++)
        assert_true(all->x[i] - all->x[i - 1] > apart);
}

/* ---- Edges ---- */

/* A tension that lags behind P and Q: there are two zones that stick, and slip lies between. */
static const loads LAGGING = {4,
                              {123.01, 139.27, 104.74, 76.86},
                              {0},
                              {-25.03, -14.89, 16.59, 18.49},
                              {-86.14, -114.33, -144.07, 84.65}};

static rwedge_contact *pressed(void)
{
    return APPLY(allowing(create_wedge(0.05, 0.5, 2.4716e-5, 0.3), 1e-3), {100, 0, 0, 0});
}

/* What a contact tells after each load, one by one. */
static places told_by_contact(rwedge_contact *contact, const loads *c, size_t *most_zones)
{
    places told = {0};
    *most_zones = 0;
    for (size_t k = 0; k <= c->count; k++) {
        double left[16], right[16], slip[16];
        size_t zones = 0;
        if (k > 0)
            apply(contact, c->P[k - 1], c->M[k - 1], c->Q[k - 1], c->sigma[k - 1]);
        const size_t n = rwedge_contact_zone_count(contact);
        assert_ok(rwedge_contact_zones(contact, n, left, right, slip));
        told.x[told.n++] = edges_of(contact).left;
        told.x[told.n++] = edges_of(contact).right;
        for (size_t i = 0; i < n; i++)
            if (slip[i] == 0) {
                told.x[told.n++] = left[i];
                told.x[told.n++] = right[i];
                zones++;
            }
        *most_zones = zones > *most_zones ? zones : *most_zones;
    }
    return told;
}

CLAIM(edges_are_those_of_every_zone_that_sticks)
{
    rwedge_contact *contact = pressed();
    const rwedge_cycle *cycle = cycle_from(contact, &LAGGING);
    size_t zones;
    const places edges = edges_in(cycle), told = told_by_contact(contact, &LAGGING, &zones);
    const double within = 1e-12 * (edges.x[edges.n - 1] - edges.x[0]); /* they count as one */
    assert_true(zones > 1);
    assert_ascending(&edges, within);
    for (size_t i = 0; i < told.n; i++)
        assert_true(has(&edges, told.x[i], within));
    for (size_t i = 0; i < edges.n; i++)
        assert_true(has(&told, edges.x[i], 0));
}

/* Under constant P: the contact's edges, and those of the zones that stick after each load. */
CLAIM(equal_edges_count_once)
{
    rwedge_contact *contact = APPLY(create(0.4, 0.5), {1, 0, 0, 0});
    const loads c = {3, {1, 1, 1}, {0}, {0.3, -0.3, 0.3}, {0}};
    assert_int_equal(rwedge_cycle_edge_count(cycle_from(contact, &c)), 4);
}

static uint64_t seed_of_noise = 7;

/* As a measured log has it. */
static loads noisy(void)
{
    loads c = {.count = LOADS};
    for (size_t i = 0; i < LOADS; i++) {
        c.P[i] = random_between(&seed_of_noise, 0.8, 1.2);
        c.Q[i] = random_between(&seed_of_noise, -0.4, 0.4) * c.P[i];
    }
    return c;
}

CLAIM(edges_of_many_loads_are_thinned_out)
{
    rwedge_contact *contact = APPLY(create(0.4, 0.5), {1, 0, 0, 0});
    const loads c = noisy();
    size_t zones;
    rwedge_contact *same = copy_of(contact);
    const rwedge_cycle *cycle = cycle_from(contact, &c);
    places told = {0};
    const places edges = edges_in(cycle);
    const double b = rwedge_contact_half_width(APPLY(create(0.4, 0.5), {1.2, 0, 0, 0}));
    assert_in_range(edges.n, 50, 201);
    for (size_t i = 0; i < c.count; i += 100) { /* as many as there is room for */
        loads part = {.count = 100};
        memcpy(part.P, c.P + i, 100 * sizeof *c.P);
        memcpy(part.Q, c.Q + i, 100 * sizeof *c.Q);
        told = told_by_contact(same, &part, &zones);
        for (size_t k = 0; k < told.n; k++)
            assert_true(has(&edges, told.x[k], 2 * b / 200));
    }
    assert_ascending(&edges, 0.98 * 2 * b / 200); /* the largest P is nearly 1.2 */
}

/* ---- Places ---- */

/* Chebyshev's places, and a parabola beyond each edge. */
CLAIM(places_are_dense_at_the_edges)
{
    rwedge_contact *contact = APPLY(create(0.4, 0.5), {1, 0.1, 0, 0});
    const loads c = {2, {1, 1}, {0.1, 0.1}, {0.3, -0.3}, {0}};
    const rwedge_cycle *cycle = cycle_from(contact, &c);
    const places all = places_in(cycle), edges = edges_in(cycle);
    const rw_patch patch = edges_of(contact);
    const double half = (patch.right - patch.left) / 2, within = 1e-14 * half;
    assert_ascending(&all, 0);
    assert_in_range(all.n, 201 + 80, 201 + 80 + edges.n);
    assert_within(all.x[0], patch.left - half, within);
    assert_within(all.x[all.n - 1], patch.right + half, within);
    for (int i = 0; i <= 200; i++)
        assert_true(has(&all, (patch.left + patch.right) / 2 - half * cos(PI * i / 200), within));
    for (int i = 1; i <= 40; i++)
        assert_true(has(&all, patch.right + half * pow(i / 40.0, 2), within));
    for (size_t i = 0; i < edges.n; i++)
        assert_true(has(&all, edges.x[i], 1e-12 * half));
}

CLAIM(a_cycle_without_contact_has_no_places)
{
    const loads apart = {2, {0, 0}, {0}, {0}, {0, 1}};
    const rwedge_cycle *cycle = cycle_from(create(0.4, 0.5), &apart);
    assert_int_equal(edges_in(cycle).n, 0);
    assert_int_equal(places_in(cycle).n, 0);
}

CLAIM(another_number_of_places_is_refused)
{
    const rwedge_cycle *cycle = cycle_from(pressed(), &LAGGING);
    double x[ROOM] = {7};
    assert_int_equal(rwedge_cycle_edge_count(NULL), 0);
    assert_int_equal(rwedge_cycle_place_count(NULL), 0);
    assert_int_equal(rwedge_cycle_edges(cycle, rwedge_cycle_edge_count(cycle) + 1, x),
                     RWEDGE_ERANGE);
    assert_int_equal(rwedge_cycle_places(cycle, rwedge_cycle_place_count(cycle) - 1, x),
                     RWEDGE_ERANGE);
    assert_int_equal(rwedge_cycle_edges(NULL, 0, x), RWEDGE_ENULL);
    assert_int_equal(rwedge_cycle_places(cycle, rwedge_cycle_place_count(cycle), NULL),
                     RWEDGE_ENULL);
    assert_true(x[0] == 7);
}

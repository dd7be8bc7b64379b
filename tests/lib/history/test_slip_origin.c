/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The paths that slip is measured from: kept with what they have in common, they are what they
 * were. */
#include "histories.h"

enum { MOST = 512 };

/* Copies of the paths, one for each origin, taken whole. */
typedef struct {
    rw_memory all[MOST];
    size_t count;
} copies;

static void cut(copies *c, size_t count)
{
    while (c->count > count)
        rw_memory_destroy(&c->all[--c->count]);
}

/* Goes on to a load, and copies the path that the load leaves if its slip needs it. */
static void follow(rwedge_contact *contact, copies *c, double P, double Q)
{
    bool is_whole = true;
    rw_memory before = rw_memory_copy(&contact->memory, &is_whole);
    assert_true(is_whole);
    const double fresh = contact->slip.origins.fresh, end = rw_memory_end(&before)->load;
    load(contact, P, Q);
    const size_t count = contact->slip.origins.count;
    const bool is_new = contact->slip.origins.fresh > fresh;
    cut(c, count - is_new);
    if (is_new || (count > c->count && P <= end)) {
        assert_int_equal(count, c->count + 1);
        c->all[c->count++] = before;
    } else {
        rw_memory_destroy(&before);
    }
    assert_int_equal(c->count, count);
}

static void assert_same_corner(const rw_corner *read, const rw_corner *expected)
{
    assert_true(read->load == expected->load && read->shear == expected->shear &&
                read->ratio == expected->ratio && read->least == expected->least &&
                read->most == expected->most && read->patch.right == expected->patch.right);
}

static void assert_as_copied(const rwedge_contact *contact, const copies *c)
{
    for (size_t k = 0; k < c->count; k++) {
        const rw_path path =
            rw_slip_origin_path(&contact->slip.origins, &contact->slip.origins.all[k]);
        assert_int_equal(path.count, c->all[k].count);
        for (size_t i = 0; i < path.count; i++)
            assert_same_corner(rw_path_corner(&path, i), &c->all[k].corners[i]);
    }
}

/* Loads that rise, with ever other slopes and slip, and now and then fall back. */
static void random_load(random_history *h, int step)
{
    const double kind = random_fraction(&h->seed), up = 0.001 + 0.01 * random_fraction(&h->seed);
    const double before = h->P;
    h->P = kind < 0.02 ? fmax(0.01, h->P * (0.5 + random_fraction(&h->seed) / 2)) : h->P + up;
    const double steepness = step % 3 == 0 ? 2 : 0.9;
    const double change = steepness * (2 * random_fraction(&h->seed) - 1) * fabs(h->P - before);
    h->Q = fmax(-0.9 * h->P, fmin(0.9 * h->P, h->Q / h->f + change)) * h->f;
}

CLAIM(paths_that_are_kept_are_what_they_were)
{
    static copies c;
    size_t most = 0;
    for (int number = 1; number <= 20; number++) {
        random_history h;
        rwedge_contact *contact = begin(&h, number);
        cut(&c, 0);
        for (int step = 0; step < 300; step++) {
            random_load(&h, step);
            follow(contact, &c, h.P, h.Q);
            if (step % 7 == 0 || step == 299)
                assert_as_copied(contact, &c);
            most = c.count > most ? c.count : most;
        }
        rwedge_contact *copy = copy_of(contact);
        load(contact, 0, 0); /* forgets all */
        assert_as_copied(copy, &c);
    }
    cut(&c, 0);
    assert_true(most > 30);
}

/* Each load rises, every other one slips: once 194 MB for 4001 loads, 3.1 GB for 16001. */
CLAIM(memory_grows_in_proportion_to_the_loads)
{
    enum { LOADS = 4000 };
    rwedge_contact *contact = APPLY(create_wedge(0.01, 0.3, 0.001, 0.5), {10, 0, 0, 0});
    double P = 10, Q = 0;
    for (int i = 0; i < LOADS; i++) {
        const double sign = i % 4 < 2 ? 1 : -1;
        P += i % 2 ? 0.001 : 0.01;
        Q += sign * (i % 2 ? 0.0006 : 0.0025);
        load(contact, P, Q);
    }
    assert_true(contact->slip.origins.count > LOADS / 3);
    const size_t points = rwedge_contact_memory(contact), n = rwedge_contact_state_size(contact);
    assert_true(points <= 2 * (LOADS + 1));
    assert_true(n <= 32 + 18 * points); /* all there is */
    rwedge_contact *twin = restored(state_of(contact));
    const double b = rwedge_contact_half_width(contact);
    for (int i = 0; i < 40; i++) {
        const double x = b * (0.3 + 0.7 * i / 40);
        assert_true(slip(contact, x) == slip(twin, x));
    }
    load(contact, 0.8 * P, 0);
    load(twin, 0.8 * P, 0);
    assert_int_equal(rwedge_contact_memory(contact), rwedge_contact_memory(twin));
    assert_true(rwedge_contact_memory(contact) < points);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unlike bodies in partial slip. Expected values: fully coupled boundary elements by another
 * program (tests/data/unlike_cases.csv), full sliding in closed form, similar bodies, symmetry. */
#include "histories.h"

#include <stdio.h>
#include <string.h>

static const double F = 0.5;

static rwedge_contact *unlike(rwedge_contact *contact, double beta, double tolerance)
{
    assert_ok(rwedge_contact_set_beta(contact, beta));
    return allowing(contact, tolerance);
}

static rwedge_contact *wedge(double beta)
{
    return unlike(create_wedge(0.01, 1, 0.01, F), beta, 1e-3);
}

/* ---- Boundary elements ---- */

enum { MOST_LOADS = 37, MOST_ROWS = 120 };

/* A case, and rows of its values: load, x, value, error. A load of -1 is the last 17 loads. */
typedef struct {
    int loads, rows;
    double load[MOST_LOADS][4], f, beta;
    bool is_held;
    char pad[16];
    double row[MOST_ROWS][4];
    char quantity[MOST_ROWS][16];
} history;

static void read_case(int number, history *h)
{
    *h = (history){.loads = 0};
    reference loads = reference_open("unlike_loads.csv");
    while (reference_next(&loads))
        if (loads.cell[0] == number) {
            memcpy(h->load[h->loads++], loads.cell + 2, sizeof h->load[0]);
            h->f = loads.cell[6];
            h->beta = loads.cell[7];
            h->is_held = loads.cell[8] == 1;
            snprintf(h->pad, sizeof h->pad, "%.15s", loads.last);
        }
    reference values = reference_open("unlike_cases.csv");
    while (reference_next(&values))
        if (values.cell[0] == number) {
            assert_true(h->rows < MOST_ROWS);
            memcpy(h->row[h->rows], values.cell + 1, sizeof h->row[0]);
            snprintf(h->quantity[h->rows++], sizeof h->quantity[0], "%.15s", values.last);
        }
}

/* theta/A = 1; of the cylinder and the flat pad R A = 1 */
static rwedge_contact *create_pad(const history *h)
{
    rwedge_contact *contact = !strcmp(h->pad, "wedge")      ? create_wedge(0.01, 1, 0.01, h->f)
                              : !strcmp(h->pad, "cylinder") ? create_flat(0, 100, 0.01, h->f)
                                                            : create_flat(0.5, 100, 0.01, h->f);
    assert_ok(rwedge_contact_set_rotation(contact, h->is_held));
    return unlike(contact, h->beta, 1e-3);
}

static bool is(const history *h, int row, const char *quantity)
{
    return !strcmp(h->quantity[row], quantity);
}

/* The largest of a quantity. */
static double largest(const history *h, const char *quantity)
{
    double most = 0;
    for (int i = 0; i < h->rows; i++)
        if (is(h, i, quantity))
            most = fmax(most, fabs(h->row[i][2]));
    return most;
}

/* What the history did: at the places of the values of the surface stress, the extremes. */
typedef struct {
    double most[MOST_ROWS], least[MOST_ROWS], energy;
    double shear_error;
    int shears;
} seen;

/* The values after a load; errors of the reference are allowed for. */
static void check_load(const history *h, int load, const rwedge_contact *contact, seen *s)
{
    const double p0 = largest(h, "p"), tension = largest(h, "sxx_max");
    const rw_patch edges = edges_of(contact);
    const double half = rw_patch_half_width(edges);
    double P, M, Q, sigma;
    assert_ok(rwedge_contact_loads(contact, &P, &M, &Q, &sigma));
    for (int i = 0; i < h->rows; i++) {
        const double *row = h->row[i], x = row[1], value = row[2], error = row[3];
        if (row[0] != load)
            continue;
        if (is(h, i, "left"))
            assert_within(edges.left, value, 1e-3 * half + error);
        if (is(h, i, "right"))
            assert_within(edges.right, value, 1e-3 * half + error);
        if (is(h, i, "p"))
            assert_within(pressure(contact, x), value, 2e-3 * p0 + error);
        if (is(h, i, "sxx"))
            assert_within(stress_at(contact, x, 0).xx, value, 5e-3 * tension + error);
        if (is(h, i, "tilt"))
            assert_within(rwedge_contact_tilt(contact) / 0.01, value, 1e-5 + error);
        if (is(h, i, "moment"))
            assert_within(M, value, 1e-3 * P * half + error);
        if (is(h, i, "q") && error < 1e-3 * h->f * p0) {
            s->shear_error += fmax(0, fabs(shear(contact, x) - value) - error) / (h->f * p0);
            s->shears++;
        }
    }
}

static void note_stresses(const history *h, int load, const rwedge_contact *contact, seen *s)
{
    const int first = h->loads > 20 ? h->loads - 17 : 0;
    if (load < first)
        return;
    if (load == first)
        s->energy = rwedge_contact_dissipated_energy(contact);
    for (int i = 0; i < h->rows; i++)
        if (h->row[i][0] == -1 && h->row[i][1] != 0) {
            const double xx = stress_at(contact, h->row[i][1], 0).xx;
            s->most[i] = load == first ? xx : fmax(s->most[i], xx);
            s->least[i] = load == first ? xx : fmin(s->least[i], xx);
        }
}

static void check_extremes(const history *h, const rwedge_contact *contact, const seen *s)
{
    const double tension = largest(h, "sxx_max"), range = largest(h, "sxx_range");
    for (int i = 0; i < h->rows; i++) {
        const double value = h->row[i][2], error = h->row[i][3];
        if (is(h, i, "sxx_max"))
            assert_within(s->most[i], value, 5e-3 * tension + error);
        if (is(h, i, "sxx_range"))
            assert_within(s->most[i] - s->least[i], value, 5e-3 * range + error);
        if (is(h, i, "energy")) /* theta^2/A of the unit a */
            assert_close((rwedge_contact_dissipated_energy(contact) - s->energy) / 0.01, value,
                         1e-2);
    }
    assert_true(s->shear_error / s->shears < 5e-4);
}

CLAIM(unlike_bodies_have_the_values_of_coupled_elements)
{
    static history h;
    for (int number = 0; number < cases_or(2); number++) {
        seen s = {.energy = 0};
        read_case(number, &h);
        rwedge_contact *contact = create_pad(&h);
        for (int i = 0; i < h.loads; i++) {
            const double *to = h.load[i];
            apply(contact, to[0], to[1], to[2], to[3]);
            check_load(&h, i, contact, &s);
            note_stresses(&h, i, contact, &s);
        }
        check_extremes(&h, contact, &s);
    }
}

/* ---- Symmetry and limits ---- */

static const rw_loads SOME[] = {{7.7, 0, 0, 0}, {7.7, 0.4, 1.5, 0}, {8, 0.1, -0.8, 0.1}};

CLAIM(the_mirror_image_goes_the_other_way)
{
    rwedge_contact *here = wedge(-0.1), *there = wedge(-0.1), *opposite = wedge(0.1);
    for (int i = 0; i < 3; i++) {
        apply(here, SOME[i].P, SOME[i].M, SOME[i].Q, SOME[i].sigma);
        apply(there, SOME[i].P, -SOME[i].M, -SOME[i].Q, SOME[i].sigma);
        apply(opposite, SOME[i].P, SOME[i].M, -SOME[i].Q, -SOME[i].sigma);
    }
    for (double x = -4.2; x < 4.3; x += 0.3) {
        const double scale = F * 2;
        assert_within(pressure(there, -x), pressure(here, x), 1e-3 * scale);
        assert_within(shear(there, -x), -shear(here, x), 1e-3 * scale);
        assert_within(pressure(opposite, x), pressure(here, x), 1e-3 * scale);
        assert_within(shear(opposite, x), -shear(here, x), 1e-3 * scale);
    }
}

CLAIM(similar_bodies_are_the_limit)
{
    rwedge_contact *nearly = wedge(1e-6), *similar = wedge(0);
    for (int i = 0; i < 3; i++) {
        apply(nearly, SOME[i].P, SOME[i].M, SOME[i].Q, SOME[i].sigma);
        apply(similar, SOME[i].P, SOME[i].M, SOME[i].Q, SOME[i].sigma);
    }
    assert_within(edges_of(nearly).left, edges_of(similar).left, 1e-5);
    assert_same_shear(nearly, similar, 2e-3);
}

/* Close to full sliding the pressure is nearly that of full sliding, in closed form. */
CLAIM(full_sliding_is_the_limit)
{
    rwedge_contact *nearly = wedge(-0.1), *slides = wedge(-0.1);
    apply(nearly, 7.7, 0, 0, 0);
    apply(nearly, 7.7, 0, 0.9999 * F * 7.7, 0);
    apply(slides, 7.7, 0, F * 7.7, 0);
    const rw_patch a = edges_of(nearly), b = edges_of(slides);
    assert_within(a.left, b.left, 1e-3 * b.right);
    assert_within(a.right, b.right, 1e-3 * b.right);
    for (double x = -3.6; x < 3.7; x += 0.37)
        assert_within(pressure(nearly, x), pressure(slides, x), 3e-3 * 2);
    apply(slides, 7.7, 0, 0.9 * F * 7.7, 0); /* and back from it */
    assert_within(pressure(slides, 1), pressure(nearly, 1), 0.01 * 2);
    apply(slides, 7.7, 0, -F * 7.7, 0);
    assert_true(rwedge_contact_error(slides) == 0);
}

/* Pressed in one load or in two, with so little friction that most of it slips meanwhile. */
CLAIM(pressing_goes_on_along_its_line)
{
    rwedge_contact *once = unlike(create_flat(0, 1, 1, 0.1), -0.14, 1e-3);
    rwedge_contact *twice = unlike(create_flat(0, 1, 1, 0.1), -0.14, 1e-3);
    apply(once, 0.02, 0, 0, 0);
    apply(twice, 0.002, 0, 0, 0);
    apply(twice, 0.02, 0, 0, 0);
    assert_true(edges_of(once).right == edges_of(twice).right);
    for (double x = 0.01; x < 0.11; x += 0.01)
        assert_true(shear(once, x) == shear(twice, x));
    assert_true(rwedge_contact_error(twice) < 2e-3);
    assert_close(rwedge_contact_dissipated_energy(twice), rwedge_contact_dissipated_energy(once),
                 1e-12);
}

/* ---- A first load in one line ---- */

/* Of any kind: P, M or the tilt, Q and sigma grow together from touching on. */
typedef struct {
    rwedge_contact *contact;
    double f, P, turn, Q, sigma;
    bool is_held;
} first_load;

static first_load draw_first_load(int number, uint64_t *seed)
{
    const double flat = random_between(seed, 0.1, 1), beta = random_between(seed, -0.25, 0.25);
    const int kind = number % 3;
    first_load l = {
        .f = random_between(seed, 0.05, 0.9), .P = kind == 0 ? 5 : 1.5, .is_held = number % 2 == 1};
    l.Q = random_between(seed, -0.95, 0.95) * l.f * l.P;
    if (number % 4 < 2)
        l.turn = random_between(seed, -1, 1) * (l.is_held ? 3e-4 : 0.05 * l.P);
    if (number % 8 < 4)
        l.sigma = random_between(seed, -0.2, 0.2) * l.f;
    l.contact = unlike(kind == 0   ? create_wedge(0.01, flat, 0.01, l.f)
                       : kind == 1 ? create_flat(0, 100, 0.01, l.f)
                                   : create_flat(flat, 100, 0.01, l.f),
                       beta, 1e-3);
    assert_ok(rwedge_contact_set_rotation(l.contact, l.is_held));
    return l;
}

static void go(const first_load *l)
{
    if (l->is_held)
        assert_ok(rwedge_contact_guide(l->contact, l->P, l->turn, l->Q, l->sigma));
    else
        apply(l->contact, l->P, l->turn, l->Q, l->sigma);
}

CLAIM(any_first_load_ends_in_balance_and_tells_a_small_error)
{
    const long loads = cases_or(12);
    uint64_t seed = seed_or(5);
    enum { PLACES = 2000 };
    for (int i = 0; i < loads; i++) {
        const first_load l = draw_first_load(i, &seed);
        go(&l);
        const rw_patch edges = edges_of(l.contact);
        const double half = rw_patch_half_width(edges), middle = rw_patch_middle(edges);
        double P = 0, M = 0, Q = 0, loaded[4];
        for (int k = 0; k < PLACES; k++) {
            const double angle = PI * (k + 0.5) / PLACES, x = middle - half * cos(angle);
            const double width = half * sin(angle) * PI / PLACES, p = pressure(l.contact, x);
            P -= p * width;
            M -= p * x * width;
            Q -= shear(l.contact, x) * width;
            assert_true(fabs(shear(l.contact, x)) <= -l.f * p + 5e-3 * l.f);
        }
        assert_ok(rwedge_contact_loads(l.contact, loaded, loaded + 1, loaded + 2, loaded + 3));
        assert_close(P, l.P, 1e-3);
        assert_within(M, loaded[1], 1e-3 * l.P * half);
        assert_within(Q, l.Q, 1e-3 * l.f * l.P);
        assert_true(rwedge_contact_error(l.contact) < 0.02);
    }
}

/* Where the coupling is weak, it is the first load of similar bodies. */
CLAIM(a_first_load_of_nearly_similar_bodies_is_theirs)
{
    rwedge_contact *nearly = wedge(1e-4), *similar = wedge(0);
    apply(nearly, 5, 0.3, 1.2, 0.1);
    apply(similar, 5, 0.3, 1.2, 0.1);
    assert_within(edges_of(nearly).left, edges_of(similar).left, 1e-3);
    assert_same_shear(nearly, similar, 5e-3);
}

/* It may be cut: the line from touching is grown anew. */
CLAIM(a_first_load_goes_on_along_its_line)
{
    rwedge_contact *once = wedge(-0.2), *twice = wedge(-0.2), *opposite = wedge(0.2);
    apply(once, 5, 0.2, 1.5, 0.05);
    apply(twice, 2.5, 0.1, 0.75, 0.025);
    apply(twice, 5, 0.2, 1.5, 0.05);
    apply(opposite, 5, 0.2, -1.5, -0.05);
    for (double x = -2.3; x < 2.7; x += 0.25) {
        assert_true(shear(once, x) == shear(twice, x));
        assert_within(shear(opposite, x), -shear(once, x), 2e-3);
    }
}

/* In proportion to P, on a cylinder that is held, all lengths grow like the root of P. */
CLAIM(a_first_load_of_a_cylinder_is_like_itself)
{
    rwedge_contact *small = unlike(create_flat(0, 100, 0.01, F), 0.2, 1e-3);
    rwedge_contact *large = unlike(create_flat(0, 100, 0.01, F), 0.2, 1e-3);
    assert_ok(rwedge_contact_set_rotation(small, 1));
    assert_ok(rwedge_contact_set_rotation(large, 1));
    assert_ok(rwedge_contact_guide(small, 1, 0, 0.3, 0));
    assert_ok(rwedge_contact_guide(large, 4, 0, 1.2, 0));
    const rw_patch here = edges_of(small), there = edges_of(large);
    assert_close(2 * here.left, there.left, 1e-5);
    assert_close(2 * here.right, there.right, 1e-5);
    for (double x = here.left; x < here.right; x += 0.1)
        assert_within(2 * shear(small, x), shear(large, 2 * x), 1e-4);
}

/* ---- What such a contact does ---- */

/* The tractions carry the loads, and are within friction. */
CLAIM(tractions_are_in_balance)
{
    rwedge_contact *contact = wedge(-0.2);
    assert_ok(rwedge_contact_set_rotation(contact, 1));
    apply(contact, 5, 0, 0, 0);
    apply(contact, 5, 0, 1.8, 0);
    const rw_patch edges = edges_of(contact);
    const double half = rw_patch_half_width(edges), middle = rw_patch_middle(edges);
    double P = 0, M = 0, Q = 0, loads[4];
    enum { PLACES = 4000 };
    for (int i = 0; i < PLACES; i++) {
        const double angle = PI * (i + 0.5) / PLACES, x = middle - half * cos(angle);
        const double step = half * sin(angle) * PI / PLACES, p = pressure(contact, x);
        P -= p * step;
        M -= p * x * step;
        Q -= shear(contact, x) * step;
        assert_true(p <= 0 && fabs(shear(contact, x)) <= -F * p + 1e-3);
    }
    assert_ok(rwedge_contact_loads(contact, &loads[0], &loads[1], &loads[2], &loads[3]));
    assert_close(P, 5, 1e-5);
    assert_close(Q, 1.8, 1e-4);
    assert_within(M, loads[1], 1e-4 * 5 * half);
    assert_within(rwedge_contact_tilt(contact), 0, 1e-15);
    assert_true(rwedge_contact_error(contact) > 0);
}

CLAIM(without_a_tolerance_partial_slip_is_refused)
{
    rwedge_contact *contact = unlike(create_wedge(0.01, 1, 0.01, F), 0.2, 0);
    refuse(contact, 1, 0, 0.2, 0, RWEDGE_EPATH);
    apply(contact, 1, 0, F, 0);
    refuse(contact, 1, 0, 0.2, 0, RWEDGE_EPATH);
}

CLAIM(a_restored_contact_goes_on_to_the_same_bits)
{
    rwedge_contact *contact = wedge(-0.1);
    for (int i = 0; i < 3; i++) {
        rwedge_contact *again = restored(state_of(contact));
        apply(contact, SOME[i].P, SOME[i].M, SOME[i].Q, SOME[i].sigma);
        apply(again, SOME[i].P, SOME[i].M, SOME[i].Q, SOME[i].sigma);
        assert_state(again, state_of(contact));
    }
}

/* Under a constant P, at a constant tilt or moment, what is dissipated in a cycle is the area of
 * its loop of Q over the displacement; with so many chords it is 0.7 % smaller. A free pad turns to
 * and fro, on which a constant M spends nothing. */
CLAIM(the_loop_of_the_displacement_is_the_energy)
{
    enum { STEPS = 32 };
    for (int is_held = 0; is_held < 2; is_held++) {
        rwedge_contact *contact = wedge(-0.1);
        assert_ok(rwedge_contact_set_rotation(contact, is_held));
        apply(contact, 7.7, 0, 0, 0);
        const double b = rwedge_contact_half_width(contact);
        apply(contact, 7.7, 0, 2.7, 0);
        apply(contact, 7.7, 0, -2.7, 0);
        apply(contact, 7.7, 0, 2.7, 0);
        const double energy = rwedge_contact_dissipated_energy(contact);
        double area = 0, Q = 2.7, u = rwedge_contact_displacement(contact, b);
        for (int i = 1; i <= STEPS; i++) {
            const double next_Q = 2.7 * cos(2 * PI * i / STEPS);
            apply(contact, 7.7, 0, next_Q, 0);
            const double next = rwedge_contact_displacement(contact, b);
            area += (Q + next_Q) / 2 * (next - u);
            Q = next_Q;
            u = next;
        }
        assert_close(area, rwedge_contact_dissipated_energy(contact) - energy, 0.012);
    }
}

/* In a cycle a place slips to and fro by its range, under no more than the largest friction. */
CLAIM(slip_and_energy_of_a_cycle_agree)
{
    enum { LOADS = 4, PLACES = 400 };
    const double P[] = {7.7, 7.7, 7.7, 7.7}, M[] = {0, 0, 0, 0}, Q[] = {2.3, 0, -2.3, 0},
                 sigma[] = {0, 0, 0, 0};
    rwedge_contact *contact =
        APPLY(wedge(-0.1), {7.7, 0, 0, 0}, {7.7, 0, 2.3, 0}, {7.7, 0, -2.3, 0}, {7.7, 0, 2.3, 0});
    rwedge_contact *going = copy_of(contact);
    double x[PLACES], range[PLACES], energy[PLACES], f1[PLACES], f2[PLACES], sum = 0;
    const rw_patch edges = edges_of(contact);
    for (int i = 0; i < PLACES; i++)
        x[i] = 1.05 * (edges.left + (edges.right - edges.left) * (i + 0.5) / PLACES);
    const double before = rwedge_contact_dissipated_energy(going);
    for (int i = 1; i <= LOADS; i++)
        apply(going, P[i % LOADS], M[i % LOADS], Q[i % LOADS], sigma[i % LOADS]);
    const double dissipated = rwedge_contact_dissipated_energy(going) - before;
    rwedge_cycle *cycle;
    assert_ok(rwedge_cycle_create(contact, LOADS, P, M, Q, sigma, &cycle));
    assert_ok(rwedge_cycle_friction(cycle, PLACES, x, range, f1, f2, energy));
    rwedge_cycle_destroy(cycle);
    for (int i = 0; i < PLACES; i++)
        sum += 2 * f1[i] * 1.05 * (edges.right - edges.left) / PLACES;
    assert_true(sum > dissipated && sum < 1.06 * dissipated);
}

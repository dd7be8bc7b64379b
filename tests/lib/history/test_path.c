/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with moment and bulk tension. */
#include "histories.h"
#include "history/off_centre.h"
#include "quadrature.h"

#include <fenv.h>
#include <string.h>

static const double F = 0.5;

/* One step from (P, M) to (P, M, Q, sigma), in 30 digits. */
CLAIM(one_step_agrees_with_30_digits)
{
    reference rows = reference_open("eccentric.csv");
    while (reference_next(&rows)) {
        const double *c = rows.cell, width = c[9] - c[8], less = 1 - fabs(c[10]) / c[0];
        rwedge_contact *contact = create_wedge(c[0], c[1], c[2], c[3]);
        apply(contact, c[4], c[5], 0, 0);
        apply(contact, c[4], c[5], c[6], c[7]);
        const rw_patch whole = edges_of(contact), stick = stick_zone_of(contact);
        assert_within(whole.left, c[8], 3e-15 * width / less);
        assert_within(whole.right, c[9], 3e-15 * width / less);
        assert_within(rwedge_contact_tilt(contact), c[10], 2e-15 * c[0]);
        assert_within(stick.left, c[11], 3e-15 * width / less);
        assert_within(stick.right, c[12], 3e-15 * width / less);
        for (const double *p = c + 13; p < c + 28; p += 5) {
            const stresses expected = {p[2], p[3], p[4]};
            const double norm = hypot(hypot(p[2], p[3]), p[4]);
            const double z = hypot(p[0] - (c[8] + c[9]) / 2, p[1]) / (width / 2);
            assert_within(apart(stress_at(contact, p[0], p[1]), expected), 0,
                          2e-14 * fmax(norm, c[0] / c[2] / (1 + z)));
        }
    }
    assert_int_equal(rows.row, 60);
}

/* Nowell and Hills (1987): the stick zone of a cylinder is c = a sqrt(1 - Q/(fP)) wide, its centre
 * e = a sigma/(4 f p0) off. E = 72.1 GPa, nu = 0.33, 543 N and 155 N on 4 mm, R = 10 mm, f = 0.3,
 * sigma = 100 MPa: half-width 0.206698 mm, p0 = 418.104 MPa, c = 0.045519, e = 0.041197, trailing
 * edge 345.747 MPa. */
CLAIM(nowell_and_hills_cylinder)
{
    const double compliance = rwedge_compliance(72.1e3, 0.33, 72.1e3, 0.33), R = 10, a = 3;
    rwedge_contact *contact = create_wedge(a / R, a, compliance, 0.3);
    apply(contact, 543 / 4.0, 0, 0, 0);
    apply(contact, 543 / 4.0, 0, 155 / 4.0, 100);
    const rw_patch whole = edges_of(contact), stick = stick_zone_of(contact);
    assert_within(whole.right, 0.206698, 5e-7);
    assert_within(-pressure(contact, 0), 418.104, 5e-4);
    assert_within(rw_patch_half_width(stick), 0.045519, 5e-7);
    assert_within(rw_patch_middle(stick), 0.041197, 5e-7);
    assert_within(stress_at(contact, whole.left, 0).xx, 345.747, 5e-4);
}

/* p0 = 157, sigma = 92.7, Q/P = 0.45, f = 0.75: c/a = 0.6325, e/a = 0.1968, edge 1.8193 p0. */
CLAIM(nowell_and_hills_ratios)
{
    const double f = 0.75, p0 = 157, a = 100, unit = 157 * 100; /* p0 = theta/A b/a at b = 1 */
    rwedge_contact *contact = create_wedge(0.1, a, 0.1 / unit, f);
    const double P = rwedge_normal_load(0.1, a, 0.1 / unit, 1);
    apply(contact, P, 0, 0, 0);
    apply(contact, P, 0, 0.45 * P, 92.7);
    const rw_patch stick = stick_zone_of(contact);
    assert_within(rw_patch_half_width(stick), 0.6325, 5e-5);
    assert_within(rw_patch_middle(stick), 0.1968, 5e-5);
    assert_within(stress_at(contact, -1, 0).xx / p0, 1.8193, 5e-5);
}

/* NAFEMS' contact benchmark CB1: a steel cylinder of R = 50 on aluminium, 35 kN/mm. */
CLAIM(nafems_cylinder)
{
    const double compliance = rwedge_compliance(210e3, 0.3, 70e3, 0.3), a = 20;
    rwedge_contact *contact = create_wedge(a / 50, a, compliance, 0);
    apply(contact, 35e3, 0, 0, 0);
    assert_within(edges_of(contact).right, 6.2146, 5e-5);
    assert_within(-pressure(contact, 0), 3585.36, 5e-2); /* of 3585.37 by rounding of its inputs */
}

/* ---- Random histories under constant P and M ---- */

typedef struct {
    double a, P, M, Q, sigma;
    rwedge_contact *contact;
} cycle;

static cycle random_cycle(uint64_t *seed)
{
    static const double ROUNDINGS[] = {0, 0.05, 0.4, 1, 6};
    cycle c = {.a = ROUNDINGS[(int)(5 * random_fraction(seed))], .P = 0.05 + random_fraction(seed)};
    c.contact = create(c.a, F);
    c.M = (2 * random_fraction(seed) - 1) * c.P * fmax(c.a, 1);
    apply(c.contact, c.P, c.M, 0, 0);
    return c;
}

/* A step that slips one way: |d sigma| <= 4 |dQ|/(pi s). It may end where fronts part. */
static int32_t random_step(cycle *c, uint64_t *seed)
{
    const double Q = 0.95 * F * c->P * (2 * random_fraction(seed) - 1);
    const double largest = rwedge_contact_largest_tension_step(c->contact, Q);
    const double sigma = c->sigma + largest * (2 * random_fraction(seed) - 1);
    const int32_t status = rwedge_contact_apply(c->contact, c->P, c->M, Q, sigma);
    if (status == RWEDGE_OK) {
        c->Q = Q;
        c->sigma = sigma;
    }
    return status;
}

static double pressure_at(double x, const void *contact)
{
    return -pressure(contact, x);
}

static double moment_at(double x, const void *contact)
{
    return -x * pressure(contact, x);
}

static double shear_at(double x, const void *contact)
{
    return -shear(contact, x);
}

static void insert(double points[], size_t *n, double at, rw_patch within)
{
    if (at < within.left || at > within.right)
        return;
    size_t i = 0;
    while (i < *n && points[i] < at)
        i++;
    if (i < *n && points[i] == at)
        return;
    memmove(points + i + 1, points + i, (*n - i) * sizeof *points);
    points[i] = at;
    ++*n;
}

/* Where the tractions are not smooth. */
static size_t marks(const rwedge_contact *contact, double points[])
{
    const rw_patch whole = edges_of(contact);
    size_t n = 0;
    for (size_t i = 1; i < contact->memory.count; i++) {
        insert(points, &n, contact->memory.corners[i].patch.left, whole);
        insert(points, &n, contact->memory.corners[i].patch.right, whole);
    }
    insert(points, &n, -contact->geometry.a, whole);
    insert(points, &n, contact->geometry.a, whole);
    return n - 1;
}

CLAIM(tractions_carry_the_loads)
{
    uint64_t seed = 5;
    for (int i = 0; i < 25; i++) {
        cycle c = random_cycle(&seed);
        for (int k = 0; k < 4; k++)
            random_step(&c, &seed);
        double points[64];
        const size_t n = marks(c.contact, points);
        const double reach = fmax(-points[0], points[n]);
        assert_close(integral(pressure_at, c.contact, n, points), c.P, 1e-10);
        assert_within(integral(moment_at, c.contact, n, points), c.M, 1e-10 * c.P * reach);
        assert_within(integral(shear_at, c.contact, n, points), c.Q, 1e-10 * c.P);
    }
}

/* (M, Q, sigma) -> (-M, -Q, sigma) is seen in a mirror. */
CLAIM(opposite_loads_give_the_mirror_image)
{
    rwedge_contact *one = create(0.4, F), *other = create(0.4, F);
    const double loads[][4] = {
        {0.5, 0.1, 0, 0}, {0.5, 0.1, 0.12, 0.03}, {0.5, 0.1, -0.2, -0.04}, {0.5, 0.1, 0.05, 0.02}};
    for (size_t i = 0; i < sizeof loads / sizeof *loads; i++) {
        const double *l = loads[i];
        apply(one, l[0], l[1], l[2], l[3]);
        apply(other, l[0], -l[1], -l[2], l[3]);
        assert_true(edges_of(one).left == -edges_of(other).right);
        for (double x = -3; x < 3; x += 0.31) {
            const stresses s = stress_at(one, x, 0.2), t = stress_at(other, -x, 0.2);
            assert_within(apart(s, (stresses){t.xx, t.yy, -t.xy}), 0, 1e-14);
        }
    }
}

/* A tension that is there before the contact only adds. */
CLAIM(tension_before_contact_only_adds)
{
    rwedge_contact *with = create(0.4, F), *without = create(0.4, F);
    apply(with, 0, 0, 0, 0.7);
    load(with, 0.5, 0);
    load(with, 0.5, 0.1);
    load(without, 0.5, 0);
    load(without, 0.5, 0.1);
    const stresses s = stress_at(with, 0.3, 0.1), t = stress_at(without, 0.3, 0.1);
    assert_within(s.xx, t.xx + 0.7, 1e-15);
    assert_true(s.yy == t.yy && s.xy == t.xy);
}

/* ---- What is refused ---- */

static void refuse(rwedge_contact *contact, double P, double M, double Q, double sigma,
                   int32_t expected)
{
    const contact_state before = state_of(contact);
    assert_int_equal(rwedge_contact_apply(contact, P, M, Q, sigma), expected);
    assert_true((strlen(rwedge_contact_obstacle(contact, P, M, Q, sigma)) > 0) ==
                (expected == RWEDGE_EPATH));
    assert_state(contact, before);
}

CLAIM(what_has_no_closed_form_is_refused)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.5, 0.1, 0, 0);
    const double largest = rwedge_contact_largest_tension_step(contact, 0.1);
    refuse(contact, 0.5, 0.1, 0.1, 1.001 * largest, RWEDGE_EPATH); /* slips both ways */
    refuse(contact, 0.5, 0.1, 0, 1e-6, RWEDGE_EPATH);
    refuse(contact, 0.6, 0.12, 0.05, 0, RWEDGE_EPATH); /* grows with shear and tilts */
    refuse(contact, 0.5, 0.1, 0.3, 0, RWEDGE_ESLIDING);
    refuse(contact, 0, 0.1, 0, 0, RWEDGE_EDOMAIN);
    refuse(contact, 0.5, NAN, 0, 0, RWEDGE_EDOMAIN);
    refuse(contact, 0.5, 0.1, 0, HUGE_VAL, RWEDGE_EDOMAIN);
    refuse(contact, 0.5, 1e15, 0, 0, RWEDGE_EDOMAIN);      /* a flank on the surface */
    apply(contact, 0.5, 0.1, 0.1, largest);                /* at the limit */
    refuse(contact, 0.5, 0.2, 0.1, largest, RWEDGE_EPATH); /* one edge recedes */
    apply(contact, 0.6, 0.12, 0.1, largest);
    assert_string_equal(rwedge_contact_obstacle(contact, 0.6, 0.12, 0.1, largest), "");
}

/* The front ends inside the first step's at both edges, but at the left there is a part beyond it
 * that sticks. */
static rwedge_contact *contact_with_two_fronts(void)
{
    rwedge_contact *contact = create(0.46, 0.45);
    apply(contact, .4779, 0, 0, 0);
    apply(contact, .4779, 0, -.1494, -.0994);
    apply(contact, .4779, 0, -.1029, -.0537);
    return contact;
}

CLAIM(what_sticks_between_two_fronts_is_refused)
{
    rwedge_contact *contact = contact_with_two_fronts();
    refuse(contact, .4779, 0, -.1845, -.0204, RWEDGE_EPATH);
    apply(contact, .4779, 0, -.2008, -.0137);
}

/* The least slip of a step, in its direction, next to the left edge: where the old front was. */
static double least_slip(const rwedge_contact *before, const rwedge_contact *after)
{
    const rw_patch whole = edges_of(after), stick = stick_zone_of(after);
    const double reach = stick.left - whole.left,
                 at_edge = slip(after, whole.left) - slip(before, whole.left);
    double least = HUGE_VAL;
    for (double t = 0; t < 0.9; t += 0.001) {
        const double x = whole.left + t * reach;
        least = fmin(least, (slip(after, x) - slip(before, x)) / at_edge);
    }
    return least;
}

/* Between the refused load and the next one that is not, the limit is where slip vanishes at one
 * point. */
CLAIM(the_limit_is_where_slip_vanishes)
{
    rwedge_contact *before = contact_with_two_fronts();
    double refused = 0, accepted = 1, least = 0;
    while (accepted - refused > 1e-12) {
        const double t = (accepted + refused) / 2;
        rwedge_contact *after = copy_of(before);
        const int32_t status = rwedge_contact_apply(after, .4779, 0, -.1845 + t * (-.2008 + .1845),
                                                    -.0204 + t * (-.0137 + .0204));
        if (status == RWEDGE_OK) {
            accepted = t;
            least = least_slip(before, after);
            assert_true(least > 0);
        } else {
            assert_int_equal(status, RWEDGE_EPATH);
            refused = t;
        }
    }
    assert_true(refused > 0 && accepted < 1 && least < 1e-3);
}

/* Q returns to that of a corner, sigma does not. */
CLAIM(a_corner_with_another_tilt_is_refused)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, 0.1, 0.2, 0.02);
    apply(contact, 0.5, 0.1, -0.1, -0.03);
    refuse(contact, 0.5, 0.1, 0.2, 0.025, RWEDGE_EPATH);
    apply(contact, 0.5, 0.1, 0.2, 0.02);
}

/* The ring that is added has one D only where the tilt stays as it is. */
CLAIM(rings_with_shear_need_a_constant_tilt)
{
    rwedge_contact *hertz = create(6, F), *centred = create(0.4, F);
    apply(hertz, 0.5, 0.5, 0, 0);
    refuse(hertz, 0.6, 0.59, 0.03, 0, RWEDGE_EPATH);
    refuse(hertz, 0.6, 0.6, 0.03, 0.001, RWEDGE_EPATH);
    apply(hertz, 0.6, 0.6, 0.03, 0);
    assert_true(stick_zone_of(hertz).left == edges_of(hertz).left);
    refuse(hertz, 0.55, 0.54, 0.015, 0, RWEDGE_EPATH);
    apply(hertz, 0.55, 0.55, 0.015, 0); /* along the same line */
    assert_true(stick_zone_of(hertz).left == edges_of(hertz).left);
    apply(centred, 0.5, 0, 0, 0);
    apply(centred, 0.5, 0, 0.1, 0.01);
    apply(centred, 0.6, 0, 0.12, 0.01);
    refuse(centred, 0.7, 0.001, 0.13, 0.01, RWEDGE_EPATH);
    apply(centred, 0.62, 0, 0.2, 0.012); /* and slips */
    hertz = create(6, F);
    apply(hertz, 0.5, 0.5, 0.1, 0); /* from the first touch on */
    assert_close(shear(hertz, 1), 0.4 * F * pressure(hertz, 1), 1e-14);
}

/* What recedes leaves patches of the history at both edges at once, or not at all. */
CLAIM(recession_is_refused_where_it_passes_a_patch_at_one_edge)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, 0.1, 0.1, 0.01);
    apply(contact, 0.6, 0.12, 0.1, 0.01);
    refuse(contact, 0.45, 0.09, 0.075, 0.01, RWEDGE_EPATH); /* past a corner */
    refuse(contact, 0.51, 0.06, 0.1, 0.01, RWEDGE_EPATH);   /* at one edge */
    apply(contact, 0.55, 0.1, 0.1, 0.01);
    apply(contact, 0.5, 0.1, 0.1, 0.01); /* to the corner, and on */
    apply(contact, 0.45, 0.09, 0.1, 0.01);
    apply(contact, 0.2, 0.03, 0.04, 0.01);
}

static void assert_same_state(const rwedge_contact *one, const rwedge_contact *other)
{
    assert_within(edges_of(one).left, edges_of(other).left, 1e-14);
    assert_within(stick_zone_of(one).left, stick_zone_of(other).left, 1e-14);
    assert_within(stick_zone_of(one).right, stick_zone_of(other).right, 1e-14);
    assert_int_equal(one->memory.count, other->memory.count);
}

/* What recedes without slip to a patch of the history, and goes on, may do so in one step. */
CLAIM(recession_passes_a_patch_at_both_edges_at_once)
{
    static const double moments[] = {0, 0.2}, ends[] = {0.45, 0.3};
    for (int i = 0; i < 4; i++) {
        const double arm = moments[i / 2], P = ends[i % 2], Q = 0.1;
        rwedge_contact *one = create(0.4, F);
        apply(one, 0.5, 0.5 * arm, 0, 0);
        apply(one, 0.5, 0.5 * arm, Q, 0.01);
        apply(one, 0.6, 0.6 * arm, Q, 0.01);
        rwedge_contact *two = copy_of(one);
        apply(one, P, P * arm, Q, 0.01);
        apply(two, 0.5, 0.5 * arm, Q, 0.01);
        apply(two, P, P * arm, Q, 0.01);
        assert_same_state(one, two);
    }
}

/* In shorter steps the front goes the same way. */
CLAIM(long_steps_lead_where_short_ones_do)
{
    static const double from[] = {0.5, 0.1, 0.1, 0.01}, to[][4] = {{0.15, 0.03, 0.03, 0.003},
                                                                   {0.9, 0.19, 0.35, 0.02},
                                                                   {0.3, 0.06, -0.1, 0.005},
                                                                   {0.3, 0.06, 0.1, 0.01}};
    for (size_t i = 0; i < sizeof to / sizeof *to; i++) {
        rwedge_contact *one = create(0.4, F), *many = create(0.4, F);
        apply(one, 0.5, 0.1, 0, 0);
        apply(one, from[0], from[1], from[2], from[3]);
        apply(one, to[i][0], to[i][1], to[i][2], to[i][3]);
        apply(many, 0.5, 0.1, 0, 0);
        apply(many, from[0], from[1], from[2], from[3]);
        for (int k = 1; k <= 8; k++) {
            double at[4];
            for (int j = 0; j < 4; j++)
                at[j] = from[j] + k / 8.0 * (to[i][j] - from[j]);
            apply(many, at[0], at[1], at[2], at[3]);
        }
        assert_within(stick_zone_of(one).left, stick_zone_of(many).left, 1e-13);
        assert_within(stick_zone_of(one).right, stick_zone_of(many).right, 1e-13);
    }
}

CLAIM(a_tilted_contact_slides)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, 0.1, 0.25, 0.01);
    double x = 0.2, w;
    assert_int_equal(rwedge_contact_stick_zone(contact, &x, &w), RWEDGE_EABSENT);
    assert_close(shear(contact, x), F * pressure(contact, x), 1e-15);
    assert_nan(rwedge_contact_dissipated_energy(contact));
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    apply(contact, 0.5, 0.1, 0.1, 0.005);
    apply(contact, 0.5, 0.1, 0.25, 0.005); /* slides again, over a front */
    assert_int_equal(contact->memory.count, 2);
}

/* With |Q| = f P there is one traction, whatever the way: also where the edges part, and where the
 * contact recedes. */
CLAIM(every_way_leads_to_sliding)
{
    static const double to[][4] = {{0.5, 0.2, 0.25, 0.01},
                                   {0.3, 0.06, -0.15, 0.02},
                                   {0.3, -0.06, 0.15, 0},
                                   {0.8, 0.1, 0.4, 1}};
    for (size_t i = 0; i < sizeof to / sizeof *to; i++) {
        rwedge_contact *contact = create(0.4, F), *fresh = create(0.4, F);
        apply(contact, 0.5, 0.1, 0, 0);
        apply(contact, 0.5, 0.1, 0.25, 0.01);
        const double *l = to[i], sign = l[2] < 0 ? -1 : 1, P = l[0], M = l[1];
        apply(contact, P, M, l[2], l[3]);
        apply(fresh, 0, 0, 0, l[3]);
        apply(fresh, P, M, 0, l[3]);
        apply(fresh, P, M, l[2], l[3]);
        assert_int_equal(contact->memory.count, 2);
        assert_within(shear(contact, 0), sign * F * pressure(contact, 0), 1e-15);
        apply(contact, P, M, 0, l[3] - sign * 0.01);
        apply(fresh, P, M, 0, l[3] - sign * 0.01);
        assert_same_state(contact, fresh);
    }
}

CLAIM(a_moment_may_be_taken_away)
{
    rwedge_contact *contact = create(0.4, F), *fresh = create(0.4, F);
    apply(contact, 0.5, 0.05, 0, 0);
    apply(contact, 0.4, 0, 0, 0);
    apply(contact, 0.4, 0, 0.1, 0);
    apply(fresh, 0.4, 0, 0, 0);
    apply(fresh, 0.4, 0, 0.1, 0);
    assert_true(edges_of(contact).left == edges_of(fresh).left);
    assert_within(stick_zone_of(contact).left, stick_zone_of(fresh).left, 1e-14);
}

/* Without friction the history leaves nothing, and M may do what it will. */
CLAIM(without_friction_all_is_exact)
{
    rwedge_contact *contact = create(0.4, 0);
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, -0.3, 0, 2);
    apply(contact, 0.3, 0.2, 0, -1);
    rwedge_contact *fresh = create(0.4, 0);
    apply(fresh, 0.3, 0.2, 0, 0);
    assert_true(edges_of(contact).left == edges_of(fresh).left);
    assert_int_equal(rwedge_contact_memory(contact), 1);
    assert_true(rwedge_contact_largest_tension_step(contact, 0) == HUGE_VAL);
    assert_string_equal(rwedge_contact_obstacle(contact, 0.2, 0.3, 0, 5), "");
    apply(contact, 0, 0, 0, 0);
}

CLAIM(random_loads_are_finite_or_change_nothing)
{
    uint64_t seed = 77;
    int accepted = 0, refused = 0;
    for (int i = 0; i < 400; i++) {
        cycle c = random_cycle(&seed);
        for (int k = 0; k < 4; k++) {
            const double P =
                random_fraction(&seed) < 0.5 ? c.P : c.P * (0.5 + random_fraction(&seed));
            const double M =
                random_fraction(&seed) < 0.7 ? c.M * P / c.P : P * (2 * random_fraction(&seed) - 1);
            const double Q =
                random_fraction(&seed) < 0.3 ? c.Q : F * P * (2 * random_fraction(&seed) - 1);
            const double sigma =
                random_fraction(&seed) < 0.5 ? c.sigma : 0.2 * random_fraction(&seed);
            const contact_state before = state_of(c.contact);
            const int32_t status = rwedge_contact_apply(c.contact, P, M, Q, sigma);
            assert_true(status == RWEDGE_OK || status == RWEDGE_EPATH || status == RWEDGE_ESLIDING);
            if (status == RWEDGE_OK)
                c.P = P, c.M = M, c.Q = Q, c.sigma = sigma;
            else
                assert_state(c.contact, before);
            status == RWEDGE_OK ? accepted++ : refused++;
            const stresses s = stress_at(c.contact, 0.3, 0.2);
            assert_true(isfinite(s.xx) && isfinite(s.yy) && isfinite(s.xy));
            const rw_patch whole = edges_of(c.contact);
            for (double t = 0.01; t < 1; t += 0.07) {
                const double x = whole.left + t * (whole.right - whole.left);
                assert_true(fabs(shear(c.contact, x)) <= -F * pressure(c.contact, x) + 1e-13);
            }
        }
    }
    assert_true(accepted > 300 && refused > 300); /* both are met with */
}

/* ---- Edges ---- */

/* The slip length 2 K_T/(f K_N) of a small Q: to 0.1 % at Q/(fP) = 0.001, 9 % at 0.1. */
CLAIM(the_slip_length_is_that_of_the_asymptotes)
{
    static const double ratios[] = {0.001, 0.1}, within[] = {0.002, 0.1};
    for (int i = 0; i < 2; i++) {
        rwedge_contact *contact = create(0.4, F);
        apply(contact, 0.5, 0.1, 0, 0);
        apply(contact, 0.5, 0.1, ratios[i] * F * 0.5, 0);
        double left, right, shear_left, shear_right;
        assert_ok(
            rwedge_contact_edge_asymptotes(contact, &left, &right, &shear_left, &shear_right));
        assert_close(stick_zone_of(contact).left - edges_of(contact).left,
                     2 * shear_left / (F * left), within[i]);
        assert_close(edges_of(contact).right - stick_zone_of(contact).right,
                     2 * shear_right / (F * right), within[i]);
    }
}

/* The stick zone after the third half-cycle, whatever came first. */
CLAIM(what_never_slips_is_what_cycles_leave)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, 0.1, 0.2, 0.02);
    apply(contact, 0.5, 0.1, -0.1, -0.03);
    apply(contact, 0.5, 0.1, 0.2, 0.02);
    apply(contact, 0.5, 0.1, -0.1, -0.03);
    double left, right;
    assert_ok(rwedge_permanent_stick(THETA, 0.4, A, F, 0.5, 0.1, -0.1, -0.03, 0.5, 0.1, 0.2, 0.02,
                                     &left, &right));
    assert_within(stick_zone_of(contact).left, left, 1e-13);
    assert_within(stick_zone_of(contact).right, right, 1e-13);
    assert_int_equal(
        rwedge_permanent_stick(THETA, 0.4, A, F, 0.5, 0, -0.25, 0, 0.5, 0, 0.25, 0, &left, &right),
        RWEDGE_EABSENT);
    assert_int_equal(
        rwedge_permanent_stick(THETA, 0.4, A, F, 0.5, 0, 0, -1, 0.5, 0, 0.01, 1, &left, &right),
        RWEDGE_EPATH);
    assert_int_equal(
        rwedge_permanent_stick(THETA, 0.4, A, F, 0.5, 0, 0, 0, 0.5, 0, 0.3, 0, &left, &right),
        RWEDGE_ESLIDING);
    assert_int_equal(
        rwedge_permanent_stick(THETA, 0.4, A, F, 0.5, 0, 0, 0, 0.5, 0, 0.1, 0, NULL, &right),
        RWEDGE_ENULL);
}

CLAIM(what_never_slips_is_the_same_on_the_way_back)
{
    double left, right, l, r;
    assert_ok(rwedge_permanent_stick(THETA, 0.4, A, F, 0.5, 0.1, -0.1, -0.03, 0.6, 0.1, 0.2, 0.02,
                                     &left, &right));
    assert_ok(rwedge_permanent_stick(THETA, 0.4, A, F, 0.6, 0.1, 0.2, 0.02, 0.5, 0.1, -0.1, -0.03,
                                     &l, &r));
    assert_true(l == left && r == right);
}

/* The ring between P = 300 and 488 takes up the change of Q: the energy stays that of the first
 * load. */
CLAIM(the_whole_smaller_contact_may_stick)
{
    double left, right;
    assert_ok(rwedge_permanent_stick(.1, 17.8, 4.81e-5, .65, 300, 0, 140, 0, 488, 0, 60, 0, &left,
                                     &right));
    rwedge_contact *contact = create_wedge(.1, 17.8, 4.81e-5, .65);
    apply(contact, 300, 0, 0, 0);
    assert_within(right, edges_of(contact).right, 1e-14 * right);
    assert_within(left, edges_of(contact).left, 1e-14 * right);
    apply(contact, 300, 0, 140, 0);
    const double energy = rwedge_contact_dissipated_energy(contact);
    for (int i = 0; i < 3; i++) {
        apply(contact, 488, 0, 60, 0);
        apply(contact, 300, 0, 140, 0);
    }
    assert_true(rwedge_contact_dissipated_energy(contact) == energy);
}

/* Q may exceed f P by rounding, as everywhere. */
CLAIM(a_cycle_may_touch_sliding)
{
    double left, right, l, r;
    assert_ok(rwedge_permanent_stick(THETA, 0.4, A, 0.3, 1000, 0, nextafter(300, 400), 0, 1000, 0,
                                     0, 0, &left, &right));
    assert_ok(rwedge_permanent_stick(THETA, 0.4, A, 0.3, 1000, 0, 300, 0, 1000, 0, 0, 0, &l, &r));
    assert_within(right, r, 1e-15 * r);
}

CLAIM(cycles_without_a_permanent_stick_zone_say_why)
{
    static const struct {
        double f, v[8]; /* P, M, Q, sigma twice */
        int32_t status;
    } cases[] = {
        {0, {0.5, 0, 0, 0, 0.6, 0, 0, 1}, RWEDGE_EABSENT},
        {0, {0.5, 0, 0, 0, 0.6, 0, 0.1, 0}, RWEDGE_ESLIDING},
        {0, {0.5, 0, 0.1, 0, 0.6, 0, 0, 0}, RWEDGE_ESLIDING},
        {0.5, {0.5, 0, 0.3, 0, 0.6, 0, 0, 0}, RWEDGE_ESLIDING},
        {0.5, {0.5, 0, 0, 0, 0.6, 0, 0.4, 0}, RWEDGE_ESLIDING},
        {0.5, {-0.5, 0, 0, 0, 0.6, 0, 0.1, 0}, RWEDGE_EDOMAIN},
        {0.5, {0.5, 0, 0, 0, -0.6, 0, 0.1, 0}, RWEDGE_EDOMAIN},
        {0.5, {0.5, 0, NAN, 0, 0.6, 0, 0.1, 0}, RWEDGE_EDOMAIN},
        {0.5, {0.5, 0, 0, NAN, 0.6, 0, 0.1, 0}, RWEDGE_EDOMAIN},
        {0.5, {0.5, 0, 0, 0, 0.6, 0, NAN, 0}, RWEDGE_EDOMAIN},
        {0.5, {0.5, 0, 0, 0, 0.6, 0, 0.1, NAN}, RWEDGE_EDOMAIN},
        {0.5, {0.5, 0.3, 0, 0, 0.6, -0.3, 0.01, 0}, RWEDGE_EPATH},
        {0.5, {0.9, 0.3, 0, 0, 0.2, 0, 0.01, 0}, RWEDGE_EPATH}, /* an edge passes it on the way */
        {0.5, {0.9, 0, 0, 0, 0, 0, 0, 0}, RWEDGE_EABSENT},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double *v = cases[i].v;
        double left = 7, right = 7;
        assert_int_equal(rwedge_permanent_stick(THETA, 0.4, A, cases[i].f, v[0], v[1], v[2], v[3],
                                                v[4], v[5], v[6], v[7], &left, &right),
                         cases[i].status);
        assert_true(left == 7 && right == 7);
    }
    double left, right;
    assert_int_equal(
        rwedge_permanent_stick(-1, 0.4, A, F, 0.5, 0, 0, 0, 0.5, 0, 0.1, 0, &left, &right),
        RWEDGE_EDOMAIN);
}

/* ---- Slip and energy ---- */

/* The loop of Q and sigma: each cycle dissipates as much, and twice as much as the slip at its ends
 * times the traction, which is f p all the time. */
static double friction_times_slip(double x, const void *contact)
{
    return F * fabs(pressure(contact, x) * slip(contact, x));
}

CLAIM(energy_is_friction_times_slip)
{
    static const double moments[] = {0, 0.1, -0.2};
    for (int i = 0; i < 3; i++) {
        rwedge_contact *contact = create(0.4, F);
        apply(contact, 0.5, moments[i], 0, 0);
        apply(contact, 0.5, moments[i], 0.2, 0.02); /* all slip has been one way */
        double points[64];
        const size_t n = marks(contact, points);
        const double first = rwedge_contact_dissipated_energy(contact);
        assert_close(first, integral(friction_times_slip, contact, n, points), 1e-10);
        apply(contact, 0.5, moments[i], -0.2, -0.02);
        const double second = rwedge_contact_dissipated_energy(contact) - first;
        apply(contact, 0.5, moments[i], 0.2, 0.02);
        const double third = rwedge_contact_dissipated_energy(contact) - first - second;
        assert_close(second, third, 1e-11);
        assert_close(second, 2 * first, 1e-11); /* half of a Masing loop's slip, twice the way */
    }
}

/* The slip begins in the outer of two rings with shear, so that the inner one is common to before
 * and after. */
CLAIM(slip_may_leave_an_inner_ring_alone)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.3, 0, 0.05, 0);
    apply(contact, 0.5, 0, 0.09, 0);
    assert_true(rwedge_contact_dissipated_energy(contact) == 0);
    apply(contact, 0.5, 0, 0.11, 0.004);
    double points[64];
    const size_t n = marks(contact, points);
    assert_close(rwedge_contact_dissipated_energy(contact),
                 integral(friction_times_slip, contact, n, points), 1e-10);
}

/* For the same Q/f and sigma/f. */
CLAIM(slip_is_proportional_to_friction)
{
    rwedge_contact *rough = create(0.4, 2), *other = create(0.4, F);
    apply(rough, 0.5, 0.1, 0, 0);
    apply(other, 0.5, 0.1, 0, 0);
    assert_true(slip(other, edges_of(other).left) == 0);
    apply(rough, 0.5, 0.1, 0.4, 0.04);
    apply(other, 0.5, 0.1, 0.1, 0.01);
    const rw_patch whole = edges_of(other);
    for (double x = whole.left; x <= whole.right; x += 0.05)
        assert_within(slip(rough, x), 4 * slip(other, x), 1e-15 * THETA);
    apply(other, 0.6, 0.12, 0.1, 0.01); /* the ring has not slipped */
    assert_true(slip(other, edges_of(other).left) == 0 && slip(other, edges_of(other).right) == 0);
    assert_true(slip(other, whole.right) != 0);
}

/* Slip began twice, at points that had come into contact at different times. */
CLAIM(slip_has_one_origin_or_none)
{
    rwedge_contact *contact = create(0.4, F);
    load(contact, 0.5, 0);
    load(contact, 0.5, 0.1);
    load(contact, 0.6, 0.1);
    load(contact, 0.6, 0.2);
    apply(contact, 0.6, 0, 0.25, 0.01);
    const double x = 0;
    double w;
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    load(contact, 0, 0);
    apply(contact, 0, 0, 0, 0);
    load(contact, 0.5, 0);
    load(contact, 0.6, 0.2); /* the ring slips at once */
    apply(contact, 0.6, 0, 0.25, 0.01);
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
}

/* Where the contact falls with moment and tension, the energy has no single integral; where rings
 * come into contact that slip at once, neither has the slip an origin. */
CLAIM(energy_and_slip_say_where_they_are_not_known)
{
    rwedge_contact *contact = create(0.4, F);
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, 0.1, 0.15, 0.01);
    apply(contact, 0.45, 0.09, 0.15, 0.01);
    assert_nan(rwedge_contact_dissipated_energy(contact));
    double x = 0, w;
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
    apply(contact, 0.6, 0.12, 0.15, 0.01);
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
    apply(contact, 0.6, 0.12, -0.1, -0.01);
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    apply(contact, 0, 0, 0, 0); /* all is forgotten */
    apply(contact, 0.5, 0.1, 0, 0);
    apply(contact, 0.5, 0.1, 0.1, 0.01);
    apply(contact, 0.52, 0.104, 0.15, 0.01); /* the ring slips at once */
    assert_int_equal(rwedge_contact_slip(contact, 1, &x, &w), RWEDGE_EPATH);
    apply(contact, 0, 0, 0, 0);
    apply(contact, 0.5, 0.1, 0, 0);
    assert_ok(rwedge_contact_slip(contact, 1, &x, &w));
}

/* The integral once went on without end. */
CLAIM(a_patch_without_width_ends_the_integral_of_its_gap)
{
    assert_nan(rw_patch_gap(&(rw_geometry){.a = 0.4}, (rw_patch){0.1, 0.1}, 0.2));
    assert_nan(rw_patch_gap(&(rw_geometry){.a = 0}, (rw_patch){0.5, 0.5}, 0.6));
}

/* So small a force moves one edge of the slip by less than the rounding of its place. */
CLAIM(the_energy_of_an_edge_that_stays_divides_by_nothing)
{
    const double a = 1e-60, compliance = 0.9999, P = 1,
                 M = 0.25 * P * rwedge_half_width(1, a, compliance, P);
    rwedge_contact *contact = create_wedge(1, a, compliance, 0.3);
    apply(contact, P, M, 0, 0);
    const double sigma = rwedge_contact_largest_tension_step(contact, 3e-9);
    feclearexcept(FE_ALL_EXCEPT);
    apply(contact, P, M, 3e-9, sigma);
    assert_int_equal(fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
    assert_true(rwedge_contact_dissipated_energy(contact) >= 0);
}

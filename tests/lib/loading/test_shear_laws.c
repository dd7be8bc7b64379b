/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a computed shear obeys, whatever the way to it: equilibrium, Coulomb's law, slip along the
 * traction, one energy by three routes. Each is looked at along a cycle, after a first one. */
#include "histories.h"

static const double F = 0.5, TOLERANCE = 1e-4;

/* Swings about P = 4 while Q swings by 1.2; P is ahead of Q and the tension behind it by `lag`.
 * theta = A = a = 1. */
typedef struct {
    double P, M, sigma, lag;
} programme;

static const programme PROGRAMMES[] = {{0, 0, 0.6, PI / 2}, {0, 0.8, 0.2, 0.5}, {0.3, 0.2, 0.4, 1}};
enum { KINDS = sizeof PROGRAMMES / sizeof *PROGRAMMES };

static void go(rwedge_contact *contact, const programme *p, int load, int loads)
{
    const double phase = 2 * PI * load / loads;
    apply(contact, 4 + p->P * sin(phase + p->lag), p->M * sin(phase), 1.2 * sin(phase),
          p->sigma * sin(phase - p->lag));
}

static rwedge_contact *after_a_cycle(const programme *p)
{
    enum { LOADS = 12 };
    rwedge_contact *contact = allowing(create_wedge(1, 1, 1, F), TOLERANCE);
    for (int i = 0; i <= LOADS; i++)
        go(contact, p, i, LOADS);
    assert_true(rwedge_contact_error(contact) > 0);
    return contact;
}

/* Of q, and of x q: by Gauss's rule on the elements that q is kept on, x = end + scale u^2, where
 * it is smooth in u. */
typedef struct {
    double force, moment;
} resultant;

static resultant resultant_of(const rwedge_contact *contact)
{
    enum { NODES = 16 };
    double node[NODES], weight[NODES];
    const rw_traction *t = &contact->computed.now->now.shear.traction;
    resultant sum = {0, 0};
    rw_gauss(NODES, node, weight);
    for (size_t i = 0; i < t->count; i++)
        for (int k = 0; k < NODES; k++) {
            const rw_element *e = &t->elements[i];
            const double length = e->last - e->first, u = e->first + length * node[k];
            const double x = e->end + e->scale * u * u;
            const double part = fabs(2 * e->scale * u * length) * weight[k] * shear(contact, x);
            sum.force += part;
            sum.moment += x * part;
        }
    return sum;
}

enum { PLACES = 120 };

/* Over a contact, dense at its edges. */
static double place(rw_patch patch, int i)
{
    return (patch.left + patch.right) / 2 -
           (patch.right - patch.left) / 2 * cos(PI * (i + 0.5) / PLACES);
}

/* The zone's label at x: which way it slips. */
static double slips(const rwedge_contact *contact, double x)
{
    double left[24], right[24], label[24];
    const size_t n = rwedge_contact_zone_count(contact);
    assert_true(n <= 24);
    assert_ok(rwedge_contact_zones(contact, n, left, right, label));
    size_t i = 0;
    while (i + 1 < n && x > right[i])
        i++;
    return label[i];
}

/* What was in contact before a load and after it. */
static rw_patch common(const rwedge_contact *before, const rwedge_contact *after)
{
    const rw_patch a = edges_of(before), b = edges_of(after);
    return (rw_patch){fmax(a.left, b.left), fmin(a.right, b.right)};
}

/* Whether it slips there before and after a load, and one way. */
static bool goes_on(const rwedge_contact *before, const rwedge_contact *after, double x)
{
    return slips(after, x) != 0 && slips(after, x) == slips(before, x);
}

static void assert_laws(const rwedge_contact *before, const rwedge_contact *after, int *slipping)
{
    assert_within(resultant_of(after).force, -after->loads.Q, 1e-10);
    for (int j = 0; j < PLACES; j++) {
        const double x = place(common(before, after), j), q = shear(after, x);
        assert_true(fabs(q) <= F * (fabs(pressure(after, x)) + TOLERANCE));
        if (goes_on(before, after, x)) {
            assert_true(slips(after, x) * q > 0);
            assert_true(slips(after, x) * (slip(after, x) - slip(before, x)) >= 0);
            ++*slipping;
        }
    }
}

CLAIM(the_shear_adds_up_to_Q_is_within_friction_and_goes_along_its_slip)
{
    enum { LOADS = 24 };
    for (int k = 0; k < KINDS; k++) {
        rwedge_contact *contact = after_a_cycle(&PROGRAMMES[k]);
        int slipping = 0;
        for (int i = 1; i <= LOADS; i++) {
            const rwedge_contact *before = copy_of(contact);
            go(contact, &PROGRAMMES[k], i, LOADS);
            assert_laws(before, contact, &slipping);
        }
        assert_true(slipping > PLACES);
    }
}

/* int q d(slip) over a load. */
static double friction_work(const rwedge_contact *before, const rwedge_contact *after)
{
    const rw_patch patch = common(before, after);
    double sum = 0;
    for (int i = 0; i < PLACES; i++) {
        const double x = place(patch, i), width = (patch.right - patch.left) / 2 * PI / PLACES *
                                                  sin(PI * (i + 0.5) / PLACES);
        sum +=
            (shear(before, x) + shear(after, x)) / 2 * (slip(after, x) - slip(before, x)) * width;
    }
    return sum;
}

static double moved(const rwedge_contact *before, const rwedge_contact *after)
{
    return rwedge_contact_displacement(after, 10) - rwedge_contact_displacement(before, 10);
}

/* The elastic parts of slip do no work in a cycle: what is left is the loop of Q over the rigid
 * displacement, and that of the shear's moment over the stretch A sigma/4. */
CLAIM(the_energy_of_a_cycle_is_the_area_of_its_loops_and_the_work_of_its_slip)
{
    enum { LOADS = 48 };
    for (int k = 0; k < KINDS; k++) {
        rwedge_contact *contact = after_a_cycle(&PROGRAMMES[k]);
        const double first = rwedge_contact_dissipated_energy(contact);
        double loop = 0, stretch = 0, slipped = 0, moment = resultant_of(contact).moment;
        for (int i = 1; i <= LOADS; i++) {
            const rwedge_contact *before = copy_of(contact);
            const double moment_before = moment;
            go(contact, &PROGRAMMES[k], i, LOADS);
            moment = resultant_of(contact).moment;
            loop += (before->loads.Q + contact->loads.Q) / 2 * moved(before, contact);
            stretch +=
                (moment_before + moment) / 2 * (contact->loads.sigma - before->loads.sigma) / 4;
            slipped += friction_work(before, contact);
        }
        const double energy = rwedge_contact_dissipated_energy(contact) - first;
        assert_close(loop + stretch, energy, 3e-3); /* 6e-4 with 96 loads */
        assert_close(slipped, energy, 1.2e-2);
    }
}

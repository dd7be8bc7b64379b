/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A cycle in which a rig turns the pad. A tilt that changes is, in small steps, a moment that
 * changes: a pad that may turn under these moments undergoes the same. */
#include "histories.h"

static const double F = 0.5, R = 20, P = 0.4;
enum { LOADS = 4, PARTS = 40, PLACES = 200 };

typedef struct {
    double P[LOADS * PARTS], turn[LOADS * PARTS], Q[LOADS * PARTS], sigma[LOADS * PARTS];
    size_t count;
} guided_loads; /* `turn` is the tilt, or the moment */

/* The pad rocks while Q goes to and fro, not in phase, and P varies. */
static guided_loads rocking(double tilt, double variation)
{
    static const double turn[] = {1, 0.3, -1, -0.2}, Q[] = {0.2, -0.5, -0.1, 0.5},
                        more[] = {1, 0, -1, 0};
    guided_loads to = {.count = LOADS};
    for (int i = 0; i < LOADS; i++) {
        to.P[i] = P * (1 + variation * more[i]);
        to.turn[i] = tilt * turn[i];
        to.Q[i] = F * P * Q[i];
    }
    return to;
}

static void destroy_cycle(void *cycle)
{
    rwedge_cycle_destroy(cycle);
}

static rwedge_cycle *guided(const rwedge_contact *contact, const guided_loads *to)
{
    rwedge_cycle *cycle = NULL;
    assert_ok(
        rwedge_cycle_create_guided(contact, to->count, to->P, to->turn, to->Q, to->sigma, &cycle));
    free_after_claim(cycle, destroy_cycle);
    return cycle;
}

static void guide(rwedge_contact *contact, const guided_loads *to, size_t i)
{
    assert_ok(rwedge_contact_guide(contact, to->P[i], to->turn[i], to->Q[i], to->sigma[i]));
}

static void guide_all(rwedge_contact *contact, const guided_loads *to)
{
    for (size_t i = 0; i < to->count; i++)
        guide(contact, to, i);
}

static rwedge_contact *held(rwedge_contact *contact)
{
    assert_ok(rwedge_contact_set_rotation(contact, 1));
    return allowing(contact, 1e-6);
}

/* A cylinder, a flat pad, a wedge. */
static rwedge_contact *pad(int kind)
{
    return held(kind == 0   ? create_flat(0, R, A, F)
                : kind == 1 ? create_flat(1, R, A, F)
                            : create(0.4, F));
}

/* The loads in parts, each as a moment. */
static guided_loads as_moments(rwedge_contact *contact, const guided_loads *to)
{
    guided_loads fine = {.count = LOADS * PARTS};
    const size_t last = to->count - 1;
    for (size_t i = 0; i < fine.count; i++) {
        const size_t now = i / PARTS, before = now > 0 ? now - 1 : last;
        const double t = (double)(i % PARTS + 1) / PARTS, s = 1 - t;
        double unused[3];
        fine.P[i] = s * to->P[before] + t * to->P[now];
        fine.Q[i] = s * to->Q[before] + t * to->Q[now];
        assert_ok(rwedge_contact_guide(contact, fine.P[i], s * to->turn[before] + t * to->turn[now],
                                       fine.Q[i], 0));
        assert_ok(rwedge_contact_loads(contact, &unused[0], &fine.turn[i], &unused[1], &unused[2]));
    }
    return fine;
}

typedef struct {
    double slip[PLACES], f1[PLACES], f2[PLACES], energy[PLACES], x[PLACES], width;
} rubbed;

static rubbed rubbed_in(const rwedge_cycle *cycle, double half)
{
    rubbed at = {.width = 2 * half};
    for (int i = 0; i < PLACES; i++)
        at.x[i] = half * sin(PI / 2 * (2 * i + 1 - PLACES) / PLACES);
    assert_ok(rwedge_cycle_friction(cycle, PLACES, at.x, at.slip, at.f1, at.f2, at.energy));
    return at;
}

static double largest(const double value[])
{
    double most = 0;
    for (int i = 0; i < PLACES; i++)
        most = fmax(most, fabs(value[i]));
    return most;
}

/* By Gauss and Chebyshev. */
static double energy_of(const rubbed *at)
{
    double sum = 0;
    for (int i = 0; i < PLACES; i++)
        sum += at->energy[i] * sqrt(at->width * at->width / 4 - at->x[i] * at->x[i]);
    return sum * PI / PLACES;
}

/* To the error of so many parts. */
CLAIM(a_pad_that_rocks_undergoes_what_its_moments_do)
{
    for (int kind = 0; kind < 3; kind++)
        for (int varies = 0; varies < 2; varies++) {
            const guided_loads to = rocking(0.003, 0.1 * varies);
            rwedge_contact *contact = pad(kind);
            for (int i = 0; i < 3; i++)
                guide_all(contact, &to);
            rwedge_contact *free_pad = copy_of(contact), *going = copy_of(contact);
            const guided_loads moments = as_moments(going, &to);
            rwedge_cycle *by_moments = NULL;
            assert_ok(rwedge_contact_set_rotation(free_pad, 0));
            assert_ok(rwedge_cycle_create(free_pad, moments.count, moments.P, moments.turn,
                                          moments.Q, moments.sigma, &by_moments));
            free_after_claim(by_moments, destroy_cycle);
            const double half = 1.3 * rwedge_contact_half_width(contact);
            const rubbed at = rubbed_in(guided(contact, &to), half),
                         expected = rubbed_in(by_moments, half);
            const double slip = largest(expected.slip), energy = largest(expected.energy);
            assert_true(slip > 0 && energy > 0);
            for (int i = 0; i < PLACES; i++) {
                if (fabs(at.x[i]) > 0.7 * half) /* which the contact leaves */
                    continue;
                assert_within(at.slip[i], expected.slip[i], 1e-3 * slip);
                assert_within(at.energy[i], expected.energy[i], 1e-3 * energy);
            }
        }
}

/* What the contact dissipates when it is guided itself is the integral over its places. */
CLAIM(the_energy_of_the_places_is_that_of_the_contact)
{
    for (int kind = 0; kind < 3; kind++) {
        const guided_loads to = rocking(0.003, 0.1);
        rwedge_contact *contact = pad(kind);
        for (int i = 0; i < 3; i++)
            guide_all(contact, &to);
        const rubbed at = rubbed_in(guided(contact, &to), 1.3 * rwedge_contact_half_width(contact));
        const double before = rwedge_contact_dissipated_energy(contact);
        guide_all(contact, &to);
        assert_close(energy_of(&at), rwedge_contact_dissipated_energy(contact) - before, 5e-3);
    }
}

CLAIM(stresses_are_those_of_the_contact_after_each_load)
{
    const guided_loads to = rocking(0.004, 0.1);
    const double x[] = {0.3, -1.5}, y[] = {0.2, 0};
    double sxx[2 * LOADS], syy[2 * LOADS], txy[2 * LOADS];
    rwedge_contact *contact = pad(1);
    guide_all(contact, &to);
    assert_ok(rwedge_cycle_stresses(guided(contact, &to), LOADS, 2, x, y, sxx, syy, txy));
    for (size_t i = 0; i < LOADS; i++) {
        guide(contact, &to, i);
        for (size_t k = 0; k < 2; k++) {
            const stresses now = stress_at(contact, x[k], y[k]),
                           told = {sxx[2 * i + k], syy[2 * i + k], txy[2 * i + k]};
            assert_true(apart(now, told) <= 1e-12 * fabs(now.xx));
        }
    }
}

/* Bit by bit. */
CLAIM(at_one_tilt_it_is_the_cycle_of_a_held_pad)
{
    guided_loads to = rocking(0, 0.1);
    const double tilt = 0.002;
    for (int i = 0; i < LOADS; i++)
        to.turn[i] = tilt;
    rwedge_contact *contact = pad(1);
    assert_ok(rwedge_contact_guide(contact, 0, tilt, 0, 0));
    guide_all(contact, &to);
    rwedge_cycle *kept = NULL;
    assert_ok(rwedge_cycle_create(contact, LOADS, to.P, to.turn, to.Q, to.sigma, &kept));
    free_after_claim(kept, destroy_cycle);
    const rubbed at = rubbed_in(guided(contact, &to), 2), expected = rubbed_in(kept, 2);
    for (int i = 0; i < PLACES; i++)
        assert_true(at.slip[i] == expected.slip[i] && at.energy[i] == expected.energy[i]);
}

/* A cylinder that rolls without shear: no place slips. */
CLAIM(a_cylinder_that_rolls_alone_slips_nowhere)
{
    guided_loads to = rocking(0.01, 0);
    for (int i = 0; i < LOADS; i++)
        to.Q[i] = 0;
    rwedge_contact *contact = pad(0);
    guide_all(contact, &to);
    const rwedge_cycle *cycle = guided(contact, &to);
    const double x[] = {-0.5, 0, 0.7};
    double slip[3], f1[3], f2[3], energy[3];
    assert_ok(rwedge_cycle_friction(cycle, 3, x, slip, f1, f2, energy));
    for (int i = 0; i < 3; i++)
        assert_within(slip[i], 0, 1e-12 * THETA * R);
}

CLAIM(what_is_no_guided_cycle_is_refused)
{
    guided_loads to = rocking(0.003, 0);
    rwedge_contact *contact = pad(1), *free_pad = create_flat(1, R, A, F);
    rwedge_cycle *cycle = NULL;
#define REFUSED(of, n, tilt, status)                                                               \
    assert_int_equal(rwedge_cycle_create_guided(of, n, to.P, tilt, to.Q, to.sigma, &cycle), status)
    guide_all(contact, &to);
    REFUSED(free_pad, LOADS, to.turn, RWEDGE_EDOMAIN);
    REFUSED(contact, 0, to.turn, RWEDGE_ERANGE);
    REFUSED(contact, LOADS, NULL, RWEDGE_ENULL);
    REFUSED(NULL, LOADS, to.turn, RWEDGE_ENULL);
    to.turn[2] = 2;
    REFUSED(contact, LOADS, to.turn, RWEDGE_EDOMAIN);
    to.turn[2] = NAN;
    REFUSED(contact, LOADS, to.turn, RWEDGE_EDOMAIN);
    to.turn[2] = 0;
    to.Q[1] = 2 * F * P;
    REFUSED(contact, LOADS, to.turn, RWEDGE_ESLIDING);
    assert_null(cycle);
}

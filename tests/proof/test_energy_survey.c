/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy of random loads under which P, M, Q and the tension change at once, computed load by
 * load, against that of many short steps: four loads a history, in every other one so much of P and
 * M that little slips.
 *
 *     test_energy_survey HISTORIES [SEED]
 *
 * The claim fails where the energy of a load differs by more than 3 % from that of the short steps,
 * in more than one load of 50. */
#include "computed/beginning.h"
#include "computed/computed_load.h"
#include "histories.h"

static const double TOLERANCE = 1e-3;

enum { LOADS = 4 };

static rwedge_contact *pressed(double a, double f, double tolerance, double P)
{
    rwedge_contact *contact = allowing(create_wedge(1, a, 1, f), tolerance);
    apply(contact, P, 0, 0, 0);
    return contact;
}

/* Short steps, at a tolerance of TOLERANCE/100: the energy of each then hardly depends on how it is
 * taken. One of a millionth of (f P)^2 A counts as none. */
enum { SHORT_STEPS = 64 };
static const double ENERGY_ERROR = 0.03, NO_ENERGY = 1e-6;

/* Of each load. Whether all were done. */
static bool energies_at_once(rwedge_contact *contact, const rw_loads loads[], double energy[])
{
    bool is_done = true;
    for (int i = 0; i < LOADS && is_done; i++) {
        const double before = rwedge_contact_dissipated_energy(contact);
        is_done = try_load(contact, loads[i]) == RWEDGE_OK;
        energy[i] = rwedge_contact_dissipated_energy(contact) - before;
    }
    return is_done;
}

/* theta = A = 1. */
static rw_scaled_loads scaled(rw_loads loads)
{
    return (rw_scaled_loads){loads.P, loads.M, loads.Q, loads.sigma / 4};
}

/* The contact would join the parts of a straight line. */
static bool energies_in_steps(const rwedge_contact *pressed, const rw_loads loads[],
                              double energy[])
{
    const rw_frame frame = rw_contact_frame(pressed);
    rw_numerical *n = rw_numerical_of_closed_form(pressed);
    bool is_done = n != NULL;
    for (int i = 0; i < LOADS && is_done; i++) {
        const rw_scaled_loads from = n->now.at, to = scaled(loads[i]);
        const double before = n->now.energy;
        for (int k = 1; k <= SHORT_STEPS && is_done; k++) {
            const rw_scaled_loads at = rw_part_of_line(from, to, (double)k / SHORT_STEPS);
            is_done = rw_numerical_step(n, &frame, at, &(int){RW_MOST_EFFORT}) == RWEDGE_OK;
        }
        energy[i] = n->now.energy - before;
    }
    rw_numerical_destroy(n);
    return is_done;
}

/* In every other history P and M change so much more than Q and sigma that little slips. */
static void draw_loads(uint64_t *state, bool slips_little, double f, double b, rw_loads first,
                       rw_loads loads[])
{
    const double spread = slips_little ? 0.4 : 0.1, share = slips_little ? 0.1 : 0.9;
    for (int i = 0; i < LOADS; i++) {
        const double P = first.P * random_between(state, 1 - spread, 1 + spread);
        loads[i] = (rw_loads){.P = P, .M = 0.1 * P * b * random_between(state, -1, 1)};
        loads[i].Q = share * f * P * random_between(state, -1, 1);
        loads[i].sigma = share * f * P / b * random_between(state, -1, 1);
    }
}

static void survey_energies(long history, int *count, int *wrong)
{
    uint64_t state = seed_or(1) + (uint64_t)history;
    for (int i = 0; i < 4; i++)
        random_fraction(&state);
    const double f = random_between(&state, 0.2, 0.8), a = random_between(&state, 0.3, 1.8);
    const double P = random_between(&state, 2, 4);
    rwedge_contact *contact = pressed(a, f, TOLERANCE, P);
    const rwedge_contact *same = pressed(a, f, TOLERANCE / 100, P);
    double once[LOADS], steps[LOADS];
    rw_loads loads[LOADS];
    draw_loads(&state, history % 2 > 0, f, rwedge_contact_half_width(contact), (rw_loads){.P = P},
               loads);
    if (!energies_at_once(contact, loads, once) || !energies_in_steps(same, loads, steps))
        return;
    for (int i = 0; i < LOADS; i++) {
        const double unit = f * loads[i].P * f * loads[i].P, off = fabs(once[i] - steps[i]);
        const bool is_wrong = off > ENERGY_ERROR * steps[i] && off > NO_ENERGY * unit;
        *count += steps[i] > 0;
        *wrong += is_wrong;
        if (is_wrong)
            print_message("    history %ld, load %d: %.3e, in steps %.3e\n", history, i, once[i],
                          steps[i]);
    }
}

/* A flat pad that rocks. Under the last load of the first, and the last but one of the second, slip
 * turns round and passes the marks of earlier loads late in the load, where the power jumps: 11 %
 * and 2.6 % too much, before the rules came near to the jump. */
CLAIM(the_energy_of_a_rocking_load_is_that_of_short_steps)
{
    static const struct {
        double f, a, P;
        rw_loads loads[LOADS];
    } rocking[] = {{0.2809,
                    4.6139,
                    3.3314,
                    {{2.8913, 2.3141, -0.1669, -0.0022},
                     {3.8832, -4.2993, -0.5109, -0.0126},
                     {3.3979, -5.5635, 0.0043, 0.0347},
                     {2.749, -2.0685, -0.2808, -0.0096}}},
                   {0.2117,
                    0.8265,
                    2.267,
                    {{2.267, -2.4767, -0.1187, 0.0078},
                     {2.267, 3.5441, 0.0755, 0.0166},
                     {2.267, -3.2334, -0.2587, -0.0063},
                     {2.267, -1.8615, 0.1774, -0.011}}}};
    for (size_t k = 0; k < sizeof rocking / sizeof *rocking; k++) {
        rwedge_contact *pads[2];
        double once[LOADS], steps[LOADS];
        for (int i = 0; i < 2; i++) {
            pads[i] = allowing(create_flat(rocking[k].a, 30, 1, rocking[k].f),
                               i == 0 ? TOLERANCE : TOLERANCE / 100);
            apply(pads[i], rocking[k].P, 0, 0, 0);
        }
        assert_true(energies_at_once(pads[0], rocking[k].loads, once));
        assert_true(energies_in_steps(pads[1], rocking[k].loads, steps));
        for (int i = 0; i < LOADS; i++)
            assert_close(once[i], steps[i], 0.02);
    }
}

CLAIM(the_energy_of_a_load_is_that_of_short_steps)
{
    const long histories = cases_or(4);
    int count = 0, wrong = 0;
    for (long i = 0; i < histories; i++)
        survey_energies(i, &count, &wrong);
    print_message("    %d loads that slip: the energy of %d is more than 3 %% off\n", count, wrong);
    assert_in_range(count, histories, LOADS * histories);
    assert_true(wrong <= 1 + count / 50);
}

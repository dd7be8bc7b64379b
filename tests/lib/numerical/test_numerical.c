/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps of the shear computed numerically where the contact has a closed form, which is not
 * used. */
#include "claims.h"
#include "contact/contact.h"
#include "numerical/computed_shear.h"
#include "numerical/pattern.h"
#include "numerical/rates.h"
#include "rwedge.h"

#include <stdlib.h>

static const double F = 0.5;

/* theta = A = a = 1; both of them from the same loads without shear. */
typedef struct {
    rw_frame frame;
    rw_numerical *numerical;
    rw_work work;
    rwedge_contact *exact;
} pair;

static void destroy(void *of_pair)
{
    pair *c = of_pair;
    rw_numerical_destroy(c->numerical);
    rw_work_destroy(&c->work);
    rwedge_contact_destroy(c->exact);
    free(c);
}

/* The contact is taken over. */
static pair *begin_with(rwedge_contact *contact, double P, double M, double tolerance)
{
    pair *c = calloc(1, sizeof *c);
    assert_non_null(c);
    c->frame = rw_frame_of(rw_arcs_of(&contact->geometry), F, tolerance);
    c->exact = contact;
    rw_numerical_state now = {.contact = rw_arcs_patch_of_moment(&c->frame.arcs, P, M),
                              .at = {P, M, 0, 0}};
    now.shear.zones = (rw_zones){1, {{0, now.contact.left, now.contact.right}}};
    c->numerical = rw_numerical_begin(&c->frame, &now, true, NULL, NULL);
    assert_non_null(c->numerical);
    rw_work_init(&c->work, &c->frame, RW_MOST_EFFORT);
    free_after_claim(c, destroy);
    assert_ok(rwedge_contact_apply(c->exact, P, M, 0, 0));
    return c;
}

static pair *begin(double P, double M, double tolerance)
{
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create(1, 1, 1, F, &contact));
    return begin_with(contact, P, M, tolerance);
}

static double peak_pressure(const rwedge_contact *contact)
{
    double left, right, most = 0;
    assert_ok(rwedge_contact_edges(contact, &left, &right));
    for (int i = 1; i < 100; i++) {
        double p, q;
        const double x = left + (right - left) * i / 100;
        assert_ok(rwedge_contact_tractions(contact, 1, &x, &p, &q));
        most = fmax(most, -p);
    }
    return most;
}

/* The largest difference of the two tractions, over f times the peak pressure. */
static double difference(const pair *c)
{
    double left, right, most = 0;
    assert_ok(rwedge_contact_edges(c->exact, &left, &right));
    for (int i = 0; i < 333; i++) {
        double p, q;
        const double x = left + (right - left) * (i + 0.5) / 333;
        assert_ok(rwedge_contact_tractions(c->exact, 1, &x, &p, &q));
        most = fmax(most, fabs(q + rw_traction_at(&c->numerical->now.shear.traction, x)));
    }
    return most / (F * peak_pressure(c->exact));
}

static void go(pair *c, double P, double M, double Q, double sigma)
{
    assert_ok(rwedge_contact_apply(c->exact, P, M, Q, sigma));
    assert_int_equal(rw_numerical_step(c->numerical, &c->frame,
                                       (rw_scaled_loads){P, M, Q, sigma / 4},
                                       &(int){RW_MOST_EFFORT}),
                     RWEDGE_OK);
    assert_within(difference(c), 0, c->frame.tolerance);
    assert_within(rw_traction_total(&c->numerical->now.shear.traction), Q,
                  0.1 * c->frame.tolerance);
}

static const double TOLERANCES[] = {1e-3, 1e-4, 1e-6};

/* What the steps so far have allocated beside tractions, in bytes. */
static double working_memory(const rw_work *w)
{
    double numbers = (5.0 + RW_LAYERS) * (double)w->fronts.capacity;
    for (int i = 0; i < RW_TRIALS; i++)
        numbers += 2.0 * w->grid[i].n * w->grid[i].n;
    return sizeof *w + numbers * sizeof(double);
}

/* Always 6.1 MB before, most of which is for loads on pads of many arcs. */
CLAIM(a_step_takes_the_memory_that_it_needs)
{
    for (int i = 0; i < 3; i++) {
        pair *c = begin(1.3, 0.1, TOLERANCES[i]);
        rw_numerical_state there = {.error = 0};
        const rw_scaled_loads to = {1.3, 0.1, 0.3, 0.05};
        assert_true(rw_implicit_step(&c->work, &c->numerical->now, to, NULL, false, &there));
        rw_traction_destroy(&there.shear.traction);
        print_message("    tolerance %g: %.2f MB\n", TOLERANCES[i], working_memory(&c->work) / 1e6);
        assert_true(working_memory(&c->work) < 0.5e6);
    }
}

static void slip_is_that_of_the_closed_form(const pair *c)
{
    double left, right;
    assert_ok(rwedge_contact_edges(c->exact, &left, &right));
    for (int i = 0; i < 40; i++) {
        const double x = left + (right - left) * (i + 0.5) / 40;
        double slip;
        assert_ok(rwedge_contact_slip(c->exact, 1, &x, &slip));
        assert_within(rw_numerical_slip(c->numerical, x), slip, 3 * c->frame.tolerance * F);
    }
}

/* Each step left a kink where the edge had been: 40 of them made all that followed slow. */
CLAIM(a_contact_that_grows_in_steps_keeps_few_kinks)
{
    pair *c = begin(2, 0, 1e-4);
    for (int i = 1; i <= 20; i++)
        go(c, 2 + 0.1 * i, 0, 0.04 * i, 0);
    assert_in_range(c->numerical->now.shear.kinks, 0, 6);
}

/* A profile of more bends than a frame keeps, of which some are slight. */
enum { PLACES = RW_MOST_BENDS + 6 };

static void bend_often(double x[], double slope[])
{
    for (int i = 0; i < PLACES; i++) {
        const double curvature = 0.55 + i % 2 * (i < 22 ? 0.3 : 1e-4);
        x[i] = 0.1 * (i - PLACES / 2);
        slope[i] = i > 0 ? slope[i - 1] + 0.1 * curvature : -1;
    }
    slope[PLACES - 1] = 1;
}

/* Cattaneo's and Mindlin's partial slip holds on any pad, under a moment and a tension in phase. */
CLAIM(loading_unloading_and_reloading_are_those_of_the_closed_form)
{
    const double x[] = {-1.5, -0.6, 0.2, 0.2, 0.7, 1.8}, slope[] = {-1, -0.2, 0, 0.05, 0.3, 1};
    const double shares[] = {0.8, -0.4, 0.6, 0.7};
    double places[PLACES], slopes[PLACES];
    bend_often(places, slopes);
    for (int i = 0; i < 12; i++) {
        rwedge_contact *pad;
        assert_ok(i < 3   ? rwedge_contact_create(1, 1, 1, F, &pad)
                  : i < 6 ? rwedge_contact_create_flat(0.8, 3, 1, F, &pad)
                  : i < 9 ? rwedge_contact_create_profile(6, x, slope, 1, F, &pad)
                          : rwedge_contact_create_profile(PLACES, places, slopes, 1, F, &pad));
        const double P = i < 3 ? 4 : 0.5, M = i < 3 ? 1.2 : 0.02, tension = i < 3 ? 0.3 : 0.05;
        pair *c = begin_with(pad, P, M, TOLERANCES[i % 3]);
        for (int k = 0; k < 4; k++) {
            const double Q = shares[k] * F * P;
            go(c, P, M, Q, tension * Q);
            slip_is_that_of_the_closed_form(c);
        }
        assert_close(c->numerical->now.energy * pad->geometry.theta * pad->geometry.theta,
                     rwedge_contact_dissipated_energy(pad), 2e-4 + TOLERANCES[i % 3]);
    }
}

CLAIM(a_contact_that_grows_and_recedes)
{
    for (int i = 0; i < 3; i++) {
        pair *c = begin(3, 0, TOLERANCES[i]);
        go(c, 3, 0, 0.6, 0);
        go(c, 4, 0, 0.9, 0); /* the ring sticks, at the ratio 0.6 of friction */
        go(c, 4, 0, 1.3, 0);
        go(c, 3.5, 0, 1.2, 0); /* recedes and slips */
    }
}

/* The energy of one load. */
static void costs_as_in_closed_form(pair *c, double P, double Q)
{
    const double before = c->numerical->now.energy,
                 exact = rwedge_contact_dissipated_energy(c->exact);
    go(c, P, 0, Q, 0);
    assert_close(c->numerical->now.energy - before,
                 rwedge_contact_dissipated_energy(c->exact) - exact, 0.01);
}

/* A ring that the contact leaves slips as the edge comes to it, under friction of that moment. Slip
 * times the mean of friction was 7 % too much of the second load, and 2.6 times the energy of the
 * last. */
CLAIM(the_energy_of_a_contact_that_recedes_is_that_of_the_closed_form)
{
    pair *c = begin(3, 0, 1e-4);
    go(c, 3, 0, 0.6, 0);
    go(c, 3.6, 0, 0.8, 0);
    costs_as_in_closed_form(c, 3.4, 0.5);
    costs_as_in_closed_form(c, 2.8, 0.2);
    go(c, 3.5, 0, 0.1, 0);
    costs_as_in_closed_form(c, 3.7, -0.4);
    costs_as_in_closed_form(c, 3, -0.6);
    go(c, 4.5, 0, 0, 0);
    costs_as_in_closed_form(c, 2.5, 0.3);
    go(c, 4.5, 0, 0.3, 0);
    costs_as_in_closed_form(c, 2.2, 0.1);
}

/* A log with 48 loads a period, of which 3 % are noise. */
static rw_scaled_loads noisy(int i)
{
    const double phase = i * PI / 24, noise = 0.03 * (fmod(i * 0.6180339887498949, 1) - 0.5);
    return (rw_scaled_loads){4 * (1 + noise), 0, 1.5 * (sin(phase) - noise),
                             0.2 * (sin(phase - PI / 4) + noise)};
}

/* A state differs from that in two halves by no more than what fits lose. */
static void is_that_in_halves(rw_work *w, const rw_numerical_state *from,
                              const rw_numerical_state *whole)
{
    const rw_scaled_loads a = from->at, b = whole->at,
                          middle = {a.P / 2 + b.P / 2, a.turn / 2 + b.turn / 2,
                                    a.shear / 2 + b.shear / 2, a.stretch / 2 + b.stretch / 2};
    const double lost = 0.1 * w->frame->tolerance * rw_peak_friction(w->frame, whole->contact);
    rw_numerical_state half, both;
    assert_true(rw_implicit_step(w, from, middle, NULL, false, &half));
    assert_true(rw_implicit_step(w, &half, b, NULL, false, &both));
    for (int i = 1; i + 1 < RW_PLACES; i++) {
        const double x = rw_place(whole->contact, i);
        assert_within(rw_traction_at(&whole->shear.traction, x),
                      rw_traction_at(&both.shear.traction, x), lost);
    }
    rw_traction_destroy(&half.shear.traction);
    rw_traction_destroy(&both.shear.traction);
}

CLAIM(a_step_in_which_all_that_sticks_stuck_all_the_time_is_exact)
{
    enum { LOADS = 48 };
    pair *c = begin(4, 0, 1e-5);
    int exact = 0;
    for (int i = 1; i <= LOADS; i++) {
        rw_numerical_state whole;
        if (rw_implicit_step(&c->work, &c->numerical->now, noisy(i), NULL, false, &whole)) {
            if (whole.is_exact)
                is_that_in_halves(&c->work, &c->numerical->now, &whole);
            exact += whole.is_exact;
            rw_traction_destroy(&whole.shear.traction);
        }
        assert_int_equal(
            rw_numerical_step(c->numerical, &c->frame, noisy(i), &(int){RW_MOST_EFFORT}),
            RWEDGE_OK);
    }
    assert_in_range(exact, LOADS * 2 / 3, LOADS - 2); /* not where an edge sticks */
}

/* Slip in every other of so many equal parts of a contact, the first of which begin at `from`. */
static rw_zones comb(rw_patch contact, int count, double from)
{
    const double width = (contact.right - contact.left) / count;
    rw_zones z = {.count = count};
    for (int i = 0; i < count; i++)
        z.zone[i] =
            (rw_zone){i % 2, i == 0 ? contact.left : contact.left + (i + from) * width,
                      i + 1 == count ? contact.right : contact.left + (i + 1 + from) * width};
    return z;
}

static bool goes_on_with(pair *c, const rw_numerical_state *half, rw_numerical_state whole,
                         const rw_zones *zones)
{
    whole.shear.zones = *zones;
    return rw_step_goes_on(&c->work, &c->numerical->now, half, &whole);
}

/* A front that stays behind the other, and more zones than have fronts, end no second half. */
CLAIM(a_step_goes_on_to_the_right_zones_alone)
{
    pair *c = begin(4, 0, 1e-4);
    rw_numerical_state half, whole;
    assert_true(rw_implicit_step(&c->work, &c->numerical->now, (rw_scaled_loads){4, 0, 0.4, 0},
                                 NULL, false, &half));
    assert_true(rw_implicit_step(&c->work, &c->numerical->now, (rw_scaled_loads){4, 0, 0.8, 0},
                                 NULL, false, &whole));
    const rw_zones right = whole.shear.zones;
    rw_zones lame = right, many = right;
    assert_int_equal(right.count, 3);
    lame.zone[0].right = lame.zone[1].left = half.shear.zones.zone[0].right;
    rw_zones parts = comb((rw_patch){right.zone[1].left, right.zone[1].right}, 21, 0);
    rw_pattern_insert(&many, &parts, 0);
    assert_int_equal(many.count, 23);
    assert_true(goes_on_with(c, &half, whole, &right));
    assert_false(goes_on_with(c, &half, whole, &lame));
    assert_false(goes_on_with(c, &half, whole, &many));
    rw_traction_destroy(&half.shear.traction);
    rw_traction_destroy(&whole.shear.traction);
}

/* At no tolerance is such a load done, and all is as before. */
CLAIM(a_load_that_is_too_far_off_has_not_converged)
{
    pair *c = begin(4, 0, 1e-4);
    c->frame.far_off = 1e-9;
    const rw_scaled_loads to = {4.2, 0, 0.5, 0.2};
    assert_int_equal(rw_numerical_step(c->numerical, &c->frame, to, &(int){RW_MOST_EFFORT}),
                     RWEDGE_ENOCONV);
    assert_true(c->numerical->now.at.P == 4 && rw_numerical_error(c->numerical) == 0);
}

/* Newton's method stood still there: the load at which Q turns, the last one here, took three times
 * as much as the one before. */
CLAIM(a_front_passes_places_that_have_slipped_before)
{
    pair *c = begin(4, 0, 1e-4);
    int spent = 0, before = 0;
    for (int i = 1; i <= 18; i++) {
        const double phase = i * PI / 12;
        const rw_scaled_loads to = {4, 0, 1.4 * sin(phase), 0.15 * sin(phase - 0.9)};
        int left = RW_MOST_EFFORT;
        assert_int_equal(rw_numerical_step(c->numerical, &c->frame, to, &left), RWEDGE_OK);
        before = spent;
        spent = RW_MOST_EFFORT - left;
    }
    assert_in_range(spent, 1, 2 * before);
}

/* The traction at a place after so many steps in a straight line. */
static double traction_after(pair *c, rw_scaled_loads to, int parts, double x)
{
    const rw_numerical_state *first = &c->numerical->now;
    const rw_scaled_loads from = first->at;
    rw_numerical_state now = *first;
    bool is_whole = true;
    now.shear.traction = rw_traction_copy(&first->shear.traction, &is_whole);
    assert_true(is_whole);
    for (int i = 1; i <= parts; i++) {
        const double u = (double)i / parts;
        const rw_scaled_loads at = {from.P + u * (to.P - from.P),
                                    from.turn + u * (to.turn - from.turn),
                                    from.shear + u * (to.shear - from.shear),
                                    from.stretch + u * (to.stretch - from.stretch)};
        rw_numerical_state next;
        assert_true(rw_implicit_step(&c->work, &now, at, NULL, false, &next));
        rw_traction_destroy(&now.shear.traction);
        now = next;
    }
    const double t = rw_traction_at(&now.shear.traction, x);
    rw_traction_destroy(&now.shear.traction);
    return t;
}

/* The difference falls to a quarter with each halving. */
static void steps_are_of_second_order(pair *c, rw_scaled_loads to, double x)
{
    double t[4];
    for (int i = 0; i < 4; i++)
        t[i] = traction_after(c, to, 1 << i, x);
    assert_true(fabs(t[2] - t[1]) < 0.35 * fabs(t[1] - t[0]));
    assert_true(fabs(t[3] - t[2]) < 0.35 * fabs(t[2] - t[1]));
}

/* What grows sticks up to both edges. With one D for all of the step no zones keep Coulomb's
 * condition. */
CLAIM(steps_of_a_contact_that_grows_are_of_second_order)
{
    pair *c = begin(2.5, 0, 1e-6);
    steps_are_of_second_order(c, (rw_scaled_loads){3.6, 0.3, 0.35, 0.02}, 1.5);
}

/* The i-th of 48 loads: P, Q and the tension with phases. */
static rw_scaled_loads cyclic_loads(int i)
{
    const double phase = 2 * PI * i / 48;
    return (rw_scaled_loads){4 * (1 + 0.1 * sin(phase + 1)), 0, 1.5 * sin(phase),
                             i > 0 ? 0.12 * sin(phase - PI / 4) : 0};
}

/* Goes on to a load, and returns what it took. */
static int effort_of(pair *c, rw_scaled_loads to)
{
    int effort = RW_MOST_EFFORT;
    assert_int_equal(rw_numerical_step(c->numerical, &c->frame, to, &effort), RWEDGE_OK);
    return RW_MOST_EFFORT - effort;
}

/* At the 34th load an edge that slipped sticks from the beginning on. D there was that of the zones
 * by which the step was tried: the tractions of the new ring erred by 3e-4, however short the steps
 * were, and the load took 5.5 million values. */
CLAIM(an_edge_that_begins_to_stick_errs_in_second_order)
{
    enum { STICKS = 34 };
    pair *c = begin(cyclic_loads(0).P, 0, 1e-6);
    for (int i = 1; i < STICKS; i++)
        effort_of(c, cyclic_loads(i));
    const double edge = c->numerical->now.contact.right;
    steps_are_of_second_order(c, cyclic_loads(STICKS), edge + 0.015);
    assert_in_range(effort_of(c, cyclic_loads(STICKS)), 0, 3500000);
    assert_true(c->numerical->now.contact.right > edge + 0.015);
}

/* Q/pi +- sigma s/4 over f (P/pi -+ tilt s), of the rates (theta = A = a = 1). */
CLAIM(rates_at_edges_that_stick_are_those_of_a_punch)
{
    pair *c = begin(4, 0.5, 1e-6);
    const rw_patch contact = c->numerical->now.contact;
    const double m = rw_patch_middle(contact), s = rw_patch_half_width(contact);
    const double P = 0.3, M = 0.1, Q = 0.03, stretch = 0.002;
    const rw_zones stuck = {1, {{0, contact.left, contact.right}}};
    rw_problem rates;
    double D[2];
    rw_problem_init_rates(&rates, &c->frame, contact, P, M, Q, stretch);
    rw_rates_ratio(&c->work.fronts, &rates, &stuck, D);
    const double tilt = 2 * (M - m * P) / (PI * s * s);
    assert_close(D[0], (Q / PI + stretch * s) / (F * (P / PI - tilt * s)), 1e-12);
    assert_close(D[1], (Q / PI - stretch * s) / (F * (P / PI + tilt * s)), 1e-12);
}

/* Nothing sticks, or zones are so many that a grid has left them: no rates are computed, and what
 * is not known counts as wrong where a step would be taken for exact. */
CLAIM(zones_without_rates)
{
    pair *c = begin(4, 0, 1e-4);
    const rw_patch contact = c->numerical->now.contact;
    const rw_zones stuck = {1, {{0, contact.left, contact.right}}},
                   slips = {1, {{1, contact.left, contact.right}}};
    const rw_zones many = comb(contact, RW_MOST_ZONES, 0),
                   others = comb(contact, RW_MOST_ZONES, 0.5);
    rw_problem rates;
    double D[2];
    rw_problem_init_rates(&rates, &c->frame, contact, 0.3, 0, 0.03, 0);
    rw_rates_ratio(&c->work.fronts, &rates, &slips, D);
    assert_true(isnan(D[0]) && isnan(D[1]));
    assert_nan(rw_rates_power(&c->work.fronts, &rates, &slips));
    assert_true(rw_rates_wrong(&c->work.fronts, &rates, &slips, &slips) == 0);
    assert_true(rw_rates_error_at_start(&c->work.fronts, &rates, &slips, &stuck) ==
                rw_rates_wrong(&c->work.fronts, &rates, &stuck, &stuck));
    assert_true(rw_rates_wrong(&c->work.fronts, &rates, &many, &many) == 0);
    assert_true(rw_rates_excess_at_start(&c->work.fronts, &rates, &many, &others, 0) == HUGE_VAL);
    const rw_zones begun = rw_rates_begun(&c->work.fronts, &rates, &many, &others);
    assert_true(begun.count > RW_MOST_FRONTS);
}

/* D at the left edge, (dQ/pi + d sigma s/4)/(f dP/pi), is below 1 where the contact begins to grow
 * and above 1 where it ends: slip begins in the new ring. */
CLAIM(slip_begins_at_an_edge_that_grows)
{
    pair *c = begin(4, 0, 1e-4);
    const double left = c->numerical->now.contact.left;
    assert_int_equal(rw_numerical_step(c->numerical, &c->frame,
                                       (rw_scaled_loads){6, 0, 0.3, 0.0825},
                                       &(int){RW_MOST_EFFORT}),
                     RWEDGE_OK);
    const rw_zones *zones = &c->numerical->now.shear.zones;
    assert_int_equal(zones->count, 2);
    assert_true(zones->zone[0].label != 0 && zones->zone[0].right < left + 0.5);
}

/* Its fronts are not searched: the grid's answer is taken, with its error. */
CLAIM(a_load_that_may_take_no_effort_has_an_answer)
{
    pair *c = begin(4, 0, 1e-4);
    int effort = -1;
    assert_int_equal(
        rw_numerical_step(c->numerical, &c->frame, (rw_scaled_loads){4.2, 0.3, 0.5, 0.2}, &effort),
        RWEDGE_OK);
    assert_in_range(rw_numerical_error(c->numerical) * 1e4, 10, 1000);
}

/* Places that stick keep the displacement of the grid, and what is wrong with it: after a load as
 * exact as any its error was told as 1e-5. */
CLAIM(an_error_of_the_grid_stays_where_it_sticks)
{
    pair *c = begin(4, 0, 1e-4);
    assert_int_equal(
        rw_numerical_step(c->numerical, &c->frame, (rw_scaled_loads){4, 0, 0.5, 0}, &(int){-1}),
        RWEDGE_OK);
    const double error = rw_numerical_error(c->numerical);
    assert_in_range(error * 1e4, 10, 1000);
    assert_ok(rwedge_contact_apply(c->exact, 4, 0, 0.9, 0));
    assert_int_equal(rw_numerical_step(c->numerical, &c->frame, (rw_scaled_loads){4, 0, 0.9, 0},
                                       &(int){RW_MOST_EFFORT}),
                     RWEDGE_OK);
    print_message("    wrong by %.1e, told %.1e\n", difference(c),
                  rw_numerical_error(c->numerical));
    assert_within(difference(c), 0, rw_numerical_error(c->numerical));
    assert_within(rw_numerical_error(c->numerical), error, 0.1 * error);
}

CLAIM(zones_are_not_searched_when_the_effort_is_spent)
{
    pair *c = begin(4, 0, 1e-4);
    const rw_numerical_state *now = &c->numerical->now;
    const rw_scaled_loads to = {4, 0, 0.5, 0};
    rw_patch contact;
    rw_zones zones;
    assert_true(rw_step_zones(&c->work, now, to, &now->shear.zones, true, &contact, &zones));
    assert_int_equal(zones.count, 3);
    c->work.effort = RW_MOST_EFFORT + 1;
    assert_false(rw_step_zones(&c->work, now, to, &now->shear.zones, true, &contact, &zones));
}

/* Of zones that all slip, each the other way, no more are kept than there is room for. */
CLAIM(a_pattern_of_too_many_zones_stays_within_its_room)
{
    rw_zones z = comb((rw_patch){0, 1}, RW_MOST_ZONES, 0);
    for (int i = 0; i < z.count; i++)
        z.zone[i].label = i % 2 ? 1 : -1;
    rw_pattern_clean(&z, 1e-3);
    assert_int_equal(z.count, RW_MOST_ZONES);
    for (int i = 0; i < z.count; i++)
        assert_true(z.zone[i].left >= 0 && z.zone[i].right <= 1 &&
                    z.zone[i].left < z.zone[i].right);
}

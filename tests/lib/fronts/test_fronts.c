/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One step from a pressed wedge to Q < f P, which slips from both edges up to the stick zone of
 * Cattaneo and Mindlin. */
#include "claims.h"
#include "contact/contact.h"
#include "fronts/fronts.h"
#include "fronts/grid.h"
#include "rwedge.h"

#include <fenv.h>

static const double F = 0.5, P = 4, Q = 1.2, TOLERANCE = 1e-6;
static const double NOT_KNOWN[2] = {NAN, NAN};

/* theta = A = a = 1. */
typedef struct {
    rwedge_contact *wedge;
    rw_frame frame;
    rw_friction friction;
    rw_shear_state none;
    rw_problem problem;
    rw_fronts fronts;
} step;

static void destroy(void *of_step)
{
    step *s = of_step;
    rw_friction_destroy(&s->friction);
    rw_fronts_destroy(&s->fronts);
    rwedge_contact_destroy(s->wedge);
}

static step *begin(void)
{
    static step s;
    s.wedge = NULL;
    assert_ok(rwedge_contact_create(1, 1, 1, F, &s.wedge));
    assert_ok(rwedge_contact_apply(s.wedge, P, 0, 0, 0));
    assert_ok(rwedge_contact_apply(s.wedge, P, 0, Q, 0));
    s.frame = rw_frame_of(rw_arcs_of(&s.wedge->geometry), F, TOLERANCE);
    const rw_patch contact = rw_arcs_patch_of_moment(&s.frame.arcs, P, 0);
    assert_true(rw_friction_create(&s.friction, &s.frame, contact));
    s.none.zones = (rw_zones){1, {{0, contact.left, contact.right}}};
    rw_problem_init(&s.problem, &s.frame, &s.friction, &s.friction, &s.none, Q, 0);
    rw_fronts_init(&s.fronts, TOLERANCE);
    s.fronts.budget = 1000;
    free_after_claim(&s, destroy);
    return &s;
}

/* As many zones as wide as each other, whose labels recur. */
static rw_zones equal_zones(rw_patch contact, int count, int labels, const int label[])
{
    rw_zones z = {.count = count};
    for (int i = 0; i < count; i++)
        z.zone[i] =
            (rw_zone){label[i % labels], contact.left + (contact.right - contact.left) * i / count,
                      contact.left + (contact.right - contact.left) * (i + 1) / count};
    return z;
}

static bool begins(step *s, int count, int labels, const int label[])
{
    const rw_zones zones = equal_zones(s->problem.to, count, labels, label);
    return rw_fronts_begin(&s->fronts, &s->problem, &zones, NOT_KNOWN);
}

static const int SLIP_AND_STICK[] = {1, 0};

CLAIM(the_fronts_are_those_of_partial_slip)
{
    step *s = begin();
    const double c = rwedge_contact_stick_half_width(s->wedge);
    for (int relaxes = 0; relaxes < 2; relaxes++) {
        rw_zones zones;
        assert_true(begins(s, 3, 2, SLIP_AND_STICK));
        assert_true(!relaxes || rw_fronts_relax(&s->fronts));
        assert_true(rw_fronts_newton(&s->fronts, 1e-10));
        rw_fronts_zones(&s->fronts, &zones);
        assert_close(zones.zone[1].left, -c, TOLERANCE);
        assert_close(zones.zone[1].right, c, TOLERANCE);
    }
}

CLAIM(a_search_ends_where_it_may_take_no_residual)
{
    step *s = begin();
    assert_true(begins(s, 3, 2, SLIP_AND_STICK));
    for (int budget = 0; budget < 6; budget++) {
        s->fronts.budget = budget;
        assert_false(rw_fronts_newton(&s->fronts, 0));
        s->fronts.budget = budget;
        assert_false(rw_fronts_relax(&s->fronts));
    }
}

/* No slip zone between two that slip opposite ways, too many zones, none that sticks. */
CLAIM(zones_that_have_no_fronts_are_refused)
{
    static const int BOTH_WAYS[] = {1, -1, 0}, SLIP[] = {1};
    step *s = begin();
    assert_true(begins(s, 2 * RW_MOST_STICK + 1, 2, SLIP_AND_STICK));
    assert_false(begins(s, 2 * RW_MOST_STICK + 3, 2, SLIP_AND_STICK));
    assert_false(begins(s, 4, 3, BOTH_WAYS));
    assert_false(begins(s, 1, 1, SLIP));
}

static const rw_layers NO_LAYERS = {.count = 0};

CLAIM(a_contact_between_two_places_of_the_grid_has_no_answer)
{
    static rw_grid grid;
    step *s = begin();
    rw_friction narrow;
    assert_true(rw_grid_init(&grid, RW_MOST_ANGLES));
    assert_true(rw_grid_solve(&grid, &s->problem, &NO_LAYERS));
    assert_true(rw_friction_create(&narrow, &s->frame,
                                   rw_arcs_patch_of_moment(&s->frame.arcs, 1e-9 * P, 0)));
    rw_problem_init(&s->problem, &s->frame, &s->friction, &narrow, &s->none, 0, 0);
    assert_false(rw_grid_solve(&grid, &s->problem, &NO_LAYERS));
    rw_friction_destroy(&narrow);
    rw_grid_destroy(&grid);
}

/* Its places are at one x, or two: the labels never settle. */
CLAIM(a_contact_as_narrow_as_rounding_has_an_answer_of_the_grid)
{
    static rw_grid grid;
    const double load = 3e-33;
    step *s = begin();
    rw_friction narrow;
    assert_true(rw_grid_init(&grid, RW_MOST_ANGLES));
    assert_true(rw_friction_create(&narrow, &s->frame,
                                   rw_arcs_patch_of_moment(&s->frame.arcs, load, 0.1 * load)));
    s->none.zones.zone[0] = (rw_zone){0, narrow.contact.left, narrow.contact.right};
    rw_problem_init(&s->problem, &s->frame, &narrow, &narrow, &s->none, 0.84 * F * load, 0);
    assert_true(rw_grid_solve(&grid, &s->problem, &NO_LAYERS));
    assert_in_range(grid.turns, 50, 200);
    rw_friction_destroy(&narrow);
    rw_grid_destroy(&grid);
}

/* By the pressure of a flat punch. */
CLAIM(the_rate_of_friction_is_none_at_the_edges)
{
    step *s = begin();
    rw_problem p = s->problem;
    const double x[] = {p.to.left, p.middle, p.to.right};
    double rate[3];
    p.is_rate = true;
    p.load[0] = 2;
    p.tilt[0] = 0;
    rw_friction_after(&p, 3, x, rate);
    assert_true(rate[0] == 0 && rate[2] == 0);
    assert_close(rate[1], F * 2 / (PI * p.half), 1e-14);
}

CLAIM(fronts_that_meet_have_no_residual)
{
    step *s = begin();
    double residual[RW_MOST_FRONTS];
    for (int zone = 1; zone <= 2; zone++) { /* one that sticks, one that slips */
        assert_true(begins(s, 5, 2, SLIP_AND_STICK));
        assert_true(rw_fronts_residual(&s->fronts, residual));
        s->fronts.y[zone] = s->fronts.y[zone - 1];
        assert_false(rw_fronts_residual(&s->fronts, residual));
    }
}

/* Layers of a contact that has grown must differ at its edges. */
CLAIM(layers_that_are_alike_have_no_weights)
{
    step *s = begin();
    const rw_patch before = rw_arcs_patch_of_moment(&s->frame.arcs, P / 2, 0);
    const double ratio[2] = {0.3, 0.3};
    const rw_zones stuck = {1, {{0, s->problem.to.left, s->problem.to.right}}};
    rw_friction friction;
    assert_true(rw_friction_create(&friction, &s->frame, before));
    rw_problem_init(&s->problem, &s->frame, &friction, &s->friction, &s->none, Q, 0);
    assert_true(rw_fronts_begin(&s->fronts, &s->problem, &stuck, ratio));
    for (int k = 0; k < RW_LAYERS; k++)
        for (int i = 0; i < 4; i++)
            s->problem.ratio[k][i / 2][i % 2] = 1;
    assert_false(rw_fronts_begin(&s->fronts, &s->problem, &stuck, ratio));
    rw_friction_destroy(&friction);
}

/* A kink is an arc without length: its curvature was its weight over 0. */
CLAIM(the_frame_of_a_profile_with_a_kink_raises_no_exception)
{
    const double x[] = {-1, -0.2, -0.2, 1}, slope[] = {-1, -0.5, 0.1, 1};
    rwedge_contact *pad = NULL;
    assert_ok(rwedge_contact_create_profile(4, x, slope, 1, F, &pad));
    feclearexcept(FE_ALL_EXCEPT);
    const rw_frame frame = rw_frame_of(rw_arcs_of(&pad->geometry), F, TOLERANCE);
    assert_int_equal(fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0);
    assert_true(frame.bends > 1 && frame.bend[1] == -0.2);
    rwedge_contact_destroy(pad);
}

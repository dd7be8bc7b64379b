/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maximum of J2 over the half-plane under any history: a search, because the tractions of a
 * history have no closed form for it, and J2 may have many maxima.
 *
 * Why the global one is not missed. G is analytic but for the marks on the surface: the edges of
 * the patches, x = +-a and the centre. At a distance r from the nearest mark the fields vary
 * over lengths of the order r. Below the surface this follows from -Im G, which is positive and
 * harmonic there: y |G'| <= |Im G| and y^2 |G''| <= 2 |Im G| (Schwarz and Pick). Next to the
 * surface, between marks, the fields continue across it. So no maximum is narrower than about 1
 * in polar coordinates (ln r, angle) around its nearest mark.
 *
 * The grid around a mark has the steps 0.7 in ln r and pi/8 in angle. It reaches from 3 b, beyond
 * which J2 falls like r^-2, inwards to 1e-14 of the distance to the next mark, or to where nothing
 * can be higher than what is known. The marks and the surface are on it. Each maximum of the grid
 * that may be the foot of the highest top is then followed to it.
 *
 * What cannot be higher. A contact is made of flat punches of half-widths t under loads P'(t) dt,
 * and its shear traction of the same with the weight f D(t), |D| <= 1. The potential of a punch has
 * the derivative z/(pi (z^2-t^2)^(3/2)). For Re z >= 0, |z+t| >= |z|, and so, whatever D is,
 *     |G'| <= |z|^(-1/2) (1/pi) int P'(t) |z-t|^(-3/2) dt <= c B (|z| y)^(-1/2),
 * with B = int (1+u^2)^(-3/4) du = 5.2442, and c = min(1, b/a), because P' <= pi c in theta/A. From
 * a mark m up to the height r/4, across and down is a way to any point at the distance r <= |m|/4;
 * on it G changes by at most 4 c B sqrt(r)/sqrt(3 |m|/4), and y |G'| is at most c B sqrt(r)/sqrt(3
 * |m|/4). In terms of sqrt(J2), which is a norm of the stress, this is rise_to() below. */
#include "contact/contact.h"

#include "base/always.h"
#include "stress/stress.h"
#include "stress/von_mises.h"

#include <float.h>

enum { ANGLES = 9, RADII = 52, LINE = 7, CLIMB_MAX = 60, FEET = 8 };

/* The ratio of neighbouring radii: RADII of them span 4e15, from 3 b to INNERMOST of b. Grids of
 * narrow patches and roundings take several times as many. */
static const double FALL = 0.5;

/* The innermost radius, of the distance to the next mark. Next to a mark J2 is J2(m) + A sqrt(r) -
 * B r, where B r is below J2 at the next mark's distance: a top farther in rises by less than 1e-14
 * of it. */
static const double INNERMOST = 1e-14;

/* Half-lengths of the line on which a climb looks for a higher place, in radians and ln r. It
 * starts with FIRST. It ends at ROUGH when only the top must be told from others, and at LAST. */
static const double FIRST_SPAN = 0.4, ROUGH_SPAN = 1e-2, LAST_SPAN = 1e-7;

/* The relative rise of J2 that counts as none. */
static const double NO_GAIN = 4 * DBL_EPSILON;

/* How well a rough climb knows a top: a fraction of J2, and of the distance from the mark. */
static const double ROUGHLY = 0.05;

/* In polar coordinates around a mark. */
typedef struct {
    double angle, log_radius;
} polar;

/* Where a climb begins: a maximum of the grid around a mark. */
typedef struct {
    double centre, innermost, outermost;
    polar at;
    double J2, hidden; /* hidden: what the steps of the grid may hide */
} foot;

/* The highest J2 so far, in (theta/A)^2, and where. */
typedef struct {
    const rwedge_contact *contact;
    double kappa;
    double tension;  /* half the bulk tension */
    bool is_centred; /* all patches are: at -x is what the opposite shear makes at x */
    double J2, x, y;
    /* the highest top climbed, and its distance from the mark; infinite before the first */
    double top_x, top_y, top_radius;
    foot feet[FEET];
    size_t count;
} search;

static double J2_of(search *s, rw_field normal, rw_field shear, double x, double y)
{
    const rw_stress_state state = rw_superpose(normal, shear);
    const double difference = state.difference - s->tension, mean = state.mean + s->tension;
    const double J2 = difference * difference + state.shear * state.shear + s->kappa * mean * mean;
    if (J2 > s->J2) {
        s->J2 = J2;
        s->x = x;
        s->y = y;
    }
    return J2;
}

/* The depth at which a place at the distance r from its mark is looked at. By rounding the place
 * may be the apex of a sharp wedge, which has no stress. Beside it J2 is not high. */
static double off_apex(const search *s, double x, double y, double r)
{
    return s->contact->geometry.a == 0 && fabs(x) + y == 0 ? 1e-3 * r : y;
}

/* At n <= RW_BATCH points, and at their mirror images if `mirrored` is not NULL. */
static void evaluate(search *s, size_t n, const double x[], const double y[], double J2[],
                     double mirrored[])
{
    rw_contact_fields fields;
    rw_contact_fields_at(s->contact, n, x, y, &fields);
    const double f = s->contact->f;
    for (size_t i = 0; i < n; i++) {
        const rw_field normal = rw_field_in(&fields.normal, (int)i),
                       shear = rw_field_in(&fields.tangential, (int)i);
        J2[i] = J2_of(s, normal, rw_field_multiple(f, shear), x[i], y[i]);
        if (mirrored)
            mirrored[i] = J2_of(s, normal, rw_field_multiple(-f, shear), -x[i], y[i]);
    }
}

/* ---- The marks ---- */

typedef struct {
    double at;
    double reach;   /* the outer radius of its grid */
    double nearest; /* the distance to the nearest of all marks, but those at the same place */
} mark;

/* How far the contact reaches from the centre. */
static double extent(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    return fmax(-patch.left, patch.right);
}

static double edge(rw_patch patch, int side)
{
    return side > 0 ? patch.right : patch.left;
}

/* The rounding as far as it is in contact. */
static rw_patch rounding(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    const double a = contact->geometry.a;
    return (rw_patch){fmax(-a, patch.left), fmin(a, patch.right)};
}

static void look_to(mark *m, double other, bool is_before)
{
    const double distance = fabs(m->at - other);
    if (is_before)
        m->reach = fmin(m->reach, 2 * distance);
    if (distance > 0)
        m->nearest = fmin(m->nearest, distance);
}

/* The edge of a patch. Its grid reaches twice the distance to the nearest of the marks before it,
 * whose grids take over there. The patches come by halves: first every other of the coarsest
 * `step`, at last each that is left, so that wide grids are far apart and narrow ones close. */
static mark patch_mark(const rwedge_contact *contact, size_t i, size_t step, int side)
{
    const rw_corner *corners = contact->memory.corners;
    const size_t last = contact->memory.count - 1;
    const rw_patch parts[] = {corners[last].patch, rounding(contact)};
    mark m = {edge(corners[i].patch, side), 3 * extent(contact), extent(contact)};
    look_to(&m, 0, true);
    look_to(&m, edge(corners[i].patch, -side), side < 0);
    for (int k = 0; k < 2; k++)
        for (int of = -1; of <= 1; of += 2)
            look_to(&m, edge(parts[k], of), true);
    look_to(&m, edge(corners[i - 1].patch, side), false);
    look_to(&m, edge(corners[i + 1].patch, side), false);
    if (i > step)
        look_to(&m, edge(corners[i - step].patch, side), true);
    if (i + step < last)
        look_to(&m, edge(corners[i + step].patch, side), true);
    return m;
}

/* A kink of a shear that is no sum of patches. */
static mark kink_mark(const rwedge_contact *contact, const rw_shear_state *shear, int i)
{
    const rw_patch parts[] = {rw_memory_end(&contact->memory)->patch, rounding(contact)};
    mark m = {shear->kink[i], 3 * extent(contact), extent(contact)};
    look_to(&m, 0, true);
    for (int k = 0; k < 2; k++)
        for (int of = -1; of <= 1; of += 2)
            look_to(&m, edge(parts[k], of), true);
    for (int j = 0; j < shear->kinks; j++)
        if (j != i)
            look_to(&m, shear->kink[j], j < i);
    return m;
}

/* The centre, the edges of the contact, and those of the rounding, in this order. */
static mark main_mark(const rwedge_contact *contact, int part, int side)
{
    const rw_corner *corners = contact->memory.corners;
    const size_t last = contact->memory.count - 1;
    const rw_patch parts[] = {{0, 0}, corners[last].patch, rounding(contact)};
    mark m = {edge(parts[part], side), 3 * extent(contact), extent(contact)};
    for (int k = 0; k < 3; k++)
        for (int of = -1; of <= 1; of += 2)
            if (k != part || of != side)
                look_to(&m, edge(parts[k], of), k < part || (k == part && side < of));
    for (size_t i = 1; i < last; i++)
        for (int of = -1; of <= 1; of += 2)
            look_to(&m, edge(corners[i].patch, of), false);
    return m;
}

/* ---- Climbing ---- */

typedef struct {
    search *s;
    double centre, innermost, outermost;
    polar top;
    double J2;
} climb;

/* Beyond the surface is the surface. */
static void evaluate_places(climb *c, size_t n, const polar at[], double J2[])
{
    double x[LINE], y[LINE];
    for (size_t i = 0; i < n; i++) {
        const double r = fmax(c->innermost, fmin(c->outermost, exp(at[i].log_radius))),
                     angle = at[i].angle;
        x[i] = c->centre + r * (angle <= 0 ? 1 : angle >= RW_PI ? -1 : cos(angle));
        y[i] = angle <= 0 || angle >= RW_PI ? 0 : r * sin(angle);
        y[i] = off_apex(c->s, x[i], y[i], r);
    }
    evaluate(c->s, n, x, y, J2, NULL);
}

/* To the highest place along a line, both ways. While the highest of its points is at an end, the
 * span is doubled. Then it is narrowed to the points beside the highest. Beyond the ends of angle
 * and radius nothing is higher. */
static void climb_along(climb *c, double to_angle, double to_log_radius, double last_span)
{
    const double length = hypot(to_angle, to_log_radius);
    bool is_found = false; /* between two points of the line */
    for (double span = FIRST_SPAN; length > 0 && span > last_span;) {
        polar at[LINE];
        double J2[LINE];
        for (int i = 0; i < LINE; i++) {
            const double t = span * (2.0 * (i + 1) / (LINE + 1) - 1) / length;
            at[i] = (polar){c->top.angle + t * to_angle, c->top.log_radius + t * to_log_radius};
        }
        evaluate_places(c, LINE, at, J2);
        int highest = 0;
        for (int i = 1; i < LINE; i++)
            if (J2[i] > J2[highest])
                highest = i;
        const bool is_higher = J2[highest] > c->J2;
        if (is_higher) {
            c->top = at[highest];
            c->J2 = J2[highest];
        }
        is_found = is_found || !is_higher || (highest > 0 && highest < LINE - 1);
        span *= is_found ? 2.0 / (LINE + 1) : 2;
    }
}

/* Two places that are each highest for their radius make a line, and the next climb goes along it
 * (Powell's conjugate direction). It is exact where J2 is quadratic. It follows the ridges of
 * narrow roundings, where J2 is flat to 1e-9. */
static void climb_to(climb *c, double last_span)
{
    for (int i = 0; i < CLIMB_MAX; i++) { /* a few are enough, but on a plateau */
        const double before = c->J2;
        climb_along(c, 1, 0, last_span);
        const polar one = c->top;
        climb_along(c, 0, 1, last_span);
        climb_along(c, 1, 0, last_span);
        climb_along(c, c->top.angle - one.angle, c->top.log_radius - one.log_radius, last_span);
        if (c->J2 - before <= NO_GAIN * before || last_span >= ROUGH_SPAN)
            return;
    }
}

/* To the highest place at any radius. A ridge lies beside the angles of the grid: along it J2 may
 * rise where the grid falls, by as much as the angle from one to the other changes. */
static void climb_ridge(climb *c)
{
    const double angle = c->top.angle, step = log(1 / FALL);
    double log_radius = log(c->innermost);
    while (log_radius < log(c->outermost)) {
        polar at[LINE];
        double J2[LINE];
        for (int i = 0; i < LINE; i++, log_radius += step)
            at[i] = (polar){angle, log_radius};
        evaluate_places(c, LINE, at, J2);
        for (int i = 0; i < LINE; i++)
            if (J2[i] > c->J2) {
                c->top = at[i];
                c->J2 = J2[i];
            }
    }
}

/* Climbs roughly first. That is enough for a top that is lower than the highest, and for one that
 * was climbed already, from a mark about as near: a mark much farther away sees less detail. */
static void climb_to_top(climb *c)
{
    search *s = c->s;
    climb_to(c, ROUGH_SPAN);
    const double r = exp(c->top.log_radius);
    const double to_known =
        hypot(c->centre + r * cos(c->top.angle) - s->top_x, r * sin(c->top.angle) - s->top_y);
    if (c->J2 < (1 - ROUGHLY) * s->J2 || (to_known < ROUGHLY * r && s->top_radius < 2 * r))
        return;
    climb_ridge(c);
    climb_to(c, LAST_SPAN);
    if (c->J2 >= s->J2) {
        s->top_x = s->x;
        s->top_y = s->y;
        s->top_radius = exp(c->top.log_radius);
    }
}

/* The highest first, as long as what the grid may hide can make one the highest. */
static void climb_all(search *s)
{
    while (s->count > 0) {
        size_t best = 0;
        for (size_t i = 1; i < s->count; i++)
            if (s->feet[i].J2 > s->feet[best].J2)
                best = i;
        const foot from = s->feet[best];
        s->feet[best] = s->feet[--s->count];
        if (from.J2 + from.hidden < s->J2)
            continue;
        climb c = {s, from.centre, from.innermost, from.outermost, from.at, from.J2};
        climb_to_top(&c);
    }
}

static void note(search *s, const foot *found)
{
    if (found->J2 + found->hidden < s->J2)
        return;
    if (s->count == FEET)
        climb_all(s);
    s->feet[s->count++] = *found;
}

/* ---- The grid around one mark ---- */

/* On both sides: [1] is the mirror image. */
typedef struct {
    double centre, floor, reach;
    int rows;
    double radius[RADII], cosine[ANGLES], sine[ANGLES];
    double J2[2][RADII * ANGLES];
} polar_grid;

static void fill(search *s, polar_grid *grid, double outermost, double innermost)
{
    double radius = outermost;
    int rows = 0;
    for (; rows < RADII && radius > innermost; rows++, radius *= FALL)
        grid->radius[rows] = radius;
    grid->rows = rows;
    const bool both = s->is_centred && grid->centre != 0;
    for (int first = 0; first < rows * ANGLES; first += RW_BATCH) {
        const int n = rows * ANGLES - first < RW_BATCH ? rows * ANGLES - first : RW_BATCH;
        double x[RW_BATCH], y[RW_BATCH];
        for (int i = 0; i < n; i++) {
            const double r = grid->radius[(first + i) / ANGLES];
            x[i] = grid->centre + r * grid->cosine[(first + i) % ANGLES];
            y[i] = off_apex(s, x[i], r * grid->sine[(first + i) % ANGLES], r);
        }
        evaluate(s, (size_t)n, x, y, grid->J2[0] + first, both ? grid->J2[1] + first : NULL);
    }
}

/* Whether no neighbour is higher; on a plateau, the first of its points. The lowest neighbour. */
static bool is_maximum(const double J2[], int rows, int i, int j, double *lowest)
{
    const double here = *lowest = J2[i * ANGLES + j];
    for (int k = i > 0 ? i - 1 : 0; k <= i + 1 && k < rows; k++)
        for (int l = j > 0 ? j - 1 : 0; l <= j + 1 && l < ANGLES; l++) {
            const double there = J2[k * ANGLES + l];
            if (there > here || (there == here && (k < i || (k == i && l < j))))
                return false;
            *lowest = fmin(*lowest, there);
        }
    return true;
}

/* A top between the points of a grid with the step h is at most h/2 away. A parabola falls 8 times
 * as far to the neighbour on the other side as it rises to its top: so the rise that is allowed is
 * 8 times that. This is an estimate, not a bound. What checks it is tests/proof/yield_survey.c,
 * which leaves nothing out on grids three times as fine: it found no higher J2 in 1500 random
 * histories, once climb_ridge() was there. */
static void note_feet(search *s, const polar_grid *grid, int side)
{
    const double *J2 = grid->J2[side];
    for (int i = 0; i < grid->rows; i++)
        for (int j = 0; j < ANGLES; j++) {
            double lowest;
            if (!is_maximum(J2, grid->rows, i, j, &lowest))
                continue;
            const double here = J2[i * ANGLES + j];
            const int angle = side ? ANGLES - 1 - j : j;
            const foot found = {side ? -grid->centre : grid->centre,
                                0.1 * grid->floor,
                                10 * grid->reach,
                                {angle * RW_PI / (ANGLES - 1), log(grid->radius[i])},
                                here,
                                here - lowest};
            note(s, &found);
        }
}

/* How fast the root of J2 may rise from a mark m in a centred contact: by this times sqrt(r/|m|).
 * The deviator of the stress is -y G_N' + y G_T' + G_T and half its trace Im G_N - Re G_T, with
 * |G_T| changing by f times what G_N may. */
static double rise_to(const search *s)
{
    const rwedge_contact *contact = s->contact;
    const double a = contact->geometry.a, b = extent(contact), f = contact->f;
    const double unit = 5.2442 / sqrt(0.75) * (a > b ? b / a : 1);
    return unit * hypot(5 * f + 1, sqrt(s->kappa) * 4 * (1 + f));
}

/* J2 at a mark, on both sides. */
static double J2_at_mark(search *s, double at)
{
    const double surface = 0;
    double J2, mirrored = 0;
    evaluate(s, 1, &at, &surface, &J2, s->is_centred ? &mirrored : NULL);
    return fmax(J2, mirrored);
}

/* Nothing is farther in. */
static double floor_of(const mark *m)
{
    return fmax(INNERMOST * m->nearest, 1e-18 * fabs(m->at));
}

/* The inner radius of a grid. Around the centre of a rounded wedge all is smooth. */
static double innermost_radius(const search *s, const mark *m, double J2)
{
    if (m->at == 0 && s->contact->geometry.a > 0)
        return 0.05 * m->nearest;
    const double floor = floor_of(m);
    if (!s->is_centred || m->at == 0)
        return floor;
    const double lacking = sqrt(s->J2) - sqrt(J2);
    const double part = lacking / rise_to(s);
    return fmax(floor, fmin(0.25, part * part) * fabs(m->at));
}

static void search_around(search *s, const mark *m)
{
    const bool is_apex = m->at == 0 && s->contact->geometry.a == 0;
    const double innermost = innermost_radius(s, m, is_apex ? 0 : J2_at_mark(s, m->at));
    polar_grid grid = {.centre = m->at, .floor = floor_of(m), .reach = m->reach};
    for (int j = 0; j < ANGLES; j++) {
        grid.cosine[j] = cos(j * RW_PI / (ANGLES - 1));
        grid.sine[j] = j == 0 || j == ANGLES - 1 ? 0 : sin(j * RW_PI / (ANGLES - 1));
    }
    /* No grid at all where nothing is higher, or where it is another mark to rounding. One that
     * goes on begins with the last two rows again, because the last had no neighbours inside. */
    for (double outermost = m->reach; outermost > innermost;
         outermost = grid.rows == RADII ? grid.radius[RADII - 2] : 0) {
        fill(s, &grid, outermost, innermost);
        note_feet(s, &grid, 0);
        if (s->is_centred && m->at != 0)
            note_feet(s, &grid, 1);
    }
}

/* ---- All marks ---- */

static bool are_centred(const rw_memory *memory)
{
    for (size_t i = 1; i < memory->count; i++)
        if (rw_patch_middle(memory->corners[i].patch) != 0)
            return false;
    return true;
}

static void search_all(search *s)
{
    const rwedge_contact *contact = s->contact;
    const size_t last = contact->memory.count - 1;
    const int to = s->is_centred ? 1 : -1;
    for (int part = 0; part < 3; part++)
        for (int side = 1; side >= (part > 0 ? to : 1); side -= 2) {
            const mark m = main_mark(contact, part, side);
            search_around(s, &m);
        }
    size_t step = 1;
    while (2 * step < last)
        step *= 2;
    for (; step > 0; step /= 2)
        for (size_t i = step; i < last; i += 2 * step)
            for (int side = 1; side >= to; side -= 2) {
                const mark m = patch_mark(contact, i, step, side);
                search_around(s, &m);
            }
    const rw_shear_state *shear = contact->numerical ? &contact->numerical->now.shear : NULL;
    for (int i = 0; shear && i < shear->kinks; i++) {
        const mark m = kink_mark(contact, shear, i);
        search_around(s, &m);
    }
    climb_all(s);
}

/* The apex of the sharp wedge: its pressure is infinite, and so are the stresses unless the
 * material yields by shape alone and the traction's infinity is stuck. */
static bool is_infinite(const rwedge_contact *contact, double kappa)
{
    return contact->geometry.a == 0 &&
           (kappa > 0 || contact->f * contact->memory.corners[1].ratio != 0);
}

int32_t rwedge_contact_yield_factor(const rwedge_contact *contact, double nu, double k,
                                    double *factor, double *x, double *y)
{
    if (!contact || !factor)
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu) || !rw_is_positive(k))
        return RWEDGE_EDOMAIN;
    if (contact->memory.count < 2)
        return RWEDGE_EABSENT;
    search s = {.contact = contact,
                .kappa = rw_plane_strain_weight(nu),
                .tension = contact->loads.sigma / 2 / rw_unit_stress(&contact->geometry),
                .is_centred = !contact->numerical && are_centred(&contact->memory),
                .top_radius = HUGE_VAL};
    double found = 0;
    if (!is_infinite(contact, s.kappa)) {
        search_all(&s);
        if (NEVER(!(s.J2 > 0))) /* the grid has points with stress */
            return RWEDGE_ERANGE;
        found = k / (rw_unit_stress(&contact->geometry) * sqrt(s.J2));
    }
    if (!rw_is_magnitude(found))
        return RWEDGE_ERANGE;
    *factor = found;
    if (x)
        *x = s.x;
    if (y)
        *y = s.y;
    return RWEDGE_OK;
}

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
 * which J2 falls like r^-2, inwards to 1e-14 of the distance to the next mark. The marks and the
 * surface are on it. Each maximum of the grid that may be the foot of the highest top is then
 * followed to it.
 *
 * On the grids the patches that end far from the mark count together (neighbourhood.h): a grid
 * takes as long for many patches as for few. A climb takes them all as they are. */
#include "contact/marks.h"
#include "contact/neighbourhood.h"

#include "base/always.h"
#include "stress/stress.h"
#include "stress/von_mises.h"

#include <float.h>

/* BAND radii of a grid are evaluated at once. */
enum { ANGLES = 9, RADII = 52, BAND = 3, LINE = 7, CLIMB_MAX = 60, FEET = 8 };

/* The ratio of neighbouring radii. Closer to the mark than CLOSE of the way to the next one, J2
 * varies by powers of r alone, and SPARSE does. */
static const double FALL = 0.5, CLOSE = 0.05, SPARSE = 0.25;

/* The innermost radius, of the distance to the next mark. Next to a mark J2 is J2(m) + A sqrt(r) -
 * B r, where B r is below J2 at the next mark's distance: a top farther in rises by less than 1e-14
 * of it. */
static const double INNERMOST = 1e-14;

/* Half-lengths of the line on which a climb looks for a higher place, in radians and ln r. It
 * starts with FIRST. It ends at ROUGH when only the top must be told from others, and at LAST. */
static const double FIRST_SPAN = 0.4, ROUGH_SPAN = 1e-2, LAST_SPAN = 1e-7;

/* The relative rise of J2 that counts as none. */
static const double NO_GAIN = 4 * DBL_EPSILON;

/* The relative error of J2 on a grid, and more. */
static const double GRID_ERROR = 1e-8;

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
    double known; /* the highest of the grids too */
    /* the highest top climbed, and its distance from the mark; infinite before the first */
    double top_x, top_y, top_radius;
    foot feet[FEET];
    size_t count;
} search;

static double J2_of(const search *s, rw_field normal, rw_field shear)
{
    const rw_stress_state state = rw_superpose(normal, shear);
    const double difference = state.difference - s->tension, mean = state.mean + s->tension;
    return difference * difference + state.shear * state.shear + s->kappa * mean * mean;
}

/* The depth at which a place at the distance r from its mark is looked at. By rounding the place
 * may be the apex of a sharp wedge, which has no stress. Beside it J2 is not high. */
static double off_apex(const search *s, double x, double y, double r)
{
    return y == 0 && rw_is_kink(&s->contact->geometry, x) ? 1e-3 * r : y;
}

/* Of the fields at n points, and at their mirror images for side = -1. */
static void J2_from(search *s, const rw_contact_fields *fields, int side, int n, double J2[])
{
    const double f = side * s->contact->f;
    for (int i = 0; i < n; i++) {
        J2[i] = J2_of(s, rw_field_in(&fields->normal, i),
                      rw_field_multiple(f, rw_field_in(&fields->tangential, i)));
        s->known = fmax(s->known, J2[i]);
    }
}

/* At n <= RW_BATCH points, which may be the place of the highest. */
static void evaluate(search *s, int n, const double x[], const double y[], double J2[])
{
    rw_contact_fields fields;
    rw_contact_fields_at(s->contact, 1, s->contact->memory.count, n, x, y, &fields);
    J2_from(s, &fields, 1, n, J2);
    for (int i = 0; i < n; i++)
        if (J2[i] > s->J2) {
            s->J2 = J2[i];
            s->x = x[i];
            s->y = y[i];
        }
}

/* Whether a foot cannot lead above what is known. */
static bool is_low(const search *s, const foot *from)
{
    return from->J2 + from->hidden < (1 - GRID_ERROR) * s->known;
}

/* ---- Climbing ---- */

typedef struct {
    search *s;
    double centre, innermost, outermost;
    polar top;
    double J2;
} climb;

/* Beyond the surface is the surface. */
static void evaluate_places(climb *c, int n, const polar at[], double J2[])
{
    double x[LINE], y[LINE];
    for (int i = 0; i < n; i++) {
        const double r = fmax(c->innermost, fmin(c->outermost, exp(at[i].log_radius))),
                     angle = at[i].angle;
        x[i] = c->centre + r * (angle <= 0 ? 1 : angle >= RW_PI ? -1 : cos(angle));
        y[i] = angle <= 0 || angle >= RW_PI ? 0 : r * sin(angle);
        y[i] = off_apex(c->s, x[i], y[i], r);
    }
    evaluate(c->s, n, x, y, J2);
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

/* A top much nearer to the centre than to its own mark is narrow from there. */
static void climb_around_centre(search *s, double from_mark)
{
    const double r = hypot(s->x, s->y);
    if (!(r > 0 && r < from_mark / 5))
        return;
    climb c = {s, 0, 1e-3 * r, 1e3 * r, {atan2(s->y, s->x), log(r)}, s->J2};
    climb_to(&c, LAST_SPAN);
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
        climb_around_centre(s, exp(c->top.log_radius));
        s->top_x = s->x;
        s->top_y = s->y;
        s->top_radius = exp(c->top.log_radius);
    }
}

/* The mark itself, where J2 is finite. */
static void evaluate_mark(search *s, double at)
{
    const double surface = 0;
    double J2;
    if (!rw_is_kink(&s->contact->geometry, at))
        evaluate(s, 1, &at, &surface, &J2);
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
        if (is_low(s, &from))
            continue;
        climb c = {s, from.centre, from.innermost, from.outermost, from.at, 0};
        evaluate_mark(s, from.centre);
        evaluate_places(&c, 1, &c.top, &c.J2);
        climb_to_top(&c);
    }
}

static void note(search *s, const foot *found)
{
    if (is_low(s, found))
        return;
    if (s->count == FEET)
        climb_all(s);
    s->feet[s->count++] = *found;
}

/* ---- The grid around one mark ---- */

/* On both sides: [1] is the mirror image. */
typedef struct {
    double centre, floor, close, reach;
    int rows;
    double radius[RADII], cosine[ANGLES], sine[ANGLES];
    double J2[2][RADII * ANGLES];
} polar_grid;

/* A band around the mark. */
static void fill_band(search *s, polar_grid *grid, const rw_neighbourhood *around, int first,
                      int rows)
{
    const int n = rows * ANGLES, from = first * ANGLES;
    double x[BAND * ANGLES], y[BAND * ANGLES];
    for (int i = 0; i < n; i++) {
        const double r = grid->radius[first + i / ANGLES];
        x[i] = grid->centre + r * grid->cosine[i % ANGLES];
        y[i] = off_apex(s, x[i], r * grid->sine[i % ANGLES], r);
    }
    rw_contact_fields fields;
    rw_neighbourhood_fields(s->contact, around, n, x, y, &fields);
    J2_from(s, &fields, 1, n, grid->J2[0] + from);
    if (s->is_centred && grid->centre != 0)
        J2_from(s, &fields, -1, n, grid->J2[1] + from);
}

/* Inwards: each band lies inside the one before. */
static void fill(search *s, polar_grid *grid, rw_neighbourhood around, double outermost,
                 double innermost)
{
    double radius = outermost;
    grid->rows = 0;
    for (; grid->rows < RADII && radius > innermost; radius *= radius > grid->close ? FALL : SPARSE)
        grid->radius[grid->rows++] = radius;
    for (int first = 0; first < grid->rows; first += BAND) {
        const int rows = grid->rows - first < BAND ? grid->rows - first : BAND;
        around = rw_neighbourhood_within(s->contact, &around, grid->centre, grid->radius[first]);
        fill_band(s, grid, &around, first, rows);
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

static bool is_smooth_at_centre(const rw_geometry *g)
{
    const rw_arcs arcs = rw_arcs_of(g);
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        if (arc.left == 0 || arc.right == 0)
            return false;
    }
    return true;
}

/* The inner radius of a grid. Around the centre of a rounded wedge all is smooth. */
static double innermost_radius(const search *s, const rw_mark *m)
{
    if (m->at == 0 && is_smooth_at_centre(&s->contact->geometry))
        return 0.05 * m->nearest;
    return fmax(INNERMOST * m->nearest, 1e-18 * fabs(m->at));
}

/* No grid at all where the mark is another one to rounding. A grid that goes on begins with the
 * last two rows again, because the last had no neighbours inside. */
static void search_around(search *s, const rw_mark *m, const rw_neighbourhood *around)
{
    const double innermost = innermost_radius(s, m);
    polar_grid grid = {
        .centre = m->at, .floor = innermost, .close = CLOSE * m->nearest, .reach = m->reach};
    for (int j = 0; j < ANGLES; j++) {
        grid.cosine[j] = cos(j * RW_PI / (ANGLES - 1));
        grid.sine[j] = j == 0 || j == ANGLES - 1 ? 0 : sin(j * RW_PI / (ANGLES - 1));
    }
    for (double outermost = m->reach; outermost > innermost;
         outermost = grid.rows == RADII ? grid.radius[RADII - 2] : 0) {
        fill(s, &grid, *around, outermost, innermost);
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

/* The edges of the patches between two, by halves: wide grids are far apart and narrow ones close.
 * The grid in the middle lies inside the disc around both ends. */
static void search_between(search *s, const rw_neighbourhood *outside, size_t inner, size_t outer,
                           int side)
{
    if (outer - inner < 2)
        return;
    const rw_corner *corners = s->contact->memory.corners;
    const double from = rw_mark_edge(corners[inner].patch, side),
                 to = rw_mark_edge(corners[outer].patch, side);
    const rw_neighbourhood around =
        rw_neighbourhood_within(s->contact, outside, from / 2 + to / 2, fabs(to - from));
    const size_t middle = inner + (outer - inner) / 2;
    const rw_mark m = rw_patch_mark(s->contact, inner, middle, outer, side);
    search_around(s, &m, &around);
    search_between(s, &around, inner, middle, side);
    search_between(s, &around, middle, outer, side);
}

static void search_all(search *s)
{
    const rwedge_contact *contact = s->contact;
    const rw_neighbourhood whole = rw_neighbourhood_whole(contact);
    const int to = s->is_centred ? 1 : -1;
    for (int part = 0; part < rw_main_parts(contact); part++)
        for (int side = 1; side >= (part > 0 ? to : 1); side -= 2) {
            const rw_mark m = rw_main_mark(contact, part, side);
            search_around(s, &m, &whole);
        }
    for (int side = 1; side >= to; side -= 2)
        search_between(s, &whole, 0, contact->memory.count - 1, side);
    const rw_shear_state *shear = contact->numerical ? &contact->numerical->now.shear : NULL;
    for (int i = 0; shear && i < shear->kinks; i++) {
        const rw_mark m = rw_kink_mark(contact, shear, i);
        search_around(s, &m, &whole);
    }
    climb_all(s);
}

/* At a kink, as the apex of the sharp wedge, the pressure is infinite, and so are the stresses
 * unless the material yields by shape alone and the traction's infinity is stuck: what counts is
 * the first patch that has the kink inside. */
static bool is_infinite(const rwedge_contact *contact, double kappa)
{
    const rw_arcs arcs = rw_arcs_of(&contact->geometry);
    const rw_memory *memory = &contact->memory;
    for (size_t i = 0; i < arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&arcs, i);
        size_t j = 1;
        while (j < memory->count && !rw_arc_is_inside(arc, memory->corners[j].patch))
            j++;
        if (arc.left == arc.right && j < memory->count &&
            (kappa > 0 || contact->f * memory->corners[j].ratio != 0))
            return true;
    }
    return false;
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
                .is_centred = !contact->numerical && rw_is_symmetric(&contact->geometry) &&
                              are_centred(&contact->memory),
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

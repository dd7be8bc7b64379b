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
 * The grid around a mark has the steps 0.4 in ln r and pi/16 in angle. It reaches from 3 b, beyond
 * which J2 falls like r^-2, to 1e-9 of the distance to the next mark. The marks and the surface
 * are on it. Each maximum of the grid that is not far below the highest is then followed to its
 * top. */
#include "contact/contact.h"

#include "base/always.h"
#include "stress/stress.h"
#include "stress/von_mises.h"

#include <float.h>

enum { ANGLES = 17, RADII = 64, LINE = 7, CLIMB_MAX = 60 }; /* ANGLES, LINE <= RW_BLOCK */

/* The ratio of neighbouring radii: RADII of them span 1e11. */
static const double FALL = 0.67;

/* A maximum of the grid is followed if it is above this fraction of the highest. The steps of the
 * grid cannot hide more. */
static const double WORTHWHILE = 0.25;

/* Half-lengths of the line on which a climb looks for a higher place, in radians and ln r. It
 * starts with FIRST. It ends at ROUGH when only the top must be told from others, and at LAST. */
static const double FIRST_SPAN = 0.4, ROUGH_SPAN = 1e-2, LAST_SPAN = 1e-7;

/* The relative rise of J2 that counts as none. */
static const double NO_GAIN = 4 * DBL_EPSILON;

/* How well a rough climb knows a top: a fraction of J2, and of the distance from the mark. */
static const double ROUGHLY = 0.05;

/* The highest J2 so far, in (theta/A)^2, and where. */
typedef struct {
    const rwedge_contact *contact;
    double kappa;
    double tension; /* half the bulk tension */
    double J2, x, y;
    /* the highest top climbed, and its distance from the mark; infinite before the first */
    double top_x, top_y, top_radius;
} search;

static void evaluate(search *s, size_t n, const double x[], const double y[], double J2[])
{
    rw_contact_fields fields;
    rw_contact_fields_at(s->contact, n, x, y, &fields);
    for (size_t i = 0; i < n; i++) {
        const rw_field shear = rw_field_multiple(s->contact->f, fields.tangential[i]);
        const rw_stress_state state = rw_superpose(fields.normal[i], shear);
        const double difference = state.difference - s->tension, mean = state.mean + s->tension;
        J2[i] = difference * difference + state.shear * state.shear + s->kappa * mean * mean;
        if (J2[i] > s->J2) {
            s->J2 = J2[i];
            s->x = x[i];
            s->y = y[i];
        }
    }
}

/* ---- The marks ---- */

/* The parts of the surface whose edges are marks: the contact, the rounding as far as it is in
 * contact, and the patches inside from the widest to the narrowest. */
static rw_patch marked(const rwedge_contact *contact, size_t i)
{
    const rw_corner *corners = contact->memory.corners;
    const size_t last = contact->memory.count - 1;
    const rw_patch patch = corners[i <= 1 ? last : last + 1 - i].patch;
    const double a = contact->geometry.a;
    return i == 1 ? (rw_patch){fmax(-a, patch.left), fmin(a, patch.right)} : patch;
}

/* First the centre, then the edges of each part. */
static double mark(const rwedge_contact *contact, size_t i)
{
    if (i == 0)
        return 0;
    const rw_patch part = marked(contact, (i - 1) / 2);
    return i % 2 ? part.right : part.left;
}

/* How far the contact reaches from the centre. */
static double extent(const rwedge_contact *contact)
{
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    return fmax(-patch.left, patch.right);
}

static size_t count_marks(const rwedge_contact *contact)
{
    return 1 + 2 * contact->memory.count;
}

/* The outer radius of the grid around a mark: twice the distance to the nearest of the marks
 * before it. Their grids take over there. */
static double reach(const rwedge_contact *contact, size_t i)
{
    double nearest = 1.5 * extent(contact);
    for (size_t j = 0; j < i; j++)
        nearest = fmin(nearest, fabs(mark(contact, i) - mark(contact, j)));
    return 2 * nearest;
}

/* The inner radius: well inside the distance to the nearest of all marks. Strong friction may put
 * the maximum b/f^2 from an edge, where p falls to 1/f: the radius is below that too. It is not
 * below the rounding of the mark itself. */
static double innermost_radius(const rwedge_contact *contact, size_t i)
{
    double nearest = extent(contact);
    for (size_t j = 0; j < count_marks(contact); j++) {
        const double distance = fabs(mark(contact, i) - mark(contact, j));
        if (distance > 0)
            nearest = fmin(nearest, distance);
    }
    const double f = fmax(1, 1e-3 * contact->f);
    return fmax(1e-9 * nearest / (f * f), 1e-18 * fabs(mark(contact, i)));
}

/* ---- Climbing ---- */

/* In polar coordinates around a mark. */
typedef struct {
    double angle, log_radius;
} polar;

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
        /* by rounding: the place is the apex of a sharp wedge, which has no stress; beside it,
         * J2 is not high */
        if (c->s->contact->geometry.a == 0 && fabs(x[i]) + y[i] == 0)
            y[i] = 1e-3 * r;
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
    for (int i = 0; ALWAYS(i < CLIMB_MAX); i++) { /* a few are enough */
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
    climb_to(c, LAST_SPAN);
    if (c->J2 >= s->J2) {
        s->top_x = s->x;
        s->top_y = s->y;
        s->top_radius = r;
    }
}

/* ---- The grid around one mark ---- */

/* As many radii as are kept at a time: those of one annulus, rows of them. */
typedef struct {
    double centre;
    int rows;
    double radius[RADII], cosine[ANGLES], sine[ANGLES];
    double J2[RADII][ANGLES];
} polar_grid;

static void fill(search *s, polar_grid *grid, double centre, double outermost, double innermost)
{
    grid->centre = centre;
    for (int j = 0; j < ANGLES; j++) {
        grid->cosine[j] = cos(j * RW_PI / (ANGLES - 1));
        grid->sine[j] = j == 0 || j == ANGLES - 1 ? 0 : sin(j * RW_PI / (ANGLES - 1));
    }
    double radius = outermost;
    int i = 0;
    for (; i < RADII && radius > innermost; i++) {
        double x[ANGLES], y[ANGLES];
        for (int j = 0; j < ANGLES; j++) {
            x[j] = centre + radius * grid->cosine[j];
            y[j] = radius * grid->sine[j];
        }
        evaluate(s, ANGLES, x, y, grid->J2[i]);
        grid->radius[i] = radius;
        radius *= FALL;
    }
    grid->rows = i;
}

/* On a plateau, the first of its points. */
static bool is_maximum(const polar_grid *grid, int i, int j)
{
    for (int k = i > 0 ? i - 1 : 0; k <= i + 1 && k < grid->rows; k++)
        for (int l = j > 0 ? j - 1 : 0; l <= j + 1 && l < ANGLES; l++)
            if (grid->J2[k][l] > grid->J2[i][j] ||
                (grid->J2[k][l] == grid->J2[i][j] && (k < i || (k == i && l < j))))
                return false;
    return true;
}

/* From the rows first ... end-1. */
static void climb_from_grid(search *s, const polar_grid *grid, int first, int end)
{
    climb c = {.s = s,
               .centre = grid->centre,
               .innermost = 0.1 * grid->radius[end - 1],
               .outermost = 10 * grid->radius[0]};
    for (int i = first; i < end; i++)
        for (int j = 0; j < ANGLES; j++)
            if (grid->J2[i][j] >= WORTHWHILE * s->J2 && is_maximum(grid, i, j)) {
                c.top = (polar){j * RW_PI / (ANGLES - 1), log(grid->radius[i])};
                c.J2 = grid->J2[i][j];
                climb_to_top(&c);
            }
}

static void search_around(search *s, size_t i)
{
    const double outermost = reach(s->contact, i), innermost = innermost_radius(s->contact, i);
    const double centre = mark(s->contact, i), surface = 0;
    double J2;
    if (centre != 0 || s->contact->geometry.a > 0)
        evaluate(s, 1, &centre, &surface, &J2);
    if (outermost <= innermost) /* the same as another mark, to rounding */
        return;
    polar_grid grid;
    fill(s, &grid, centre, outermost, innermost);
    int first = 0;
    /* the next annulus repeats the last two rows, so that each row has both its neighbours once */
    while (grid.rows == RADII) {
        climb_from_grid(s, &grid, first, RADII - 1);
        fill(s, &grid, centre, grid.radius[RADII - 2], innermost);
        first = 1;
    }
    climb_from_grid(s, &grid, first, grid.rows);
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
                .top_radius = HUGE_VAL};
    double found = 0;
    if (!is_infinite(contact, s.kappa)) {
        for (size_t i = 0; i < count_marks(contact); i++)
            search_around(&s, i);
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

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
 * surface are on it. Each maximum of the grid that may lead to the highest top is then
 * followed to it.
 *
 * On the grids the patches that end far from the mark count together (neighbourhood.h): a grid
 * takes as long for many patches as for few. A climb takes them all as they are. */
#include "yield/climb.h"
#include "yield/marks.h"
#include "yield/neighbourhood.h"

#include "stress/von_mises.h"

/* BAND radii of a grid are evaluated at once. */
enum { ANGLES = 9, RADII = 52, BAND = 3, STARTS_KEPT = 8 };

/* Closer to the mark than CLOSE of the way to the next one, J2 varies by powers of r alone. There
 * SPARSE suffices as the ratio of neighbouring radii. */
static const double CLOSE = 0.05, SPARSE = 0.25;

/* The innermost radius, of the distance to the next mark. Next to a mark J2 is J2(m) + A sqrt(r) -
 * B r, where B r is below J2 at the next mark's distance: a top farther in rises by less than 1e-14
 * of it. */
static const double INNERMOST = 1e-14;

/* The relative error of J2 on a grid, and more. */
static const double GRID_ERROR = 1e-8;

typedef struct {
    rw_highest highest;
    bool is_centred; /* all patches are: at -x are the fields of the opposite shear at x */
    rw_climb starts[STARTS_KEPT];
    size_t count;
} search;

/* ---- Where to climb ---- */

/* Whether the climb from a start cannot end above the highest J2 known. */
static bool is_low(const search *s, double J2, double hidden)
{
    return J2 + hidden < (1 - GRID_ERROR) * s->highest.known;
}

/* Climbs from the highest start first, as long as one may lead above the highest J2 known, with
 * what the grid may hide. */
static void climb_all(search *s)
{
    while (s->count > 0) {
        size_t best = 0;
        for (size_t i = 1; i < s->count; i++)
            if (s->starts[i].J2 > s->starts[best].J2)
                best = i;
        const rw_climb from = s->starts[best];
        s->starts[best] = s->starts[--s->count];
        if (!is_low(s, from.J2, from.hidden))
            rw_climb_from(&s->highest, from);
    }
}

static void note(search *s, const rw_climb *from)
{
    if (is_low(s, from->J2, from->hidden))
        return;
    if (s->count == STARTS_KEPT)
        climb_all(s);
    s->starts[s->count++] = *from;
}

/* ---- The grid around one mark ---- */

/* J2 on both sides of the contact: [1] is the mirror image. */
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
        y[i] = rw_off_apex(s->highest.contact, x[i], r * grid->sine[i % ANGLES], r);
    }
    rw_contact_fields fields;
    rw_neighbourhood_fields(s->highest.contact, around, n, x, y, &fields);
    rw_J2_from(&s->highest, &fields, 1, n, grid->J2[0] + from);
    if (s->is_centred && grid->centre != 0)
        rw_J2_from(&s->highest, &fields, -1, n, grid->J2[1] + from);
}

/* Inwards: each band lies inside the one before. */
static void fill(search *s, polar_grid *grid, rw_neighbourhood around, double outermost,
                 double innermost)
{
    double radius = outermost;
    grid->rows = 0;
    for (; grid->rows < RADII && radius > innermost;
         radius *= radius > grid->close ? RW_FALL : SPARSE)
        grid->radius[grid->rows++] = radius;
    for (int first = 0; first < grid->rows; first += BAND) {
        const int rows = grid->rows - first < BAND ? grid->rows - first : BAND;
        around =
            rw_neighbourhood_within(s->highest.contact, &around, grid->centre, grid->radius[first]);
        fill_band(s, grid, &around, first, rows);
    }
}

/* Whether no neighbour is higher (on a plateau only its first point counts), and the lowest
 * neighbour. */
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
 * 8 times that. This is an estimate, not a bound. tests/proof/test_yield_survey.c checks it: it
 * leaves no start out, on grids three times as fine. It found no higher J2 in 1500 random
 * histories, once climb_ridge() was there. */
static void note_starts(search *s, const polar_grid *grid, int side)
{
    const double *J2 = grid->J2[side];
    for (int i = 0; i < grid->rows; i++)
        for (int j = 0; j < ANGLES; j++) {
            const double here = J2[i * ANGLES + j];
            double lowest;
            if (is_low(s, here, here) || !is_maximum(J2, grid->rows, i, j, &lowest))
                continue;
            const int angle = side ? ANGLES - 1 - j : j;
            const rw_climb top = {side ? -grid->centre : grid->centre,
                                  0.1 * grid->floor,
                                  10 * grid->reach,
                                  {angle * RW_PI / (ANGLES - 1), log(grid->radius[i])},
                                  here,
                                  here - lowest};
            note(s, &top);
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
    if (m->at == 0 && is_smooth_at_centre(&s->highest.contact->geometry))
        return 0.05 * m->nearest;
    return fmax(INNERMOST * m->nearest, 1e-18 * fabs(m->at));
}

/* There is no grid where the mark coincides with another one, to rounding. A grid that goes on
 * begins with the last two rows again, because the last had no neighbours inside. */
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
        note_starts(s, &grid, 0);
        if (s->is_centred && m->at != 0)
            note_starts(s, &grid, 1);
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
    const rw_corner *corners = s->highest.contact->memory.corners;
    const double from = rw_mark_edge(corners[inner].patch, side),
                 to = rw_mark_edge(corners[outer].patch, side);
    const rw_neighbourhood around =
        rw_neighbourhood_within(s->highest.contact, outside, from / 2 + to / 2, fabs(to - from));
    const size_t middle = inner + (outer - inner) / 2;
    const rw_mark m = rw_patch_mark(s->highest.contact, inner, middle, outer, side);
    search_around(s, &m, &around);
    search_between(s, &around, inner, middle, side);
    search_between(s, &around, middle, outer, side);
}

static void search_all(search *s)
{
    const rwedge_contact *contact = s->highest.contact;
    const rw_neighbourhood whole = rw_neighbourhood_whole(contact);
    const int next = s->is_centred ? 2 : 1; /* right marks alone */
    for (int i = 0; i < rw_main_marks(contact); i += i == 0 ? 1 : next) {
        const rw_mark m = rw_main_mark(contact, i);
        search_around(s, &m, &whole);
    }
    search_between(s, &whole, 0, contact->memory.count - 1, 1);
    if (!s->is_centred)
        search_between(s, &whole, 0, contact->memory.count - 1, -1);
    const rw_shear_state *shear = contact->computed.now ? &contact->computed.now->now.shear : NULL;
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
    const double unit = rw_unit_stress(&contact->geometry);
    search s = {.highest = {.contact = contact,
                            .kappa = rw_plane_strain_weight(nu),
                            .tension = contact->loads.sigma / 2 / unit,
                            .top_radius = HUGE_VAL},
                .is_centred = !contact->computed.now && !contact->unlike &&
                              rw_is_symmetric(&contact->geometry) && are_centred(&contact->memory)};
    double most = 0;
    const rw_highest *highest = &s.highest;
    if (!is_infinite(contact, highest->kappa)) {
        search_all(&s);
        if (!(highest->J2 > 0)) /* the stresses of the smallest contacts round to 0 */
            return RWEDGE_ERANGE;
        most = k / (unit * sqrt(highest->J2));
    }
    if (!rw_is_magnitude(most))
        return RWEDGE_ERANGE;
    *factor = most;
    if (x)
        *x = highest->x;
    if (y)
        *y = highest->y;
    return RWEDGE_OK;
}

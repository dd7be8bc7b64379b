/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The maximum of J2 over the half-plane under any history: a search, because the tractions of a history have no closed
 * form for it, and J2 may have many maxima.
 *
 * Why the global one is not missed. G is analytic but for the marks on the surface: the edges of the patches, x = +-a
 * and the centre. At a distance r from the nearest mark the fields vary over lengths of the order r: -Im G is positive
 * and harmonic in the half-plane, so that y |G'| <= |Im G| and y^2 |G''| <= 2 |Im G| (Schwarz and Pick), and next to
 * the surface between marks they continue across it. In polar coordinates around each mark, with ln r, no maximum is
 * therefore narrower than about 1. The grid has the steps 0.4 in ln r and pi/16 in angle, reaches from 3 b (beyond it
 * J2 falls like r^-2) to 1e-9 of the distance to the next mark, and has the marks themselves and the surface on it.
 * Every maximum of the grid that is not far below the highest is then followed to its top. */
#include "contact.h"

#include "stress.h"
#include "von_mises.h"

#include <float.h>

enum { ANGLES = 17, RADII = 54, CLIMB_MAX = 400, NEWTON_MAX = 40 }; /* ANGLES <= RW_BLOCK */

/* The ratio of neighbouring radii: RADII of them span 1e9. */
static const double FALL = 0.67;

/* A maximum of the grid is followed where it is above this fraction of the highest: the grid's steps cannot lose as
 * much. */
static const double WORTHWHILE = 0.25;

/* The highest J2 so far, in (theta/A)^2 over the square of a power of two, and where. */
typedef struct {
    const rwedge_contact *contact;
    double kappa, magnify;
    double J2, x, y;
} search;

/* The stresses of Hertz' contact are of the order b/a, whose square might underflow. */
static int magnification(const rwedge_contact *contact)
{
    return ilogb(fmax(1, contact->geometry.a / rwedge_contact_half_width(contact)));
}

static void evaluate(search *s, size_t n, const double x[], const double y[], double J2[])
{
    rw_contact_fields fields;
    rw_contact_fields_at(s->contact, n, x, y, &fields);
    for (size_t i = 0; i < n; i++) {
        const rw_field shear = rw_field_multiple(s->contact->f, fields.tangential[i]);
        const rw_stress_state state = rw_superpose(fields.normal[i], shear);
        const double difference = s->magnify * state.difference, mean = s->magnify * state.mean;
        const double in_shear = s->magnify * state.shear;
        J2[i] = difference * difference + in_shear * in_shear + s->kappa * mean * mean;
        if (J2[i] > s->J2) {
            s->J2 = J2[i];
            s->x = x[i];
            s->y = y[i];
        }
    }
}

/* ---- The marks ---- */

/* Mark 0 is the centre, then in pairs +-: the edges of the contact, +-a, and the patches' edges from outside
 * inwards. */
static double mark(const rwedge_contact *contact, size_t i)
{
    if (i == 0)
        return 0;
    const size_t pair = (i + 1) / 2, corners = contact->path.count;
    const double at = pair == 2 ? fmin(contact->geometry.a, rwedge_contact_half_width(contact))
                                : contact->path.corners[pair == 1 ? corners - 1 : corners + 1 - pair].half_width;
    return i % 2 ? at : -at;
}

static size_t count_marks(const rwedge_contact *contact)
{
    return 1 + 2 * contact->path.count;
}

/* How far the grid around a mark reaches: twice the distance to the nearest of the marks before it, whose grid takes
 * over there. */
static double reach(const rwedge_contact *contact, size_t i)
{
    double nearest = 1.5 * rwedge_contact_half_width(contact);
    for (size_t j = 0; j < i; j++)
        nearest = fmin(nearest, fabs(mark(contact, i) - mark(contact, j)));
    return 2 * nearest;
}

/* ---- Climbing ---- */

/* Newton's steps to the top, with differences over 1e-4 of the depth: they follow the long flat ridges of J2 that a
 * narrow rounding has, where the search in eight directions below would creep. */
static void refine(search *s, double x, double y, double J2)
{
    for (int i = 0; i < NEWTON_MAX && y > 0; i++) {
        const double h = 1e-4 * y;
        double px[9], py[9], v[9];
        for (int j = 0; j < 9; j++) {
            px[j] = x + h * (j % 3 - 1);
            py[j] = y + h * (j / 3 - 1);
        }
        evaluate(s, 9, px, py, v);
        const double g_x = (v[5] - v[3]) / 2, g_y = (v[7] - v[1]) / 2;
        const double xx = v[5] - 2 * v[4] + v[3], yy = v[7] - 2 * v[4] + v[1], xy = (v[8] - v[6] - v[2] + v[0]) / 4;
        const double determinant = xx * yy - xy * xy;
        if (!(xx < 0 && determinant > 0)) /* no maximum nearby */
            return;
        const double to_x = (xy * g_y - yy * g_x) / determinant * h, to_y = (xy * g_x - xx * g_y) / determinant * h;
        const double length = hypot(to_x, to_y), shorter = length > 0.5 * y ? 0.5 * y / length : 1;
        const double next_x = x + shorter * to_x, next_y = y + shorter * to_y;
        double next;
        evaluate(s, 1, &next_x, &next_y, &next);
        if (!(next > J2))
            return;
        x = next_x;
        y = next_y;
        J2 = next;
    }
}

/* Eight neighbours at a distance, which is halved where none is higher: to a distance that no longer shows in a
 * maximum. */
static void climb(search *s, double x, double y, double J2, double step)
{
    static const double AROUND[8][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    const double smallest = step * 1e-8;
    for (int i = 0; i < CLIMB_MAX && step > smallest; i++) {
        double px[8], py[8], around[8];
        for (int j = 0; j < 8; j++) {
            px[j] = x + step * AROUND[j][0];
            py[j] = fmax(0, y + step * AROUND[j][1]);
            if (s->contact->geometry.a == 0 && px[j] == 0 && py[j] == 0)
                py[j] = step / 2; /* beside the apex of the sharp wedge, where there is no stress to speak of */
        }
        evaluate(s, 8, px, py, around);
        int highest = 0;
        for (int j = 1; j < 8; j++)
            if (around[j] > around[highest])
                highest = j;
        if (around[highest] > J2) {
            x = px[highest];
            y = py[highest];
            J2 = around[highest];
        } else {
            step /= 2;
        }
    }
    refine(s, x, y, J2);
}

/* ---- The grid around one mark ---- */

typedef struct {
    double centre;
    double radius[RADII], cosine[ANGLES], sine[ANGLES];
    double J2[RADII][ANGLES];
} polar_grid;

static void fill(search *s, polar_grid *grid, double centre, double outermost)
{
    grid->centre = centre;
    for (int j = 0; j < ANGLES; j++) {
        grid->cosine[j] = cos(j * RW_PI / (ANGLES - 1));
        grid->sine[j] = j == 0 || j == ANGLES - 1 ? 0 : sin(j * RW_PI / (ANGLES - 1));
    }
    for (int i = 0; i < RADII; i++) {
        grid->radius[i] = i == 0 ? outermost : FALL * grid->radius[i - 1];
        double x[ANGLES], y[ANGLES];
        for (int j = 0; j < ANGLES; j++) {
            x[j] = centre + grid->radius[i] * grid->cosine[j];
            y[j] = grid->radius[i] * grid->sine[j];
        }
        evaluate(s, ANGLES, x, y, grid->J2[i]);
    }
}

static bool is_maximum(const polar_grid *grid, int i, int j)
{
    for (int k = i > 0 ? i - 1 : 0; k <= i + 1 && k < RADII; k++)
        for (int l = j > 0 ? j - 1 : 0; l <= j + 1 && l < ANGLES; l++)
            if (grid->J2[k][l] > grid->J2[i][j])
                return false;
    return true;
}

static void climb_from_grid(search *s, const polar_grid *grid)
{
    for (int i = 0; i < RADII; i++)
        for (int j = 0; j < ANGLES; j++)
            if (grid->J2[i][j] >= WORTHWHILE * s->J2 && is_maximum(grid, i, j))
                climb(s, grid->centre + grid->radius[i] * grid->cosine[j], grid->radius[i] * grid->sine[j],
                      grid->J2[i][j], 0.25 * grid->radius[i]);
}

static void search_around(search *s, size_t i)
{
    const double outermost = reach(s->contact, i), centre = mark(s->contact, i), surface = 0;
    if (!(outermost > 0))
        return;
    double J2;
    if (centre != 0 || s->contact->geometry.a > 0)
        evaluate(s, 1, &centre, &surface, &J2);
    polar_grid grid;
    fill(s, &grid, centre, outermost);
    climb_from_grid(s, &grid);
}

/* The apex of the sharp wedge: its pressure is infinite, and so are the stresses unless the material yields by shape
 * alone and the traction's infinity is stuck. */
static bool is_infinite(const rwedge_contact *contact, double kappa)
{
    return contact->geometry.a == 0 && (kappa > 0 || contact->f * contact->path.corners[1].ratio != 0);
}

int32_t rwedge_contact_yield_factor(const rwedge_contact *contact, double nu, double k, double *factor, double *x,
                                    double *y)
{
    if (!contact || !factor)
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu) || !rw_is_nonnegative(k) || k == 0)
        return RWEDGE_EDOMAIN;
    if (contact->path.count < 2)
        return RWEDGE_EABSENT;
    const int doublings = magnification(contact);
    search s = {.contact = contact, .kappa = rw_plane_strain_weight(nu), .magnify = rw_power_of_two(doublings)};
    double found = 0;
    if (!is_infinite(contact, s.kappa)) {
        for (size_t i = 0; i < count_marks(contact); i++)
            search_around(&s, i);
        if (!(s.J2 > 0)) /* unreached: the grid has points with stress */
            return RWEDGE_ERANGE;
        rw_scaled highest = rw_scaled_times(rw_unit_stress(&contact->geometry), rw_scaled_from(sqrt(s.J2)));
        highest.exponent -= doublings;
        found = rw_scaled_value(rw_scaled_over(rw_scaled_from(k), highest));
    }
    if (!isfinite(found))
        return RWEDGE_ERANGE;
    *factor = found;
    if (x)
        *x = s.x;
    if (y)
        *y = s.y;
    return RWEDGE_OK;
}

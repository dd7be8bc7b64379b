/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A layer in place of the half-plane. The slope of its surface beside a force at the distance u is
 * that of a half-plane, 1/u, and more:
 *
 *     1/u + a1 u/t^2 + O(u^3/t^4),   a1 = int (M(x) - 1) x dx,   M = (cosh 2x - 1)/(sinh 2x + 2x).
 *
 * Summed over the pressure of a load P the first term is linear in x: a parabola that the pad has
 * beside its own profile. lib/README.md, "A specimen of finite thickness". */
#include "pads/pads.h"

#include <stdlib.h>

static const double FIRST = -1.0420749174684513; /* a1 */

/* The largest half-width, over t. */
static const double WIDEST = 0.5;

/* Adds a line of this rate to the slopes. Beyond the outermost places it goes as far as a contact
 * may reach. */
static void add_line(double rate, double t, size_t n, double x[], double slope[])
{
    x[0] = x[1] - t;
    slope[0] = slope[1];
    x[n - 1] = x[n - 2] + t;
    slope[n - 1] = slope[n - 2];
    for (size_t i = 0; i < n; i++)
        slope[i] += rate * x[i];
}

static bool is_thin(const rw_geometry *g, double t, double P)
{
    const rw_patch patch = rw_patch_under_moment(g, P, 0);
    return !islessequal(rw_patch_half_width(patch), WIDEST * t);
}

int32_t rwedge_contact_set_thickness(rwedge_contact *contact, double t, double P)
{
    if (!contact)
        return RWEDGE_ENULL;
    if (!rw_is_positive(t) || !rw_is_positive(P) || contact->phase != RW_APART || contact->is_held)
        return RWEDGE_EDOMAIN;
    const double own = 2 * rwedge_contact_strain(contact),
                 rate = -FIRST * own * P / (RW_PI * t * t);
    const size_t n = rwedge_contact_place_count(contact) + 2;
    double *x = malloc(2 * n * sizeof *x);
    if (!x)
        return RWEDGE_ENOMEM;
    double *slope = x + n;
    rw_geometry geometry;
    rwedge_contact_places(contact, n - 2, x + 1, slope + 1);
    add_line(rate, t, n, x, slope);
    int32_t status = rw_profile_geometry(n, x, slope, contact->geometry.A, &geometry);
    free(x);
    if (status == RWEDGE_OK && is_thin(&geometry, t, P)) {
        rw_pad_destroy(geometry.pad);
        status = RWEDGE_ERANGE;
    }
    if (status != RWEDGE_OK)
        return status;
    rw_pad_destroy(contact->geometry.pad);
    contact->geometry = geometry;
    contact->memory.corners[0].stretch = rw_contact_stretch(contact, contact->loads.sigma);
    return RWEDGE_OK;
}

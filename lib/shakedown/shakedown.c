/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load that a contact in full sliding carries again and again: after the first passes it is
 * elastic. Residual stresses help, so it is above the elastic limit. Melan's theorem is exact here:
 * lib/README.md, "Shakedown". */
#include "base/domain.h"
#include "base/root.h"
#include "contact/contact.h"
#include "shakedown/deepest.h"
#include "strength/limit_load.h"
#include "stress/von_mises.h"
#include "yield/yield_load.h"

/* The smallest tip, besides the sharp wedge. */
static const double SMALLEST_TIP = 1e-3;

/* For alpha >= 1 the load and the stresses both fall like 1/alpha. */
static double shape(double alpha)
{
    return fmin(alpha, 1);
}

static bool is_case(double alpha, double f, double nu)
{
    return rw_is_magnitude(alpha) && (alpha == 0 || alpha >= SMALLEST_TIP) && rw_is_friction(f) &&
           rw_is_poisson(nu);
}

static rw_pass pass_of(double alpha, double f, double nu)
{
    return (rw_pass){.arcs = {.count = 1, .rounding = rw_rounding(shape(alpha))},
                     .patch = {-1, 1},
                     .f = f,
                     .weight = sqrt(rw_plane_strain_weight(nu))};
}

static double limit_of(double alpha, double peak)
{
    return rwedge_load(shape(alpha)) / peak;
}

/* Without friction and volume change the surface has no deviator. */
static bool has_surface(double f, double nu)
{
    return f > 0 || nu < 0.5;
}

/* The stresses at the apex of the sharp wedge are infinite, but for the case above. */
static bool is_infinite(double alpha, double f, double nu)
{
    return alpha == 0 && has_surface(f, nu);
}

static int32_t check(double alpha, double f, double nu, const double *limit, const double *y)
{
    if (!limit || !y)
        return RWEDGE_ENULL;
    return is_case(alpha, f, nu) ? RWEDGE_OK : RWEDGE_EDOMAIN;
}

static int32_t give(double alpha, rw_depth depth, double *limit, double *y)
{
    *limit = limit_of(alpha, depth.peak);
    *y = depth.y;
    return RWEDGE_OK;
}

static rw_depth deepest(double alpha, double f, double nu)
{
    const rw_pass pass = pass_of(alpha, f, nu);
    rw_depth depth = {.y = 0};
    if (alpha > 0)
        return rw_deepest(&pass);
    rw_subsurface_depth(&pass, &depth);
    return depth;
}

int32_t rwedge_shakedown_limit(double alpha, double f, double nu, double *limit, double *y)
{
    const int32_t status = check(alpha, f, nu, limit, y);
    if (status != RWEDGE_OK)
        return status;
    if (!is_infinite(alpha, f, nu))
        return give(alpha, deepest(alpha, f, nu), limit, y);
    *limit = *y = 0;
    return RWEDGE_OK;
}

int32_t rwedge_subsurface_shakedown(double alpha, double f, double nu, double *limit, double *y)
{
    const int32_t status = check(alpha, f, nu, limit, y);
    if (status != RWEDGE_OK)
        return status;
    const rw_pass pass = pass_of(alpha, f, nu);
    rw_depth depth;
    const bool has_one = !is_infinite(alpha, f, nu) && rw_subsurface_depth(&pass, &depth);
    return has_one ? give(alpha, depth, limit, y) : RWEDGE_EABSENT;
}

int32_t rwedge_surface_shakedown(double alpha, double f, double nu, double *limit)
{
    if (!limit)
        return RWEDGE_ENULL;
    if (!is_case(alpha, f, nu))
        return RWEDGE_EDOMAIN;
    if (!has_surface(f, nu))
        return RWEDGE_EABSENT;
    const rw_pass pass = pass_of(alpha, f, nu);
    *limit = alpha > 0 ? limit_of(alpha, rw_surface_peak(&pass)) : 0;
    return RWEDGE_OK;
}

/* ---- The load at which a contact with units just shakes down ---- */

static double peak(double alpha, double f, double nu)
{
    return deepest(alpha, f, nu).peak;
}

double rwedge_shakedown_load(double theta, double a, double A, double f, double nu, double k)
{
    const rw_limit shakedown = {peak, SMALLEST_TIP, 1e-13};
    return rw_limit_load(&shakedown, theta, a, A, f, nu, k);
}

/* ---- Any pad ---- */

static bool has_kink_inside(const rw_pass *pass)
{
    for (size_t i = 0; i < pass->arcs.count; i++) {
        const rw_arc arc = rw_arc_at(&pass->arcs, i);
        if (arc.left == arc.right && rw_arc_is_inside(arc, pass->patch))
            return true;
    }
    return false;
}

int32_t rwedge_contact_shakedown_factor(const rwedge_contact *contact, double nu, double k,
                                        double *factor, double *y)
{
    if (!contact || !factor)
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu) || !rw_is_positive(k))
        return RWEDGE_EDOMAIN;
    if (contact->phase != RW_SLIDING && (contact->f > 0 || contact->phase == RW_APART))
        return RWEDGE_EABSENT;
    const rw_pass pass = {.arcs = rw_arcs_of(&contact->geometry),
                          .patch = rw_memory_end(&contact->memory)->patch,
                          .f = copysign(contact->f, contact->loads.Q),
                          .weight = sqrt(rw_plane_strain_weight(nu)),
                          .slides = rw_contact_way(contact)};
    const double unit = rw_unit_stress(&contact->geometry);
    rw_depth depth = {.y = 0};
    double most = 0;
    if (!has_kink_inside(&pass)) {
        depth = rw_deepest(&pass);
        most = depth.peak > 0 ? k / (unit * depth.peak) : HUGE_VAL; /* 0: next to no width */
    }
    if (!rw_is_magnitude(most))
        return RWEDGE_ERANGE;
    *factor = most;
    if (y)
        *y = depth.y;
    return RWEDGE_OK;
}

static int32_t factor(const rwedge_contact *contact, double nu, double k, double *factor, double *x,
                      double *y)
{
    *x = 0;
    return rwedge_contact_shakedown_factor(contact, nu, k, factor, y);
}

int32_t rwedge_contact_shakedown_load(const rwedge_contact *contact, double nu, double k, double *P,
                                      double *y)
{
    double load, at_x, at_y;
    if (!contact || !P)
        return RWEDGE_ENULL;
    if (!rw_is_poisson(nu) || !rw_is_positive(k))
        return RWEDGE_EDOMAIN;
    const int32_t status = rw_limit_of_pad(contact, factor, nu, k, &load, &at_x, &at_y);
    if (status != RWEDGE_OK)
        return status;
    *P = load;
    if (y)
        *y = at_y;
    return RWEDGE_OK;
}

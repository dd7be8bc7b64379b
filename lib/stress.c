/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The interior stress field. With a normal traction of potential G_N and a shear traction of potential G_T,
 *     s = (sxx+syy)/2 = Im G_N - Re G_T,   D = (syy-sxx)/2 + i txy = -y G_N' + i y G_T' + G_T,
 * which is Eq. (32), (33) for G_T = f G_N. In partial slip G_T = f (G_N - G_c), where G_c belongs to the same profile
 * pressed to the half-width c of the stick zone. */
#include "stress.h"

#include "domain.h"
#include "rwedge.h"

rw_stress_state rw_superpose(rw_field normal, rw_field tangential)
{
    return (rw_stress_state){
        .mean = normal.G_im - tangential.G_re,
        .difference = tangential.G_re - tangential.H_im - normal.H_re,
        .shear = tangential.G_im + tangential.H_re - normal.H_im,
    };
}

/* The tractions of one contact: all of its patches share the centre 0. */
typedef struct {
    double f, c;
    rw_potential contact, stick;
} tractions;

/* A stick zone so narrow that 1/c, alpha/c or z/c might overflow carries no load that a double could show. */
static bool can_matter(double c, double length)
{
    return c > 1e-290 && length <= c * 1e280;
}

/* reach: the largest |x| or y of the points. */
static void prepare(rw_potential *potential, double alpha, double c, double reach)
{
    if (reach <= RW_NEAR * c)
        rw_potential_init_near(potential, alpha, c);
    else
        rw_potential_init_patch(potential, alpha, c);
}

static tractions make_tractions(double alpha, double f, double c, double reach)
{
    tractions t = {.f = f, .c = can_matter(c, alpha) ? c : 0};
    prepare(&t.contact, alpha, 1, reach);
    if (t.c > 0)
        prepare(&t.stick, alpha, c, reach);
    return t;
}

static rw_field difference(rw_field a, rw_field b)
{
    return (rw_field){a.G_re - b.G_re, a.G_im - b.G_im, a.H_re - b.H_re, a.H_im - b.H_im};
}

static void stress_at(const tractions *t, double x, double y, double *sxx, double *syy, double *txy)
{
    const rw_field normal = rw_potential_at(&t->contact, x, y);
    rw_field shear = normal;
    if (can_matter(t->c, fmax(fabs(x), y)))
        shear = difference(normal, rw_potential_at(&t->stick, x, y));
    const rw_stress_state s = rw_superpose(normal, rw_field_multiple(t->f, shear));
    *sxx = s.mean - s.difference;
    *syy = s.mean + s.difference;
    *txy = s.shear;
}

static bool is_contact(double alpha, double f, double c)
{
    return rw_is_nonnegative(alpha) && rw_is_friction(f) && rw_is_fraction(c);
}

static bool is_point(double alpha, double x, double y)
{
    return isfinite(x) && rw_is_nonnegative(y) && !(alpha == 0 && x == 0 && y == 0);
}

int32_t rwedge_stress(double alpha, double f, double c, double x, double y, double *sxx, double *syy, double *txy)
{
    return rwedge_stresses(alpha, f, c, 1, &x, &y, sxx, syy, txy);
}

int32_t rwedge_stresses(double alpha, double f, double c, size_t n, const double x[], const double y[], double sxx[],
                        double syy[], double txy[])
{
    if (!is_contact(alpha, f, c))
        return RWEDGE_EDOMAIN;
    if (n > 0 && (!x || !y || !sxx || !syy || !txy))
        return RWEDGE_ENULL;
    double reach = 0;
    for (size_t i = 0; i < n; i++) {
        if (!is_point(alpha, x[i], y[i]))
            return RWEDGE_EDOMAIN;
        reach = fmax(reach, fmax(fabs(x[i]), y[i]));
    }
    const tractions t = make_tractions(alpha, f, c, reach);
    for (size_t i = 0; i < n; i++)
        stress_at(&t, x[i], y[i], &sxx[i], &syy[i], &txy[i]);
    return RWEDGE_OK;
}

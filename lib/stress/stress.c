/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The interior stress field. With a normal traction of potential G_N and a shear traction of
 * potential G_T,
 *     s = (sxx+syy)/2 = Im G_N - Re G_T,   D = (syy-sxx)/2 + i txy = -y G_N' + i y G_T' + G_T,
 * This is Eq. (32), (33) for G_T = f G_N. In partial slip G_T = f (G_N - G_c). G_c belongs to the
 * same profile pressed to the half-width c of the stick zone. */
#include "stress/stress.h"

#include "stress/batch.h"
#include "base/domain.h"
#include "base/inline.h"
#include "rwedge.h"

/* The two patches of one contact, both centred at 0. `stick` is used only if c > 0. */
typedef struct {
    double f, c;
    rw_potential contact, stick;
} tractions;

static tractions make_tractions(double alpha, double f, double c)
{
    tractions t = {.f = f, .c = c};
    rw_potential_init(&t.contact, alpha);
    if (c > 0)
        rw_potential_init_patch(&t.stick, alpha, c);
    return t;
}

RW_INLINE rw_field difference(rw_field a, rw_field b)
{
    return (rw_field){a.G_re - b.G_re, a.G_im - b.G_im, a.H_re - b.H_re, a.H_im - b.H_im};
}

/* normal: the field of the whole contact; stick: that of the stick zone's patch, or 0. */
RW_INLINE void combine(double f, rw_field normal, rw_field stick, double *sxx, double *syy,
                       double *txy)
{
    const rw_stress_state s = rw_superpose(normal, rw_field_multiple(f, difference(normal, stick)));
    *sxx = s.mean - s.difference;
    *syy = s.mean + s.difference;
    *txy = s.shear;
}

static void stresses_at(const tractions *t, int count, const double x[], const double y[],
                        double sxx[], double syy[], double txy[])
{
    rw_fields normal, stick = {{0}, {0}, {0}, {0}};
    rw_potential_fields(&t->contact, count, x, y, &normal);
    if (t->c > 0)
        rw_potential_fields(&t->stick, count, x, y, &stick);
    for (int i = 0; i < count; i++)
        combine(t->f, rw_field_in(&normal, i), rw_field_in(&stick, i), &sxx[i], &syy[i], &txy[i]);
}

static bool is_contact(double alpha, double f, double c)
{
    return rw_is_magnitude(alpha) && rw_is_friction(f) && rw_is_stick(c);
}

static bool is_point(double alpha, double x, double y)
{
    return rw_is_signed(x) && rw_is_magnitude(y) && !(alpha == 0 && x == 0 && y == 0);
}

int32_t rwedge_stress(double alpha, double f, double c, double x, double y, double *sxx,
                      double *syy, double *txy)
{
    if (!is_contact(alpha, f, c))
        return RWEDGE_EDOMAIN;
    if (!sxx || !syy || !txy)
        return RWEDGE_ENULL;
    if (!is_point(alpha, x, y))
        return RWEDGE_EDOMAIN;
    const tractions t = make_tractions(alpha, f, c);
    const rw_field normal = rw_potential_at(&t.contact, x, y), none = {0, 0, 0, 0};
    combine(f, normal, c > 0 ? rw_potential_at(&t.stick, x, y) : none, sxx, syy, txy);
    return RWEDGE_OK;
}

int32_t rwedge_stresses(double alpha, double f, double c, size_t n, const double x[],
                        const double y[], double sxx[], double syy[], double txy[])
{
    if (!is_contact(alpha, f, c))
        return RWEDGE_EDOMAIN;
    if (n > 0 && (!x || !y || !sxx || !syy || !txy))
        return RWEDGE_ENULL;
    for (size_t i = 0; i < n; i++)
        if (!is_point(alpha, x[i], y[i]))
            return RWEDGE_EDOMAIN;
    const tractions t = make_tractions(alpha, f, c);
    for (size_t i = 0; i < n; i += RW_BATCH)
        stresses_at(&t, n - i < RW_BATCH ? (int)(n - i) : RW_BATCH, x + i, y + i, sxx + i, syy + i,
                    txy + i);
    return RWEDGE_OK;
}

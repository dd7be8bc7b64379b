/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The interior stress field. With a normal traction of potential G_N and a shear traction of
 * potential G_T,
 *     s = (sxx+syy)/2 = Im G_N - Re G_T,   D = (syy-sxx)/2 + i txy = -y G_N' + i y G_T' + G_T,
 * This is Eq. (32), (33) for G_T = f G_N. In partial slip G_T = f (G_N - G_c). G_c belongs to the
 * same profile pressed to the half-width c of the stick zone. */
#include "stress/stress.h"

#include "potential/batch.h"
#include "base/domain.h"
#include "base/select.h"
#include "stress/derivatives.h"
#include "rwedge.h"

/* The two patches of one contact, both centred at 0. `stick` is used only if c > 0. */
typedef struct {
    double f, c;
    rw_potential contact, stick;
} tractions;

static tractions make_tractions(double alpha, double f, double c)
{
    tractions t = {.f = f, .c = c};
    rw_potential_init(&t.contact, alpha, 1);
    if (c > 0)
        rw_potential_init(&t.stick, alpha, c);
    return t;
}

RW_INLINE rw_field difference(rw_field a, rw_field b)
{
    return (rw_field){a.G_re - b.G_re, a.G_im - b.G_im, a.H_re - b.H_re, a.H_im - b.H_im};
}

/* normal: the field of the whole contact; stick: that of the stick zone's patch, or 0. */
RW_INLINE rw_stress_state state_of(double f, rw_field normal, rw_field stick)
{
    return rw_superpose(normal, rw_field_multiple(f, difference(normal, stick)));
}

static void stresses_at(const tractions *t, int count, const double x[], const double y[],
                        double sxx[], double syy[], double txy[])
{
    rw_fields normal, stick = {{0}, {0}, {0}, {0}};
    rw_potential_fields(&t->contact, count, x, y, &normal);
    if (t->c > 0)
        rw_potential_fields(&t->stick, count, x, y, &stick);
    for (int i = 0; i < count; i++)
        rw_give_stress(state_of(t->f, rw_field_in(&normal, i), rw_field_in(&stick, i)), &sxx[i],
                       &syy[i], &txy[i]);
}

static const rw_field NO_FIELD = {0, 0, 0, 0};

static rw_field stick_at(const tractions *t, double x, double y)
{
    return t->c > 0 ? rw_potential_at(&t->stick, x, y) : NO_FIELD;
}

/* ---- Derivatives: they add up as the stresses do ---- */

typedef rw_field (*change)(const rw_potential *potential, double x, double y);

static rw_stress_state changed(const tractions *t, change by, double x, double y, double factor)
{
    const rw_field normal = rw_field_multiple(factor, by(&t->contact, x, y));
    return state_of(t->f, normal,
                    t->c > 0 ? rw_field_multiple(factor, by(&t->stick, x, y)) : NO_FIELD);
}

/* An analytic function has d/dy = i d/dx; y G' has the term G' besides. */
static rw_field by_y(const rw_potential *potential, double x, double y)
{
    const rw_field d = rw_potential_by_x(potential, x, y);
    return (rw_field){-d.G_im, d.G_re, d.G_re - d.H_im, d.G_im + d.H_re};
}

static rw_stress_state by_friction(const tractions *t, double x, double y)
{
    const rw_field normal = rw_potential_at(&t->contact, x, y);
    return rw_superpose(NO_FIELD, difference(normal, stick_at(t, x, y)));
}

/* d/dc at c = 0 is that of a stick zone that begins to grow: its load grows like c^2 within the
 * rounding, but like c for the sharp wedge. */
static rw_stress_state by_stick_zone(const tractions *t, double x, double y)
{
    if (t->c == 0 && t->contact.alpha > 0)
        return rw_superpose(NO_FIELD, NO_FIELD);
    const double least = t->c > 0 ? t->c : RW_SMALLEST;
    rw_potential stick;
    rw_potential_init(&stick, t->contact.a, least);
    return rw_superpose(NO_FIELD,
                        rw_field_multiple(-t->f / least, rw_potential_by_half_width(&stick, x, y)));
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
    const rw_field normal = rw_potential_at(&t.contact, x, y);
    rw_give_stress(state_of(f, normal, stick_at(&t, x, y)), sxx, syy, txy);
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

/* At an edge, and where the rounding ends, derivatives are infinite. */
static bool is_smooth_at(double alpha, double c, double x, double y)
{
    const double place = fabs(x);
    return y > 0 || (place != 1 && place != alpha && (c == 0 || place != c));
}

int32_t rwedge_stress_gradient(double alpha, double f, double c, double x, double y, double *sxx_x,
                               double *syy_x, double *txy_x, double *sxx_y, double *syy_y,
                               double *txy_y)
{
    if (!sxx_x || !syy_x || !txy_x || !sxx_y || !syy_y || !txy_y)
        return RWEDGE_ENULL;
    if (!is_contact(alpha, f, c) || !is_point(alpha, x, y) || !is_smooth_at(alpha, c, x, y))
        return RWEDGE_EDOMAIN;
    const tractions t = make_tractions(alpha, f, c);
    rw_give_stress(changed(&t, rw_potential_by_x, x, y, 1), sxx_x, syy_x, txy_x);
    rw_give_stress(changed(&t, by_y, x, y, 1), sxx_y, syy_y, txy_y);
    return RWEDGE_OK;
}

int32_t rwedge_stress_sensitivity(double alpha, double f, double c, double x, double y,
                                  double d_alpha[3], double d_f[3], double d_c[3])
{
    if (!d_alpha || !d_f || !d_c)
        return RWEDGE_ENULL;
    if (!is_contact(alpha, f, c) || !is_point(alpha, x, y) || !is_smooth_at(alpha, c, x, y))
        return RWEDGE_EDOMAIN;
    const tractions t = make_tractions(alpha, f, c);
    const double per_alpha = alpha > 0 ? 1 / alpha : 0;
    rw_give_stress(changed(&t, rw_potential_by_rounding, x, y, per_alpha), &d_alpha[0], &d_alpha[1],
                   &d_alpha[2]);
    rw_give_stress(by_friction(&t, x, y), &d_f[0], &d_f[1], &d_f[2]);
    rw_give_stress(by_stick_zone(&t, x, y), &d_c[0], &d_c[1], &d_c[2]);
    return RWEDGE_OK;
}

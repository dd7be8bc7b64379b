/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "references/field.h"

#include <math.h>

void traction_init(traction *t, const arb_t a, const arb_t f, double nu, slong prec)
{
    t->patches = 0;
    t->shear_alone = false;
    arb_init(t->a), arb_init(t->f), arb_init(t->kappa);
    arb_set(t->a, a);
    arb_set(t->f, f);
    arb_set_d(t->kappa, nu);
    arb_mul_2exp_si(t->kappa, t->kappa, 1);
    arb_sub_ui(t->kappa, t->kappa, 1, prec);
    arb_mul(t->kappa, t->kappa, t->kappa, prec);
    arb_div_ui(t->kappa, t->kappa, 3, prec);
}

void traction_add(traction *t, const arb_t half_width, const arb_t weight, slong prec)
{
    ball_patch_init(&t->patch[t->patches], t->a, half_width, prec);
    arb_init(&t->weight[t->patches]);
    arb_set(&t->weight[t->patches], weight);
    t->patches++;
}

void traction_clear(traction *t)
{
    for (; t->patches > 0; t->patches--) {
        ball_patch_clear(&t->patch[t->patches - 1]);
        arb_clear(&t->weight[t->patches - 1]);
    }
    arb_clear(t->a), arb_clear(t->f), arb_clear(t->kappa);
}

/* ---- Stresses: s = Im N - Re T, D = -y N' + i y T' + T, sxx, syy = s -+ Re D, txy = Im D ---- */

void ball_stresses(arb_t sxx, arb_t syy, arb_t txy, const traction *t, const acb_t z, slong prec)
{
    acb_ptr v = _acb_vec_init(5);
    acb_ptr G = v, H = v + 1, T = v + 2, H_T = v + 3, D = v + 4;
    for (int i = 0; i < t->patches; i++) {
        if (arb_is_zero(&t->weight[i]) && i + 1 < t->patches)
            continue;
        ball_potential(G, &t->patch[i], z, prec);
        ball_potential_slope_by_depth(H, &t->patch[i], z, prec);
        acb_addmul_arb(T, G, &t->weight[i], prec);
        acb_addmul_arb(H_T, H, &t->weight[i], prec);
    }
    if (t->shear_alone) {
        acb_zero(G);
        acb_zero(H);
    }
    acb_mul_arb(T, T, t->f, prec);
    acb_mul_arb(H_T, H_T, t->f, prec);
    acb_mul_onei(H_T, H_T);
    acb_add(D, T, H_T, prec);
    acb_sub(D, D, H, prec);
    arb_sub(sxx, acb_imagref(G), acb_realref(T), prec);
    arb_add(syy, sxx, acb_realref(D), prec);
    arb_sub(sxx, sxx, acb_realref(D), prec);
    arb_set(txy, acb_imagref(D));
    _acb_vec_clear(v, 5);
}

/* ---- J2 = |D|^2 + kappa s^2 ---- */

enum { ORDERS = 4 };

/* G'' and G''' of one patch, which are algebraic; over the half-width, X = sqrt(z^2-1), q = z^2
 * - alpha^2:
 *     G''  =  (2/pi) [c0/(X q) + (phi0/alpha)/X^3],
 *     G''' = -(2/pi) z [c0/(X^3 q) + 2 c0/(X q^2) + 3 (phi0/alpha)/X^5]. */
static void add_bends(acb_ptr sum, const ball_patch *patch, const acb_t point, const arb_t weight,
                      slong prec)
{
    acb_ptr v = _acb_vec_init(6);
    acb_ptr z = v, per_X = v + 1, per_X2 = v + 2, corner = v + 3, edge = v + 4, u = v + 5;
    arb_t factor;
    arb_init(factor);
    acb_div_arb(z, point, patch->half_width, prec);
    acb_sub_ui(u, z, 1, prec);
    ball_root(per_X, u, prec);
    acb_add_ui(u, z, 1, prec);
    ball_root(u, u, prec);
    acb_mul(per_X, per_X, u, prec);
    acb_inv(per_X, per_X, prec);
    acb_mul(per_X2, per_X, per_X, prec);
    acb_sub_arb(corner, z, patch->alpha, prec);
    acb_add_arb(u, z, patch->alpha, prec);
    acb_mul(corner, corner, u, prec);
    acb_inv(corner, corner, prec); /* 1/q */
    if (arb_is_zero(patch->alpha))
        arb_one(factor);
    else
        arb_div(factor, patch->phi0, patch->alpha, prec);
    acb_mul_arb(edge, per_X2, factor, prec);
    acb_mul_2exp_si(u, corner, 1); /* 1/X^2 + 2/q */
    acb_add(u, u, per_X2, prec);
    acb_mul_arb(corner, corner, patch->c0, prec);
    acb_mul(u, u, corner, prec);
    acb_add(corner, corner, edge, prec);
    acb_mul(edge, edge, per_X2, prec);
    acb_addmul_ui(u, edge, 3, prec);
    acb_mul(u, u, z, prec);
    arb_const_pi(factor, prec);
    arb_div(factor, weight, factor, prec);
    arb_mul_2exp_si(factor, factor, 1);
    acb_mul_arb(per_X, per_X, factor, prec);
    arb_mul(factor, patch->half_width, patch->half_width, prec);
    acb_div_arb(per_X, per_X, factor, prec);
    acb_addmul(sum, corner, per_X, prec);
    acb_div_arb(per_X, per_X, patch->half_width, prec);
    acb_submul(sum + 1, u, per_X, prec);
    arb_clear(factor);
    _acb_vec_clear(v, 6);
}

/* N, N', N'', N''' and the same of T, as far as the order needs them. */
static void ball_jets(acb_ptr N, acb_ptr T, int order, const traction *t, const acb_t z, slong prec)
{
    arb_t one;
    acb_t v;
    arb_init(one), acb_init(v);
    arb_one(one);
    for (int i = 0; i < t->patches; i++) {
        const bool whole = i + 1 == t->patches;
        if (arb_is_zero(&t->weight[i]) && !whole)
            continue;
        ball_potential(v, &t->patch[i], z, prec);
        acb_addmul_arb(T, v, &t->weight[i], prec);
        if (whole)
            acb_set(N, v);
        ball_potential_slope(v, &t->patch[i], z, prec);
        acb_addmul_arb(T + 1, v, &t->weight[i], prec);
        if (whole)
            acb_set(N + 1, v);
        if (order > 0)
            add_bends(T + 2, &t->patch[i], z, &t->weight[i], prec);
        if (order > 0 && whole)
            add_bends(N + 2, &t->patch[i], z, one, prec);
    }
    for (int k = 0; k < ORDERS; k++)
        acb_mul_arb(T + k, T + k, t->f, prec);
    arb_clear(one), acb_clear(v);
}

/* result = re a re b + im a im b. */
static void add_dot(arb_t sum, const acb_t a, const acb_t b, slong prec)
{
    arb_addmul(sum, acb_realref(a), acb_realref(b), prec);
    arb_addmul(sum, acb_imagref(a), acb_imagref(b), prec);
}

/* -y N^(k) + i y T^(k). */
static void by_depth(acb_t D, const acb_ptr N, const acb_ptr T, int k, const arb_t y, slong prec)
{
    acb_mul_onei(D, T + k);
    acb_sub(D, D, N + k, prec);
    acb_mul_arb(D, D, y, prec);
}

/* d = i d/dx of what is analytic in z, and the explicit y; all products of derivatives of D and
 * of s. */
void ball_J2(arb_ptr J2, int order, const traction *t, const acb_t z, slong prec)
{
    acb_ptr v = _acb_vec_init(2 * ORDERS + 8);
    acb_ptr N = v, T = v + ORDERS, D = v + 2 * ORDERS, Dx = D + 1, Dy = D + 2, Dxx = D + 3,
            Dxy = D + 4, Dyy = D + 5, u = D + 6;
    arb_ptr w = _arb_vec_init(6);
    arb_ptr s = w, sx = w + 1, sy = w + 2, sxx = w + 3, sxy = w + 4, r = w + 5;
    const arb_srcptr y = acb_imagref(z), kappa = t->kappa;
    ball_jets(N, T, order, t, z, prec);

    by_depth(D, N, T, 1, y, prec);
    acb_add(D, D, T, prec);
    arb_sub(s, acb_imagref(N), acb_realref(T), prec);
    arb_zero(J2 + J2_0);
    add_dot(J2 + J2_0, D, D, prec);
    arb_mul(r, s, s, prec);
    arb_addmul(J2 + J2_0, kappa, r, prec);
    if (order > 0) {
        by_depth(Dx, N, T, 2, y, prec);
        acb_mul_onei(Dy, Dx);
        acb_add(Dx, Dx, T + 1, prec); /* T' */
        acb_mul_onei(u, T + 1);
        acb_mul_2exp_si(u, u, 1);
        acb_add(Dy, Dy, u, prec); /* 2 i T' - N' */
        acb_sub(Dy, Dy, N + 1, prec);
        arb_sub(sx, acb_imagref(N + 1), acb_realref(T + 1), prec);
        arb_add(sy, acb_realref(N + 1), acb_imagref(T + 1), prec);
        arb_zero(J2 + J2_X);
        add_dot(J2 + J2_X, D, Dx, prec);
        arb_mul(r, s, sx, prec);
        arb_addmul(J2 + J2_X, kappa, r, prec);
        arb_zero(J2 + J2_Y);
        add_dot(J2 + J2_Y, D, Dy, prec);
        arb_mul(r, s, sy, prec);
        arb_addmul(J2 + J2_Y, kappa, r, prec);
        arb_mul_2exp_si(J2 + J2_X, J2 + J2_X, 1);
        arb_mul_2exp_si(J2 + J2_Y, J2 + J2_Y, 1);
    }
    if (order > 1) {
        by_depth(Dxx, N, T, 3, y, prec);
        acb_mul_onei(Dxy, Dxx); /* i y (-N''' + i T''') */
        acb_neg(Dyy, Dxx);
        acb_add(Dxx, Dxx, T + 2, prec);
        acb_mul_onei(u, T + 2);
        acb_mul_2exp_si(u, u, 1);
        acb_sub(u, u, N + 2, prec); /* 2 i T'' - N'' */
        acb_add(Dxy, Dxy, u, prec);
        acb_mul_onei(u, N + 2);
        acb_mul_2exp_si(u, u, 1);
        acb_sub(Dyy, Dyy, u, prec); /* -2 i N'' - 3 T'' */
        acb_submul_ui(Dyy, T + 2, 3, prec);
        arb_sub(sxx, acb_imagref(N + 2), acb_realref(T + 2), prec);
        arb_add(sxy, acb_realref(N + 2), acb_imagref(T + 2), prec);
        for (int k = J2_XX; k <= J2_YY; k++)
            arb_zero(J2 + k);
        add_dot(J2 + J2_XX, Dx, Dx, prec);
        add_dot(J2 + J2_XX, D, Dxx, prec);
        arb_mul(r, sx, sx, prec);
        arb_addmul(r, s, sxx, prec);
        arb_addmul(J2 + J2_XX, kappa, r, prec);
        add_dot(J2 + J2_XY, Dx, Dy, prec);
        add_dot(J2 + J2_XY, D, Dxy, prec);
        arb_mul(r, sx, sy, prec);
        arb_addmul(r, s, sxy, prec);
        arb_addmul(J2 + J2_XY, kappa, r, prec);
        add_dot(J2 + J2_YY, Dy, Dy, prec);
        add_dot(J2 + J2_YY, D, Dyy, prec);
        arb_mul(r, sy, sy, prec);
        arb_submul(r, s, sxx, prec);
        arb_addmul(J2 + J2_YY, kappa, r, prec);
        for (int k = J2_XX; k <= J2_YY; k++)
            arb_mul_2exp_si(J2 + k, J2 + k, 1);
    }
    _acb_vec_clear(v, 2 * ORDERS + 8);
    _arb_vec_clear(w, 6);
}

/* ---- Its stationary points ---- */

static double middle(const arb_t ball)
{
    return arf_get_d(arb_midref(ball), ARF_RND_NEAR);
}

/* The inverse of the Hessian at the middle, times -1, in lengths of the depth; any numbers near
 * it serve. */
static bool invert(double inverse[3], arb_srcptr J2, double depth, double *flatness)
{
    const double J = middle(J2 + J2_0), scale = depth * depth / J;
    const double xx = middle(J2 + J2_XX) * scale, xy = middle(J2 + J2_XY) * scale,
                 yy = middle(J2 + J2_YY) * scale;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant != 0 && isfinite(determinant)))
        return false;
    if (flatness)
        /* the smaller curvature, but for a factor of 2 */
        *flatness = fabs(determinant) / hypot(hypot(xx, yy), xy);
    inverse[0] = yy / determinant * scale;
    inverse[1] = -xy / determinant * scale;
    inverse[2] = xx / determinant * scale;
    return true;
}

/* Krawczyk's operator about the middle of the box, step = K - middle: it contains middle - step
 * of every stationary point of the box; and where K lies inside the box, there is one. */
static bool krawczyk(arb_ptr step, arb_ptr at_middle, arb_ptr over_box, double *flatness,
                     const traction *t, const acb_t box, slong prec)
{
    arb_ptr w = _arb_vec_init(8);
    arb_ptr inv = w, r = w + 3, u = w + 7;
    acb_t centre;
    acb_init(centre);
    acb_get_mid(centre, box);
    ball_J2(at_middle, 1, t, centre, prec);
    ball_J2(over_box, 2, t, box, prec);
    double inverse[3];
    const bool regular = invert(inverse, over_box, middle(acb_imagref(centre)), flatness);
    if (regular) {
        for (int i = 0; i < 3; i++)
            arb_set_d(inv + i, inverse[i]);
        static const int HESSIAN[2][2] = {{J2_XX, J2_XY}, {J2_XY, J2_YY}};
        static const int INVERSE[2][2] = {{0, 1}, {1, 2}};
        for (int i = 0; i < 2; i++) { /* -Y g + (1 - Y H)(box - middle) */
            arb_zero(step + i);
            arb_submul(step + i, inv + INVERSE[i][0], at_middle + J2_X, prec);
            arb_submul(step + i, inv + INVERSE[i][1], at_middle + J2_Y, prec);
            for (int j = 0; j < 2; j++) {
                arb_set_si(r, i == j);
                arb_submul(r, inv + INVERSE[i][0], over_box + HESSIAN[0][j], prec);
                arb_submul(r, inv + INVERSE[i][1], over_box + HESSIAN[1][j], prec);
                arb_zero(u);
                mag_set(arb_radref(u), arb_radref(j == 0 ? acb_realref(box) : acb_imagref(box)));
                arb_addmul(step + i, r, u, prec);
            }
        }
    }
    acb_clear(centre);
    _arb_vec_clear(w, 8);
    return regular && arb_is_finite(step) && arb_is_finite(step + 1);
}

static bool is_inside(const acb_t box, arb_srcptr step)
{
    mag_t reach;
    mag_init(reach);
    arb_get_mag(reach, step);
    bool inside = mag_cmp(reach, arb_radref(acb_realref(box))) < 0;
    arb_get_mag(reach, step + 1);
    inside = inside && mag_cmp(reach, arb_radref(acb_imagref(box))) < 0;
    mag_clear(reach);
    return inside;
}

static void move(acb_t box, arb_srcptr step, slong prec)
{
    acb_get_mid(box, box);
    arb_add(acb_realref(box), acb_realref(box), step, prec);
    arb_add(acb_imagref(box), acb_imagref(box), step + 1, prec);
}

/* Newton's method without proof. */
static void improve(acb_t z, arb_ptr w, const traction *t, slong prec)
{
    acb_get_mid(z, z);
    for (int i = 0; i < 12; i++) {
        const double depth = middle(acb_imagref(z));
        acb_t next;
        acb_init(next);
        acb_set(next, z);
        const bool stepped = krawczyk(w, w + 2, w + 2 + J2_COUNT, NULL, t, z, prec);
        const double length = hypot(middle(w), middle(w + 1));
        const bool usable = stepped && length < 0.5 * depth;
        if (usable) {
            move(next, w, prec);
            acb_get_mid(z, next);
        }
        acb_clear(next);
        if (!usable || length < ldexp(depth, -(int)prec / 2))
            return;
    }
}

bool ball_stationary(arb_t x, arb_t y, arb_t J2, double *flatness, const traction *t, const acb_t z,
                     slong prec)
{
    arb_ptr w = _arb_vec_init(3 + 2 * J2_COUNT);
    arb_ptr step = w, at_middle = w + 2, over_box = w + 2 + J2_COUNT, d = w + 2 + 2 * J2_COUNT;
    acb_t box;
    acb_init(box);
    acb_set(box, z);
    improve(box, w, t, prec);
    const double depth = middle(acb_imagref(box));
    bool proved = false;
    for (slong bits = prec / 2; bits > 0 && !proved; bits -= prec / 12) {
        acb_get_mid(box, box);
        mag_set_d(arb_radref(acb_realref(box)), ldexp(depth, -(int)bits));
        mag_set(arb_radref(acb_imagref(box)), arb_radref(acb_realref(box)));
        proved =
            krawczyk(step, at_middle, over_box, flatness, t, box, prec) && is_inside(box, step);
    }
    /* Taylor about the middle m: J2(m + d) in J2(m) + g d + d H d/2, d in the step */
    mag_t reach;
    mag_init(reach);
    arb_get_mag(arb_radref(d), step);
    arb_get_mag(reach, step + 1);
    mag_max(arb_radref(d), arb_radref(d), reach);
    arb_set(J2, at_middle + J2_0);
    arb_addmul(J2, at_middle + J2_X, d, prec);
    arb_addmul(J2, at_middle + J2_Y, d, prec);
    arb_mul(d, d, d, prec);
    for (int k = J2_XX; k <= J2_YY; k++)
        arb_addmul(J2, over_box + k, d, prec);
    mag_clear(reach);
    move(box, step, prec);
    arb_set(x, acb_realref(box));
    arb_set(y, acb_imagref(box));
    acb_clear(box);
    _arb_vec_clear(w, 3 + 2 * J2_COUNT);
    return proved;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerical/fronts.h"

#include "base/domain.h"
#include "base/linear.h"

#include <stdlib.h>
#include <string.h>

/* Gauss's panels at a front, each so much nearer to it than the one before: for the residual, for
 * the traction next to the front. */
enum { COARSE = 3, FINE = 7, MOST_PANELS = 12 };

static const double RATIO = 0.12;

/* Of the half-width: distances from a front are not less. */
static const double AT_FRONT = 1e-15;

/* Chebyshev points on a gap, and terms of X there. */
enum { GAP_POINTS = 40, GAP_TERMS = 48 };

bool rw_fronts_create(rw_fronts *f, int order)
{
    *f = (rw_fronts){.order = order, .capacity = 4096};
    rw_gauss(order, f->node, f->weight);
    f->x = malloc(4 * f->capacity * sizeof *f->x);
    f->step = f->x + f->capacity;
    f->change = f->step + f->capacity;
    f->X = f->change + f->capacity;
    return f->x != NULL;
}

void rw_fronts_destroy(rw_fronts *f)
{
    free(f->x);
    *f = (rw_fronts){0};
}

bool rw_fronts_begin(rw_fronts *f, const rw_problem *p, const rw_zones *zones)
{
    f->problem = p;
    f->zones = zones->count;
    f->fronts = zones->count - 1;
    f->sticks = 0;
    f->segments = 0;
    f->count = 0;
    for (int i = 0; i < zones->count; i++) {
        f->label[i] = zones->zone[i].label;
        f->sticks += f->label[i] == 0;
        if (i > 0 && (f->label[i] == 0) == (f->label[i - 1] == 0))
            return false;
    }
    f->sticks_to_edge[0] = f->label[0] == 0;
    f->sticks_to_edge[1] = f->label[f->zones - 1] == 0;
    f->unknowns = f->fronts + f->sticks_to_edge[0] + f->sticks_to_edge[1];
    if (f->sticks == 0 || f->sticks > RW_MOST_STICK || f->unknowns != 2 * f->sticks)
        return false;
    for (int i = 0; i < 2; i++)
        if (f->sticks_to_edge[i] && !p->grows[i])
            return false;
    for (int i = 0; i < f->fronts; i++)
        f->y[i] = rw_angle_of(p, zones->zone[i].right);
    for (int i = f->fronts; i < f->unknowns; i++)
        f->y[i] = 0;
    return true;
}

rw_layers rw_fronts_zones(const rw_fronts *f, rw_zones *zones)
{
    zones->count = f->zones;
    for (int i = 0; i < f->zones; i++)
        zones->zone[i] =
            (rw_zone){f->label[i], i == 0 ? f->problem->to.left : zones->zone[i - 1].right,
                      i == f->fronts ? f->problem->to.right : rw_place_of(f->problem, f->y[i])};
    const int layers = f->unknowns - f->fronts;
    return (rw_layers){layers > 0 ? f->y[f->fronts] : 0, layers > 1 ? f->y[f->fronts + 1] : 0};
}

/* ---- Quadrature over what slips ---- */

typedef struct {
    int count; /* of zones that stick */
    double end[RW_MOST_FRONTS];
    double middle, half; /* of the contact */
} stuck;

static stuck stuck_of(const rw_fronts *f, const rw_zones *zones)
{
    stuck s = {.middle = f->problem->middle, .half = f->problem->half};
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label == 0) {
            s.end[2 * s.count] = zones->zone[i].left;
            s.end[2 * s.count + 1] = zones->zone[i].right;
            s.count++;
        }
    return s;
}

/* X outside of what sticks, and its size inside, over half^count. */
static double X_at(const stuck *s, double x)
{
    double product = 1;
    for (int i = 0; i < s->count; i++) {
        const double least = AT_FRONT * s->half;
        const double size =
            sqrt(fmax(fabs(x - s->end[2 * i]), least) * fmax(fabs(x - s->end[2 * i + 1]), least)) /
            s->half;
        product *= x < s->end[2 * i] ? -size : size;
    }
    return product;
}

static double nearest_end(const stuck *s, double x)
{
    double nearest = HUGE_VAL;
    for (int i = 0; i < 2 * s->count; i++)
        nearest = fmin(nearest, fabs(x - s->end[i]));
    return nearest;
}

static bool put(rw_fronts *f, double x, double step, double change)
{
    if (f->count == f->capacity) {
        const size_t n = f->capacity;
        double *all = malloc(8 * n * sizeof *all);
        if (!all)
            return false;
        for (int i = 0; i < 4; i++)
            memcpy(all + 2 * n * (size_t)i, f->x + n * (size_t)i, n * sizeof *all);
        free(f->x);
        f->x = all;
        f->step = all + 2 * n;
        f->change = all + 4 * n;
        f->X = all + 6 * n;
        f->capacity = 2 * n;
    }
    f->x[f->count] = x;
    f->step[f->count] = step;
    f->change[f->count++] = change;
    return true;
}

static double change_at(const rw_fronts *f, rw_layers layers, int label, double x)
{
    const double base = rw_base_traction(f->problem, layers, x);
    return label == 0 ? -base : label * rw_friction_after(f->problem, x) - base;
}

/* A panel at the distances from `near` to `far` of both ends, like square roots at its own. */
static bool put_panel(rw_fronts *f, const rw_segment *s, rw_layers layers, double near, double far)
{
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < f->order; i++) {
            const double angle = RW_PI * f->node[i], half = sin(angle / 2);
            const double distance = near + (far - near) * half * half;
            const double step = (far - near) / 2 * RW_PI * sin(angle) * f->weight[i];
            const double x = side == 0 ? s->from + distance : s->to - distance;
            if (!put(f, x, step, change_at(f, layers, s->label, x)))
                return false;
        }
    return true;
}

static bool put_segment(rw_fronts *f, rw_segment *s, rw_layers layers)
{
    s->first = f->count;
    const double half = (s->to - s->from) / 2;
    double near = 0, far = half * pow(RATIO, s->panels);
    for (int i = 0; i <= s->panels; i++) {
        if (!put_panel(f, s, layers, near, far))
            return false;
        near = far;
        far = i + 1 == s->panels ? half : far / RATIO;
    }
    s->count = f->count - s->first;
    return true;
}

/* A segment as it was computed last is left as it is. */
static bool add_segment(rw_fronts *f, const stuck *sticks, rw_layers layers, double from, double to,
                        int label, int finest)
{
    const double near = fmin(nearest_end(sticks, from), nearest_end(sticks, to)),
                 length = to - from;
    int panels = 1;
    if (near == 0)
        panels = finest;
    else if (near < length)
        panels = (int)fmin(MOST_PANELS, fmax(2, 1 + ceil(log(near / length) / log(RATIO))));
    if (f->segments == RW_MOST_SEGMENTS)
        return false;
    rw_segment *s = &f->segment[f->segments++];
    if (s->first == f->count && s->from == from && s->to == to && s->label == label &&
        s->panels == panels && s->count > 0) {
        f->count += s->count;
        return true;
    }
    const size_t first = s->first, count = s->count;
    *s = (rw_segment){from, to, label, panels, 0, 0};
    if (!put_segment(f, s, layers))
        return false;
    if (s->first != first || s->count != count) /* it has taken the place of those that follow */
        for (int i = f->segments; i < RW_MOST_SEGMENTS; i++)
            f->segment[i].count = 0;
    return true;
}

/* Whether the zone has slipped as far as it can before, so that nothing changes. */
static bool is_spent(const rw_problem *p, int label, double from, double to)
{
    const rw_zones *old = &p->old->zones;
    for (int i = 0; p->is_still && i < old->count; i++)
        if (old->zone[i].label == label && label != 0 && from >= old->zone[i].left &&
            to <= old->zone[i].right)
            return true;
    return false;
}

static int by_size(const void *a, const void *b)
{
    const double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/* All places where the change is not smooth, between two others. */
static int breaks_of(const rw_problem *p, double from, double to, double at[])
{
    const double other[] = {-p->a, p->a, p->to.left, p->to.right, p->from.left, p->from.right};
    int n = 0;
    at[n++] = from;
    for (int i = 0; i < 6; i++)
        if (other[i] > from && other[i] < to)
            at[n++] = other[i];
    for (int i = 0; i < p->old->kinks; i++)
        if (p->old->kink[i] > from && p->old->kink[i] < to)
            at[n++] = p->old->kink[i];
    at[n++] = to;
    qsort(at, (size_t)n, sizeof *at, by_size);
    return n;
}

static bool add_zone(rw_fronts *f, const stuck *sticks, rw_layers layers, rw_zone zone, int finest)
{
    double at[RW_MOST_KINKS + 8];
    const int n = breaks_of(f->problem, zone.left, zone.right, at);
    for (int i = 0; i + 1 < n; i++)
        if (at[i + 1] > at[i] && !is_spent(f->problem, zone.label, at[i], at[i + 1]) &&
            !add_segment(f, sticks, layers, at[i], at[i + 1], zone.label, finest))
            return false;
    return true;
}

static bool collect(rw_fronts *f, const rw_zones *zones, rw_layers layers, int finest)
{
    const rw_problem *p = f->problem;
    const stuck sticks = stuck_of(f, zones);
    if (layers.first != f->layers.first || layers.second != f->layers.second)
        for (int i = 0; i < RW_MOST_SEGMENTS; i++)
            f->segment[i].count = 0;
    f->layers = layers;
    f->segments = 0;
    f->count = 0;
    if (p->both.left < p->to.left &&
        !add_zone(f, &sticks, layers, (rw_zone){0, p->both.left, p->to.left}, finest))
        return false;
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label != 0 && !add_zone(f, &sticks, layers, zones->zone[i], finest))
            return false;
    if (p->both.right > p->to.right &&
        !add_zone(f, &sticks, layers, (rw_zone){0, p->to.right, p->both.right}, finest))
        return false;
    for (size_t i = 0; i < f->count; i++)
        f->X[i] = X_at(&sticks, f->x[i]);
    return true;
}

/* ---- The polynomial ---- */

/* int over a slip zone between two that stick of X (1/pi) int [dt/X]/(s - x) ds dx: the inner
 * integral over x is a Chebyshev series of X/sqrt((x - a)(b - x)). */
static double gap_of_change(const rw_fronts *f, const stuck *sticks, double a, double b)
{
    const double half = (b - a) / 2, middle = (a + b) / 2;
    enum { TURN = 2 * (GAP_TERMS + 1) };
    double sampled[GAP_TERMS], c[GAP_TERMS], sine[TURN];
    for (int i = 0; i < TURN; i++)
        sine[i] = sin(2 * RW_PI * i / TURN);
    for (int i = 0; i < GAP_TERMS; i++)
        sampled[i] = X_at(sticks, middle + half * cos(2 * RW_PI * (i + 1) / TURN)) / half;
    for (int k = 0; k < GAP_TERMS; k++) {
        c[k] = 0;
        for (int i = 0; i < GAP_TERMS; i++)
            c[k] += 4.0 / TURN * sampled[i] * sine[(k + 1) * (i + 1) % TURN];
    }
    double sum = 0;
    for (size_t i = 0; i < f->count; i++) {
        const double eta = (f->x[i] - middle) / half;
        double kernel = 0;
        if (fabs(eta) <= 1) {
            double b1 = 0, b2 = 0; /* Clenshaw, of T_1 ... */
            for (int k = GAP_TERMS - 1; k >= 0; k--) {
                const double b0 = c[k] + 2 * eta * b1 - b2;
                b2 = b1;
                b1 = b0;
            }
            kernel = eta * b1 - b2;
        } else {
            const double R = 1 / (eta + copysign(sqrt(eta * eta - 1), eta));
            for (int k = GAP_TERMS - 1; k >= 0; k--)
                kernel = (kernel + c[k]) * R;
        }
        sum += f->step[i] * f->change[i] / f->X[i] * kernel;
    }
    return half * sum;
}

/* The first n coefficients of product (1 - c/z)^(power), power +-1/2. */
static void expand_at_infinity(int n, int count, const double c[], double power, double series[])
{
    for (int i = 0; i < n; i++)
        series[i] = i == 0;
    for (int j = 0; j < count; j++) {
        double factor[RW_MOST_FRONTS + 1] = {1}, product[RW_MOST_FRONTS + 1];
        for (int k = 1; k < n; k++)
            factor[k] = factor[k - 1] * c[j] * (k - 1 - power) / k;
        for (int i = 0; i < n; i++) {
            product[i] = 0;
            for (int k = 0; k <= i; k++)
                product[i] += series[i - k] * factor[k];
        }
        memcpy(series, product, (size_t)n * sizeof *series);
    }
}

/* Rows of A p = B. */
static void conditions(const rw_fronts *f, const stuck *s, rw_layers layers, const double front[],
                       double A[], double B[])
{
    const rw_problem *p = f->problem;
    const int m = s->count, n = 2 * m;
    const double shear = p->shear - p->f * (layers.first * p->load + layers.second * p->layer_load);
    const double stretch =
        p->stretch + p->f * (layers.first * p->tilt + layers.second * p->layer_tilt);
    double moment[RW_MOST_STICK + 1] = {0}, grown[RW_MOST_FRONTS + 1], shrunk[RW_MOST_FRONTS + 1];
    for (size_t i = 0; i < f->count; i++) {
        const double at = (f->x[i] - s->middle) / s->half;
        double power = f->step[i] * f->change[i] / f->X[i] / s->half;
        for (int j = 0; j <= m; j++, power *= at)
            moment[j] += power;
    }
    expand_at_infinity(n + 1, n, front, 0.5, grown);
    expand_at_infinity(n + 1, n, front, -0.5, shrunk);
    memset(A, 0, (size_t)(n * n) * sizeof *A);
    for (int row = 0; row <= m; row++) { /* of the power m - 1 - row at infinity */
        const int power = m - 1 - row;
        for (int i = m + power; i < n; i++)
            A[row * n + i] = i - m - power <= n && i >= 0 ? shrunk[i - m - power] : 0;
        B[row] = (power == 0 ? stretch : 0) - (power == -1 ? shear / (RW_PI * s->half) : 0);
        for (int j = 0; j <= row; j++)
            B[row] += grown[row - j] * moment[j] / RW_PI;
    }
    for (int k = 0; k + 1 < m; k++) {
        const double a = s->end[2 * k + 1], b = s->end[2 * k + 2], half = (b - a) / 2;
        double *row = A + (m + 1 + k) * n;
        for (int i = 0; i < GAP_POINTS; i++) {
            const double x = (a + b) / 2 + half * cos(RW_PI * (i + 0.5) / GAP_POINTS);
            const double at = (x - s->middle) / s->half;
            double share = sqrt((x - a) * (b - x)) / X_at(s, x) * RW_PI / GAP_POINTS / half;
            for (int j = 0; j < n; j++, share *= at)
                row[j] += share;
        }
        B[m + 1 + k] = -gap_of_change(f, s, a, b) / half;
    }
}

/* The coefficients of 1/sqrt of dt, over sqrt(half), at the fronts and then at edges that stick. */
static bool residual(rw_fronts *f, double r[])
{
    rw_zones zones;
    const rw_layers layers = rw_fronts_zones(f, &zones);
    if (f->budget-- <= 0 || !collect(f, &zones, layers, COARSE))
        return false;
    const stuck s = stuck_of(f, &zones);
    const int n = 2 * s.count;
    double A[RW_MOST_FRONTS * RW_MOST_FRONTS], B[RW_MOST_FRONTS], front[RW_MOST_FRONTS];
    for (int i = 0; i < n; i++)
        front[i] = (s.end[i] - s.middle) / s.half;
    conditions(f, &s, layers, front, A, B);
    if (!rw_solve((size_t)n, A, B))
        return false;
    double K[RW_MOST_FRONTS];
    for (int j = 0; j < n; j++) {
        double value = 0, apart = 1;
        for (int i = n - 1; i >= 0; i--)
            value = value * front[j] + B[i];
        for (int i = 0; i < n; i++)
            apart *= i == j ? 1 : fabs(front[i] - front[j]);
        /* X has the sign (-1)^(m-1-k) on the k-th zone, times i */
        K[j] = ((s.count - 1 - j / 2) % 2 == 0 ? -1 : 1) * value / sqrt(apart);
        if (!isfinite(K[j]))
            return false;
    }
    int count = 0;
    for (int j = 0; j < n; j++)
        if (!(j == 0 && f->sticks_to_edge[0]) && !(j == n - 1 && f->sticks_to_edge[1]))
            r[count++] = K[j];
    if (f->sticks_to_edge[0])
        r[count++] = K[0];
    if (f->sticks_to_edge[1])
        r[count++] = K[n - 1];
    return true;
}

/* ---- Rates ---- */

/* w' = p/X where it slips. */
static double slope_at(const stuck *s, const double polynomial[], double x)
{
    const double at = (x - s->middle) / s->half;
    double value = 0;
    for (int i = 2 * s->count - 1; i >= 0; i--)
        value = value * at + polynomial[i];
    return value / X_at(s, x);
}

/* The largest slip with the sign of the traction, from the front on. */
static double wrong_slip(const stuck *s, const double polynomial[], rw_zone zone, bool is_leftmost)
{
    enum { POINTS = 24 };
    const double front = is_leftmost ? zone.right : zone.left;
    const double length = is_leftmost ? zone.left - zone.right : zone.right - zone.left;
    double slip = 0, most = 0;
    for (int i = 0; i < POINTS; i++) {
        const double angle = RW_PI * (i + 0.5) / POINTS, half = sin(angle / 2);
        slip += slope_at(s, polynomial, front + length * half * half) * length * sin(angle) *
                (RW_HALF_PI / POINTS);
        most = fmax(most, zone.label * slip);
    }
    return most;
}

double rw_fronts_wrong_rate(const rw_problem *p, const rw_zones *zones, double shear,
                            double stretch)
{
    rw_problem rates = *p;
    rates.shear = shear;
    rates.stretch = stretch;
    const rw_fronts f = {.problem = &rates};
    const stuck s = stuck_of(&f, zones);
    double A[RW_MOST_FRONTS * RW_MOST_FRONTS], B[RW_MOST_FRONTS], front[RW_MOST_FRONTS], most = 0;
    if (s.count == 0 || s.count > RW_MOST_STICK)
        return 0;
    for (int i = 0; i < 2 * s.count; i++)
        front[i] = (s.end[i] - s.middle) / s.half;
    conditions(&f, &s, (rw_layers){0, 0}, front, A, B);
    if (!rw_solve((size_t)(2 * s.count), A, B))
        return 0;
    for (int i = 0; i < zones->count; i++)
        if (zones->zone[i].label != 0)
            most = fmax(most, wrong_slip(&s, B, zones->zone[i], i == 0));
    return most / (p->scale * p->half);
}

/* ---- Newton ---- */

static double largest(int n, const double v[])
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(v[i]));
    return most;
}

/* How wide the narrower zone beside a front is. */
static double room(const rw_fronts *f, int j)
{
    const double before = j > 0 ? f->y[j - 1] : 0, after = j + 1 < f->fronts ? f->y[j + 1] : RW_PI;
    return fmin(f->y[j] - before, after - f->y[j]);
}

static double nearest_kink(const rw_fronts *f, double angle)
{
    double nearest = 1;
    for (int i = 0; i < f->problem->old->kinks; i++)
        nearest = fmin(nearest, fabs(rw_angle_of(f->problem, f->problem->old->kink[i]) - angle));
    return nearest;
}

static bool jacobian(rw_fronts *f, double J[])
{
    const int n = f->unknowns;
    for (int j = 0; j < n; j++) {
        const double y = f->y[j];
        const double h =
            j < f->fronts ? fmin(1e-5 * room(f, j), fmax(0.3 * nearest_kink(f, y), 3e-8)) : 1e-5;
        double up[RW_MOST_FRONTS], down[RW_MOST_FRONTS];
        f->y[j] = y + h;
        bool is_done = residual(f, up);
        f->y[j] = y - h;
        is_done = is_done && residual(f, down);
        f->y[j] = y;
        if (!is_done)
            return false;
        for (int i = 0; i < n; i++)
            J[i * n + j] = (up[i] - down[i]) / (2 * h);
    }
    return true;
}

/* A front does not jump over a kink of the old traction: it stops just beyond it. */
static void stop_at_kinks(const rw_fronts *f, double d[])
{
    const rw_problem *p = f->problem;
    for (int j = 0; j < f->fronts; j++)
        for (int i = 0; i < p->old->kinks; i++) {
            const double to = rw_angle_of(p, p->old->kink[i]) - f->y[j];
            if (to * (to - d[j]) < 0 && fabs(to) > 4e-5)
                d[j] = to + copysign(2e-5, d[j]);
        }
}

/* The part of the step that leaves a quarter of each zone. */
static double damping(const rw_fronts *f, const double d[])
{
    double part = 1;
    for (int i = 0; i <= f->fronts; i++) {
        const double gap = (i < f->fronts ? f->y[i] : RW_PI) - (i > 0 ? f->y[i - 1] : 0);
        const double grows = (i < f->fronts ? d[i] : 0) - (i > 0 ? d[i - 1] : 0);
        if (grows < 0)
            part = fmin(part, 0.75 * gap / -grows);
    }
    return part;
}

/* The best of ever shorter steps; its residual in r. */
static bool go_along(rw_fronts *f, const double d[], double r[], double *size)
{
    const int n = f->unknowns;
    double from[RW_MOST_FRONTS], best[RW_MOST_FRONTS], lowest = HUGE_VAL, new_r[RW_MOST_FRONTS];
    const double before = largest(n, r), whole = damping(f, d);
    memcpy(from, f->y, sizeof from);
    for (double part = whole; part >= 0.05 * whole; part /= 2) {
        for (int i = 0; i < n; i++)
            f->y[i] = from[i] + part * d[i];
        if (!residual(f, new_r))
            return false;
        if (largest(n, new_r) < lowest) {
            lowest = largest(n, new_r);
            memcpy(best, f->y, sizeof best);
            memcpy(r, new_r, sizeof new_r);
        }
        if (lowest < before * (1 - 1e-2 * part))
            break;
    }
    memcpy(f->y, best, sizeof best);
    *size = lowest;
    return true;
}

bool rw_fronts_newton(rw_fronts *f, double nothing)
{
    const int n = f->unknowns;
    double r[RW_MOST_FRONTS], J[RW_MOST_FRONTS * RW_MOST_FRONTS], d[RW_MOST_FRONTS];
    if (!residual(f, r))
        return false;
    int worse = 0;
    for (int turn = 0; turn < 40; turn++) {
        const double before = largest(n, r);
        if (before < nothing)
            return true;
        if (!jacobian(f, J))
            return false;
        for (int i = 0; i < n; i++)
            d[i] = -r[i];
        if (!rw_solve((size_t)n, J, d))
            return false;
        stop_at_kinks(f, d);
        double size, kept[RW_MOST_FRONTS];
        memcpy(kept, f->y, sizeof kept);
        if (!go_along(f, d, r, &size))
            return false;
        if (size >= before) {
            if (before < 30 * nothing || (before < 1000 * nothing && worse > 1)) {
                memcpy(f->y, kept, sizeof kept);
                return true;
            }
            if (++worse > 6)
                return false;
        }
        for (int i = 0; i < f->fronts; i++)
            if (room(f, i) < 1e-9)
                return false;
    }
    return false;
}

/* ---- Front by front ---- */

/* > 0 where the front wants to move into the zone that sticks. */
static bool pull(rw_fronts *f, int j, double angle, double *value)
{
    double r[RW_MOST_FRONTS];
    const double y = f->y[j];
    const int slip = f->label[j] != 0 ? f->label[j] : f->label[j + 1];
    f->y[j] = angle;
    const bool is_done = residual(f, r);
    f->y[j] = y;
    *value = slip * r[j];
    return is_done;
}

/* Regula falsi (Illinois) between a and b. */
static bool close_in(rw_fronts *f, int j, double a, double at_a, double b, double at_b)
{
    for (int turn = 0; turn < 30 && fabs(b - a) > 1e-7; turn++) {
        const double c = b - at_b * (b - a) / (at_b - at_a);
        double at_c;
        if (!isfinite(c) || !pull(f, j, c, &at_c))
            return false;
        if (at_c * at_b < 0) {
            a = b;
            at_a = at_b;
        } else {
            at_a /= 2;
        }
        b = c;
        at_b = at_c;
    }
    f->y[j] = b;
    return true;
}

static bool relax_front(rw_fronts *f, int j)
{
    const double start = f->y[j], inwards = f->label[j] != 0 ? 1 : -1;
    double a = start, at_a;
    if (!pull(f, j, a, &at_a))
        return false;
    const double direction = at_a > 0 ? inwards : -inwards;
    const double limit = direction < 0       ? j > 0 ? f->y[j - 1] : 0
                         : j + 1 < f->fronts ? f->y[j + 1]
                                             : RW_PI;
    double step = 0.02 * fmin(1, fabs(limit - start) / 0.04);
    while (fabs(limit - a) > 1e-4 * fabs(limit - start)) {
        double b = a + direction * step, at_b;
        if ((b - limit) * direction >= -1e-3 * fabs(limit - start))
            b = (a + limit) / 2;
        if (!pull(f, j, b, &at_b))
            return false;
        if (at_a * at_b <= 0)
            return close_in(f, j, a, at_a, b, at_b);
        a = b;
        at_a = at_b;
        step *= 2;
    }
    return false; /* the zone vanishes */
}

bool rw_fronts_relax(rw_fronts *f)
{
    if (f->unknowns != f->fronts)
        return false;
    for (int sweep = 0; sweep < 3; sweep++) {
        double moved = 0;
        for (int j = 0; j < f->fronts; j++) {
            const double before = f->y[j];
            if (!relax_front(f, j))
                return false;
            moved = fmax(moved, fabs(f->y[j] - before));
        }
        if (moved < 1e-3)
            break;
    }
    return true;
}

/* ---- The traction that sticks ---- */

bool rw_fronts_prepare_stick(rw_fronts *f, const rw_zones *zones, rw_layers layers)
{
    if (!collect(f, zones, layers, FINE))
        return false;
    for (size_t i = 0; i < f->count; i++)
        f->change[i] *= f->step[i] / f->X[i] / RW_PI;
    for (int i = 0; i < RW_MOST_SEGMENTS; i++) /* they are changes no more */
        f->segment[i].count = 0;
    return true;
}

double rw_fronts_stick_traction(const rw_fronts *f, const rw_zones *zones, rw_layers layers,
                                double x)
{
    const stuck s = stuck_of(f, zones);
    int after = 0; /* zones that stick beyond this one */
    for (int k = 0; k < s.count; k++)
        after += x < s.end[2 * k];
    double sum = 0;
    for (size_t i = 0; i < f->count; i++) {
        const double d = f->x[i] - x;
        sum += f->change[i] / (d == 0 ? 1 : d) * (d != 0);
    }
    return rw_base_traction(f->problem, layers, x) + sum * fabs(X_at(&s, x)) * (after % 2 ? -1 : 1);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The critical plane, against textbook cycles and a scan of all planes. */
#include "claims.h"
#include "rwedge.h"

static double some_stress(uint64_t *seed)
{
    return 2 * random_fraction(seed) - 1;
}

/* The traction on the plane whose normal is (sin(angle), cos(angle)). */
static void resolve(const double s[3], double angle, double *along_normal, double *across)
{
    const double x = sin(angle), y = cos(angle);
    const double tx = s[0] * x + s[2] * y, ty = s[2] * x + s[1] * y;
    *along_normal = tx * x + ty * y;
    *across = tx * y - ty * x;
}

enum { LOADS_MAX = 400 };

typedef struct {
    size_t n;
    double sxx[LOADS_MAX], syy[LOADS_MAX], txy[LOADS_MAX];
    double E, nu, k;
} cycle;

typedef enum { SMITH_WATSON_TOPPER, FATEMI_SOCIE } parameter;

static double parameter_of(const cycle *c, parameter which, double *angle)
{
    double value = NAN;
    assert_ok(
        which == SMITH_WATSON_TOPPER
            ? rwedge_smith_watson_topper(c->n, c->sxx, c->syy, c->txy, c->E, c->nu, &value, angle)
            : rwedge_fatemi_socie(c->n, c->sxx, c->syy, c->txy, c->E, c->nu, c->k, &value, angle));
    return value;
}

/* The definition on one plane: stresses and strains of each load resolved on it. */
static double on_plane(const cycle *c, parameter which, double angle)
{
    double most = -HUGE_VAL, top = -HUGE_VAL, bottom = HUGE_VAL;
    for (size_t i = 0; i < c->n; i++) {
        const double factor = (1 + c->nu) / c->E;
        const double s[3] = {c->sxx[i], c->syy[i], c->txy[i]};
        const double e[3] = {factor * ((1 - c->nu) * s[0] - c->nu * s[1]),
                             factor * ((1 - c->nu) * s[1] - c->nu * s[0]), factor * s[2]};
        double normal, unused, strain[2];
        resolve(s, angle, &normal, &unused);
        resolve(e, angle, &strain[0], &strain[1]);
        const double counts = which == SMITH_WATSON_TOPPER ? strain[0] : 2 * strain[1];
        most = fmax(most, normal), top = fmax(top, counts), bottom = fmin(bottom, counts);
    }
    return (top - bottom) / 2 * fmax(0, which == SMITH_WATSON_TOPPER ? most : 1 + c->k * most);
}

/* The maximum in [lo, hi] by golden section. */
static double golden(const cycle *c, parameter which, double lo, double hi)
{
    const double ratio = (sqrt(5) - 1) / 2;
    double best = 0;
    while (hi - lo > 1e-9) {
        const double p = hi - ratio * (hi - lo), q = lo + ratio * (hi - lo);
        const double at_p = on_plane(c, which, p), at_q = on_plane(c, which, q);
        best = fmax(best, fmax(at_p, at_q));
        if (at_p < at_q)
            lo = p;
        else
            hi = q;
    }
    return best;
}

/* Every tenth of a degree, and golden section about each that is not below its neighbours. */
static double scanned(const cycle *c, parameter which)
{
    enum { PLANES = 1800 };
    static double at[PLANES];
    const double step = PI / PLANES;
    for (int i = 0; i < PLANES; i++)
        at[i] = on_plane(c, which, i * step);
    double best = 0;
    for (int i = 0; i < PLANES; i++)
        if (at[i] >= at[(i + 1) % PLANES] && at[i] >= at[(i + PLANES - 1) % PLANES])
            best = fmax(best, golden(c, which, (i - 1) * step, (i + 1) * step));
    return best;
}

/* The unit in which the header states the errors. */
static double unit_of(const cycle *c, parameter which)
{
    double s = 0;
    for (size_t i = 0; i < c->n; i++) {
        double s1, s2, angle;
        rwedge_principal_stresses(c->sxx[i], c->syy[i], c->txy[i], &s1, &s2, &angle);
        s = fmax(s, fmax(fabs(s1), fabs(s2)));
    }
    return (which == SMITH_WATSON_TOPPER ? s : 1 + s * c->k) * s * (1 + c->nu) / c->E;
}

typedef enum { PROPORTIONAL, ELLIPSE, TRIANGLE, JUMPS, BACK_AND_FORTH, WALK, KINDS } path;

/* A cycle of one of the kinds, about a random mean stress. */
static void draw_cycle(cycle *c, path kind, size_t n, uint64_t *seed)
{
    double part[3][3], now[3] = {0, 0, 0};
    for (int i = 0; i < 9; i++)
        part[i / 3][i % 3] = some_stress(seed);
    *c = (cycle){.n = n,
                 .E = 1 + 9 * random_fraction(seed),
                 .nu = 0.5 * random_fraction(seed),
                 .k = 3 * random_fraction(seed) - 0.5};
    c->k = fmax(c->k, 0);
    for (size_t i = 0; i < n; i++) {
        const double t = 2 * PI * (double)i / (double)n;
        double u = cos(t), v = sin(t);
        if (kind == PROPORTIONAL)
            v = u;
        if (kind == TRIANGLE)
            u = fabs(1 - t / PI), v = u * u;
        if (kind == BACK_AND_FORTH)
            u = i % 2 ? 1 : -1, v = (double)(i / 2 % 2);
        for (int j = 0; j < 3; j++) {
            if (kind == WALK)
                now[j] += 0.3 * some_stress(seed);
            else
                now[j] = kind == JUMPS ? some_stress(seed)
                                       : 0.5 * part[0][j] + u * part[1][j] + v * part[2][j];
        }
        c->sxx[i] = now[0], c->syy[i] = now[1], c->txy[i] = now[2];
    }
}

/* No scanned plane has more, and the plane that is named has it. */
CLAIM(the_critical_plane_is_that_of_a_scan)
{
    static const size_t counts[] = {1, 2, 3, 12, 48, 65, 400};
    static cycle c;
    uint64_t seed = 3;
    for (path kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
            for (parameter which = SMITH_WATSON_TOPPER; which <= FATEMI_SOCIE; which++) {
                draw_cycle(&c, kind, counts[i], &seed);
                double angle;
                const double value = parameter_of(&c, which, &angle), unit = unit_of(&c, which);
                assert_within(value, scanned(&c, which), 1e-14 * unit);
                assert_within(on_plane(&c, which, angle), value, 1e-14 * unit);
                assert_true(angle > -PI / 2 && angle <= PI / 2);
            }
}

/* A path round a circle: as many planes are the worst as there are loads, all but rounding. */
CLAIM(a_circular_path_has_as_many_worst_planes_as_loads)
{
    static cycle c;
    static const size_t counts[] = {4, 7, 48, 63, 64, 65, 128, 400};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        c = (cycle){.n = counts[i], .E = 1, .nu = 0.3, .k = 0};
        for (size_t j = 0; j < c.n; j++) {
            const double t = 2 * PI * (double)j / (double)c.n;
            c.sxx[j] = cos(t), c.syy[j] = -cos(t), c.txy[j] = sin(t);
        }
        double angle;
        /* the widest of a regular polygon: from corner to corner, or to the middle of a side */
        const double width = c.n % 2 ? 2 * cos(PI / (2.0 * (double)c.n)) : 2;
        assert_close(parameter_of(&c, FATEMI_SOCIE, &angle), 1.3 * width, 1e-14);
        if (c.n % 2 == 0)
            assert_close(parameter_of(&c, SMITH_WATSON_TOPPER, &angle), 1.3, 1e-14);
    }
}

static cycle alternating(double sxx, double syy, double txy)
{
    cycle c = {.n = 2, .E = 210e3, .nu = 0.3};
    c.sxx[0] = sxx, c.syy[0] = syy, c.txy[0] = txy;
    c.sxx[1] = -sxx, c.syy[1] = -syy, c.txy[1] = -txy;
    return c;
}

/* At the worst plane the second and third derivatives are 0 too: the product is (1 + c) (3 - c)/10,
 * c the cosine of twice the angle from it. The value is as good as ever; many planes have it, but
 * for rounding. */
CLAIM(a_flat_maximum)
{
    static const double mean[2] = {1, 0.4}, half_difference[2] = {1, 1.2};
    for (double at = -1.5; at < 1.5; at += 0.1) {
        cycle c = {.n = 2, .E = 1};
        for (int i = 0; i < 2; i++) {
            c.sxx[i] = mean[i] - half_difference[i] * cos(2 * at);
            c.syy[i] = mean[i] + half_difference[i] * cos(2 * at);
            c.txy[i] = half_difference[i] * sin(2 * at);
        }
        double angle;
        assert_close(parameter_of(&c, SMITH_WATSON_TOPPER, &angle), 0.4, 1e-14);
        assert_within(angle, at, 5e-4);
    }
}

/* The header's way to plane stress: exx = (sxx - nu syy)/E. */
CLAIM(plane_stress_by_other_constants)
{
    const double nu = 0.3;
    cycle c = alternating(250, 0, 0);
    c.E *= (1 + 2 * nu) / ((1 + nu) * (1 + nu));
    c.nu = nu / (1 + nu);
    double angle;
    assert_close(parameter_of(&c, SMITH_WATSON_TOPPER, &angle), 250 * 250 / 210e3, 1e-14);
    assert_close(parameter_of(&c, FATEMI_SOCIE, &angle), 1.3 * 250 / 210e3, 1e-14);
}

CLAIM(harmless_cycles_have_none)
{
    cycle c = alternating(10, 20, 5);
    double angle = 7;
    c.sxx[1] = c.sxx[0], c.syy[1] = c.syy[0], c.txy[1] = c.txy[0]; /* constant */
    assert_within(parameter_of(&c, SMITH_WATSON_TOPPER, &angle), 0, 0);
    assert_within(angle, 0, 0);
    assert_within(parameter_of(&c, FATEMI_SOCIE, &angle), 0, 0);
    c = alternating(10, 20, 5);
    for (int i = 0; i < 2; i++) /* never in tension */
        c.sxx[i] -= 100, c.syy[i] -= 100;
    assert_within(parameter_of(&c, SMITH_WATSON_TOPPER, &angle), 0, 0);
    c.k = 1; /* 1 + k sn_max/sy < 0 on all planes */
    assert_within(parameter_of(&c, FATEMI_SOCIE, &angle), 0, 0);
    assert_within(angle, 0, 0);
    c = (cycle){.n = 3, .E = 1};
    assert_within(parameter_of(&c, SMITH_WATSON_TOPPER, &angle), 0, 0);
    assert_within(parameter_of(&c, FATEMI_SOCIE, &angle), 0, 0);
}

CLAIM(a_field_is_its_points)
{
    enum { POINTS = 37, LOADS = 90 };
    static double s[3][LOADS * POINTS], value[2][POINTS], angle[2][POINTS];
    static cycle c;
    uint64_t seed = 7;
    for (size_t j = 0; j < POINTS; j++) {
        draw_cycle(&c, (path)(j % KINDS), LOADS, &seed);
        for (size_t i = 0; i < LOADS; i++) {
            s[0][i * POINTS + j] = c.sxx[i];
            s[1][i * POINTS + j] = c.syy[i];
            s[2][i * POINTS + j] = c.txy[i];
        }
    }
    assert_ok(rwedge_smith_watson_topper_field(LOADS, POINTS, s[0], s[1], s[2], 7, 0.3, value[0],
                                               angle[0]));
    assert_ok(
        rwedge_fatemi_socie_field(LOADS, POINTS, s[0], s[1], s[2], 7, 0.3, 2, value[1], angle[1]));
    c.E = 7, c.nu = 0.3, c.k = 2;
    for (size_t j = 0; j < POINTS; j++) {
        for (size_t i = 0; i < LOADS; i++) {
            c.sxx[i] = s[0][i * POINTS + j];
            c.syy[i] = s[1][i * POINTS + j];
            c.txy[i] = s[2][i * POINTS + j];
        }
        for (parameter which = SMITH_WATSON_TOPPER; which <= FATEMI_SOCIE; which++) {
            double own;
            assert_true(parameter_of(&c, which, &own) == value[which][j]);
            assert_true(own == angle[which][j]);
        }
    }
    assert_ok(rwedge_fatemi_socie_field(LOADS, 0, s[0], s[1], s[2], 7, 0.3, 2, value[1],
                                        angle[1])); /* no points */
}

CLAIM(a_cycle_has_loads_and_no_more_than_there_are_addresses)
{
    const double s[2] = {1, 2};
    double value = 11, angle = 12;
    assert_int_equal(rwedge_smith_watson_topper(0, s, s, s, 1, 0.3, &value, &angle), RWEDGE_ERANGE);
    assert_int_equal(rwedge_fatemi_socie(0, s, s, s, 1, 0.3, 1, &value, &angle), RWEDGE_ERANGE);
    assert_int_equal(
        rwedge_smith_watson_topper_field((size_t)-1 / 4, 8, s, s, s, 1, 0.3, &value, &angle),
        RWEDGE_ERANGE);
    assert_true(value == 11 && angle == 12);
}

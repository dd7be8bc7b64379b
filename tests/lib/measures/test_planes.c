/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The worst of all planes, or of those that contain z, against closed forms and a scan in plain
 * tensors. */
#include "claims.h"
#include "rwedge.h"

enum { LOADS_MAX = 400 };

/* Of planes that contain z; of all. */
typedef enum {
    SMITH_WATSON_TOPPER,
    FATEMI_SOCIE,
    IN_PLANE,
    SMITH_WATSON_TOPPER_ALL = IN_PLANE,
    FATEMI_SOCIE_ALL,
    FINDLEY,
    CRITERIA
} criterion;

typedef struct {
    size_t n;
    double sxx[LOADS_MAX], syy[LOADS_MAX], txy[LOADS_MAX];
    double E, nu, k;
    int32_t plane_stress;
} cycle;

typedef struct {
    double value, angle, out_of_plane;
} worst;

static int32_t ask(const cycle *c, criterion asked, worst *w)
{
    static const int32_t numbers[CRITERIA] = {
        RWEDGE_MEASURE_SWT_IN_PLANE, RWEDGE_MEASURE_FATEMI_SOCIE_IN_PLANE, RWEDGE_MEASURE_SWT,
        RWEDGE_MEASURE_FATEMI_SOCIE, RWEDGE_MEASURE_FINDLEY};
    const double of_strain[3] = {c->E, c->k, 1};
    const double *constants = asked == FINDLEY ? &c->k : of_strain;
    return rwedge_criterion(numbers[asked], constants, c->n, c->sxx, c->syy, c->txy, c->nu,
                            c->plane_stress, &w->value, &w->angle, &w->out_of_plane);
}

static worst worst_of(const cycle *c, criterion asked)
{
    worst w = {NAN, NAN, 0};
    assert_ok(ask(c, asked, &w));
    return w;
}

static bool is_of_strain(criterion asked)
{
    return asked == SMITH_WATSON_TOPPER || asked == SMITH_WATSON_TOPPER_ALL;
}

/* ---- The definitions, in three dimensions ---- */

typedef struct {
    double x[3];
} vector;

static double dot(vector a, vector b)
{
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

static vector normal_of(double angle, double out)
{
    return (vector){{cos(out) * sin(angle), cos(out) * cos(angle), sin(out)}};
}

static vector traction(const cycle *c, size_t i, vector n)
{
    const double nu = c->plane_stress ? 0 : c->nu;
    return (vector){{c->sxx[i] * n.x[0] + c->txy[i] * n.x[1],
                     c->txy[i] * n.x[0] + c->syy[i] * n.x[1],
                     nu * (c->sxx[i] + c->syy[i]) * n.x[2]}};
}

static double normal_strain(const cycle *c, size_t i, double normal_stress)
{
    const double trace = (c->sxx[i] + c->syy[i]) * (c->plane_stress ? 1 : 1 + c->nu);
    return ((1 + c->nu) * normal_stress - c->nu * trace) / c->E;
}

/* Of the smallest circle around points of the plane: by all pairs and triples. */
static double radius_around(size_t n, const double x[], const double y[])
{
    double best = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = i + 1; j < n; j++) {
            best = fmax(best, hypot(x[i] - x[j], y[i] - y[j]) / 2);
            for (size_t k = j + 1; k < n; k++) {
                const double a = hypot(x[i] - x[j], y[i] - y[j]),
                             b = hypot(x[j] - x[k], y[j] - y[k]),
                             d = hypot(x[k] - x[i], y[k] - y[i]);
                const double area =
                    fabs((x[j] - x[i]) * (y[k] - y[i]) - (x[k] - x[i]) * (y[j] - y[i])) / 2;
                const double longest = fmax(a, fmax(b, d));
                const bool is_acute = 2 * longest * longest < a * a + b * b + d * d;
                if (is_acute && area > 1e-9)
                    best = fmax(best, a * b * d / (4 * area));
            }
        }
    return best;
}

/* In planes that contain z shear has one direction. */
static double shear_amplitude(const cycle *c, criterion asked, const double x[], const double y[])
{
    double top = -HUGE_VAL, bottom = HUGE_VAL;
    if (asked >= IN_PLANE)
        return radius_around(c->n, x, y);
    for (size_t i = 0; i < c->n; i++)
        top = fmax(top, x[i]), bottom = fmin(bottom, x[i]);
    return (top - bottom) / 2;
}

static double on_plane(const cycle *c, criterion asked, double angle, double out)
{
    const vector n = normal_of(angle, out), u = {{cos(angle), -sin(angle), 0}},
                 v = normal_of(angle, out + PI / 2);
    double x[LOADS_MAX], y[LOADS_MAX], peak = -HUGE_VAL, top = -HUGE_VAL, bottom = HUGE_VAL;
    for (size_t i = 0; i < c->n; i++) {
        const vector t = traction(c, i, n);
        const double strain = normal_strain(c, i, dot(t, n));
        x[i] = dot(t, u), y[i] = dot(t, v);
        peak = fmax(peak, dot(t, n)), top = fmax(top, strain), bottom = fmin(bottom, strain);
    }
    if (is_of_strain(asked))
        return fmax(0, peak) * (top - bottom) / 2;
    const double amplitude = shear_amplitude(c, asked, x, y);
    if (asked == FINDLEY)
        return amplitude + c->k * peak;
    return 2 * (1 + c->nu) / c->E * amplitude * fmax(0, 1 + c->k * peak);
}

/* Two degrees apart, or a third of one, then ever finer around the worst planes of the scan. */
static double scanned(const cycle *c, criterion asked)
{
    enum { FINER = 30 };
    const bool all = asked >= IN_PLANE;
    const int across = all ? 90 : 600, up = all ? 46 : 1, beside = all ? 2 : 0;
    double best = -HUGE_VAL, angle = 0, out = 0;
    for (int i = 0; i < across; i++)
        for (int j = 0; j < up; j++) {
            const double value = on_plane(c, asked, PI * i / across, PI / 2 * j / 45);
            if (value > best)
                best = value, angle = PI * i / across, out = PI / 2 * j / 45;
        }
    double step = PI / across;
    for (int turn = 0; turn < FINER; turn++, step *= 0.6)
        for (int i = -2; i <= 2; i++)
            for (int j = -beside; j <= beside; j++) {
                const double value = on_plane(c, asked, angle + i * step, out + j * step);
                if (value > best) {
                    best = value, angle += i * step, out += j * step;
                    i = -2, j = -beside;
                }
            }
    return best;
}

/* The unit in which the header states the errors. */
static double unit_of(const cycle *c, criterion asked)
{
    double s = 0;
    for (size_t i = 0; i < c->n; i++)
        s = fmax(s, fmax(fabs(c->sxx[i]), fmax(fabs(c->syy[i]), fabs(c->txy[i]))));
    if (asked == FINDLEY)
        return (1 + c->k) * s;
    return (is_of_strain(asked) ? s : 1 + s * c->k) * s * (1 + c->nu) / c->E;
}

static double some_stress(uint64_t *seed)
{
    return 2 * random_fraction(seed) - 1;
}

typedef enum { PROPORTIONAL, ELLIPSE, TRIANGLE, BACK_AND_FORTH, JUMPS, WALK, KINDS } path;

/* Where along its two directions a cycle of that kind is. */
static void trace(path kind, size_t i, size_t n, double *u, double *v)
{
    const double t = 2 * PI * (double)i / (double)n;
    *u = cos(t), *v = kind == PROPORTIONAL ? cos(t) : sin(t);
    if (kind == TRIANGLE)
        *u = fabs(1 - t / PI), *v = *u * *u;
    if (kind == BACK_AND_FORTH)
        *u = i % 2 ? 1 : -1, *v = (double)(i / 2 % 2);
}

/* A cycle of one of the kinds, about a random mean stress. */
static void draw_cycle(cycle *c, path kind, size_t n, uint64_t *seed)
{
    double part[3][3], now[3] = {0, 0, 0}, u, v;
    for (int i = 0; i < 9; i++)
        part[i / 3][i % 3] = some_stress(seed);
    *c = (cycle){.n = n,
                 .E = 1 + 9 * random_fraction(seed),
                 .nu = 0.5 * random_fraction(seed),
                 .k = fmax(0, 3 * random_fraction(seed) - 0.5),
                 .plane_stress = random_fraction(seed) < 0.3};
    for (size_t i = 0; i < n; i++) {
        trace(kind, i, n, &u, &v);
        for (int j = 0; j < 3; j++)
            now[j] = kind == JUMPS  ? some_stress(seed)
                     : kind == WALK ? now[j] + 0.3 * some_stress(seed)
                                    : 0.5 * part[0][j] + u * part[1][j] + v * part[2][j];
        c->sxx[i] = now[0], c->syy[i] = now[1], c->txy[i] = now[2];
    }
}

/* The plane that is named has the value. */
static worst assert_named(const cycle *c, criterion asked)
{
    const worst w = worst_of(c, asked);
    assert_within(on_plane(c, asked, w.angle, w.out_of_plane), w.value, 2e-14 * unit_of(c, asked));
    assert_true(w.angle > -PI / 2 && w.angle <= PI / 2);
    assert_true(w.out_of_plane >= 0 && w.out_of_plane <= PI / 2);
    return w;
}

/* And no scanned plane has more. */
static void assert_worst(const cycle *c, criterion asked)
{
    const worst w = assert_named(c, asked);
    assert_true(scanned(c, asked) <= w.value + 1e-14 * unit_of(c, asked));
}

CLAIM(the_worst_plane_is_that_of_a_scan)
{
    enum { FEW = 4, TURNS = 3 };
    static const size_t counts[] = {1, 2, 3, 9, 12, 48, 65, 400};
    static cycle c;
    uint64_t seed = 5;
    for (path kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < TURNS * sizeof counts / sizeof *counts; i++)
            for (criterion asked = 0; asked < (i < TURNS * FEW ? CRITERIA : IN_PLANE); asked++) {
                draw_cycle(&c, kind, counts[i / TURNS], &seed);
                assert_worst(&c, asked);
            }
}

/* In plane stress, nearly along one direction. All planes of a latitude around it are nearly
 * equally bad, and the search ran out of patience: its values were 8e-8 and 2e-7 of them too small.
 * Tension and shear a quarter of a cycle apart: many more planes are than there is room for. */
CLAIM(the_worst_of_planes_that_are_nearly_as_bad_is_found)
{
    static const cycle cases[] = {{.n = 2,
                                   .sxx = {-0.38315830408701557, -1.9142652511662037},
                                   .syy = {-0.01000310088100409, -0.078424148767204674},
                                   .txy = {-0.058712556434125984, -0.36436191488408698},
                                   .k = 0.38131379654066228},
                                  {.n = 2,
                                   .sxx = {1.136, -0.8104},
                                   .syy = {0.04023, -0.01234},
                                   .txy = {0.1781, -0.1258},
                                   .k = 0.5},
                                  {.n = 4,
                                   .sxx = {1, 1e-4, -1},
                                   .syy = {0, 0, 1e-4},
                                   .txy = {-3e-5, 0.5, 0, -0.5},
                                   .k = 0.5}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        cycle c = cases[i];
        c.E = 1, c.nu = 0.33, c.plane_stress = true;
        assert_true(scanned(&c, FATEMI_SOCIE_ALL) <=
                    worst_of(&c, FATEMI_SOCIE_ALL).value * (1 + 1e-9));
    }
}

/* The strain does not swing where the normal stress is high: no quick bound holds. */
CLAIM(a_static_stress_across_a_plane_without_strain_hides_no_worse_one)
{
    const cycle c = {
        .n = 2, .sxx = {1.05, 0.95}, .syy = {0.1, -0.1}, .E = 1, .nu = 0.5, .plane_stress = true};
    assert_worst(&c, SMITH_WATSON_TOPPER_ALL);
}

/* Under a large k the worst plane is that of the peak; its amplitude may be next to nothing. */
CLAIM(a_peak_without_amplitude_is_a_number)
{
    const cycle c = {.n = 2, .sxx = {-1, 0}, .syy = {0.8, 0.9}, .txy = {0, 1e-310}, .k = 1e12};
    assert_close(worst_of(&c, FINDLEY).value, 0.9e12, 1e-12);
}

/* A shear that turns twice: on each plane that contains z, others of the loads are the worst. */
CLAIM(each_of_many_loads_in_turn_is_the_worst)
{
    enum { N = 2048 };
    static double sxx[N], syy[N], txy[N];
    const double k = 0.25;
    double value, angle, out_of_plane;
    for (int i = 0; i < N; i++) {
        const double t = 4 * PI * i / N;
        syy[i] = 100 * cos(t), sxx[i] = -syy[i], txy[i] = 100 * sin(t);
    }
    assert_ok(rwedge_criterion(RWEDGE_MEASURE_FINDLEY, &k, N, sxx, syy, txy, 0.3, 0, &value, &angle,
                               &out_of_plane));
    assert_close(value, 125, 1e-14);
}

/* ---- Planes that contain z ---- */

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
        /* the widest of a regular polygon: from corner to corner, or to the middle of a side */
        const double width = c.n % 2 ? 2 * cos(PI / (2.0 * (double)c.n)) : 2;
        assert_close(worst_of(&c, FATEMI_SOCIE).value, 1.3 * width, 1e-14);
        if (c.n % 2 == 0)
            assert_close(worst_of(&c, SMITH_WATSON_TOPPER).value, 1.3, 1e-14);
    }
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
        const worst w = worst_of(&c, SMITH_WATSON_TOPPER);
        assert_close(w.value, 0.4, 1e-14);
        assert_within(w.angle, at, 5e-4);
    }
}

/* Constant; never in tension, where 1 + k sn_max/sy < 0 on all planes; none at all. */
CLAIM(harmless_cycles_have_none)
{
    static const cycle cycles[] = {
        {.n = 2, .sxx = {10, 10}, .syy = {20, 20}, .txy = {5, 5}, .E = 1, .nu = 0.3},
        {.n = 2, .sxx = {-90, -110}, .syy = {-80, -120}, .txy = {5, -5}, .E = 1, .nu = 0.3, .k = 1},
        {.n = 3, .E = 1}};
    for (size_t i = 0; i < sizeof cycles / sizeof *cycles; i++)
        for (criterion asked = 0; asked < IN_PLANE; asked++) {
            const worst w = worst_of(&cycles[i], asked);
            assert_true(w.value == 0 && w.angle == 0);
        }
}

/* ---- The ratio of the modified Woehler curve ---- */

/* Of a shear +-t under a mean tension m, whose plane is that of x or y. */
static double modified_wohler(double t, double m, const double constants[3])
{
    const double sxx[2] = {0, 0}, syy[2] = {m, m}, txy[2] = {t, -t};
    double value, angle, out_of_plane;
    assert_ok(rwedge_criterion(RWEDGE_MEASURE_MODIFIED_WOHLER, constants, 2, sxx, syy, txy, 0, 0,
                               &value, &angle, &out_of_plane));
    return value;
}

CLAIM(the_ratio_of_a_mean_stress_to_a_shear_counts_up_to_its_limit)
{
    const double constants[3] = {40, 71, 0}, own_limit[3] = {40, 71, 0.5};
    assert_close(modified_wohler(100, 60, constants), 100 + 40 * 0.6, 1e-12);
    assert_close(modified_wohler(100, 88.75, constants), 100 + 71 / 2.0, 1e-12); /* rho_lim */
    assert_close(modified_wohler(100, 500, constants), 100 + 71 / 2.0, 1e-12);
    assert_close(modified_wohler(100, 60, own_limit), 100 + 40 * 0.5, 1e-12);
    assert_close(modified_wohler(100, -60, constants), 100, 1e-12); /* of the planes that shear so,
                                                                       that of x is not pressed */
}

/* It was 1.2e16: of a shear that is a rounding. */
CLAIM(a_mean_stress_alone_has_no_modified_wohler_parameter)
{
    const double constants[3] = {40, 71, 0};
    assert_true(modified_wohler(0, 110, constants) == 0);
    assert_true(modified_wohler(1e-14, 110, constants) == 0);
    assert_close(modified_wohler(1e-6, 110, constants), 71 / 2.0, 1e-7);
}

/* ---- Errors ---- */

CLAIM(a_cycle_has_loads_and_no_more_than_there_are_addresses)
{
    static const cycle none = {.E = 1, .nu = 0.3};
    const double s[3] = {1, 2, 3};
    worst w = {5, 6, 7};
    for (criterion asked = 0; asked < CRITERIA; asked++)
        assert_int_equal(ask(&none, asked, &w), RWEDGE_ERANGE);
    assert_int_equal(rwedge_criterion_field(RWEDGE_MEASURE_SWT_IN_PLANE, s, (size_t)-1 / 4, 8, s, s,
                                            s, 0.3, 0, &w.value, &w.angle, &w.out_of_plane),
                     RWEDGE_ERANGE);
    assert_int_equal(rwedge_criterion_field(RWEDGE_MEASURE_FINDLEY, s, 2, SIZE_MAX / 8, s, s, s,
                                            0.3, 0, &w.value, &w.angle, &w.out_of_plane),
                     RWEDGE_ERANGE);
    assert_true(w.value == 5 && w.angle == 6 && w.out_of_plane == 7);
}

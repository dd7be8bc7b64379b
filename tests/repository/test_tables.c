/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Linear interpolation in the shipped tables is as good as tables/README.md says. The errors are
 * measured at the centre of every cell, where they are largest, and printed. */
#include "claims.h"
#include "rwedge.h"

#include <stdio.h>
#include <string.h>

enum { COLUMNS = 9, MOST_ROWS = 7000 };

static struct {
    int rows;
    double cell[MOST_ROWS][COLUMNS];
} loaded;

static void load(const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "../../tables/%s.csv", name);
    reference table = reference_open(path);
    for (loaded.rows = 0; reference_next(&table); loaded.rows++) {
        assert_true(loaded.rows < MOST_ROWS);
        memcpy(loaded.cell[loaded.rows], table.cell, sizeof loaded.cell[0]);
    }
}

/* Columns of the elastic-limit tables. */
enum { A_OVER_B, F, NU, LIMIT, X, Y, BRANCH, BELOW, SURFACE };

static const char *const nus[] = {"0.25", "0.30", "0.35"};

typedef struct {
    double below, surface, smaller, naive; /* largest relative errors */
} errors;

/* A limit and its branches: columns of the table, and what the library has. */
typedef struct {
    int limit_column, below_column, surface_column;
    double (*limit)(double alpha, double f, double nu);
    int32_t (*below)(double alpha, double f, double nu, double *limit);
    int32_t (*surface)(double alpha, double f, double nu, double *limit);
} limit_kind;

static int32_t below_yield(double alpha, double f, double nu, double *limit)
{
    double x, y;
    return rwedge_subsurface_yield(alpha, f, nu, limit, &x, &y);
}

static int32_t surface_yield(double alpha, double f, double nu, double *limit)
{
    double x;
    return rwedge_surface_yield(alpha, f, nu, limit, &x);
}

static double shakedown(double alpha, double f, double nu)
{
    double limit, y;
    assert_ok(rwedge_shakedown_limit(alpha, f, nu, &limit, &y));
    return limit;
}

static int32_t below_shakedown(double alpha, double f, double nu, double *limit)
{
    double y;
    return rwedge_subsurface_shakedown(alpha, f, nu, limit, &y);
}

static const limit_kind FIRST_YIELD = {LIMIT,       BELOW,        SURFACE, rwedge_elastic_limit,
                                       below_yield, surface_yield},
                        SHAKEDOWN = {3, 6, 7, shakedown, below_shakedown, rwedge_surface_shakedown};

static double mean_of_corners(int row, int across, int column)
{
    return (loaded.cell[row][column] + loaded.cell[row + 1][column] +
            loaded.cell[row + across][column] + loaded.cell[row + across + 1][column]) /
           4;
}

static void keep_larger(double *worst, double value, double exact)
{
    *worst = fmax(*worst, fabs(value / exact - 1));
}

/* Both branches interpolated apart and the smaller taken, and, for comparison, the limit itself
 * interpolated. */
static errors interpolate_limits(const limit_kind *of, int across, double from)
{
    errors worst = {0, 0, 0, 0};
    for (int i = 0; i + across + 1 < loaded.rows; i++) {
        const double *v = loaded.cell[i], *w = loaded.cell[i + across + 1];
        if ((i + 1) % across == 0 || v[A_OVER_B] < from)
            continue;
        const double alpha = (v[A_OVER_B] + w[A_OVER_B]) / 2, f = (v[F] + w[F]) / 2, nu = v[NU];
        const double below = mean_of_corners(i, across, of->below_column),
                     surface = mean_of_corners(i, across, of->surface_column);
        double exact;
        assert_ok(of->surface(alpha, f, nu, &exact));
        keep_larger(&worst.surface, surface, exact);
        if (!isnan(below) && of->below(alpha, f, nu, &exact) == RWEDGE_OK)
            keep_larger(&worst.below, below, exact);
        exact = of->limit(alpha, f, nu);
        keep_larger(&worst.smaller, isnan(below) ? surface : fmin(below, surface), exact);
        keep_larger(&worst.naive, mean_of_corners(i, across, of->limit_column), exact);
    }
    return worst;
}

CLAIM(interpolating_the_branches_apart_is_accurate)
{
    /* table, from which a/b, and the error of the limit that tables/README.md states */
    static const struct {
        const char *name;
        const limit_kind *of;
        double from, stated;
    } cases[] = {{"elastic-limit-nu-", &FIRST_YIELD, 0.1, 0.012},
                 {"elastic-limit-fine-nu-", &FIRST_YIELD, 0.01, 0.007},
                 {"elastic-limit-fine-nu-", &FIRST_YIELD, 0.05, 0.0009},
                 {"elastic-limit-fine-nu-", &FIRST_YIELD, 0.1, 0.0005},
                 {"shakedown-limit-nu-", &SHAKEDOWN, 0.1, 0.018}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (int n = 0; n < 3; n++) {
            char name[64];
            snprintf(name, sizeof name, "%s%s", cases[i].name, nus[n]);
            load(name);
            const errors e = interpolate_limits(cases[i].of, 65, cases[i].from);
            print_message("%-28s a/b >= %.2f: below %.1e, surface %.1e, smaller %.1e; the limit "
                          "itself %.1e\n",
                          name, cases[i].from, e.below, e.surface, e.smaller, e.naive);
            assert_true(e.smaller <= cases[i].stated);
            /* the larger by far where a cusp is within the cell */
            assert_true(e.naive >= e.smaller);
        }
}

CLAIM(max_tension_interpolates)
{
    load("max-tension");
    assert_int_equal(loaded.rows, 101 * 8);
    double worst = 0;
    for (int i = 0; i + 8 < loaded.rows; i++) {
        const double *v = loaded.cell[i], *w = loaded.cell[i + 8];
        keep_larger(&worst, (v[3] + w[3]) / 2, rwedge_max_tension((v[0] + w[0]) / 2));
    }
    print_message("max-tension: %.1e\n", worst);
    assert_true(worst <= 1.8e-4);
}

CLAIM(contact_law_interpolates)
{
    load("contact-law");
    assert_int_equal(loaded.rows, 200);
    double load_worst = 0, peak_worst = 0, inverse_worst = 0;
    for (int i = 0; i + 1 < loaded.rows; i++) {
        const double *v = loaded.cell[i], *w = loaded.cell[i + 1], middle = (v[0] + w[0]) / 2;
        keep_larger(&load_worst, (v[1] + w[1]) / 2, rwedge_load(middle));
        keep_larger(&peak_worst, (v[3] + w[3]) / 2, rwedge_peak_pressure(middle));
        const double inverse_load = (1 / v[2] + 1 / w[2]) / 2; /* a/b linearly in theta a/(AP) */
        keep_larger(&inverse_worst, middle, rwedge_a_over_b(1 / inverse_load));
    }
    print_message("contact-law: load %.1e, peak pressure %.1e, a/b from the load %.1e\n",
                  load_worst, peak_worst, inverse_worst);
    assert_true(load_worst <= 1.6e-4 && peak_worst <= 0.0105 && inverse_worst <= 1.1e-4);
}

CLAIM(critical_friction_interpolates)
{
    enum { ACROSS = 100 }; /* Poisson's ratio down, a/b across */
    load("critical-friction");
    assert_int_equal(loaded.rows, 13 * ACROSS);
    double worst = 0, worst_of_common = 0;
    for (int i = 0; i + ACROSS + 1 < loaded.rows; i++) {
        const double *v = loaded.cell[i], *w = loaded.cell[i + ACROSS + 1];
        const bool all_positive =
            v[2] > 0 && loaded.cell[i + 1][2] > 0 && loaded.cell[i + ACROSS][2] > 0 && w[2] > 0;
        if ((i + 1) % ACROSS == 0 || !all_positive)
            continue;
        const double exact = rwedge_critical_friction((v[0] + w[0]) / 2, (v[1] + w[1]) / 2);
        const double error = fabs(mean_of_corners(i, ACROSS, 2) - exact);
        worst = fmax(worst, error);
        if (v[0] > 0.095 && v[1] > 0.295)
            worst_of_common = fmax(worst_of_common, error);
    }
    print_message("critical-friction: %.1e in f where none of the four neighbours is 0; %.1e for "
                  "a/b >= 0.1, nu >= 0.3\n",
                  worst, worst_of_common);
    assert_true(worst <= 0.02 && worst_of_common <= 0.004);
}

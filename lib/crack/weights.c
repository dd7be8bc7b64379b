/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bueckner's weight functions: the stress on the line of the crack that does no work on any
 * dislocation of the crack, and is sqrt(2/(pi (l - r))) at the tip.
 *   Places are l cos^14(u/2) from the mouth, equally spaced in u, with dislocations halfway between
 * them: there the trapezoidal rule is right for Cauchy's kernel too. At the tip all is even in u.
 * Towards the mouth, where densities are no power of the distance, places crowd so that the rule
 * sees little of it: the error falls with m^-14, with cos^2 it would fall with m^-2. */
#include "crack/weights.h"

#include "base/domain.h"
#include "base/linear.h"
#include "crack/dislocation.h"

#include <rwedge.h>
#include <stdlib.h>

enum { GRADE = 7, FEWEST = 2, MOST = 512 };

/* 75 degrees: beyond, the narrow wedge beside the crack takes too many places. */
static const double STEEPEST = 1.31;

bool rw_is_crack_angle(double angle)
{
    return islessequal(fabs(angle), STEEPEST);
}

/* The rule of m places on the line of a crack of the length 1. Half steps of u/2: the place k is at
 * 2 k of them, the dislocation before the place j at 2 j - 1. */
typedef struct {
    rw_complex direction;
    size_t m;
    double tip;                      /* weight of the stress at the tip */
    double squared_cosine[2 * MOST]; /* of a number of half steps */
    double sine[4 * MOST];
} rule;

static void set_rule(double angle, size_t m, rule *line)
{
    const double step = RW_HALF_PI / ((double)m - 0.5);
    line->direction = (rw_complex){sin(angle), cos(angle)};
    line->m = m;
    line->tip = sqrt(2 * GRADE / RW_PI) * step;
    for (size_t i = 0; i < 4 * m; i++)
        line->sine[i] = sin((double)i * (step / 2));
    for (size_t i = 0; i < 2 * m; i++) {
        const double cosine = cos((double)i * (step / 2));
        line->squared_cosine[i] = cosine * cosine;
    }
}

static double seventh_power(double x)
{
    const double square = x * x, cube = square * x;
    return cube * cube * x;
}

static double place_of(const rule *line, size_t k)
{
    return seventh_power(line->squared_cosine[2 * k]);
}

/* The distances from the mouth of the place k, r, and of the dislocation just before the place j,
 * t. */
typedef struct {
    double r, t, r_less_t;
} distances;

/* With t = w^7 and r = (w y)^7 it is r - t = t (y - 1)(1 + y + ... + y^6); w (y - 1) is the product
 * of two sines. */
static distances between(const rule *line, size_t k, size_t j)
{
    const size_t place = 2 * k, dislocation = 2 * j - 1;
    const double w = line->squared_cosine[dislocation], r = place_of(line, k), t = seventh_power(w);
    const double y = line->squared_cosine[place] / w;
    const double difference =
        dislocation > place ? line->sine[dislocation - place] : -line->sine[place - dislocation];
    const double apart = line->sine[dislocation + place] * difference / w;
    double powers = 1;
    for (int i = 1; i < GRADE; i++)
        powers = 1 + y * powers;
    return (distances){r, t, t * apart * powers};
}

/* The equations: A of 2 (m - 1) unknowns, b of as many rows of right-hand sides. The unknowns are
 * the weights over their places, those of the normal stress first. */
typedef struct {
    size_t unknowns, sides;
    double *A, *b;
} equations;

/* The work of the stress at the place k on the dislocation before the place j, in the row of the
 * equation: 0 where its density opens the line, 1 where it slides along it. The weight at the tip
 * is known. */
static void write_work(const rule *line, size_t k, size_t j, const equations *all)
{
    const size_t n = line->m - 1;
    const distances d = between(line, k, j);
    rw_line_stress stress[2];
    rw_dislocation_stresses(line->direction, d.r, d.t, d.r_less_t, stress);
    for (size_t i = 0; i < 2; i++) {
        const size_t row = i * n + j - 1;
        double *A = all->A + row * all->unknowns, *b = all->b + row * all->sides;
        if (k == 0) {
            b[0] = -line->tip * stress[i].normal;
            b[1] = -line->tip * stress[i].shear;
        } else {
            A[k - 1] = d.r * stress[i].normal;
            A[n + k - 1] = d.r * stress[i].shear;
        }
    }
}

static void write_equations(const rule *line, const size_t at[], const equations *all)
{
    const size_t n = line->m - 1;
    for (size_t j = 1; j <= n; j++) {
        double *b = all->b + (j - 1) * all->sides, *other = b + n * all->sides;
        for (size_t k = 0; k <= n; k++)
            write_work(line, k, j, all);
        for (size_t i = 2; i < all->sides; i++) {
            b[i] = j <= at[i - 2] ? -8 * RW_PI : 0; /* dislocations that are deeper open it */
            other[i] = 0;
        }
    }
}

static void copy_rows(const rule *line, const equations *solved, double row[])
{
    const size_t m = line->m;
    for (size_t i = 0; i < solved->sides; i++) {
        double *normal = row + i * 2 * m, *shear = normal + m;
        normal[0] = i == 0 ? line->tip : 0;
        shear[0] = i == 1 ? line->tip : 0;
        for (size_t k = 1; k < m; k++) {
            normal[k] = place_of(line, k) * solved->b[(k - 1) * solved->sides + i];
            shear[k] = place_of(line, k) * solved->b[(m + k - 2) * solved->sides + i];
        }
    }
}

void rw_crack_places(size_t m, double place[])
{
    rule line;
    set_rule(0, m, &line);
    for (size_t k = 0; k < m; k++)
        place[k] = place_of(&line, k);
}

int32_t rw_crack_rows(double angle, size_t m, size_t openings, const size_t at[], double row[])
{
    rule line;
    set_rule(angle, m, &line);
    equations all = {.unknowns = 2 * (m - 1), .sides = 2 + openings};
    all.A = malloc((all.unknowns + all.sides) * all.unknowns * sizeof *all.A);
    if (!all.A)
        return RWEDGE_ENOMEM;
    all.b = all.A + all.unknowns * all.unknowns;
    write_equations(&line, at, &all);
    const bool is_solved = rw_solve(all.unknowns, all.sides, all.A, all.b);
    if (is_solved)
        copy_rows(&line, &all, row);
    free(all.A);
    return is_solved ? RWEDGE_OK : RWEDGE_ENOCONV;
}

size_t rwedge_crack_points(double angle)
{
    static const double ROUNDING = 1e-9; /* of whole degrees in rad */
    if (!rw_is_crack_angle(angle))
        return 0;
    return 97 + (size_t)ceil(2 * fabs(angle) * 180 / RW_PI - ROUNDING);
}

int32_t rwedge_crack_weights(double angle, size_t m, double place[], double normal_I[],
                             double shear_I[], double normal_II[], double shear_II[])
{
    if (!place || !normal_I || !shear_I || !normal_II || !shear_II)
        return RWEDGE_ENULL;
    if (!rw_is_crack_angle(angle))
        return RWEDGE_EDOMAIN;
    if (m < FEWEST || m > MOST)
        return RWEDGE_ERANGE;
    double *row = malloc(4 * m * sizeof *row);
    const int32_t status = row ? rw_crack_rows(angle, m, 0, NULL, row) : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK) {
        double *const receives[] = {normal_I, shear_I, normal_II, shear_II};
        for (size_t i = 0; i < 4; i++)
            for (size_t k = 0; k < m; k++)
                receives[i][k] = row[i * m + k];
        rw_crack_places(m, place);
    }
    free(row);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the yield factor of a contact with a history misses the maximum of J2. The library
 * climbs from those points of its grids alone that may lie below the highest top. Here nothing is
 * left out: grids three times as fine around every mark, both sides apart, and a climb from every
 * maximum of them that reaches 0.8 of the highest. Stresses come from the public function, so that
 * nothing of the search is shared.
 *
 *     yield_survey HISTORIES [SEED]
 *
 * Random loads of P and Q, and of moment and tension; sharp, rounded and Hertz; nu 0 to 0.5. */
#include "claims.h"
#include "contact/contact.h"

#include <stdio.h>
#include <stdlib.h>

enum { ANGLES = 25, RADII = 190, MARKS_MAX = 40 };
static const double FALL = 0.83, COARSE = 0.04, FINE = 1e-8, WORTH = 0.8;

static const double THETA = 0.1, A = 0.1;

typedef struct {
    const rwedge_contact *contact;
    double kappa, highest;
} search;

static double J2_of(const search *s, double sxx, double syy, double txy)
{
    const double difference = (sxx - syy) / 2, mean = (sxx + syy) / 2;
    return difference * difference + txy * txy + s->kappa * mean * mean;
}

typedef struct {
    double log_r, angle, J2;
} place;

enum { AROUND = 8 };

/* In polar coordinates around a mark; beyond the surface is the surface. */
static void evaluate(search *s, double mark, place at[AROUND])
{
    double x[AROUND], y[AROUND], sxx[AROUND], syy[AROUND], txy[AROUND];
    for (int i = 0; i < AROUND; i++) {
        const double r = exp(at[i].log_r), up = fmax(0, fmin(PI, at[i].angle));
        x[i] = mark + r * cos(up);
        y[i] = up == 0 || up == PI ? 0 : r * sin(up);
    }
    const bool done = rwedge_contact_stresses(s->contact, AROUND, x, y, sxx, syy, txy) == RWEDGE_OK;
    for (int i = 0; i < AROUND; i++) { /* not at the apex */
        at[i].J2 = done ? J2_of(s, sxx[i], syy[i], txy[i]) : 0;
        s->highest = fmax(s->highest, at[i].J2);
    }
}

/* To the highest of the eight places around, at ever smaller distances. */
static void climb(search *s, double mark, place top)
{
    for (double step = COARSE; step > FINE;) {
        place at[AROUND];
        for (int i = 0; i < AROUND; i++)
            at[i] =
                (place){top.log_r + step * cos(PI / 4 * i), top.angle + step * sin(PI / 4 * i), 0};
        evaluate(s, mark, at);
        const double before = top.J2;
        for (int i = 0; i < AROUND; i++)
            if (at[i].J2 > top.J2)
                top = at[i];
        step *= top.J2 > before * (1 + 1e-15) ? 1.5 : 0.4;
    }
}

typedef struct {
    double J2[RADII][ANGLES];
    double x[ANGLES], y[ANGLES], sxx[ANGLES], syy[ANGLES], txy[ANGLES];
} polar_grid;

static void fill(search *s, polar_grid *g, double mark, double reach)
{
    for (int i = 0; i < RADII; i++) {
        const double r = reach * pow(FALL, i);
        for (int j = 0; j < ANGLES; j++) {
            g->x[j] = mark + r * cos(PI * j / (ANGLES - 1));
            g->y[j] = j == 0 || j == ANGLES - 1 ? 0 : r * sin(PI * j / (ANGLES - 1));
            g->J2[i][j] = 0;
        }
        if (rwedge_contact_stresses(s->contact, ANGLES, g->x, g->y, g->sxx, g->syy, g->txy) !=
            RWEDGE_OK)
            continue; /* the apex is among them */
        for (int j = 0; j < ANGLES; j++) {
            g->J2[i][j] = J2_of(s, g->sxx[j], g->syy[j], g->txy[j]);
            s->highest = fmax(s->highest, g->J2[i][j]);
        }
    }
}

static bool is_top(const polar_grid *g, int i, int j)
{
    for (int k = -1; k <= 1; k++)
        for (int l = -1; l <= 1; l++)
            if (i + k >= 0 && i + k < RADII && j + l >= 0 && j + l < ANGLES &&
                g->J2[i + k][j + l] > g->J2[i][j])
                return false;
    return true;
}

static void survey_mark(search *s, double mark, double reach)
{
    static polar_grid grid;
    fill(s, &grid, mark, reach);
    for (int i = 0; i < RADII; i++)
        for (int j = 0; j < ANGLES; j++)
            if (grid.J2[i][j] > WORTH * s->highest && is_top(&grid, i, j))
                climb(s, mark,
                      (place){log(reach) + i * log(FALL), PI * j / (ANGLES - 1), grid.J2[i][j]});
}

static double highest_of(const rwedge_contact *contact, double nu)
{
    search s = {contact, (1 - 2 * nu) * (1 - 2 * nu) / 3, 0};
    const rw_memory *memory = &contact->memory;
    const double b = fmax(-rw_memory_end(memory)->patch.left, rw_memory_end(memory)->patch.right);
    double marks[MARKS_MAX] = {0, -contact->geometry.a, contact->geometry.a};
    size_t count = 3;
    for (size_t i = memory->count; i-- > 1 && count + 2 <= MARKS_MAX;) {
        marks[count++] = memory->corners[i].patch.left;
        marks[count++] = memory->corners[i].patch.right;
    }
    for (size_t i = 0; i < count; i++)
        if (fabs(marks[i]) <= b)
            survey_mark(&s, marks[i], 3 * b);
    return s.highest;
}

/* ---- What is drawn ---- */

static void go_on(rwedge_contact *contact, uint64_t *seed, double f, bool is_centred)
{
    double P, M, Q, sigma;
    rwedge_contact_loads(contact, &P, &M, &Q, &sigma);
    const double arm = P > 0 ? M / P : 0, kind = random_fraction(seed);
    if (kind < 0.4 || P == 0)
        P = P == 0 ? 1 : P * random_between(seed, 0.5, 1.5);
    Q = f * P * (kind > 0.95 ? 1 : random_between(seed, -1, 1));
    if (!is_centred && kind >= 0.4) /* within what slips one way */
        sigma += random_between(seed, -0.5, 0.5) * rwedge_contact_largest_tension_step(contact, Q);
    (void)rwedge_contact_apply(contact, P, arm * P, Q, sigma); /* or stays as it is */
}

static rwedge_contact *draw(uint64_t *seed, double *nu)
{
    const double kind = random_fraction(seed), P = 1;
    const double a = kind < 0.1 ? 0 : pow(10, random_between(seed, -5, 1));
    const double f = random_fraction(seed) < 0.1 ? 0 : pow(10, random_between(seed, -2, 0.3));
    const bool is_centred = random_fraction(seed) < 0.6;
    *nu = random_fraction(seed) < 0.1 || a == 0 ? 0.5 : random_between(seed, 0, 0.5);
    rwedge_contact *contact;
    assert_ok(rwedge_contact_create(THETA, a, A, f, &contact));
    const double b = rwedge_half_width(THETA, a, A, P);
    const double arm = is_centred ? 0 : random_between(seed, -0.4, 0.4) * b;
    if (rwedge_contact_apply(contact, P, arm * P, 0, 0) != RWEDGE_OK)
        assert_ok(rwedge_contact_apply(contact, P, 0, 0, 0));
    const int loads = (int)random_between(seed, 0, 9);
    for (int i = 0; i < loads; i++)
        go_on(contact, seed, f, is_centred);
    return contact;
}

int main(int argc, char **argv)
{
    const long histories = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    if (histories < 1) {
        fprintf(stderr, "usage: yield_survey HISTORIES [SEED]\n");
        return 2;
    }
    long missed = 0, searched = 0;
    double worst = -1;
    for (long i = 0; i < histories; i++) {
        const uint64_t drawn = seed;
        double nu, factor, x, y;
        rwedge_contact *contact = draw(&seed, &nu);
        const int32_t status = rwedge_contact_yield_factor(contact, nu, 1, &factor, &x, &y);
        if (status == RWEDGE_OK && factor > 0) {
            const double above = highest_of(contact, nu) * factor * factor - 1;
            searched++;
            worst = fmax(worst, above);
            if (above > 2e-12) {
                printf("history of seed %llu: J2 is higher by %.3g\n", (unsigned long long)drawn,
                       above);
                missed++;
            }
        }
        rwedge_contact_destroy(contact);
    }
    printf("%ld histories, %ld with a finite stress; highest J2 found over that of the yield "
           "factor, less 1: %.1e; %ld missed\n",
           histories, searched, worst, missed);
    return missed ? 1 : 0;
}

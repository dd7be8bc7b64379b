/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "boundary_element.h"

#include <gsl/gsl_linalg.h>
#include <math.h>

enum { SIZE = BOUNDARY_ELEMENTS_MAX + 2, ITERATIONS_MAX = 500 };

typedef struct {
    size_t n;
    double row[SIZE][SIZE + 1]; /* the last column is the right-hand side, then the solution */
} linear_system;

static linear_system equations; /* large for a stack; the tests run in one thread */

/* The solution is in the column n. */
static void solve(void)
{
    const size_t n = equations.n;
    int sign;
    gsl_matrix_view matrix = gsl_matrix_view_array_with_tda(equations.row[0], n, n, SIZE + 1);
    gsl_vector_view right = gsl_vector_view_array_with_stride(&equations.row[0][n], SIZE + 1, n);
    gsl_permutation *order = gsl_permutation_alloc(n);
    gsl_linalg_LU_decomp(&matrix.matrix, order, &sign);
    gsl_linalg_LU_svx(&matrix.matrix, order, &right.vector);
    gsl_permutation_free(order);
}

/* int ln|t| dt */
static double logarithm_integral(double t)
{
    return t == 0 ? 0 : t * log(fabs(t)) - t;
}

/* The displacement at element i from a unit traction on element j, Eq. (1) and (17) integrated. */
static double influence(const boundary_element *s, size_t i, size_t j)
{
    const double half = s->width / 2, away = s->x[i] - s->x[j];
    return s->A / acos(-1) * (logarithm_integral(away + half) - logarithm_integral(away - half));
}

static double displaced(const boundary_element *s, size_t i, size_t first, size_t end,
                        const double traction[])
{
    double sum = 0;
    for (size_t j = first; j < end; j++)
        sum += influence(s, i, j) * traction[j];
    return sum;
}

static double profile(const boundary_element *s, double signed_x)
{
    const double x = fabs(signed_x);
    if (s->height)
        return s->height(signed_x);
    return s->theta * (x < s->a ? x * x / (2 * s->a) : x - s->a / 2);
}

void boundary_element_start(boundary_element *solver, double theta, double a, double compliance,
                            double f, size_t n, double half)
{
    *solver = (boundary_element){.theta = theta,
                                 .a = a,
                                 .A = compliance,
                                 .f = f,
                                 .n = n,
                                 .end = n,
                                 .width = 2 * half / (double)n};
    for (size_t i = 0; i < n; i++)
        solver->x[i] = ((double)i + 0.5) * solver->width - half;
}

/* A row of the equations: what m tractions add up to, each weighted by its place or not. */
static void balance(const boundary_element *s, size_t row, size_t first, size_t m, bool by_place,
                    double sum)
{
    for (size_t j = 0; j < equations.n; j++)
        equations.row[row][j] = 0;
    for (size_t j = 0; j < m; j++)
        equations.row[row][j] = -s->width * (by_place ? s->x[first + j] : 1);
    equations.row[row][equations.n] = sum;
}

/* Where the wedge comes to, as a function of x: depth + tilt x - profile. */
typedef struct {
    double depth, tilt;
} position;

/* The pressure of the elements from `first` to end - 1 in contact, under P and M. */
static position press(const boundary_element *s, size_t first, size_t end, rw_loads to, double p[])
{
    const size_t m = end - first;
    equations.n = m + 2;
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < m; j++)
            equations.row[i][j] = influence(s, first + i, first + j);
        equations.row[i][m] = -1;
        equations.row[i][m + 1] = -s->x[first + i];
        equations.row[i][equations.n] = -profile(s, s->x[first + i]);
    }
    balance(s, m, first, m, false, to.P);
    balance(s, m + 1, first, m, true, to.M);
    solve();
    for (size_t i = 0; i < m; i++)
        p[first + i] = equations.row[i][equations.n];
    return (position){equations.row[m][equations.n], equations.row[m + 1][equations.n]};
}

static bool overlaps(const boundary_element *s, size_t i, size_t first, size_t end,
                     const double p[], position at)
{
    return displaced(s, i, first, end, p) < at.depth + at.tilt * s->x[i] - profile(s, s->x[i]);
}

/* Moves the edges until no element in contact is pulled, and none beside it overlaps; whether it
 * came to an end. */
static bool find_contact(boundary_element *s, rw_loads to, double p[])
{
    size_t first = s->first, end = s->end;
    for (int iteration = 0; iteration < ITERATIONS_MAX; iteration++) {
        const position at = press(s, first, end, to, p);
        const bool left = first > 0 && overlaps(s, first - 1, first, end, p, at);
        const bool right = end < s->n && overlaps(s, end, first, end, p, at);
        const size_t before = end - first;
        while (end - first > 3 && p[first] >= 0)
            first++;
        while (end - first > 3 && p[end - 1] >= 0)
            end--;
        if (end - first < before)
            continue;
        if (left || right) {
            first -= left;
            end += right;
        } else {
            s->first = first;
            s->end = end;
            s->tilt = at.tilt;
            return true;
        }
    }
    return false;
}

/* The shear traction of the elements in contact, in their present motion. Returns the rigid
 * displacement. */
static double solve_tangential(const boundary_element *s, const double p[], const motion moves[],
                               rw_loads to, double q[])
{
    const size_t m = s->end - s->first;
    equations.n = m + 1;
    for (size_t i = 0; i < m; i++) {
        const size_t e = s->first + i;
        const bool sticks = moves[e] == STICKS;
        for (size_t j = 0; j < m; j++)
            equations.row[i][j] = sticks ? influence(s, e, s->first + j) : i == j;
        equations.row[i][m] = sticks ? -1 : 0;
        equations.row[i][m + 1] = sticks ? s->displacement[e] - s->A * to.sigma / 4 * s->x[e]
                                  : moves[e] == FORWARD ? -s->f * p[e]
                                                        : s->f * p[e];
    }
    balance(s, m, s->first, m, false, to.Q);
    solve();
    for (size_t i = 0; i < m; i++)
        q[s->first + i] = equations.row[i][m + 1];
    return equations.row[m][m + 1];
}

/* Whether Coulomb's law holds everywhere; where it does not the element sticks or slips instead. */
static bool obeys_friction(const boundary_element *s, const double p[], const double q[],
                           const double moved[], motion moves[])
{
    bool obeys = true;
    const double noise = 1e-12;
    for (size_t i = s->first; i < s->end; i++) {
        const double slip = moved[i] - s->displacement[i];
        if (moves[i] == STICKS && fabs(q[i]) > -s->f * p[i] * (1 + noise)) {
            moves[i] = q[i] > 0 ? FORWARD : BACKWARD;
            obeys = false;
        } else if ((moves[i] == FORWARD && slip < 0) || (moves[i] == BACKWARD && slip > 0)) {
            moves[i] = STICKS;
            obeys = false;
        }
    }
    return obeys;
}

static void accept(boundary_element *s, const double p[], const double q[], const double moved[],
                   const motion moves[])
{
    for (size_t i = 0; i < s->n; i++) {
        const bool touches = i >= s->first && i < s->end;
        const double slip = touches ? moved[i] - s->displacement[i] : 0;
        const double mean = touches ? (s->q[i] + q[i]) / 2 : 0;
        s->energy += s->width * slip * mean;
        s->slip[i] = touches ? s->slip[i] + slip : 0;
        s->p[i] = touches ? p[i] : 0;
        s->q[i] = touches ? q[i] : 0;
        s->moves[i] = moves[i];
        s->displacement[i] = moved[i];
    }
}

static int take_step(boundary_element *s, rw_loads to)
{
    double p[SIZE], q[SIZE], moved[SIZE];
    motion moves[SIZE] = {STICKS};
    if (!find_contact(s, to, p))
        return 1;
    for (int iteration = 0; iteration < ITERATIONS_MAX; iteration++) {
        const double rigid = solve_tangential(s, p, moves, to, q);
        for (size_t i = 0; i < s->n; i++)
            moved[i] = displaced(s, i, s->first, s->end, q) + s->A * to.sigma / 4 * s->x[i] - rigid;
        if (obeys_friction(s, p, q, moved, moves)) {
            accept(s, p, q, moved, moves);
            s->rigid = rigid;
            s->loads = to;
            return 0;
        }
    }
    return 1;
}

int boundary_element_go(boundary_element *solver, int steps, rw_loads to)
{
    const rw_loads from = solver->loads;
    int failed = 0;
    for (int i = 1; i <= steps && !failed; i++)
        failed = take_step(solver, rw_loads_between(from, to, (double)i / steps));
    return failed;
}

/* ---- Beside the library ---- */

/* Where slip jumps: what is beyond has come into contact since. */
static bool is_at_a_jump(const rwedge_contact *contact, const boundary_element *solver, double x)
{
    return fabs(x - contact->settled.left) < solver->width ||
           fabs(x - contact->settled.right) < solver->width;
}

/* What has been in contact since the first leg, if a load was computed. What comes later touches as
 * an element, not as a place. */
static rw_patch lasting(const rwedge_contact *contact, difference *sum)
{
    const rw_patch now = edges_of(contact), before = sum->legs == 0 ? now : sum->lasting;
    sum->lasting = (rw_patch){fmax(before.left, now.left), fmin(before.right, now.right)};
    return contact->numerical ? sum->lasting : now;
}

void add_difference(const rwedge_contact *contact, const boundary_element *solver, double f,
                    difference *sum)
{
    double off[2] = {0}, slip[2] = {0}, limit = 0;
    const rw_patch part = lasting(contact, sum);
    size_t number[2] = {0};
    for (size_t i = 0; i < solver->n; i++) {
        const double x = solver->x[i];
        off[0] += fabs(pressure(contact, x) - solver->p[i]);
        off[1] += fabs(shear(contact, x) - solver->q[i]);
        limit += fabs(pressure(contact, x));
        double slipped; /* there may be no closed form of it */
        if (i >= solver->first && i < solver->end && !is_at_a_jump(contact, solver, x) &&
            rwedge_contact_slip(contact, 1, &x, &slipped) == RWEDGE_OK) {
            const bool is_young = !(x > part.left && x < part.right);
            slip[is_young] += fabs(slipped - solver->slip[i]);
            number[is_young]++;
        }
    }
    sum->pressure += off[0] / limit;
    sum->shear += off[1] / (f * limit);
    const double most = f * THETA * rwedge_contact_half_width(contact);
    sum->slip += number[0] > 0 ? slip[0] / (double)number[0] / most : 0;
    sum->young_slip += number[1] > 0 ? slip[1] / (double)number[1] / most : 0;
    const double energy = rwedge_contact_dissipated_energy(contact);
    if (energy > 0)
        sum->energy = fabs(solver->energy / energy - 1); /* that of the whole history */
    sum->legs++;
}

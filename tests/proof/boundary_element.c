/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "boundary_element.h"

#include <math.h>
#include <stdbool.h>

enum { SIZE = BOUNDARY_ELEMENTS_MAX + 1, ITERATIONS_MAX = 200 };

typedef struct {
    size_t n;
    double row[SIZE][SIZE + 1]; /* the last column is the right-hand side, then the solution */
} linear_system;

static linear_system equations; /* large for a stack; the tests run in one thread */

static void swap_rows(size_t i, size_t j)
{
    for (size_t k = 0; k <= equations.n; k++) {
        const double kept = equations.row[i][k];
        equations.row[i][k] = equations.row[j][k];
        equations.row[j][k] = kept;
    }
}

/* Gauss, with pivots. The solution is in the column n. */
static void solve(void)
{
    const size_t n = equations.n;
    for (size_t k = 0; k < n; k++) {
        size_t pivot = k;
        for (size_t i = k + 1; i < n; i++)
            if (fabs(equations.row[i][k]) > fabs(equations.row[pivot][k]))
                pivot = i;
        swap_rows(k, pivot);
        for (size_t i = k + 1; i < n; i++) {
            const double factor = equations.row[i][k] / equations.row[k][k];
            if (factor != 0)
                for (size_t j = k; j <= n; j++)
                    equations.row[i][j] -= factor * equations.row[k][j];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; j++)
            equations.row[k][n] -= equations.row[k][j] * equations.row[j][n];
        equations.row[k][n] /= equations.row[k][k];
    }
}

/* int ln|t| dt */
static double logarithm_integral(double t)
{
    return t == 0 ? 0 : t * log(fabs(t)) - t;
}

/* The displacement at element i from a unit traction on element j and its mirror image, Eq. (1)
 * and (17) integrated. */
static double influence(const boundary_element *s, size_t i, size_t j)
{
    const double half = s->width / 2, near = s->x[i] - s->x[j], far = s->x[i] + s->x[j];
    return s->A / acos(-1) *
           (logarithm_integral(near + half) - logarithm_integral(near - half) +
            logarithm_integral(far + half) - logarithm_integral(far - half));
}

static double profile(const boundary_element *s, double x)
{
    return s->theta * (x < s->a ? x * x / (2 * s->a) : x - s->a / 2);
}

void boundary_element_start(boundary_element *solver, double theta, double a, double A, double f,
                            size_t n, double width)
{
    *solver = (boundary_element){
        .theta = theta, .a = a, .A = A, .f = f, .n = n, .width = width / (double)n};
    for (size_t i = 0; i < n; i++)
        solver->x[i] = ((double)i + 0.5) * solver->width;
}

/* The last row: what the tractions of the first m elements add up to. */
static void balance(const boundary_element *s, size_t m, double force)
{
    for (size_t j = 0; j < m; j++)
        equations.row[m][j] = -2 * s->width;
    equations.row[m][m] = 0;
    equations.row[m][m + 1] = force;
    equations.n = m + 1;
}

/* The pressure of m elements in contact under P; whether all are pressed. */
static bool press(const boundary_element *s, size_t m, double P, double p[])
{
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < m; j++)
            equations.row[i][j] = influence(s, i, j);
        equations.row[i][m] = -1;
        equations.row[i][m + 1] = -profile(s, s->x[i]);
    }
    balance(s, m, P);
    solve();
    for (size_t i = 0; i < m; i++)
        p[i] = equations.row[i][m + 1];
    return p[m - 1] < 0;
}

/* The widest contact that has no tension at its edge. */
static size_t find_contact(const boundary_element *s, double P, double p[])
{
    size_t m = s->touching > 0 ? s->touching : 1;
    while (m < s->n && press(s, m, P, p))
        m++;
    while (m > 1 && !press(s, m, P, p))
        m--;
    return m;
}

typedef enum { STICKS, FORWARD, BACKWARD } motion;

/* Displacements of the first n elements from the tractions of the first m. */
static void displace(const boundary_element *s, size_t m, const double q[], double displacement[])
{
    for (size_t i = 0; i < s->n; i++) {
        displacement[i] = 0;
        for (size_t j = 0; j < m; j++)
            displacement[i] += influence(s, i, j) * q[j];
    }
}

static void solve_tangential(const boundary_element *s, size_t m, const double p[],
                             const motion moves[], double Q)
{
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < m; j++)
            equations.row[i][j] = moves[i] == STICKS ? influence(s, i, j) : i == j;
        equations.row[i][m] = moves[i] == STICKS ? -1 : 0;
        equations.row[i][m + 1] = moves[i] == STICKS    ? s->displacement[i]
                                  : moves[i] == FORWARD ? -s->f * p[i]
                                                        : s->f * p[i];
    }
    balance(s, m, Q);
    solve();
}

/* Whether Coulomb's law holds everywhere; where it does not the element sticks or slips instead. */
static bool obeys_friction(const boundary_element *s, size_t m, const double p[], const double q[],
                           const double moved[], motion moves[])
{
    bool obeys = true;
    const double noise = 1e-12;
    for (size_t i = 0; i < m; i++) {
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

static void accept(boundary_element *s, size_t m, const double p[], const double q[],
                   const double moved[])
{
    for (size_t i = 0; i < s->n; i++) {
        const double slip = i < m ? moved[i] - s->displacement[i] : 0;
        /* both halves, mean traction */
        s->energy += i < m ? s->width * slip * (s->q[i] + q[i]) : 0;
        s->slip[i] = i < m ? s->slip[i] + slip : 0;
        s->p[i] = i < m ? p[i] : 0;
        s->q[i] = i < m ? q[i] : 0;
        s->displacement[i] = moved[i];
    }
    s->touching = m;
}

int boundary_element_step(boundary_element *s, double P, double Q)
{
    double p[SIZE], q[SIZE], moved[SIZE];
    motion moves[SIZE];
    const size_t m = find_contact(s, P, p);
    for (size_t i = 0; i < m; i++)
        moves[i] = STICKS;
    for (int iteration = 0; iteration < ITERATIONS_MAX; iteration++) {
        solve_tangential(s, m, p, moves, Q);
        for (size_t i = 0; i < m; i++)
            q[i] = equations.row[i][m + 1];
        const double rigid = equations.row[m][m + 1];
        displace(s, m, q, moved);
        for (size_t i = 0; i < s->n; i++)
            moved[i] -= rigid;
        if (obeys_friction(s, m, p, q, moved, moves)) {
            accept(s, m, p, q, moved);
            s->rigid = rigid;
            s->P = P;
            s->Q = Q;
            return 0;
        }
    }
    return 1;
}

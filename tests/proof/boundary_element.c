/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "boundary_element.h"

#include <gsl/gsl_linalg.h>
#include <math.h>

enum { ITERATIONS_MAX = 500 };

/* int ln|t| dt */
static double logarithm_integral(double t)
{
    return t == 0 ? 0 : t * log(fabs(t)) - t;
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
                                 .width = 2 * half / (double)n,
                                 .p.count = n + 2,
                                 .q.count = n + 1};
    for (size_t i = 0; i < n; i++) { /* Eq. (1) and (17) integrated */
        const double away = (double)i * solver->width, reach = solver->width / 2;
        solver->x[i] = ((double)i + 0.5) * solver->width - half;
        solver->influence[i] =
            compliance / PI * (logarithm_integral(away + reach) - logarithm_integral(away - reach));
    }
    for (size_t i = 0; i < UNKNOWNS_MAX; i++) {
        solver->p.lowest[i] = solver->q.lowest[i] = -HUGE_VAL;
        solver->p.highest[i] = i < n ? 0 : HUGE_VAL;
        solver->q.highest[i] = HUGE_VAL;
    }
}

/* ---- Tractions between bounds ---- */

/* What the unknown j does at element i, or to the sum i. */
static double coefficient(const boundary_element *s, size_t i, size_t j)
{
    if (i < s->n && j < s->n)
        return s->influence[i > j ? i - j : j - i];
    const size_t least = i < j ? i : j, most = i < j ? j : i;
    if (least >= s->n) /* both are unknowns of the pad, which has no place there */
        return 0;
    const double lever = most == s->n ? 1 : s->x[least];
    return i < s->n ? -lever : lever;
}

/* The displacement at element i less the wanted one. */
static double excess(const boundary_element *s, const unknowns *u, size_t i)
{
    double sum = -u->wanted[i];
    for (size_t j = 0; j < u->count; j++)
        sum += coefficient(s, i, j) * u->value[j];
    return sum;
}

/* Those that are free, the others at their bounds. */
static void solve_free(const boundary_element *s, unknowns *u)
{
    size_t free[UNKNOWNS_MAX], m = 0;
    for (size_t i = 0; i < u->count; i++) {
        u->value[i] = u->at[i] == FREE ? 0 : u->at[i] == LOWEST ? u->lowest[i] : u->highest[i];
        if (u->at[i] == FREE)
            free[m++] = i;
    }
    if (m == 0) /* all slides */
        return;
    gsl_matrix *matrix = gsl_matrix_alloc(m, m);
    gsl_vector *right = gsl_vector_alloc(m);
    gsl_permutation *order = gsl_permutation_alloc(m);
    int sign;
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < m; j++)
            gsl_matrix_set(matrix, i, j, coefficient(s, free[i], free[j]));
        gsl_vector_set(right, i, -excess(s, u, free[i]));
    }
    gsl_linalg_LU_decomp(matrix, order, &sign);
    gsl_linalg_LU_svx(matrix, order, right);
    for (size_t i = 0; i < m; i++)
        u->value[free[i]] = gsl_vector_get(right, i);
    gsl_matrix_free(matrix);
    gsl_vector_free(right);
    gsl_permutation_free(order);
}

/* Free, or at which bound, after this solution. */
static bound bound_after(const boundary_element *s, const unknowns *u, size_t i)
{
    const double noise = 1 + 1e-12;
    if (u->lowest[i] == u->highest[i])
        return HIGHEST;
    if (u->at[i] == HIGHEST)
        return excess(s, u, i) >= 0 ? HIGHEST : FREE;
    if (u->at[i] == LOWEST)
        return excess(s, u, i) <= 0 ? LOWEST : FREE;
    return u->value[i] > u->highest[i] * noise  ? HIGHEST
           : u->value[i] < u->lowest[i] * noise ? LOWEST
                                                : FREE;
}

/* Whether it came to an end. */
static bool solve(const boundary_element *s, unknowns *u)
{
    bool is_solved = false;
    for (int iteration = 0; iteration < ITERATIONS_MAX && !is_solved; iteration++) {
        solve_free(s, u);
        is_solved = true;
        for (size_t i = 0; i < u->count; i++) {
            const bound before = u->at[i];
            u->at[i] = bound_after(s, u, i);
            is_solved = is_solved && u->at[i] == before;
        }
    }
    return is_solved;
}

/* ---- The contact ---- */

/* What the tractions up to the middle of element i carry: the other displacement of unlike bodies
 * is that times A B. */
static double carried(const boundary_element *s, const unknowns *u, size_t i)
{
    double sum = u->value[i] / 2;
    for (size_t j = 0; j < i; j++)
        sum += u->value[j];
    return sum * s->width;
}

/* Under P and M: no element is pulled, and none outside overlaps. */
static bool press(boundary_element *s, rw_loads to)
{
    for (size_t i = 0; i < s->n; i++)
        s->p.wanted[i] = -profile(s, s->x[i]) + s->A * s->B * carried(s, &s->q, i);
    s->p.wanted[s->n] = -to.P / s->width;
    s->p.wanted[s->n + 1] = -to.M / s->width;
    return solve(s, &s->p);
}

/* Under Q and sigma, by Coulomb's law: at first all that is in contact sticks. */
static bool drag(boundary_element *s, rw_loads to)
{
    for (size_t i = 0; i < s->n; i++) {
        s->q.highest[i] = -s->f * s->p.value[i];
        s->q.lowest[i] = -s->q.highest[i];
        s->q.wanted[i] =
            s->displacement[i] - s->A * to.sigma / 4 * s->x[i] - s->A * s->B * carried(s, &s->p, i);
        if (s->is_driven)
            s->q.wanted[i] += s->driven_to;
        s->q.at[i] = s->p.value[i] < 0 ? FREE : HIGHEST;
    }
    s->q.wanted[s->n] = -to.Q / s->width;
    return solve(s, &s->q);
}

/* In turn, until the shear stays: the mean change is a share of friction. */
static bool press_and_drag(boundary_element *s, rw_loads to)
{
    enum { PASSES_MAX = 60 };
    const double CLOSE = 1e-7;
    double changed = HUGE_VAL;
    for (int pass = 0; pass < PASSES_MAX && changed > CLOSE * s->f * to.P; pass++) {
        double before[BOUNDARY_ELEMENTS_MAX];
        for (size_t i = 0; i < s->n; i++)
            before[i] = s->q.value[i];
        if (!press(s, to) || !drag(s, to))
            return false;
        changed = 0;
        for (size_t i = 0; i < s->n && s->B != 0; i++)
            changed += s->width * fabs(s->q.value[i] - before[i]);
    }
    return changed <= CLOSE * s->f * to.P;
}

static bool take_step(boundary_element *s, rw_loads to)
{
    for (size_t i = 0; i < s->n; i++)
        s->q_before[i] = s->q.value[i];
    if (!press_and_drag(s, to))
        return false;
    for (size_t i = 0; i < s->n; i++) {
        const double moved = excess(s, &s->q, i);
        const bool touches = s->p.value[i] < 0;
        s->energy += touches ? s->width * moved * (s->q_before[i] + s->q.value[i]) / 2 : 0;
        s->slip[i] = touches ? s->slip[i] + moved : 0;
        s->displacement[i] += moved;
    }
    s->loads = to;
    return true;
}

int boundary_element_go(boundary_element *solver, int steps, rw_loads to)
{
    const rw_loads from = solver->loads;
    bool done = true;
    for (int i = 1; i <= steps && done; i++)
        done = take_step(solver, rw_loads_between(from, to, (double)i / steps));
    return !done;
}

/* ---- A rig ---- */

/* The displacement is the rigid one, and less by a share of Q: the half-width's, and what the rig
 * gives way. Under a given P it does not matter to the pressure. */
void boundary_element_hold(boundary_element *s, double b, double compliance)
{
    for (size_t i = 0; i < s->n; i++)
        s->influence[i] -= s->width * (s->A / PI * log(b / 2) + compliance);
    s->is_driven = true;
    s->q.count = s->n;
}

int boundary_element_drive(boundary_element *s, int steps, rw_loads to, double displacement)
{
    const rw_loads from = s->loads;
    const double start = s->driven_to;
    bool done = true;
    for (int i = 1; i <= steps && done; i++) {
        const double part = (double)i / steps;
        s->driven_to = start + (displacement - start) * part;
        done = take_step(s, rw_loads_between(from, to, part));
    }
    return !done;
}

double boundary_element_force(const boundary_element *s)
{
    double sum = 0;
    for (size_t i = 0; i < s->n; i++)
        sum -= s->width * s->q.value[i];
    return sum;
}

/* ---- Wear ---- */

/* Under P and a held tilt. */
static bool press_held(boundary_element *s, double P, double tilt)
{
    s->p.count = s->n + 1;
    for (size_t i = 0; i < s->n; i++)
        s->p.wanted[i] = tilt * s->x[i] - profile(s, s->x[i]) - s->worn[i];
    s->p.wanted[s->n] = -P / s->width;
    return solve(s, &s->p);
}

/* From one extreme of Q to the other all that slips changes its shear by twice the friction. */
static bool drag_back(boundary_element *s, double Q_a)
{
    for (size_t i = 0; i < s->n; i++) {
        s->q.highest[i] = -2 * s->f * s->p.value[i];
        s->q.lowest[i] = -s->q.highest[i];
        s->q.wanted[i] = 0;
        s->q.at[i] = s->p.value[i] < 0 ? FREE : HIGHEST;
    }
    s->q.wanted[s->n] = -2 * Q_a / s->width;
    return solve(s, &s->q);
}

/* Wears by a cycle, there and back; what the deepest place gains. */
static double wear_once(boundary_element *s, double rate)
{
    double most = 0;
    for (size_t i = 0; i < s->n; i++) {
        const double gained = -rate * s->p.value[i] * 2 * fabs(excess(s, &s->q, i));
        s->worn[i] += gained;
        most = fmax(most, gained);
    }
    return most;
}

int boundary_element_wear(boundary_element *s, double P, double tilt, double Q_a, double rate)
{
    enum { CYCLES_MAX = 2000 };
    const double END = 1e-4; /* of what the first cycle wears */
    double first = 0;
    for (int cycle = 0; cycle < CYCLES_MAX; cycle++) {
        if (!press_held(s, P, tilt) || !drag_back(s, Q_a))
            return 1;
        const double gained = wear_once(s, rate);
        first = cycle == 0 ? gained : first;
        if (gained < END * first)
            return 0;
    }
    return 1;
}

/* ---- Beside the library ---- */

/* Where slip jumps: what is beyond has come into contact since. */
static bool is_at_a_jump(const rwedge_contact *contact, const boundary_element *solver, double x)
{
    return fabs(x - contact->slip.settled.left) < solver->width ||
           fabs(x - contact->slip.settled.right) < solver->width;
}

/* What has been in contact since the first leg, if a load was computed. What comes later touches as
 * an element, not as a place. */
static rw_patch lasting(const rwedge_contact *contact, difference *sum)
{
    const rw_patch now = edges_of(contact), before = sum->legs == 0 ? now : sum->lasting;
    sum->lasting = (rw_patch){fmax(before.left, now.left), fmin(before.right, now.right)};
    return contact->computed.now ? sum->lasting : now;
}

void add_difference(const rwedge_contact *contact, const boundary_element *solver, double f,
                    difference *sum)
{
    double off[2] = {0}, slip[2] = {0}, limit = 0;
    const rw_patch part = lasting(contact, sum);
    size_t number[2] = {0};
    for (size_t i = 0; i < solver->n; i++) {
        const double x = solver->x[i];
        off[0] += fabs(pressure(contact, x) - solver->p.value[i]);
        off[1] += fabs(shear(contact, x) - solver->q.value[i]);
        limit += fabs(pressure(contact, x));
        double slipped; /* there may be no closed form of it */
        if (solver->p.value[i] < 0 && !is_at_a_jump(contact, solver, x) &&
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

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A history of P, M, Q and bulk tension as tests and joints have it, computed where there is no
 * closed form. Each load is done or it does not converge. One that is done leaves a shear that is
 * finite and within friction; one that is not leaves the contact as it was, to the last number.
 *
 * Uniform bytes are realistic loads at random. theta = A = a = 1, f = 0.1 to 1; the mean P is 0.2
 * to 20, in the logarithm: a/b from 0.1 to 3. Then there are four kinds of history, of up to 24
 * loads after the first one, which is P and M alone:
 *   steps under constant P and M; steps of P too, by a tenth; steps of P and M, by P b/10;
 *   a log: Q and tension swing, one after the other, and all four scatter by up to 3 %.
 * |Q| is up to 0.95 f P, in every sixteenth load f P; |sigma| up to 4 f P/(pi b). */
#include "input.h"
#include "rwedge.h"

#include <time.h>

/* What the loads have come to so far. */
static struct {
    long loads, computed, unsolved;
    double slowest, worst; /* load, in seconds of the processor; error that was told */
} tally;

enum { LOADS_MAX = 24, POINTS = 41, LOG = 3 };
static const double PI = 3.14159265358979323846;

typedef struct {
    double P, M, Q, sigma;
} loads;

typedef struct {
    uint8_t kind;
    double f, tolerance, swing, lag, scatter; /* swing: of Q over f P */
    loads first;
    double b; /* under the first load */
} history;

typedef struct {
    size_t count;
    double *number;
} snapshot;

static double take_signed(input *in)
{
    return 2 * take_fraction(in) - 1;
}

static snapshot take_snapshot(const rwedge_contact *contact)
{
    const size_t n = rwedge_contact_state_size(contact);
    snapshot s = {n, malloc(n * sizeof *s.number)};
    CLAIM(s.number && rwedge_contact_state(contact, n, s.number) == RWEDGE_OK, "a state");
    return s;
}

static bool has_changed(const snapshot *before, const rwedge_contact *contact)
{
    snapshot now = take_snapshot(contact);
    const bool is_same = now.count == before->count &&
                         memcmp(now.number, before->number, now.count * sizeof *now.number) == 0;
    free(now.number);
    return !is_same;
}

static history take_history(input *in)
{
    const uint8_t kind = take_byte(in);
    history h = {.kind = kind % 4, .tolerance = kind & 4 ? 1e-3 : 1e-4};
    h.f = 0.1 + 0.9 * take_fraction(in);
    h.first.P = 0.2 * pow(100, take_fraction(in));
    h.swing = 0.95 * take_fraction(in);
    h.lag = PI * take_fraction(in);
    h.scatter = 0.03 * take_fraction(in);
    return h;
}

static loads take_loads(input *in, const history *h, int number)
{
    const double reach = 4 * h->f * h->first.P / (PI * h->b), turn = 2 * PI * number / 16;
    loads to = h->first;
    if (h->kind == LOG) {
        to.P *= 1 + h->scatter * take_signed(in);
        to.M += h->scatter * h->first.P * h->b * take_signed(in);
        to.Q = h->swing * h->f * h->first.P * (sin(turn) + h->scatter * take_signed(in));
        to.sigma = h->swing * reach * (sin(turn - h->lag) + h->scatter * take_signed(in));
        return to;
    }
    if (h->kind > 0)
        to.P *= 1 + 0.1 * take_signed(in);
    if (h->kind > 1)
        to.M += 0.1 * h->first.P * h->b * take_signed(in);
    to.Q = take_byte(in) < 16 ? h->f * to.P : 0.95 * h->f * to.P * take_signed(in);
    to.sigma = reach * take_signed(in);
    return to;
}

static void check(const rwedge_contact *contact, double f)
{
    double left, right, x[POINTS], p[POINTS], q[POINTS], slip[POINTS], peak = 0;
    const double error = rwedge_contact_error(contact);
    CLAIM(isfinite(error) && error >= 0, "error %g", error);
    CLAIM(rwedge_contact_edges(contact, &left, &right) == RWEDGE_OK, "edges");
    for (int i = 0; i < POINTS; i++)
        x[i] = (left + right) / 2 - (right - left) / 2 * cos(PI * (i + 0.5) / POINTS);
    CLAIM(rwedge_contact_tractions(contact, POINTS, x, p, q) == RWEDGE_OK, "tractions");
    for (int i = 0; i < POINTS; i++)
        peak = fmax(peak, -p[i]);
    for (int i = 0; i < POINTS; i++)
        CLAIM(isfinite(q[i]) && fabs(q[i]) <= f * (-p[i] + (error + 1e-12) * peak),
              "x %.17g: q %g, f p %g, peak %g, error %g", x[i], q[i], f * p[i], f * peak, error);
    if (error > 0 && rwedge_contact_slip(contact, POINTS, x, slip) == RWEDGE_OK)
        for (int i = 0; i < POINTS; i++)
            CLAIM(isfinite(slip[i]), "slip %g", slip[i]);
}

/* Whether the load was done. */
static bool go(rwedge_contact *contact, const history *h, loads to)
{
    snapshot before = take_snapshot(contact);
    const double energy = rwedge_contact_dissipated_energy(contact);
    const clock_t start = clock();
    const int32_t status = rwedge_contact_apply(contact, to.P, to.M, to.Q, to.sigma);
    tally.slowest = fmax(tally.slowest, (double)(clock() - start) / CLOCKS_PER_SEC);
    CLAIM(status == RWEDGE_OK || status == RWEDGE_ENOCONV, "P %.17g M %.17g Q %.17g: %d", to.P,
          to.M, to.Q, (int)status);
    CLAIM(status == RWEDGE_OK || !has_changed(&before, contact), "a refused load changed it");
    free(before.number);
    tally.loads++;
    tally.unsolved += status != RWEDGE_OK;
    if (status != RWEDGE_OK)
        return false;
    check(contact, h->f);
    const double after = rwedge_contact_dissipated_energy(contact);
    CLAIM(!(after < energy) && !isinf(after), "the energy goes from %g to %g", energy, after);
    tally.computed += rwedge_contact_error(contact) > 0;
    tally.worst = fmax(tally.worst, rwedge_contact_error(contact));
    return true;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    rwedge_contact *contact = NULL;
    history h = take_history(&in);
    CLAIM(rwedge_contact_create(1, 1, 1, h.f, &contact) == RWEDGE_OK, "create");
    CLAIM(rwedge_contact_allow_error(contact, h.tolerance) == RWEDGE_OK, "allow_error");
    h.b = rwedge_half_width(1, 1, 1, h.first.P);
    h.first.M = 0.2 * h.first.P * h.b * take_signed(&in);
    if (go(contact, &h, h.first))
        for (int i = 1; i <= LOADS_MAX && in.left > 0; i++)
            go(contact, &h, take_loads(&in, &h, i));
    rwedge_contact_destroy(contact);
    return 0;
}

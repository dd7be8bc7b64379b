/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any history of loads leaves a contact that is possible. Its friction is never exceeded, its
 * energy never falls, a refused load changes nothing, a copy is the same, and the tractions add up
 * to the loads. */
#include "input.h"
#include "rwedge.h"

#include <float.h>

enum { LOADS_MAX = 24, POINTS = 5 };

/* All that is asked of a contact. */
typedef struct {
    double half_width, stick, energy, memory;
    double p[POINTS], q[POINTS], slip[POINTS], sxx[POINTS], syy[POINTS], txy[POINTS];
} appearance;

typedef struct {
    double theta, a, A, f, P, Q;
    rwedge_contact *contact;
} subject;

static appearance look(const subject *s)
{
    appearance seen;
    double x[POINTS], y[POINTS];
    memset(&seen, 0, sizeof seen);
    const double b = seen.half_width = rwedge_contact_half_width(s->contact);
    seen.stick = rwedge_contact_stick_half_width(s->contact);
    seen.energy = rwedge_contact_dissipated_energy(s->contact);
    seen.memory = (double)rwedge_contact_memory(s->contact);
    if (b > 0 && b < 1e-57) /* the points would leave the domain */
        return seen;
    for (int i = 0; i < POINTS; i++) {
        x[i] = b * (0.49 * i - 0.97);
        y[i] = b * (i % 3 * 0.4);
    }
    int32_t status = rwedge_contact_tractions(s->contact, POINTS, x, seen.p, seen.q);
    CLAIM(status == RWEDGE_OK, "tractions: %d", (int)status);
    status = rwedge_contact_slip(s->contact, POINTS, x, seen.slip);
    CLAIM(status == RWEDGE_OK, "slip: %d", (int)status);
    status = rwedge_contact_stresses(s->contact, POINTS, x, y, seen.sxx, seen.syy, seen.txy);
    CLAIM(status == RWEDGE_OK, "stresses: %d", (int)status);
    return seen;
}

static void check(const subject *s, const appearance *now)
{
    const double unit = s->theta / s->A;
    CLAIM(now->stick >= 0 && now->stick <= now->half_width, "c %g, b %g", now->stick,
          now->half_width);
    CLAIM(isfinite(now->energy) && now->energy >= 0, "%g", now->energy);
    CLAIM((s->P == 0) == (now->memory == 0) && (s->P == 0) == (now->half_width == 0),
          "P %g, memory %g", s->P, now->memory);
    for (int i = 0; i < POINTS; i++) {
        CLAIM(isfinite(now->p[i]) && now->p[i] <= 0, "p %g", now->p[i]);
        CLAIM(fabs(now->q[i]) <= s->f * (fabs(now->p[i]) * (1 + 1e-12) + unit * 1e-12),
              "q %g, p %g, f %g", now->q[i], now->p[i], s->f);
        CLAIM(isfinite(now->slip[i]), "slip %g", now->slip[i]);
        CLAIM(isfinite(now->sxx[i]) && isfinite(now->syy[i]) && isfinite(now->txy[i]), "P %g, Q %g",
              s->P, s->Q);
    }
    /* on the surface the stresses are the tractions */
    CLAIM(fabs(now->syy[0] - now->p[0]) <= 1e-11 * (1 + s->f) * (unit + fabs(now->p[0])),
          "syy %g, p %g", now->syy[0], now->p[0]);
}

/* P and Q are the integrals of the tractions: Chebyshev's rule, exact for Hertz, rough for the
 * corners of a history. */
static void check_balance(const subject *s)
{
    enum { N = 200 };
    double P = 0, Q = 0;
    const double b = rwedge_contact_half_width(s->contact);
    for (int i = 0; i < N; i++) {
        const double t = (i + 0.5) * 3.14159265358979323846 / N, x = b * cos(t);
        double p, q;
        const int32_t status = rwedge_contact_tractions(s->contact, 1, &x, &p, &q);
        CLAIM(status == RWEDGE_OK, "%d", (int)status);
        P -= p * sin(t) * (b * 3.14159265358979323846 / N);
        Q -= q * sin(t) * (b * 3.14159265358979323846 / N);
    }
    CLAIM(fabs(P - s->P) <= 0.05 * s->P, "P %.17g, integral %.17g", s->P, P);
    CLAIM(fabs(fabs(Q) - fabs(s->Q)) <= 0.1 * s->f * s->P, "Q %.17g, integral %.17g", s->Q, Q);
}

static void check_copy(subject *s, const appearance *now)
{
    rwedge_contact *copy = NULL;
    CLAIM(rwedge_contact_copy(s->contact, &copy) == RWEDGE_OK, "copy");
    rwedge_contact_destroy(s->contact);
    s->contact = copy;
    const appearance again = look(s);
    CLAIM(memcmp(now, &again, sizeof again) == 0, "a copy differs");
}

static void check_yield(const subject *s, input *in)
{
    const double nu = take_fraction(in) / 2, k = s->theta / s->A;
    double factor = -1, x = -1, y = -1;
    const int32_t status = rwedge_contact_yield_factor(s->contact, nu, k, &factor, &x, &y);
    if (s->P == 0)
        CLAIM(status == RWEDGE_EABSENT && factor == -1, "%d", (int)status);
    else
        CLAIM((status == RWEDGE_OK && isfinite(factor) && factor >= 0 && isfinite(x) && y >= 0) ||
                  status == RWEDGE_ERANGE,
              "%d", (int)status);
}

/* The next load, wild or tame. */
static void take_load(input *in, const subject *s, double *P, double *Q)
{
    const uint8_t choice = take_byte(in);
    *P =
        choice % 4 == 0 ? s->P : take_fraction(in) * (choice % 4 == 1 ? 1 : 1e-3) * s->theta / s->A;
    *Q = s->f * *P * (2 * take_fraction(in) - 1);
    if (choice >= 0xf0)
        *P = take_double(in);
    if (choice >= 0xe0)
        *Q = choice % 2 == 0 ? take_double(in) : s->f * *P * (choice % 3 == 0 ? 1 : -1);
}

static void go_on(subject *s, input *in, appearance *now)
{
    double P, Q;
    take_load(in, s, &P, &Q);
    const int32_t status = rwedge_contact_load(s->contact, P, Q);
    CLAIM(status == RWEDGE_OK || status == RWEDGE_ESLIDING || status == RWEDGE_ERANGE ||
              status == RWEDGE_EDOMAIN,
          "%d", (int)status);
    if (status == RWEDGE_OK) {
        s->P = P;
        s->Q = Q;
    }
    const appearance next = look(s);
    if (status != RWEDGE_OK)
        CLAIM(memcmp(now, &next, sizeof next) == 0, "a refused load changed the contact");
    CLAIM(next.energy >= now->energy, "the energy falls from %.17g to %.17g", now->energy,
          next.energy);
    check(s, &next);
    *now = next;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    const uint8_t kind = take_byte(&in);
    subject s = {.theta = 0.1, .A = 0.5};
    s.a = kind % 4 == 0 ? 0 : kind % 4 == 1 ? take_fraction(&in) * 1e-6 : take_fraction(&in) * 2;
    s.f = kind % 16 == 15 ? 0 : 1.5 * take_fraction(&in);
    const bool is_far_from_one = kind % 16 == 13;
    if (is_far_from_one) {
        s.theta = ldexp(s.theta, -take_byte(&in) / 4);
        s.A = ldexp(s.A, (take_byte(&in) - 128) / 2);
        s.a = ldexp(s.a, (take_byte(&in) - 128) / 2);
    }
    CLAIM(rwedge_contact_create(s.theta, s.a, s.A, s.f, &s.contact) == RWEDGE_OK, "create");
    appearance now = look(&s);
    for (int i = 0; i < LOADS_MAX && in.left > 0; i++) {
        go_on(&s, &in, &now);
        if (now.memory > 0 && kind >= 0x80)
            check_copy(&s, &now);
    }
    if (s.a > 1e-3 && s.P > 1e-6 && !is_far_from_one)
        check_balance(&s);
    if (kind % 32 == 31)
        check_yield(&s, &in);
    rwedge_contact_destroy(s.contact);
    return 0;
}

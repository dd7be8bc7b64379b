/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Edges of contacts of a flat pad with rounded edges, of a worn profile of 20 arcs and of an
 * asymmetric one: sums over the arcs, each of them a wedge's rounding, and Krawczyk's operator.
 * tests/lib/contact/test_pads.c compares all else with the wedge's. */
#include <vector>

#include "rows/eccentric.hpp"

namespace
{

/* ---- Profiles ---- */

enum { PAD_KIND, SEED, PAD_LOAD, PAD_MOMENT };
enum { FLAT, WORN, ASYMMETRIC, KINDS };

/* In units of A = 1. */
struct profile {
    double a, R;                  /* of a flat pad; its reach is a + R */
    double left, right;           /* a patch that shows what is special */
    std::vector<double> x, slope; /* of any other */
};

/* Edges from far beyond the flat's corners to 1e-9 beyond them. */
void draw_flat(probe *own, profile *p)
{
    p->a = log_between(own, 1e-3, 1e3);
    p->right = p->a / (1 - log_between(own, 1e-9, 0.99));
    p->left = -p->right;
    p->R = p->right * log_between(own, 1, 1e3);
}

/* Slopes that rise in every arc, in some only a little. */
void draw_slopes(probe *own, size_t n, profile *p)
{
    double x = -1, slope = -0.05 * uniform(own) - 0.01;
    for (size_t i = 0; i < n; i++) {
        p->x.push_back(x);
        p->slope.push_back(slope);
        x += (1 + 9 * uniform(own)) / 5.5 * 2 / (double)n;
        slope += 0.2 / (double)n * log_between(own, 1e-2, 1);
    }
    const size_t i = (size_t)(uniform(own) * (double)(n - 1));
    p->left = chance(own, 0.3) ? p->x[i] : between(own, p->x[0], p->x[n - 1]);
    p->right = p->left + log_between(own, 1e-3, 2);
}

void mirror(profile *p)
{
    const size_t n = p->x.size();
    for (size_t i = 0; i < n / 2; i++) {
        p->x[n - 1 - i] = -p->x[i];
        p->slope[n - 1 - i] = -p->slope[i];
    }
    p->x[n / 2] = p->slope[n / 2] = 0;
}

profile profile_of(const double v[])
{
    profile p = {};
    probe own = {};
    own.random = (uint64_t)v[SEED];
    if (v[PAD_KIND] == FLAT)
        draw_flat(&own, &p);
    else
        draw_slopes(&own, v[PAD_KIND] == WORN ? 21 : 7, &p);
    if (v[PAD_KIND] == WORN)
        mirror(&p);
    return p;
}

/* ---- Arcs ---- */

struct arc {
    ball middle, half, weight;
};

std::vector<arc> arcs_of(const profile &p)
{
    if (p.x.empty()) {
        const ball half = ball(p.R) / 2, middle = half + p.a, weight = ball(1) / 2;
        return {{-middle, half, weight}, {middle, half, weight}};
    }
    std::vector<arc> arcs;
    const ball all = ball(p.slope.back()) - p.slope.front();
    for (size_t i = 1; i < p.x.size(); i++)
        arcs.push_back({(ball(p.x[i]) + p.x[i - 1]) / 2, (ball(p.x[i]) - p.x[i - 1]) / 2,
                        (ball(p.slope[i]) - p.slope[i - 1]) / all});
    return arcs;
}

/* Half of the angle between the outermost slopes; 1 of a flat pad. */
ball angle_of(const profile &p)
{
    return p.x.empty() ? 1 : (ball(p.slope.back()) - p.slope.front()) / 2;
}

carried carried_by(const std::vector<arc> &arcs, const ball_edges &e)
{
    const ball middle = (e.left + e.right) / 2;
    carried sum = {0, 0, 0, 0, 0, middle, (e.right - e.left) / 2};
    for (const arc &part : arcs) {
        const ball from = part.middle - part.half, to = part.middle + part.half;
        if (from >= e.right || to <= e.left) {
            sum.tilt += from >= e.right ? -part.weight : part.weight;
            continue;
        }
        const carried c = carried_by(part.half, {e.left - part.middle, e.right - part.middle});
        sum.P += part.weight * c.P;
        sum.M += part.weight * (c.M + part.middle * c.P);
        sum.tilt += part.weight * c.tilt;
        sum.u += part.weight * c.u;
        sum.v += part.weight * c.v;
    }
    return sum;
}

/* ---- What is drawn ---- */

/* kind, seed, P, M; false where the patch holds nothing. */
bool some_pad(probe *call, int kinds)
{
    argument(call, "kind", (int)(kinds * uniform(call)));
    argument(call, "seed", 1 + floor(1e9 * uniform(call)));
    const precision here(256);
    const profile p = profile_of(call->value);
    const carried c = carried_by(arcs_of(p), {p.left, p.right});
    const double unit = middle(angle_of(p));
    const double P = argument(call, "P", middle(c.P) * unit), M = middle(c.M) * unit;
    argument(call, "M", chance(call, 0.3) || call->value[PAD_KIND] == FLAT ? 0 : M);
    return P > 1e-30;
}

shared_contact pressed(const double v[])
{
    const profile p = profile_of(v);
    rwedge_contact *made = NULL;
    const int32_t status =
        p.x.empty()
            ? rwedge_contact_create_flat(p.a, p.R, 1, 0.5, &made)
            : rwedge_contact_create_profile(p.x.size(), p.x.data(), p.slope.data(), 1, 0.5, &made);
    const shared_contact contact = shared(made);
    return status == RWEDGE_OK &&
                   rwedge_contact_apply(made, v[PAD_LOAD], v[PAD_MOMENT], 0, 0) == RWEDGE_OK
               ? contact
               : NULL;
}

/* ---- Edges ---- */

template <int kinds> bool draw_edges(probe *call)
{
    const shared_contact contact = some_pad(call, kinds) ? pressed(call->value) : NULL;
    double *r = call->result;
    return contact && gives_if(call, rwedge_contact_edges(contact.get(), &r[0], &r[1])) &&
           gives_if(call, rwedge_contact_beyond_flat(contact.get(), &r[2], &r[3]));
}

ball_edges edges_near(const profile &p, const double v[], const double guess[2])
{
    const std::vector<arc> arcs = arcs_of(p);
    const ball theta = angle_of(p);
    return patch_carrying([&](const ball_edges &e) { return carried_by(arcs, e); },
                          v[PAD_LOAD] / theta, v[PAD_MOMENT] / theta, guess);
}

/* What a flat magnifies: the root of 1 - a/b. */
ball narrowness(const profile &p, const ball_edges &e)
{
    return p.x.empty() ? sqrt(1 - p.a / e.right) : ball(1);
}

ball judge_edges(const probe &call)
{
    const double *r = call.result;
    const profile p = profile_of(call.value);
    const ball_edges e = edges_near(p, call.value, r);
    const ball width = e.right - e.left, reach = max(width, max(abs(e.left), abs(e.right)));
    const carried c = carried_by(arcs_of(p), e);
    const ball flat = 1 - abs(c.tilt);
    const ball even = min(c.u, c.v) / max(c.u, c.v);
    return max(error_over(r[0], e.left, reach), error_over(r[1], e.right, reach)) * flat * even *
           narrowness(p, e);
}

ball judge_beyond_flat(const probe &call)
{
    const double *r = call.result;
    const profile p = profile_of(call.value);
    const double guess[2] = {-p.a - r[2], p.a + r[2]};
    const ball_edges e = edges_near(p, call.value, guess);
    return max(relative_error(r[2], -e.left - p.a), relative_error(r[3], e.right - p.a));
}

#define PADS "flat, a/b 0.01 to 1 - 1e-9; 20 worn arcs; 6 arcs, asymmetric"

} // namespace

const row PAD_ROWS[] = {
    {"contact_edges, of pads", PADS ", P and M; edges at places",
     "of the width or \\|x\\|, over 1 - \\|delta\\| and the root of 1 - a/b", 1e-14, "1e-14", 0.2,
     draw_edges<KINDS>, judge_edges},
    {"contact_beyond_flat", "flat, a/b 0.01 to 1 - 1e-9; P", "relative", 1e-14, "1e-14", 1,
     draw_edges<1>, judge_beyond_flat},
    {},
};

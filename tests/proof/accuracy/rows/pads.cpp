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
struct pad {
    double a, R;                  /* of a flat pad; its reach is a + R */
    double left, right;           /* a patch that shows what is special */
    std::vector<double> x, slope; /* of any other */
};

/* Edges from far beyond the flat's corners to 1e-9 beyond them. */
void draw_flat(probe *own, pad *p)
{
    p->a = log_between(own, 1e-3, 1e3);
    p->right = p->a / (1 - log_between(own, 1e-9, 0.99));
    p->left = -p->right;
    p->R = p->right * log_between(own, 1, 1e3);
}

/* Slopes that rise in every arc, in some only a little. */
void draw_slopes(probe *own, size_t n, pad *p)
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

void mirror(pad *p)
{
    const size_t n = p->x.size();
    for (size_t i = 0; i < n / 2; i++) {
        p->x[n - 1 - i] = -p->x[i];
        p->slope[n - 1 - i] = -p->slope[i];
    }
    p->x[n / 2] = p->slope[n / 2] = 0;
}

pad pad_of(const double v[])
{
    pad p = {};
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

profile arcs_of(const pad &p)
{
    if (p.x.empty()) {
        const ball half = ball(p.R) / 2, middle = half + p.a, weight = ball(1) / 2;
        return {{-middle, half, weight}, {middle, half, weight}};
    }
    profile arcs;
    const ball all = ball(p.slope.back()) - p.slope.front();
    for (size_t i = 1; i < p.x.size(); i++)
        arcs.push_back({(ball(p.x[i]) + p.x[i - 1]) / 2, (ball(p.x[i]) - p.x[i - 1]) / 2,
                        (ball(p.slope[i]) - p.slope[i - 1]) / all});
    return arcs;
}

/* Half of the angle between the outermost slopes; 1 of a flat pad. */
ball angle_of(const pad &p)
{
    return p.x.empty() ? 1 : (ball(p.slope.back()) - p.slope.front()) / 2;
}

/* ---- What is drawn ---- */

/* kind, seed, P, M; false where the patch holds nothing. */
bool some_pad(probe *call, int kinds)
{
    argument(call, "kind", (int)(kinds * uniform(call)));
    argument(call, "seed", 1 + floor(1e9 * uniform(call)));
    const precision here(256);
    const pad p = pad_of(call->value);
    const carried c = carried_by(arcs_of(p), {p.left, p.right});
    const double unit = middle(angle_of(p));
    const double P = argument(call, "P", middle(c.P) * unit), M = middle(c.M) * unit;
    argument(call, "M", chance(call, 0.3) || call->value[PAD_KIND] == FLAT ? 0 : M);
    return P > 1e-30;
}

shared_contact pressed(const double v[])
{
    const pad p = pad_of(v);
    rwedge_contact *made = NULL;
    const int32_t status =
        p.x.empty()
            ? rwedge_contact_create_flat(p.a, p.R, 1, 0.5, &made)
            : rwedge_contact_create_profile(p.x.size(), p.x.data(), p.slope.data(), 1, 0.5, &made);
    return pressed(status, made, v[PAD_LOAD], v[PAD_MOMENT]);
}

/* ---- Edges ---- */

template <int kinds> bool draw_edges(probe *call)
{
    const shared_contact contact = some_pad(call, kinds) ? pressed(call->value) : NULL;
    double *r = call->result;
    return contact && gives(call, rwedge_contact_edges(contact.get(), &r[0], &r[1])) &&
           gives(call, rwedge_contact_beyond_flat(contact.get(), &r[2], &r[3]));
}

ball_edges edges_near(const pad &p, const double v[], const double guess[2])
{
    const ball theta = angle_of(p);
    return patch_carrying(arcs_of(p), v[PAD_LOAD] / theta, &carried::M, v[PAD_MOMENT] / theta,
                          guess);
}

/* What a flat magnifies: the root of 1 - a/b. */
ball narrowness(const pad &p, const ball_edges &e)
{
    return p.x.empty() ? sqrt(1 - p.a / e.right) : ball(1);
}

ball judge_edges(const probe &call)
{
    const double *r = call.result;
    const pad p = pad_of(call.value);
    const ball_edges e = edges_near(p, call.value, r);
    const carried c = carried_by(arcs_of(p), e);
    const ball even = min(c.u, c.v) / max(c.u, c.v);
    return edges_error(r, e, reach_of(e)) * flatness(c.tilt) * even * narrowness(p, e);
}

ball judge_beyond_flat(const probe &call)
{
    const double *r = call.result;
    const pad p = pad_of(call.value);
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

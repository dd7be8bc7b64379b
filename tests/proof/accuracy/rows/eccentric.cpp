/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts with a moment and a bulk tension: edges, tilt, stick zones. A patch is drawn first, and
 * its load and moment from it, so that its edges can be put next to the ends of the rounding. Then
 * the patch of the rounded load and moment is enclosed. */
#include <math.h>

#include "references/root.hpp"
#include "rows/eccentric.hpp"
#include "rows/rows.hpp"

namespace
{

/* Angle, sine and cosine of an end of the rounding as the patch sees it. */
struct patch_end {
    ball phi, sine, cosine;
};

patch_end end_of(const ball &at, const ball_edges &e, const ball &half)
{
    const ball from_left = min(max((at - e.left) / half, 0), 2),
               to_right = min(max((e.right - at) / half, 0), 2);
    const ball sine = (from_left - to_right) / 2, cosine = sqrt(from_left * to_right);
    return {atan2(sine, cosine), sine, cosine};
}

carried carried_by_sharp(const ball_edges &e)
{
    const ball root = sqrt(-e.left * e.right), middle = (e.left + e.right) / 2;
    return {2 * root,       middle * root, 2 / pi() * atan2(middle, root), -e.left / root,
            e.right / root, middle,        (e.right - e.left) / 2};
}

/* By one arc, around 0. */
carried carried_by(const ball &a, const ball_edges &e)
{
    if (is_zero(a))
        return carried_by_sharp(e);
    const ball middle = (e.left + e.right) / 2, s = (e.right - e.left) / 2;
    const patch_end first = end_of(-a, e, s), last = end_of(a, e, s);
    const ball phi = last.phi - first.phi, cosines = last.cosine - first.cosine;
    const ball P = sqr(s) / (2 * a) * (phi + last.sine * last.cosine - first.sine * first.cosine);
    const ball M = middle * P + cube(s) / (6 * a) * (cube(first.cosine) - cube(last.cosine));
    const ball beyond = max(a - e.right, 0) - max(e.left + a, 0);
    const ball tilt =
        -(s * (last.phi * last.sine - first.phi * first.sine + cosines) + pi() / 2 * beyond) /
        (pi() * a);
    return {P, M, tilt, s / (2 * a) * (phi - cosines), s / (2 * a) * (phi + cosines), middle, s};
}

/* What the edges carry too much, and how that changes with them: dM = m dP + (pi s^2/2) d delta. */
residual excess_at(const carried &c, const ball &P, ball carried::*other, const ball &much)
{
    const column F = {c.P - P, c.*other - much};
    if (other == &carried::M)
        return {F,
                {-c.v, c.u, c.half * c.v / 2 - c.middle * c.v, c.half * c.u / 2 + c.middle * c.u}};
    return {F, {-c.v, c.u, c.v / (pi() * c.half), c.u / (pi() * c.half)}};
}

} // namespace

/* An arc beyond an edge only tilts. */
carried carried_by(const profile &arcs, const ball_edges &e)
{
    carried sum = {0, 0, 0, 0, 0, (e.left + e.right) / 2, (e.right - e.left) / 2};
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

ball_edges patch_carrying(const profile &arcs, const ball &P, ball carried::*other,
                          const ball &much, const double guess[2])
{
    const auto excess = [&](const column &e) {
        return excess_at(carried_by(arcs, {e.x, e.y}), P, other, much);
    };
    const column e = find_zero(column{guess[0], guess[1]}, guess[1] - guess[0], excess);
    return {e.x, e.y};
}

ball flatness(const ball &tilt)
{
    return 1 - abs(tilt);
}

ball reach_of(const ball_edges &e)
{
    return max(e.right - e.left, max(abs(e.left), abs(e.right)));
}

ball edges_error(const double answer[2], const ball_edges &e, const ball &scale)
{
    return max(error_over(answer[0], e.left, scale), error_over(answer[1], e.right, scale));
}

shared_contact pressed(int32_t status, rwedge_contact *created, double P, double M)
{
    const shared_contact contact = shared(created);
    return status == RWEDGE_OK && rwedge_contact_apply(created, P, M, 0, 0) == RWEDGE_OK ? contact
                                                                                         : NULL;
}

namespace
{

/* ---- What is drawn ---- */

/* A patch that holds a part of the rounding, in a; in 1 where that is 0. */
void some_patch(probe *call, bool is_sharp, double *left, double *right)
{
    const double kind = uniform(call), tiny = log_between(call, 1e-15, 1);
    if (is_sharp) {
        *right = 1;
        *left = kind < 0.5 ? -uniform(call) : kind < 0.7 ? -tiny : tiny / 4 - 1;
    } else if (kind < 0.3) { /* no larger than the rounding, s tiny too */
        const double half = chance(call, 0.5) ? tiny / 2 : uniform(call) / 2;
        const double middle = (1 - half) * (2 * uniform(call) - 1);
        *left = middle - half;
        *right = middle + half;
    } else if (kind < 0.45) { /* right edge next to an end */
        *right = near(call, 1);
        *left = *right - log_between(call, 1e-3, 10);
    } else if (kind < 0.6) { /* left edge next to the other */
        *left = near(call, -1);
        *right = 1 + log_between(call, 1e-6, 10);
    } else if (kind < 0.75) { /* |delta| near 1 */
        *left = 1 - log_between(call, 1e-4, 1);
        *right = 1 + log_between(call, 1e-2, 1e3);
    } else if (kind < 0.9) { /* nearly centred */
        *right = log_between(call, 0.1, 1e3);
        *left = -*right * (1 - tiny);
    } else {
        *left = -log_between(call, 1e-2, 1e3);
        *right = log_between(call, 1e-2, 1e3);
    }
    if (chance(call, 0.5)) {
        const double mirrored = -*left;
        *left = -*right;
        *right = mirrored;
    }
}

/* theta, a, A, P, M of a contact; false where they leave the domain. */
bool some_pressing(probe *call)
{
    const double theta = argument(call, "theta", log_between(call, 1e-4, 1.5));
    const bool is_sharp = chance(call, 0.05);
    const double unit = log_between(call, 1e-3, 1e3);
    const double a = argument(call, "a", is_sharp ? 0 : unit);
    const double A = argument(call, "A", log_between(call, 1e-6, 1e2));
    double left, right;
    some_patch(call, is_sharp, &left, &right);
    if (!(left < right) || left >= (is_sharp ? 0 : 1) || right <= (is_sharp ? 0 : -1))
        return false;
    const precision here(256);
    const carried c = carried_by(wedge(a), {left * unit, right * unit});
    const double P = middle(c.P) * (theta / A), M = middle(c.M) * (theta / A);
    argument(call, "P", P);
    argument(call, "M", fabs(M) < 1e-40 ? 0 : M);
    return P > 1e-40;
}

shared_contact pressed(const probe *call, double f, double P, double M)
{
    const double *v = call->value;
    rwedge_contact *made = NULL;
    const int32_t status = rwedge_contact_create(v[THETA], v[ROUNDING], v[COMPLIANCE], f, &made);
    return pressed(status, made, P, M);
}

shared_contact pressed(const probe *call, double f)
{
    return pressed(call, f, call->value[LOAD], call->value[MOMENT]);
}

/* The contact's patch in balls, and what it carries; per_stress is A/theta. */
struct pressed_patch {
    carried c;
    ball_edges edges;
    ball a, per_stress;
};

pressed_patch ball_pressed(const double v[], double P, double M, const double guess[2])
{
    const ball a = v[ROUNDING], per_stress = ball(v[COMPLIANCE]) / v[THETA], load = P * per_stress;
    const ball_edges e = patch_carrying(wedge(a), load, &carried::M, M * per_stress, guess);
    carried c = carried_by(wedge(a), e);
    c.P = load; /* exactly */
    return {c, e, a, per_stress};
}

/* That of the call's first load; its edges as the library finds them are those results. */
pressed_patch ball_pressed(const probe &call, int left)
{
    const double *v = call.value;
    return ball_pressed(v, v[LOAD], v[MOMENT], call.result + left);
}

/* What |x| at the edges magnifies: the smaller of 1 and width/|x|, times 1 - |delta|. */
ball magnified(const ball &error, const pressed_patch &p)
{
    return error * (2 * p.c.half / reach_of(p.edges)) * flatness(p.c.tilt);
}

/* ---- Edges, tilt ---- */

bool draw_edges(probe *call)
{
    const shared_contact contact = some_pressing(call) ? pressed(call, 0.5) : NULL;
    if (!contact)
        return false;
    double *r = call->result;
    r[2] = rwedge_contact_tilt(contact.get());
    gives(call, rwedge_contact_edges(contact.get(), &r[0], &r[1]));
    return gives(call, rwedge_contact_edge_asymptotes(contact.get(), &r[3], &r[4], &r[5], &r[6]));
}

ball judge_edges(const probe &call)
{
    const pressed_patch p = ball_pressed(call, 0);
    return magnified(edges_error(call.result, p.edges, 2 * p.c.half), p);
}

ball judge_tilt(const probe &call)
{
    const pressed_patch p = ball_pressed(call, 0);
    const ball theta = call.value[THETA];
    return magnified(error_over(call.result[2], p.c.tilt * theta, theta), p);
}

/* K_N = (2/pi) (theta/A) sqrt(2/s) v at the left edge, with u at the right one; of the edges that
 * were found, because it changes like a root where an edge passes an end of the rounding. */
ball judge_asymptotes(const probe &call)
{
    const double *v = call.value, *r = call.result;
    const carried c = carried_by(wedge(v[ROUNDING]), {r[0], r[1]});
    const ball unit = 2 / pi() * v[THETA] / v[COMPLIANCE] * sqrt(2 / c.half);
    const ball scale = unit * max(c.u, c.v);
    return max(error_over(r[3], unit * c.v, scale), error_over(r[4], unit * c.u, scale));
}

/* ---- Stick zones ---- */

/* |T| = (|Q|/f A/theta, -+A sigma/(4 theta f)), the sign that of Q. */
struct tangential {
    ball load, tilt;
};

tangential tangential_of(const ball &per_stress, double f, const ball &Q, const ball &sigma)
{
    const ball unit = per_stress / f;
    return {abs(Q) * unit, (sign(Q) < 0 ? sigma : -sigma) * unit / 4};
}

ball_edges edges_of(const pressed_patch &whole, const tangential &sticking, const double guess[2])
{
    return patch_carrying(wedge(whole.a), sticking.load, &carried::tilt, sticking.tilt, guess);
}

/* Of the width of the contact, over 1 - |delta| of both, and the root of what sticks of P. */
ball front_error(const double answer[2], const ball_edges &e, const pressed_patch &whole,
                 const tangential &sticking)
{
    const ball flat = min(flatness(sticking.tilt), flatness(whole.c.tilt));
    return edges_error(answer, e, reach_of(whole.edges) / (flat * sqrt(sticking.load / whole.c.P)));
}

ball judge_stick_zone(const probe &call)
{
    const double *v = call.value;
    const pressed_patch whole = ball_pressed(call, 2);
    const tangential T = tangential_of(whole.per_stress, v[FRICTION], v[SHEAR], v[TENSION]);
    const tangential sticking = {whole.c.P - T.load, whole.c.tilt - T.tilt};
    return front_error(call.result, edges_of(whole, sticking, call.result), whole, sticking);
}

ball judge_tension_step(const probe &call)
{
    const pressed_patch p = ball_pressed(call, 2);
    const ball step = 4 * fabs(call.value[SHEAR]) / p.c.half / pi();
    return magnified(relative_error(call.result[4], step), p);
}

/* ---- What never slips ---- */

enum { SECOND_LOAD = FRICTION + 1, SECOND_MOMENT, Q1, Q2, S1, S2 };

bool draw_permanent(probe *call)
{
    if (!some_pressing(call))
        return false;
    const double *v = call->value, f = argument(call, "f", log_between(call, 0.01, 2));
    const double grown = chance(call, 0.5) ? 1 : between(call, 0.8, 1.25);
    const double P = argument(call, "P2", v[LOAD] * grown);
    const double M = argument(call, "M2", v[MOMENT] * grown);
    const double least = f * fmin(P, v[LOAD]);
    double *r = call->result;
    const shared_contact contact = pressed(call, f), other = pressed(call, f, P, M);
    const double one = argument(call, "Q1", least * (1.8 * uniform(call) - 0.9));
    const double two = argument(call, "Q2", least * (1.8 * uniform(call) - 0.9));
    const double most = contact ? rwedge_contact_largest_tension_step(contact.get(), two - one) : 0;
    const double from = argument(call, "sigma1", 0.3 * most * uniform(call));
    const double to = argument(call, "sigma2", from + most * (1.8 * uniform(call) - 0.9));
    return contact && other && rwedge_contact_edges(contact.get(), &r[2], &r[3]) == RWEDGE_OK &&
           rwedge_contact_edges(other.get(), &r[4], &r[5]) == RWEDGE_OK &&
           rwedge_contact_permanent_stick(contact.get(), v[LOAD], v[MOMENT], one, from, P, M, two,
                                          to, &r[0], &r[1]) == RWEDGE_OK;
}

/* (N1 + N2 - |T2 - T1|)/2; all of the smaller contact where that patch is larger than it. */
ball judge_permanent(const probe &call)
{
    const double *v = call.value, *r = call.result;
    const pressed_patch one = ball_pressed(call, 2),
                        two = ball_pressed(v, v[SECOND_LOAD], v[SECOND_MOMENT], r + 4);
    const pressed_patch &smaller = two.c.P > one.c.P ? one : two,
                        &larger = &smaller == &one ? two : one;
    const tangential T =
        tangential_of(one.per_stress, v[FRICTION], ball(v[Q2]) - v[Q1], ball(v[S2]) - v[S1]);
    const tangential sticking = {(one.c.P + two.c.P - T.load) / 2,
                                 (one.c.tilt + two.c.tilt - T.tilt) / 2};
    const ball_edges e = edges_of(larger, sticking, r);
    if (e.left <= smaller.edges.left && e.right >= smaller.edges.right)
        return magnified(edges_error(r, smaller.edges, 2 * smaller.c.half), smaller);
    return front_error(r, e, larger, sticking);
}

#define PATCHES "M; edges dense at -a, a; s from 1e-15 a; \\|delta\\| to 1 - 1e-9"

const auto draw_stick_zone = [](probe *call) { return draw_slipping(call) != NULL; };

} // namespace

shared_contact draw_slipping(probe *call)
{
    if (!some_pressing(call))
        return NULL;
    const double f = argument(call, "f", log_between(call, 0.01, 2)), *v = call->value;
    const shared_contact contact = pressed(call, f);
    if (!contact)
        return NULL;
    const double part = chance(call, 0.3) ? log_between(call, 1e-12, 0.9) : 0.9 * uniform(call);
    const double Q = argument(call, "Q", either_sign(call, part * f * v[LOAD]));
    const double most = rwedge_contact_largest_tension_step(contact.get(), Q);
    const double sigma = argument(
        call, "sigma", most * (chance(call, 0.2) ? either_sign(call, 1) : 2 * uniform(call) - 1));
    double *r = call->result;
    if (rwedge_contact_edges(contact.get(), &r[2], &r[3]) != RWEDGE_OK ||
        rwedge_contact_apply(contact.get(), v[LOAD], v[MOMENT], Q, sigma) != RWEDGE_OK ||
        rwedge_contact_stick_zone(contact.get(), &r[0], &r[1]) != RWEDGE_OK)
        r[0] = NAN;
    r[4] = most;
    return contact;
}

const row ECCENTRIC_ROWS[] = {
    {"contact_edges", PATCHES, "of the width or \\|x\\|, over 1 - \\|delta\\|", 1e-14, "1e-14", 1,
     draw_edges, judge_edges},
    {"contact_tilt", PATCHES, "of theta max(1, \\|x\\|/width), over 1 - \\|delta\\|", 1e-14,
     "1e-14", 1, draw_edges, judge_tilt},
    {"contact_edge_asymptotes", PATCHES, "of the larger K_N of the edges found", 1e-14, "1e-14", 1,
     draw_edges, judge_asymptotes},
    {"contact_stick_zone", "also Q to 0.9 f P, sigma to its limit",
     "of the contact's width or \\|x\\|, over 1 - \\|delta\\| and the root of what sticks of P",
     1e-14, "1e-14", 1, draw_stick_zone, judge_stick_zone},
    {"contact_largest_tension_step", "the same",
     "relative, times max(1, \\|x\\|/width), over 1 - \\|delta\\|", 1e-14, "1e-14", 1,
     draw_stick_zone, judge_tension_step},
    {"contact_permanent_stick", "P, M constant or in proportion",
     "of the contact's width or \\|x\\|, over 1 - \\|delta\\| and the root of what sticks of P",
     1e-14, "1e-14", 1, draw_permanent, judge_permanent},
    {},
};

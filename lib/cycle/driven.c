/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The next load where a rig prescribes a displacement. Q rises with the displacement, so that there
 * is one; where even f P does not reach what is prescribed, the bodies slide on by the rest. */
#include "cycle/states.h"

#include "base/domain.h"
#include "base/root.h"

/* P, M and sigma of the load, and what is prescribed. */
typedef struct {
    const rwedge_contact *contact;
    double P, M, sigma, b, displacement, compliance;
    bool *lacked_memory; /* in a trial */
} rig;

/* The contact under the load with a Q. */
static int32_t contact_under(const rig *r, double Q, rwedge_contact **contact)
{
    int32_t status = rwedge_contact_copy(r->contact, contact);
    if (status != RWEDGE_OK)
        return status;
    (*contact)->drive.b = r->b;
    return rwedge_contact_apply(*contact, r->P, r->M, Q, r->sigma);
}

/* How far the rig is beyond what is prescribed. NaN where that is not known. */
static double beyond(const rig *r, const rwedge_contact *contact, double Q)
{
    return rwedge_contact_displacement(contact, r->b) + r->compliance * Q - r->displacement;
}

static double beyond_with(double Q, const void *context)
{
    const rig *r = context;
    rwedge_contact *contact = NULL;
    const int32_t status = contact_under(r, Q, &contact);
    const double value = status == RWEDGE_OK ? beyond(r, contact, Q) : NAN;
    *r->lacked_memory = *r->lacked_memory || status == RWEDGE_ENOMEM;
    rwedge_contact_destroy(contact);
    return value;
}

/* Why a Q on the way to the root has no displacement. */
static int32_t reason(const rig *r, double Q)
{
    rwedge_contact *contact = NULL;
    const int32_t status = contact_under(r, Q, &contact);
    rwedge_contact_destroy(contact);
    return status == RWEDGE_OK ? RWEDGE_EPATH : status;
}

/* The largest Q of one sign whose displacement is known. Of unlike bodies that is not so where they
 * slide, but up to this part of f P. */
static const double INSIDE = 1 - 1e-6;

typedef struct {
    double Q, beyond;
} end;

static end end_of(const rig *r, double way)
{
    const double limit = way * r->contact->f * r->P;
    const end all = {limit, beyond_with(limit, r)};
    return isnan(all.beyond) ? (end){INSIDE * limit, beyond_with(INSIDE * limit, r)} : all;
}

/* Whether unlike bodies touch with no way prescribed: they are pressed alone. A first load with a
 * force along the surface may not converge. */
static bool is_pressed_alone(const rig *r)
{
    const rwedge_contact *c = r->contact;
    const double NO_WAY = 1e-6; /* over A f P */
    return c->unlike && c->phase == RW_APART &&
           fabs(beyond_with(0, r)) <= NO_WAY * c->geometry.A * c->f * r->P;
}

/* The rounding of displacements: a way below it does not turn the bodies round. */
static double rounding_of_way(const rig *r, double limit)
{
    static const double ROUNDED = 1e-14;
    const double slid = r->contact->drive.slid;
    return ROUNDED *
           (fabs(r->displacement) + fabs(slid) + (r->compliance + r->contact->geometry.A) * limit);
}

/* Q, and how far the bodies slide besides; NaN where the root, or how far, is not known. The side
 * on which the contact is comes first. */
static double find(const rig *r, double *slid)
{
    const double limit = r->contact->f * r->P, way = r->contact->loads.Q < 0 ? -1 : 1;
    end side[2];
    if (is_pressed_alone(r))
        return 0;
    for (int i = 0; i < 2; i++) {
        const double sign = i == 0 ? way : -way;
        side[i] = end_of(r, sign);
        const double short_of = -side[i].beyond * sign; /* of what is prescribed */
        if (isnan(short_of) || (short_of > 0 && fabs(side[i].Q) < limit))
            return NAN;
        *slid = short_of > 0 ? -side[i].beyond : 0;
        if (short_of >= -rounding_of_way(r, limit))
            return side[i].Q;
    }
    return rw_root(beyond_with, r, fmin(side[0].Q, side[1].Q), fmax(side[0].Q, side[1].Q),
                   1e-15 * limit);
}

/* Slides on. Where it slid the same way before, P grew or fell on the way. */
static void slide(rwedge_contact *contact, const rwedge_contact *before, double slid)
{
    const bool slid_before = before->phase == RW_SLIDING && before->loads.Q * slid > 0;
    const double P = slid_before ? before->loads.P / 2 + contact->loads.P / 2 : contact->loads.P;
    contact->drive.slid += slid;
    contact->energy.sum += contact->f * P * fabs(slid);
}

/* The half-width that displacements count from. */
static int32_t reference(const rig *r, double *b)
{
    rwedge_contact *contact = NULL;
    *b = r->contact->drive.b > 0 ? r->contact->drive.b : rwedge_contact_half_width(r->contact);
    if (*b > 0)
        return RWEDGE_OK;
    const int32_t status = contact_under(r, 0, &contact);
    *b = rwedge_contact_half_width(contact);
    rwedge_contact_destroy(contact);
    return status;
}

/* The bodies are apart: the next contact begins where the rig is. */
static int32_t separate(rig *r, rwedge_contact **contact)
{
    const int32_t status = contact_under(r, 0, contact);
    if (status == RWEDGE_OK)
        (*contact)->drive.slid = r->displacement;
    return status;
}

static int32_t drive(rig *r, double *Q, rwedge_contact **contact)
{
    double slid = 0;
    *Q = 0;
    if (r->P == 0)
        return separate(r, contact);
    int32_t status = reference(r, &r->b);
    if (status != RWEDGE_OK)
        return status;
    *Q = find(r, &slid);
    if (*r->lacked_memory)
        return RWEDGE_ENOMEM;
    if (isnan(*Q))
        return reason(r, r->contact->f * r->P);
    status = contact_under(r, *Q, contact);
    if (status != RWEDGE_OK)
        return status;
    if (slid != 0)
        slide(*contact, r->contact, slid);
    return RWEDGE_OK;
}

int32_t rwedge_contact_drive(rwedge_contact *contact, double P, double M, double sigma,
                             double displacement, double compliance, double *Q)
{
    if (!contact || !Q)
        return RWEDGE_ENULL;
    if (!rw_is_magnitude(P) || !rw_is_signed(M) || !rw_is_signed(sigma) ||
        !rw_is_signed(displacement) || !rw_is_magnitude(compliance))
        return RWEDGE_EDOMAIN;
    bool lacked_memory = false;
    rig r = {contact, P, M, sigma, contact->drive.b, displacement, compliance, &lacked_memory};
    rwedge_contact *next = NULL;
    double found;
    const int32_t status = drive(&r, &found, &next);
    if (status == RWEDGE_OK) {
        rw_contact_exchange(contact, next);
        *Q = found;
    }
    rwedge_contact_destroy(next);
    return status;
}

/* ---- A cycle ---- */

/* Q, and how far the bodies slide beside the load. */
static int32_t drive_to(rwedge_contact *going, const rw_rig_history *loads, size_t i, double *Q,
                        double *slid)
{
    const double before = going->drive.slid;
    const int32_t status = rwedge_contact_drive(going, loads->P[i], loads->M[i], loads->sigma[i],
                                                loads->displacement[i], loads->compliance, Q);
    *slid = status == RWEDGE_OK && going->phase != RW_APART ? going->drive.slid - before : 0;
    return status;
}

int32_t rw_drive_through(const rwedge_contact *contact, const rw_rig_history *loads, double Q[],
                         double slid[], double *b)
{
    rwedge_contact *going = NULL;
    int32_t status = rwedge_contact_copy(contact, &going);
    for (size_t i = 0; i < loads->count && status == RWEDGE_OK; i++)
        status = drive_to(going, loads, i, &Q[i], &slid[i]);
    *b = status == RWEDGE_OK ? going->drive.b : 0;
    rwedge_contact_destroy(going);
    return status;
}

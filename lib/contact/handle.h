/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A contact: its parts, what it is at present, and its life. */
#ifndef RW_CONTACT_HANDLE_H
#define RW_CONTACT_HANDLE_H

#include "formulas/size.h"
#include "history/slip_origin.h"
#include "numerical/computed_shear.h"
#include "rwedge.h"
#include "unlike/sliding_patch.h"

typedef struct {
    double P, M, Q, sigma;
} rw_loads;

/* Loads as a contact goes to them, in a straight line. `turn` is M, or of a held pad its tilt over
 * theta. */
typedef struct {
    double P, turn, Q, sigma;
} rw_goal;

/* What a contact is at present. Without friction it is centred while it is loaded. */
typedef enum {
    RW_APART,      /* the bodies do not touch */
    RW_CENTRED,    /* they have had no moment, and one tension, since they touched */
    RW_OFF_CENTRE, /* they have had a moment, or another tension, since they touched */
    RW_SLIDING,    /* friction is exhausted all over */
    RW_COMPUTED    /* the shear has no closed form */
} rw_phase;

/* The slip of the places of a contact that slides off its centre: shift + slope x - height h(x), h
 * being the height of the profile, rw_profile_height(). */
typedef struct {
    double shift, slope, height;
} rw_slide;

/* The half-width that a prescribed displacement counts from, 0 where none was prescribed yet; how
 * far the bodies have slid beyond what their loads tell; the slip when they last slid off the
 * centre, from which later slip counts, all 0 before. */
typedef struct {
    double b, slid;
    rw_slide slide;
} rw_drive;

/* What counts while it slides. */
typedef struct {
    double largest_load; /* since it slides */
    bool is_off_centre;  /* as in the phase RW_OFF_CENTRE */
} rw_sliding;

/* What counts while the shear is computed, of which the memory then has none. */
typedef struct {
    rw_numerical *now;
    rw_numerical *start;   /* where the last straight line began */
    double strayed;        /* how far the loads since were off that line */
    rwedge_contact *exact; /* the contact in its last closed form; NULL: it had none */
} rw_computed;

/* A load is computed where its closed form leaves this unknown. */
typedef enum { RW_NONE_FOLLOWED, RW_SLIP_FOLLOWED, RW_SLIP_AND_ENERGY_FOLLOWED } rw_followed;

/* What slip counts from: slip.c. */
typedef struct {
    rw_slip_origins origins;
    bool is_known; /* whether they tell the slip off the centre too */
    rw_followed followed;
    rw_patch settled; /* off the centre: where it may have slipped; the rest touched later */
} rw_slip_record;

/* What has been dissipated. */
typedef struct {
    double sum, rest; /* rest: what rounding left out of the sum */
    bool is_known;    /* false from a load of unknown energy on, until the bodies touch anew */
} rw_dissipated;

struct rwedge_contact {
    rw_geometry geometry; /* its pad is the contact's own */
    double f;
    double strain;     /* of the surface per bulk tension, over A/4: 1 for equal compliances */
    double beta;       /* Dundurs' of half-plane and pad; 0 where their coupling is neglected */
    rw_unlike *unlike; /* of beta f; NULL where it is 0 */
    double tolerance;  /* of loads without a closed form; 0: they are refused */
    bool is_held;
    double held_tilt; /* over theta */
    rw_phase phase;
    rw_loads loads;
    double touched_at; /* the bulk tension at which the bodies touched */
    rw_memory memory;  /* loads are P, shears Q/f */
    rw_slip_record slip;
    rw_dissipated energy;
    rw_sliding sliding;
    rw_drive drive;
    rw_computed computed;
    /* The same contact, which has computed the loads whose slip or energy has no closed form; both
     * are known from it. NULL: from this one, if they are known; and if this one is computed.
     * beside.c */
    rwedge_contact *beside;
};

/* A contact without load, which owns the geometry's pad from then on. RWEDGE_ENOMEM. */
int32_t rw_contact_create(const rw_geometry *geometry, double f, rwedge_contact **contact);

/* A contact of the same bodies without load and history: not held, or held at the same tilt;
 * without tolerance. RWEDGE_ENOMEM. */
int32_t rw_contact_unloaded(const rwedge_contact *contact, rwedge_contact **unloaded);

/* Sets what follows from beta and friction. false where memory is short. */
bool rw_contact_make_unlike(rwedge_contact *contact);

/* The contacts exchange all they have. */
void rw_contact_exchange(rwedge_contact *a, rwedge_contact *b);

/* Ends the computed shear. The contact is without shear until its phase is set anew. */
void rw_contact_drop_computed(rwedge_contact *contact);

/* Keeps the other one, which has the same loads, beside the contact if slip and energy are known
 * from it alone. Returns what is to be destroyed, or NULL. */
rwedge_contact *rw_contact_keep_beside(rwedge_contact *contact, rwedge_contact *other);

/* Ends what is beside a contact. */
void rw_contact_drop_beside(rwedge_contact *contact);

/* The loads as the contact takes them: a held pad keeps its tilt. */
static inline rw_goal rw_goal_of(const rwedge_contact *c, rw_loads to)
{
    return (rw_goal){to.P, c->is_held ? c->held_tilt : to.M, to.Q, to.sigma};
}

/* How the contact slides: both bodies count as similar where it does not. */
static inline rw_sliding_way rw_contact_way(const rwedge_contact *c)
{
    return (rw_sliding_way){c->phase == RW_COMPUTED ? NULL : c->unlike,
                            rw_memory_end(&c->memory)->ratio < 0 ? -1 : 1};
}

/* Whether it has had a moment, or another tension than at first, since the bodies touched. */
static inline bool rw_contact_is_off_centre(const rwedge_contact *c)
{
    return c->phase == RW_OFF_CENTRE || c->phase == RW_COMPUTED ||
           (c->phase == RW_SLIDING && c->sliding.is_off_centre);
}

/* The contact from which slip and energy are known, if they are. */
static inline const rwedge_contact *rw_contact_of_slip(const rwedge_contact *c)
{
    return c->beside ? c->beside : c;
}

static inline bool rw_contact_knows_slip(const rwedge_contact *c)
{
    const rwedge_contact *other = rw_contact_of_slip(c);
    return !rw_contact_is_off_centre(other) || other->slip.is_known;
}

static inline bool rw_contact_knows_slip_and_energy(const rwedge_contact *c)
{
    return rw_contact_knows_slip(c) && rw_contact_of_slip(c)->energy.is_known;
}

/* The stretch that a bulk tension makes, in the unit of the memory. */
static inline double rw_contact_stretch(const rwedge_contact *c, double sigma)
{
    return c->f > 0 ? -(c->geometry.A / c->geometry.theta) * sigma / (4 * c->f) * c->strain : 0;
}

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The states that a contact goes through in a cycle of loads, and what happens to a place. Of a
 * state that is kept which the questions need: its shear, edges, and how slip goes on from the
 * state before. */
#ifndef RW_STATES_H
#define RW_STATES_H

#include "contact/record.h"
#include "cycle/shift.h"

/* The slip of places that come into contact in a step, since they did, is known at so many. */
enum { RW_RING = 6 };

typedef struct {
    rw_patch patch; /* of the contact; NaN when separated */
    rw_patch stuck; /* where nothing has slipped since the state before; none if computed */
    bool is_load;   /* after a load; else on the way to one, where P or M changes */
    bool is_computed;
    rw_patch *sticks; /* where a computed state sticks: `stick_count` patches, its own */
    int stick_count;
    double noise; /* the error of a computed slip: what sticks has not slipped so little */
    rw_displacement displacement;
    double ring[2][RW_RING]; /* at the left, right edge: slip since they touched */
    double leave[2];         /* slip at the edge since the state before, where it moves inwards */
} rw_state;

/* The most places at which a cycle is measured. */
enum { RW_CYCLE_PLACES = 479 };

/* Edges of the contact, and of the zones that stick, and places to measure at: cycle_places.c. */
typedef struct {
    double *all;
    size_t count, capacity;
    rw_patch outermost; /* of the contact, where there are edges */
    double place[RW_CYCLE_PLACES];
    size_t places;
} rw_edges;

/* Adds those of a contact. false where memory is short. */
bool rw_edges_add(rw_edges *edges, const rwedge_contact *contact);

/* Puts all edges in ascending order, each once. To be called after the last one. */
void rw_edges_settle(rw_edges *edges);

/* The first state on the way is that before the cycle. */
struct rwedge_cycle {
    rwedge_contact *before;
    rw_load_history loads; /* its arrays are the cycle's own, in one block */
    bool is_guided;        /* M of the loads is the tilt at which the pad is held, as in rw_goal */
    double *slid;          /* with each load, beyond what it tells; NULL: no rig prescribes it */
    rw_record at_loads;    /* what the loads leave */
    rw_record on_the_way;  /* all states, for slip */
    rw_state *states;
    size_t count, capacity;
    rw_edges edges;       /* before the cycle, and after each load */
    double rounding;      /* of an edge */
    double least, most;   /* half-widths after loads; least: 0 where the bodies are apart once */
    rw_patch never_slips; /* the widest such zone; without width where there is none */
    int32_t slip_status;  /* RWEDGE_EPATH where the slip of a state has no closed form */
};

/* What a rig prescribes: displacements in place of Q. */
typedef struct {
    size_t count;
    const double *P, *M, *sigma, *displacement;
    double compliance;
} rw_rig_history;

/* Drives a copy of the contact: Q of each load, how far the bodies slide besides, and the
 * half-width that the displacements count from. */
int32_t rw_drive_through(const rwedge_contact *contact, const rw_rig_history *loads, double Q[],
                         double slid[], double *b);

/* How far they slide beside the load i. */
static inline double rw_cycle_slid(const rwedge_cycle *cycle, size_t i)
{
    return cycle->slid ? cycle->slid[i] : 0;
}

/* Where the load i leads a contact of the cycle. */
static inline rw_goal rw_cycle_goal(const rwedge_cycle *cycle, const rwedge_contact *contact,
                                    size_t i)
{
    const rw_loads to = rw_loads_at(&cycle->loads, i);
    return cycle->is_guided ? (rw_goal){to.P, to.M, to.Q, to.sigma} : rw_goal_of(contact, to);
}

/* What friction does at a place of the surface. All 0 where there is no contact in the cycle. */
typedef struct {
    double slip_range, shear, energy; /* shear: the largest magnitude of q */
} rw_slip_measures;

/* Room for the sums over the pieces of a state at places, to be freed; NULL where memory is
 * short. */
typedef struct {
    double displacement, shear;
} rw_piece_sum;

rw_piece_sum *rw_cycle_room(const rwedge_cycle *cycle);

/* At n <= RW_SLIP_PLACES places of the surface. */
enum { RW_SLIP_PLACES = 32 };
void rw_slip_measures_at(const rwedge_cycle *cycle, size_t n, const double x[], rw_piece_sum room[],
                         rw_slip_measures measures[]);

/* The inner and the outer end, as left and right, of what a step from the patch `old` to `now` has
 * added to the contact, or taken from it, at its left (0) or right (1) edge. A contact that lies
 * apart from the old one is all new, from its middle on. */
rw_patch rw_ring_of(rw_patch old, rw_patch now, int side);

/* The node k of a ring: the part of the way from its inner to its outer end. */
static inline double rw_ring_node(int k)
{
    return (1 - cos(RW_PI * (2 * k + 1) / (2 * RW_RING))) / 2;
}

/* Whether a place has finite stresses after all loads. */
bool rw_cycle_has_stress(const rwedge_cycle *cycle, double x, double y);

/* The stresses after each load at n places, 3 loads n numbers: those of a load one after the other,
 * sxx of all loads first, then syy and txy. */
int32_t rw_cycle_stresses(const rwedge_cycle *cycle, size_t n, const double x[], const double y[],
                          double stress[]);

/* The largest sxx after any load at the place i, from the stresses at n places. */
double rw_largest_stress(const rwedge_cycle *cycle, size_t n, const double stress[], size_t i);

/* Notes a state for slip, which may be computed beside the contact. `from`: the contact before the
 * step, NULL in the first state; `lender` as in rw_record_add(), of the contact alone. */
int32_t rw_note_state(rwedge_cycle *cycle, const rwedge_contact *from, const rwedge_contact *to,
                      const rw_entry *lender);

/* Notes that all places slip alike, by `slid`, under the loads that the contact has. */
int32_t rw_note_sliding(rwedge_cycle *cycle, const rwedge_contact *contact, double slid);

/* Notes that what the whole step leaves stuck has stuck in its parts too, which are the states from
 * `first` on. */
void rw_note_stuck(rwedge_cycle *cycle, size_t first, rw_patch stuck);

#endif

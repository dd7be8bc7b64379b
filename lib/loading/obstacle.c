/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Why a load has no closed form, and which other loads lead there: they are tried on copies. */
#include "loading/step_to.h"

/* The ways to a load, in the order in which they are tried. The last always leads there. */
typedef enum { PRESSING_FIRST, SHEAR_FIRST, LESS_TENSION, FARTHER, SEPARATED, WAYS } way;

enum { LOADS = 3 }; /* of a way, the last ones the same where there are fewer */

#define IN_WORDS(reason)                                                                           \
    {                                                                                              \
        [PRESSING_FIRST] = reason "; apply it as two loads: first P and M, then Q and sigma",      \
        [SHEAR_FIRST] = reason "; apply it as two loads: first Q and sigma, then P and M",         \
        [LESS_TENSION] = reason "; change sigma by less",                                          \
        [FARTHER] = reason "; go twice as far along the same straight line",                       \
        [SEPARATED] = reason "; separate the bodies, which forgets the history, then apply sigma " \
                             "with P = 0, then P and M, then Q",                                   \
    }

static const char *const TEXTS[][WAYS] = {
    [RW_EDGES_PART] = IN_WORDS("one edge of the contact would advance while the other recedes"),
    [RW_SLIPS_BOTH_WAYS] = IN_WORDS("the two edges would slip in opposite directions"),
    [RW_FRONTS_PART] = IN_WORDS("slip would go beyond an older slip zone at one edge alone"),
    [RW_GROWS_UNEVENLY] =
        IN_WORDS("the contact would grow under a shear that does not grow in proportion to it"),
};

static const char UNLIKE[] = "unlike bodies have a closed form in full sliding alone, |Q| = f P";

static rw_loads twice_as_far(rw_loads from, rw_loads to)
{
    return (rw_loads){2 * to.P - from.P, 2 * to.M - from.M, 2 * to.Q - from.Q,
                      2 * to.sigma - from.sigma};
}

/* The largest change of the tension under constant P and M. */
static rw_loads with_less_tension(const rwedge_contact *contact, rw_loads to)
{
    const double most = rwedge_contact_largest_tension_step(contact, to.Q);
    const double change = to.sigma - contact->loads.sigma;
    if (most > 0)
        to.sigma = contact->loads.sigma + copysign(fmin(0.99 * most, fabs(change)), change);
    return to;
}

/* What the loads would return. */
static int32_t status_of(const rwedge_contact *contact, const rw_loads loads[LOADS])
{
    rwedge_contact *trial = NULL;
    int32_t status = rwedge_contact_copy(contact, &trial);
    for (int i = 0; i < LOADS && status == RWEDGE_OK; i++)
        status = rwedge_contact_apply(trial, loads[i].P, loads[i].M, loads[i].Q, loads[i].sigma);
    rwedge_contact_destroy(trial);
    return status;
}

static way first_that_leads_there(const rwedge_contact *contact, rw_loads to)
{
    const rw_loads now = contact->loads, less = with_less_tension(contact, to),
                   far = twice_as_far(now, to);
    const rw_loads ways[SEPARATED][LOADS] = {
        [PRESSING_FIRST] = {{to.P, to.M, now.Q, now.sigma}, to, to},
        [SHEAR_FIRST] = {{now.P, now.M, to.Q, to.sigma}, to, to},
        [LESS_TENSION] = {less, less, less},
        [FARTHER] = {far, far, far},
    };
    way i = 0;
    while (i < SEPARATED && status_of(contact, ways[i]) != RWEDGE_OK)
        i++;
    return i;
}

const char *rwedge_contact_obstacle(const rwedge_contact *contact, double P, double M, double Q,
                                    double sigma)
{
    const rw_loads to = {P, M, Q, sigma}, itself[LOADS] = {to, to, to};
    if (contact && contact->unlike)
        return status_of(contact, itself) == RWEDGE_EPATH ? UNLIKE : "";
    const rw_obstacle obstacle = contact ? rw_contact_obstacle(contact, to) : RW_NO_OBSTACLE;
    if (obstacle == RW_NO_OBSTACLE || status_of(contact, itself) != RWEDGE_EPATH)
        return "";
    return TEXTS[obstacle][first_that_leads_there(contact, to)];
}

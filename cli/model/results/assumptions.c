/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a report of a case says that was assumed, and which errors its numbers have. */
#include "results.h"

#include <math.h>
#include <stdio.h>

static void tell_bodies(const contact_case *setup, const case_said *said, remark_teller *tell,
                        void *to)
{
    tell(to,
         setup->is_plane_stress ? "Plane stress: a thin plate." : "Plane strain: a long contact.");
    tell(to, "Both bodies are elastic half-planes beside the contact, and slopes are small.");
    if (isinf(setup->E2))
        tell(to, "Body 2 is rigid.");
    else if (!said->has_E2)
        tell(to, "Body 2 is of the material of body 1.");
    if (setup->is_coupled)
        tell(to, "Of unlike bodies, friction changes the pressure: that is computed.");
    else if (setup->beta != 0 && setup->f > 0)
        tell(to, "Of unlike bodies, friction does not change the pressure (Dundurs' beta is "
                 "neglected).");
    if (setup->shape.places != NULL)
        tell(to, said->fits         ? "The pad is the convex profile that fits its heights."
                 : said->takes_hull ? "The pad is the convex hull of its heights."
                                    : "The pad is its profile, linear in the slopes.");
}

static void tell_loads(const contact_case *setup, const case_said *said, remark_teller *tell,
                       void *to)
{
    if (setup->f == 0)
        tell(to, said->has_f ? "No friction." : "No friction is given: it is taken for 0.");
    else
        tell(to, "Coulomb friction, the same everywhere; the bodies do not wear.");
    if (said->has_history)
        tell(to, "The loads follow one another in straight steps, from bodies that are apart.");
    else if (setup->f > 0)
        tell(to, "P and M come first, then Q and sigma grow together.");
    if (setup->is_held)
        tell(to, "The pad is held at its tilt; M is a result.");
    else if (setup->is_coupled)
        tell(to, "The pad is free to tilt.");
}

static void tell_strength(const contact_case *setup, const case_said *said, remark_teller *tell,
                          void *to)
{
    if (said->is_of_body2)
        tell(to, "Stresses and strength are those of body 2, the pad.");
    if (isnan(setup->k))
        return;
    tell(to, "First yield by von Mises. What is of full sliding takes Q = f P, whatever Q is.");
    tell(to, "Shakedown: perfect plasticity, small strains, the same loads pass after pass.");
}

void assumptions_tell(const contact_case *setup, const case_said *said, remark_teller *tell,
                      void *to)
{
    tell_bodies(setup, said, tell, to);
    tell_loads(setup, said, tell, to);
    tell_strength(setup, said, tell, to);
    if (!said->has_units)
        tell(to, "The numbers are in consistent units, such as N, mm and MPa; P, M and Q per unit "
                 "length.");
    else if (said->has_width)
        tell(to, "P, M and Q are per unit length: given for the whole width, and divided by it.");
}

/* A design needs so many digits. */
enum { DIGITS = 4 };

static void tell_fit(const pad_profile *fitted, remark_teller *tell, void *to)
{
    char text[200], number[NUMBER_SIZE];
    number_write(fitted->rms, DIGITS, '.', number);
    snprintf(text, sizeof text,
             "The fit of the profile leaves %s of the heights (root of the mean square), with %d "
             "arcs.",
             number, (int)fitted->arcs);
    tell(to, text);
}

void errors_tell(const contact_case *setup, doubts all, bool lacks_slip, remark_teller *tell,
                 void *to)
{
    char text[DOUBT_SIZE];
    const bool matters = doubts_matter(all);
    if (!(all.error > 0))
        tell(to,
             "All is in closed form: numerical errors are far below the digits that are shown.");
    while (doubts_next(&all, text))
        tell(to, text);
    if (setup->shape.places != NULL && setup->shape.places->arcs > 0)
        tell_fit(setup->shape.places, tell, to);
    if (lacks_slip)
        tell(to, "The slip has no closed form after these loads: what depends on it is not told.");
    if (!matters)
        tell(to, "Nothing else makes these numbers doubtful.");
}

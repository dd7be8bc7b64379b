/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of a fit beside the results: what it leaves in the contact, and how far the largest
 * pressure depends on the number of arcs. */
#include "solve.h"

/* Adds the change of the pressure in per cent to the text, if there is such a fit. */
static void add_change(const contact_case *setup, int32_t arcs, const char *with, double pressure,
                       char text[80])
{
    static pad_profile other; /* is large */
    if (arcs < 1 || !pad_fit_again(setup->shape.places, arcs, &other))
        return;
    const double change = 100 * (case_peak_pressure(setup, &other) / pressure - 1);
    list_add(text, 80, ", ", "by %+.2f %% with %s", change, with);
    pad_profile_free(&other);
}

void fit_say(const contact_case *setup)
{
    const pad_profile *places = setup->shape.places;
    double left, right, x;
    char changes[80] = "";
    if (places == NULL || places->arcs == 0 ||
        rwedge_contact_edges(setup->contact, &left, &right) != RWEDGE_OK)
        return;
    const double residue = pad_fit_residue(places, left, right, &x);
    const double pressure = case_peak_pressure(setup, places);
    add_change(setup, places->arcs - 1, "one arc fewer", pressure, changes);
    add_change(setup, places->arcs + 1, "one more", pressure, changes);
    notice("the fit: the largest residue within the contact is %.3g, at x = %.6g; p0 changes %s",
           residue, x, changes[0] != '\0' ? changes : "in no way that is known");
}

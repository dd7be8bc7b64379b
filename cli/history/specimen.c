/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "history.h"

#include <math.h>

/* The parabola that the pad gets is that of one P. */
static void refuse_changing(const load_history *loads, double P)
{
    complaint why;
    for (size_t i = 0; i < loads->count; i++)
        if (loads->load[i].P != P) {
            complain(&why,
                     "P %.6g: must stay that of the first load, %.6g, with --specimen-thickness",
                     loads->load[i].P, P);
            load_history_fail(loads, i, "", &why);
        }
}

/* The half-width of the contact under P alone. */
static double half_width_under(const rwedge_contact *contact, double P)
{
    rwedge_contact *tried;
    status_check(rwedge_contact_copy(contact, &tried), "the contact");
    const int32_t status = rwedge_contact_load(tried, P, 0);
    const double b = rwedge_contact_half_width(tried);
    rwedge_contact_destroy(tried);
    status_check(status, "the contact");
    return b;
}

/* Says the error of the half-width, and the tension that stretches as P does, as rwedge.h has
 * them. */
static void say(double t, double P, const contact_case *setup)
{
    const double b = half_width_under(setup->contact, P),
                 share = 2 * rwedge_contact_strain(setup->contact) / setup->A;
    notice(
        "--specimen-thickness: a layer of %.4g half-widths, by its first correction: the "
        "half-width errs by %.2g %%; left out: P stretches body 1 as a sigma of %.4g does, and Q "
        "tilts it by %.3g Q",
        t / b, 20 * share * pow(b / t, 4), 0.4893 * P / t, 0.2446 * share * setup->A / t);
}

void specimen_refuse(const arguments *line, const char *where)
{
    const char *text = line->value[OPTION_SPECIMEN_THICKNESS];
    if (text != NULL || line->value[OPTION_OPPOSITE] != NULL)
        usage_error("--specimen-thickness%s%s: not %s; allowed: history, fretting, crack",
                    text != NULL ? " " : "", text != NULL ? text : "", where);
}

void specimen_take(const arguments *line, const load_history *loads, const load_history *before,
                   contact_case *setup)
{
    const char *text = line->value[OPTION_SPECIMEN_THICKNESS];
    const bool is_opposite = line->value[OPTION_OPPOSITE] != NULL;
    if (is_opposite && text == NULL)
        usage_error("--opposite: needs --specimen-thickness");
    if (text == NULL)
        return;
    if (setup->is_held)
        usage_error("--specimen-thickness %s: not of a pad that is held at a tilt", text);
    const double thickness = option_size(line, OPTION_SPECIMEN_THICKNESS, "specimen-thickness",
                                         "length", units_of(line)),
                 t = is_opposite ? thickness / 2 : thickness, P = loads->load[0].P;
    refuse_changing(loads, P);
    if (before != NULL)
        refuse_changing(before, P);
    if (!(P > 0))
        usage_error("--specimen-thickness %s: needs a P above 0, which is constant", text);
    const int32_t status = rwedge_contact_set_thickness(setup->contact, t, P);
    if (status == RWEDGE_ERANGE)
        usage_error("--specimen-thickness %s: must be at least %.6g, %sthe width of the contact",
                    text, (is_opposite ? 4 : 2) * half_width_under(setup->contact, P),
                    is_opposite ? "twice " : "");
    status_check(status, "the contact");
    say(t, P, setup);
}

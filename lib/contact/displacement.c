/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far bodies move because they slip. In plane strain the displacement of remote points grows
 * like the logarithm of their distance d. If the contact were bonded over |x| < b, it would be (A
 * Q/pi) ln(2 d/b) along the force. A flat punch of half-width s that carries dQ moves the bodies by
 * (A dQ/pi) ln(b/s) further, whatever d is. The pressure of a patch of half-width s is a sum of
 * such punches, dP(s) each, and the traction is a sum of patches:
 *
 *     displacement = (A f/pi) sum (D_i - D_(i+1)) int_0^(s_i) ln(b/s) dP(s).
 * Off the centre it is the slip of a place, plus the displacement that the tractions cause
 * there. */
#include "contact/contact.h"

#include "traction/transform.h"

/* int P(s)/s ds from 0 to s, in theta/A. */
static double load_integral(double a, double s)
{
    if (s <= a)
        return 0.25 * RW_PI * s * (s / a);
    const double t = a / s, root = sqrt((s - a) * (s + a));
    const double ratio = t > 0 ? asin(t) / t : 1;
    return 0.5 * s * ratio + 1.5 * root - a * acos(t);
}

/* int ln(b/s) dP(s), by parts. */
static double centred(const rwedge_contact *contact, double b)
{
    const rw_memory *path = &contact->memory;
    double sum = 0;
    for (size_t i = 1; i < path->count; i++) {
        const double s = path->corners[i].patch.right;
        sum += rw_patch_weight(path, i) *
               (rw_as_length(&contact->geometry, path->corners[i].load) * log(b / s) +
                load_integral(contact->geometry.a, s));
    }
    return contact->f * contact->geometry.theta / RW_PI * sum;
}

/* ---- Off the centre ---- */

/* int -q(t) ln(b/(2 |t - x|)) dt between two places, whose ends may be kinks of q or t = x: the
 * points are dense there. */
static double panel(const rwedge_contact *contact, double b, double x, double from, double to)
{
    enum { POINTS = 400 };
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        const double u = (i + 0.5) / POINTS, rate = u * (1 - u);
        const double t = from + (to - from) * (u * u * u * (10 - u * (15 - 6 * u)));
        double p, q = 0;
        rwedge_contact_tractions(contact, 1, &t, &p, &q);
        sum -= q * log(b / (2 * fabs(t - x))) * rate * rate;
    }
    return sum * (30.0 / POINTS) * fabs(to - from);
}

/* int -q(t) ln(b/(2 |t - x|)) dt for a computed shear, which is no sum of patches. */
static double numerical_sum(const rwedge_contact *contact, double b, double x)
{
    const rw_traction *t = &contact->computed.now->now.shear.traction;
    return rw_unit_stress(&contact->geometry) *
           (RW_PI * rw_traction_displacement(t, x) + log(b / 2) * rw_traction_total(t));
}

/* The same of the pressure of unlike bodies, which moves both sides of a place apart. */
static double pressed_sum(const rwedge_contact *contact, double x)
{
    const rw_numerical_state *now = &contact->computed.now->now;
    const double left =
        rw_traction_load_to(&now->pressed, x) - rw_traction_total(&now->pressed) / 2;
    return now->coupling == 0 ? 0
                              : rw_unit_stress(&contact->geometry) * RW_PI * now->coupling * left;
}

/* A place in contact since before the first slip, as the innermost patch of the memory is: one that
 * came later was not where it would have been without shear. NaN where all such places have left
 * the contact. */
static double lasting_place(const rwedge_contact *contact)
{
    const bool has_slipped = rw_contact_is_off_centre(contact) &&
                             (contact->computed.now || contact->slip.origins.count > 0);
    const rw_patch inner = contact->memory.corners[1].patch,
                   patch =
                       has_slipped ? contact->slip.settled : rw_memory_end(&contact->memory)->patch;
    if (patch.left > patch.right)
        return NAN;
    return fmin(fmax(rw_patch_middle(patch), inner.left), inner.right);
}

/* The edges of the patches, which are nested, are kinks of q. */
double rw_contact_moved(const rwedge_contact *contact, double b, double x)
{
    const rw_memory *path = &contact->memory;
    const double tension = contact->loads.sigma - contact->touched_at;
    double left = x, right = x, sum = 0;
    if (contact->computed.now)
        sum = numerical_sum(contact, b, x) - pressed_sum(contact, x);
    for (size_t i = 1; i < path->count && !contact->computed.now; i++) {
        const rw_patch patch = path->corners[i].patch;
        if (patch.left < left) /* nested patches may share an edge */
            sum += panel(contact, b, x, left, patch.left);
        if (patch.right > right)
            sum += panel(contact, b, x, right, patch.right);
        left = fmin(left, patch.left);
        right = fmax(right, patch.right);
    }
    return contact->geometry.A * (sum / RW_PI + contact->strain * tension * x / 4);
}

static double off_centre(const rwedge_contact *contact, double b)
{
    const double x = lasting_place(contact);
    double slip;
    if (rwedge_contact_slip(contact, 1, &x, &slip) != RWEDGE_OK)
        return NAN;
    return rw_contact_moved(contact, b, x) - slip;
}

double rwedge_contact_displacement(const rwedge_contact *contact, double b)
{
    if (!contact || !rw_is_positive(b) || contact->memory.count < 2)
        return NAN;
    const bool has_no_sum = rw_contact_is_off_centre(contact) || contact->geometry.pad;
    return (has_no_sum ? off_centre(contact, b) : centred(contact, b)) + contact->drive.slid;
}

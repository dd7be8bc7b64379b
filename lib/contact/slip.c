/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Slip. The surface displacement that a shear traction causes has the gradient -A Re G_T, Eq.
 * (17); for a path with the patches s_i, in the order of their size, and the slopes D_i between
 * them that makes, at a point inside the contact,
 *     w(x) = f theta [ sum (D_i - D_(i+1)) s_i gap(x/s_i) - D_1 h(x) ],
 * where h is the profile. w is 0 at x = 0, and patches wider than x add nothing. So w depends on
 * the path below u alone, where u is the load with which the edge of the contact is at x.
 *
 * While the point is in contact, slip changes the path below u, and w with it; nothing else does.
 * A rising load adds to the path beyond u, a falling one cuts it off there. The slip is therefore
 * w of the present path less w of the path when the point came into contact (slip_origin.h). What
 * both paths have in common is left out of both sums, because it would cancel. */
#include "contact/contact.h"

#include "history/gap.h"

/* The sum of w(x)/(f theta) over the corners from `first` to count - 1, without the term of the
 * profile. `beyond` is the slope D after the last of them. */
static double displacement(const rwedge_contact *contact, const rw_path *path, size_t first,
                           size_t count, double beyond, double x)
{
    double sum = 0;
    for (size_t i = first; i < count; i++) {
        const rw_corner *corner = rw_path_corner(path, i);
        if (rw_patch_has(corner->patch, x))
            continue;
        const double next = i + 1 < count ? rw_path_corner(path, i + 1)->ratio : beyond;
        sum += (corner->ratio - next) * rw_patch_gap(&contact->geometry, corner->patch, x);
    }
    return sum;
}

/* The displacement by the present path beyond that by the first `kept` corners of an earlier one,
 * after which its slope is `beyond`. */
static double displacement_since(const rwedge_contact *contact, const rw_path *base, size_t kept,
                                 double beyond, double x)
{
    const rw_path now = rw_memory_path(&contact->memory),
                  kept_part = {base->corners, base->origins, base->origin, kept};
    const size_t common = rw_memory_common(&contact->memory, &kept_part),
                 first = common > 1 ? common - 1 : 1;
    return displacement(contact, &now, first, now.count, 0, x) -
           displacement(contact, base, first, kept, beyond, x);
}

/* The displacement by a patch that is no corner of the path. */
static double departure_displacement(const rwedge_contact *contact, const rw_departure *left,
                                     double x)
{
    const rw_corner *corner = &left->corner;
    const rw_patch patch = rw_patch_under_tilt(&contact->geometry, corner->load, 0);
    return (corner->ratio - left->slip) * rw_patch_gap(&contact->geometry, patch, x);
}

/* What is small last. */
static double in_units(const rwedge_contact *contact, double w)
{
    const double f = contact->f, theta = contact->geometry.theta;
    return f > 1 ? f * w * theta : theta * w * f;
}

/* x >= 0 */
static double slip_at(const rwedge_contact *contact, double x)
{
    const rw_geometry *g = &contact->geometry;
    const rw_memory *now = &contact->memory;
    /* the load under which the edge of the contact is at x */
    const double u = fmin(rw_normal_load(g, x), rw_memory_end(now)->load);
    const rw_slip_origin *origin = rw_slip_origin_of(&contact->slip.origins, u);
    if (!origin || u == 0)
        return 0;
    const rw_path base = rw_slip_origin_path(&contact->slip.origins, origin);
    const rw_departure left = rw_slip_origin_departure(origin, &base, u);
    const size_t kept = left.kept;
    const bool is_corner = left.corner.load == rw_path_corner(&base, kept - 1)->load;
    const double after_kept = is_corner ? left.slip : left.corner.ratio;
    double w = displacement_since(contact, &base, kept, after_kept, x);
    if (!is_corner && left.slip != 0)
        w -= departure_displacement(contact, &left, x);
    const double at_centre = kept > 1 ? rw_path_corner(&base, 1)->ratio : after_kept;
    w -= (now->corners[1].ratio - at_centre) * rw_height(g, x);
    return in_units(contact, w);
}

double rw_slip_of_slide(const rwedge_contact *contact, double x)
{
    const rw_slide *slide = &contact->drive.slide;
    const double height =
        slide->height != 0 ? slide->height * rw_profile_height(&contact->geometry, x) : 0;
    return slide->shift + slide->slope * x - height;
}

/* Off the centre: from the one origin that serves all points. */
static double slip_off_centre(const rwedge_contact *contact, double x)
{
    const rw_slip_origins *origins = &contact->slip.origins;
    if (x < contact->slip.settled.left || x > contact->slip.settled.right)
        return 0;
    const double slid = rw_slip_of_slide(contact, x);
    if (origins->count == 0)
        return slid;
    const rw_path base = rw_slip_origin_path(origins, &origins->all[0]);
    return slid + in_units(contact, displacement_since(contact, &base, base.count, 0, x));
}

static double slip_of(const rwedge_contact *contact, double x)
{
    if (contact->phase == RW_APART)
        return 0;
    if (contact->phase == RW_COMPUTED)
        return contact->geometry.theta * rw_numerical_slip(contact->computed.now, x);
    return rw_contact_is_off_centre(contact) ? slip_off_centre(contact, x)
                                             : slip_at(contact, fabs(x));
}

int32_t rwedge_contact_slip(const rwedge_contact *contact, size_t n, const double x[],
                            double slip[])
{
    if (!contact || (n > 0 && (!x || !slip)))
        return RWEDGE_ENULL;
    const rw_patch patch = rw_memory_end(&contact->memory)->patch;
    for (size_t i = 0; i < n; i++)
        if (!rw_is_signed(x[i]) || x[i] < patch.left || x[i] > patch.right)
            return RWEDGE_EDOMAIN;
    if (!rw_contact_knows_slip(contact))
        return RWEDGE_EPATH;
    for (size_t i = 0; i < n; i++)
        slip[i] = slip_of(rw_contact_of_slip(contact), x[i]);
    return RWEDGE_OK;
}

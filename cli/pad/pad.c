/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pad.h"

#include <math.h>

pad pad_wedge(double theta, double a)
{
    return (pad){PAD_WEDGE, theta, a, NAN, rwedge_radius(theta, a), NULL};
}

pad pad_cylinder(double radius)
{
    return (pad){PAD_CYLINDER, 1, radius, NAN, radius, NULL};
}

pad pad_flat(double flat, double radius)
{
    return (pad){PAD_FLAT, NAN, NAN, flat, radius, NULL};
}

pad pad_of_profile(const pad_profile *places)
{
    return (pad){PAD_PROFILE, NAN, NAN, NAN, NAN, places};
}

bool pad_has_formulas(const pad *shape)
{
    return shape->kind == PAD_WEDGE || shape->kind == PAD_CYLINDER;
}

int32_t pad_contact(const pad *shape, double A, double f, rwedge_contact **contact)
{
    *contact = NULL;
    if (shape->kind == PAD_WEDGE)
        return rwedge_contact_create(shape->theta, shape->a, A, f, contact);
    if (shape->kind == PAD_PROFILE)
        return rwedge_contact_create_profile(shape->places->count, shape->places->x,
                                             shape->places->slope, A, f, contact);
    return rwedge_contact_create_flat(shape->kind == PAD_FLAT ? shape->flat : 0, shape->radius, A,
                                      f, contact);
}

double pad_half_width(const pad *shape, double A, double P)
{
    rwedge_contact *contact = NULL;
    double b = NAN;
    if (shape->kind == PAD_WEDGE)
        return rwedge_half_width(shape->theta, shape->a, A, P);
    if (pad_contact(shape, A, 0, &contact) == RWEDGE_OK &&
        rwedge_contact_load(contact, P, 0) == RWEDGE_OK)
        b = rwedge_contact_half_width(contact);
    rwedge_contact_destroy(contact);
    return b;
}

double pad_height(const pad *shape, double x)
{
    const double reach = fabs(x);
    if (shape->kind == PAD_PROFILE)
        return pad_profile_height(shape->places, x);
    if (shape->kind == PAD_WEDGE && reach >= shape->a)
        return shape->theta * (reach - shape->a / 2);
    const double rounded = shape->kind == PAD_FLAT ? fmax(reach - shape->flat, 0) : reach;
    return rounded * rounded / (2 * shape->radius);
}

bool pad_is_kink(const pad *shape, double x)
{
    const pad_profile *places = shape->places;
    if (places == NULL)
        return shape->a == 0 && x == 0;
    for (size_t i = 1; i < places->count; i++)
        if (places->x[i - 1] == x && places->x[i] == x && places->slope[i] > places->slope[i - 1])
            return true;
    return false;
}

static double slope_at(const pad_profile *places, double x)
{
    size_t i = 0;
    while (i < places->count && places->x[i] <= x)
        i++;
    if (i == 0 || i == places->count)
        return places->slope[i == 0 ? 0 : i - 1];
    const double part = (x - places->x[i - 1]) / (places->x[i] - places->x[i - 1]);
    return places->slope[i - 1] + part * (places->slope[i] - places->slope[i - 1]);
}

double pad_steepest(const pad *shape, double left, double right)
{
    if (shape->kind == PAD_WEDGE)
        return shape->theta;
    if (shape->kind == PAD_PROFILE)
        return fmax(-slope_at(shape->places, left), slope_at(shape->places, right));
    const double from = shape->kind == PAD_FLAT ? shape->flat : 0;
    return (fmax(-left, right) - from) / shape->radius;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planes/plane_cycle.h"

#include <float.h>
#include <stddef.h>
#include <stdlib.h>

rw_plane_cycle *rw_plane_cycle_create(size_t loads)
{
    rw_plane_cycle *cycle = malloc(sizeof *cycle);
    if (!cycle)
        return NULL;
    *cycle = (rw_plane_cycle){.loads = loads,
                              .item = calloc(loads, sizeof *cycle->item),
                              .local = calloc(loads, sizeof *cycle->local),
                              .point = calloc(loads, sizeof *cycle->point),
                              .wave = calloc(RW_WAVE_KINDS * loads, sizeof *cycle->wave)};
    if (cycle->item && cycle->local && cycle->point && cycle->wave)
        return cycle;
    rw_plane_cycle_destroy(cycle);
    return NULL;
}

void rw_plane_cycle_destroy(rw_plane_cycle *cycle)
{
    if (!cycle)
        return;
    free(cycle->item);
    free(cycle->local);
    free(cycle->point);
    free(cycle->wave);
    free(cycle);
}

void rw_plane_cycle_set(rw_plane_cycle *cycle, size_t i, const rw_plane_load *load,
                        const rw_severity *severity)
{
    cycle->item[i] = (rw_item){.xx = load->s - load->d,
                               .yy = load->s + load->d,
                               .d = load->d,
                               .t = load->t,
                               .z = load->z,
                               .lift = load->z - load->s,
                               .size = sqrt(load->d * load->d + load->t * load->t),
                               .level = load->z + severity->shift * load->s};
}

/* The middle between the least and the largest of the loads. */
static double middle_of(const rw_plane_cycle *cycle, size_t offset)
{
    double least = DBL_MAX, most = -DBL_MAX;
    for (size_t i = 0; i < cycle->loads; i++) {
        const double v = *(const double *)((const char *)&cycle->item[i] + offset);
        least = rw_smaller(least, v);
        most = rw_larger(most, v);
    }
    return (least + most) / 2;
}

void rw_plane_cycle_centre(rw_plane_cycle *cycle)
{
    const double d = middle_of(cycle, offsetof(rw_item, d)),
                 t = middle_of(cycle, offsetof(rw_item, t)),
                 lift = middle_of(cycle, offsetof(rw_item, lift)),
                 level = middle_of(cycle, offsetof(rw_item, level));
    for (size_t i = 0; i < cycle->loads; i++) {
        rw_item *load = &cycle->item[i];
        load->deviation_d = load->d - d;
        load->deviation_t = load->t - t;
        load->deviation_lift = load->lift - lift;
        load->level -= level;
        load->deviation_size =
            sqrt(load->deviation_d * load->deviation_d + load->deviation_t * load->deviation_t);
    }
}

/* Where the stresses change along one direction alone, as near a free surface in plane stress, all
 * planes of one latitude around it are nearly equally bad, and cells may be long. So the pole is
 * the principal direction that differs most from the two others, where these are so close; of the
 * load farthest from the middle. Otherwise it is z: on its equator the worst plane is mostly. */
static rw_pole pole_of(const rw_plane_cycle *cycle)
{
    static const double CLOSE = 0.2;
    rw_pole pole = {{1, 0}, true};
    double most = 0;
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        const double lift = fabs(load->deviation_lift), size = load->deviation_size;
        if (size == 0 || size + lift <= most)
            continue;
        const double length = load->deviation_lift > 0 ? -size : size;
        most = size + lift;
        pole = (rw_pole){{load->deviation_d / length, load->deviation_t / length},
                         fabs(size - lift) > CLOSE * 2 * size};
    }
    return pole;
}

static rw_tensor tensor_of(rw_direction deviator, double lift, double z, bool is_z)
{
    const double d = deviator.cosine, t = deviator.sine;
    rw_tensor s = {.base = z, .pole = d - lift, .side = -d - lift, .shear = t};
    if (is_z)
        s = (rw_tensor){.base = z - lift + d, .pole = lift - d, .side = -2 * d, .twist = t};
    s.ring = sqrt(s.side * s.side + 4 * s.twist * s.twist);
    return s;
}

rw_pole rw_plane_cycle_turn(rw_plane_cycle *cycle)
{
    const rw_pole pole = pole_of(cycle);
    const rw_direction back = {pole.psi.cosine, -pole.psi.sine};
    for (size_t i = 0; i < cycle->loads; i++) {
        rw_item *load = &cycle->item[i];
        const rw_direction all = rw_turned_with((rw_direction){load->d, load->t}, back);
        const rw_direction deviation =
            rw_turned_with((rw_direction){load->deviation_d, load->deviation_t}, back);
        load->d = all.cosine, load->t = all.sine;
        load->deviation_d = deviation.cosine, load->deviation_t = deviation.sine;
        load->all = tensor_of(all, load->lift, load->z, pole.is_z);
        load->deviation = tensor_of(deviation, load->deviation_lift, load->level, pole.is_z);
    }
    return pole;
}

static double largest_stress(const rw_plane_cycle *cycle)
{
    double largest = 0;
    for (size_t i = 0; i < cycle->loads; i++) {
        const rw_item *load = &cycle->item[i];
        largest = rw_larger(largest, load->size + fabs(load->lift) + fabs(load->z));
    }
    return largest;
}

double rw_plane_cycle_noise(const rw_plane_cycle *cycle, const rw_severity *severity)
{
    const double stress = largest_stress(cycle), rounding = 4 * DBL_EPSILON * stress;
    return rounding *
           (severity->is_sum ? 1 + severity->gain : severity->offset + severity->gain * stress);
}

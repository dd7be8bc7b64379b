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
                              .point = calloc(loads, sizeof *cycle->point),
                              .wave = calloc(RW_WAVE_KINDS * loads, sizeof *cycle->wave),
                              .cell = malloc(2 * RW_CELLS * sizeof *cycle->cell)};
    if (cycle->item && cycle->point && cycle->wave && cycle->cell)
        return cycle;
    rw_plane_cycle_destroy(cycle);
    return NULL;
}

void rw_plane_cycle_destroy(rw_plane_cycle *cycle)
{
    if (!cycle)
        return;
    free(cycle->item);
    free(cycle->point);
    free(cycle->wave);
    free(cycle->cell);
    free(cycle);
}

void rw_plane_cycle_set(rw_plane_cycle *cycle, size_t i, const rw_plane_load *load,
                        const rw_severity *severity)
{
    const double s = (load->xx + load->yy) / 2, d = (load->yy - load->xx) / 2;
    cycle->item[i] = (rw_item){.xx = load->xx,
                               .yy = load->yy,
                               .d = d,
                               .t = load->xy,
                               .z = load->zz,
                               .lift = load->zz - s,
                               .size = sqrt(d * d + load->xy * load->xy),
                               .level = load->zz + severity->shift * s};
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

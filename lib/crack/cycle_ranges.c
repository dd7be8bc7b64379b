/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where faces pass through each other K is straight between loads. Where they press it is not: the
 * instants at which a crack closes are looked for. */
#include "crack/cycle_ranges.h"

#include "crack/weights.h"

#include <stdlib.h>

int32_t rw_cycle_ranges(rw_crack *crack, int32_t shear, size_t n, const double length[],
                        rw_crack_range range[])
{
    const size_t loads = rw_crack_loads(crack), all = n * loads;
    double *room = malloc(3 * all * sizeof *room);
    if (!room)
        return RWEDGE_ENOMEM;
    const rw_crack_K K = {n, room, room + all, NULL, crack->presses ? room + 2 * all : NULL};
    const int32_t status = rw_crack_intensities(crack, n, length, &K);
    for (size_t j = 0; j < n && status == RWEDGE_OK; j++) {
        const rw_cycle_of_K of_length = {loads, n, K.I + j, K.II + j,
                                         K.passing ? K.passing + j : NULL};
        range[j] = rw_crack_range_of(&of_length, shear);
    }
    free(room);
    return status;
}

/* The lengths in groups, as their stresses are asked. */
static int32_t ask(rw_crack *crack, int32_t shear, size_t n, const double length[],
                   rw_crack_range range[])
{
    int32_t status = RWEDGE_OK;
    for (size_t j = 0; j < n && status == RWEDGE_OK; j += RW_CRACK_LENGTHS) {
        const size_t group = n - j < RW_CRACK_LENGTHS ? n - j : RW_CRACK_LENGTHS;
        status = rw_cycle_ranges(crack, shear, group, length + j, range + j);
    }
    return status;
}

int32_t rwedge_cycle_closing_ranges(const rwedge_cycle *cycle, double x, double angle,
                                    int32_t shear, size_t n, const double length[],
                                    double range_I[], double range_II[], double K_max[], double R[])
{
    if (!cycle || (n > 0 && (!length || !range_I || !range_II || !K_max || !R)))
        return RWEDGE_ENULL;
    if (n > SIZE_MAX / 2 / sizeof(rw_crack_range))
        return RWEDGE_ERANGE;
    if (!rw_is_signed(x) || !rw_is_crack_angle(angle) || !rw_is_crack_shear(shear) ||
        !rw_are_crack_lengths(n, length))
        return RWEDGE_EDOMAIN;
    rw_crack crack;
    rw_crack_range *range = malloc((n + 1) * sizeof *range);
    int32_t status = rw_crack_create(cycle, x, angle, true, &crack);
    status = range ? status : RWEDGE_ENOMEM;
    if (status == RWEDGE_OK)
        status = ask(&crack, shear, n, length, range);
    for (size_t j = 0; j < n && status == RWEDGE_OK; j++) {
        range_I[j] = range[j].I;
        range_II[j] = range[j].II;
        K_max[j] = range[j].K_max;
        R[j] = range[j].R;
    }
    rw_crack_destroy(&crack);
    free(range);
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Least squares by Givens' rotations, a row at a time: what many heights say of a parabola is kept
 * in three rows, to rounding. So a fit takes as long for a million heights as for a thousand. */
#include "profile/profile.h"

#include <math.h>
#include <string.h>

/* Its square is no number yet: what is less is 0 beside any t. */
static const double TINY = 1e-150;

static void add_row(rw_equations *to, double row[4])
{
    for (int k = 0; k < 3; k++) {
        double *own = to->row[k];
        if (fabs(row[k]) < TINY)
            continue;
        const double size = sqrt(own[k] * own[k] + row[k] * row[k]);
        const double c = own[k] / size, s = row[k] / size;
        for (int i = k; i < 4; i++) {
            const double before = own[i];
            own[i] = c * before + s * row[i];
            row[i] = c * row[i] - s * before;
        }
    }
    to->rest += row[3] * row[3];
}

static void merge(rw_equations *to, const rw_equations *from)
{
    for (int k = 0; k < 3; k++) {
        double row[4];
        memcpy(row, from->row[k], sizeof row);
        add_row(to, row);
    }
    to->rest += from->rest;
}

static size_t cell_of(double t)
{
    const double cell = floor((t + 1) / 2 * RW_CELLS);
    return cell >= RW_CELLS ? RW_CELLS - 1 : cell > 0 ? (size_t)cell : 0;
}

void rw_compress(size_t n, const double t[], const double h[], rw_compressed *all)
{
    memset(all, 0, sizeof *all);
    for (size_t i = 0; i < n; i++) {
        double row[4] = {1, t[i], t[i] * t[i], h[i]};
        add_row(&all->node[RW_CELLS + cell_of(t[i])], row);
    }
    for (size_t i = RW_CELLS - 1; i > 0; i--) {
        all->node[i] = all->node[2 * i];
        merge(&all->node[i], &all->node[2 * i + 1]);
    }
}

rw_equations rw_compressed_range(const rw_compressed *all, size_t first, size_t end)
{
    rw_equations sum = {{{0}}, 0};
    for (first += RW_CELLS, end += RW_CELLS; first < end; first /= 2, end /= 2) {
        if (first % 2 == 1)
            merge(&sum, &all->node[first++]);
        if (end % 2 == 1)
            merge(&sum, &all->node[--end]);
    }
    return sum;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include "contact_values.h"
#include "yield_values.h"

#include <math.h>

void workbook_compute(const yield_table *table, const double input[INPUT_CELLS], case_values *out)
{
    double *v = out->number;
    for (int i = 0; i < CELL_COUNT; i++)
        v[i] = NAN;
    out->safety[0] = out->branch[0] = '\0';
    contact_solve(input, v);
    yield_solve(table, v);
    if (v[WORK_OK] > 0) {
        contact_answer(v);
        yield_answer(table, out);
    }
}

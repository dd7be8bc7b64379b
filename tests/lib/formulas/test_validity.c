/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact is doubted for; the thresholds are those of the header. */
#include "claims.h"
#include "rwedge.h"

#include <fenv.h>

/* Arguments that are not known are not doubted, and raise nothing. */
CLAIM(each_doubt_begins_at_its_threshold)
{
    reference table = reference_open("validity.csv");
    feclearexcept(FE_ALL_EXCEPT);
    while (reference_next(&table)) {
        const double *v = table.cell;
        assert_int_equal(rwedge_validity(v[0], v[1], v[2], v[3], v[4], v[5]), v[6]);
    }
    assert_int_equal(fetestexcept(FE_INVALID), 0);
}

CLAIM(every_bit_has_its_own_text_and_nothing_else_has_one)
{
    int32_t all = 0;
    for (int32_t bit = 1; rwedge_validity_text(bit)[0] != '\0'; bit *= 2) {
        all |= bit;
        for (int32_t other = 1; other < bit; other *= 2)
            assert_string_not_equal(rwedge_validity_text(bit), rwedge_validity_text(other));
    }
    assert_int_equal(all, rwedge_validity(1.15, 1e-3, 0.1, 0.6, 1, 0.5));
    const int32_t none[] = {0, 3, -1, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++)
        assert_string_equal(rwedge_validity_text(none[i]), "");
}

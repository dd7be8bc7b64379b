/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a contact is doubted for; the thresholds are those of the header. */
#include "claims.h"
#include "rwedge.h"

#include <fenv.h>

/* Arguments that are not known are not doubted, and raise nothing. */
CLAIM(each_doubt_begins_at_its_threshold)
{
    const double same = rwedge_dundurs_beta(2.1e5, 0.3, 2.1e5, 0.3),
                 other = rwedge_dundurs_beta(2.1e5, 0.3, 7e4, 0.33);
    /* steel in GPa beside a load in N/mm: a/b = 0.0046 in place of 4.6 */
    const double wrong = 1 / rwedge_half_width(0.01, 1, rwedge_compliance(210, 0.3, 210, 0.3), 500),
                 right =
                     1 / rwedge_half_width(0.01, 1, rwedge_compliance(21e4, 0.3, 21e4, 0.3), 500);
    const struct {
        double v[6]; /* theta, a/b, beta, f, k/E, safety */
        int32_t doubt;
    } cases[] = {
        {{0.01, 0.5, 0, 0.3, 2e-3, 1.5}, 0},
        {{0.01, 0, 0.2, 0, 2e-3, HUGE_VAL}, 0}, /* sharp; without friction */
        {{NAN, NAN, NAN, NAN, NAN, NAN}, 0},
        {{0.1, NAN, NAN, NAN, NAN, NAN}, 0},
        {{nextafter(0.1, 1), NAN, NAN, NAN, NAN, NAN}, RWEDGE_DOUBT_ANGLE},
        {{NAN, NAN, 0.1, 0, NAN, NAN}, 0},
        {{NAN, NAN, same, 0.3, NAN, NAN}, 0},
        {{NAN, NAN, other, 0.3, NAN, NAN}, RWEDGE_DOUBT_COUPLING},
        {{NAN, NAN, -0.1, 1e-9, NAN, NAN}, RWEDGE_DOUBT_COUPLING},
        {{NAN, NAN, NAN, NAN, NAN, 1}, 0},
        {{NAN, NAN, NAN, NAN, NAN, nextafter(1, 0)}, RWEDGE_DOUBT_YIELD},
        {{NAN, NAN, NAN, NAN, NAN, 0}, RWEDGE_DOUBT_YIELD}, /* the sharp wedge */
        {{NAN, 0.01, NAN, NAN, NAN, NAN}, 0},
        {{NAN, 1e4, NAN, NAN, NAN, NAN}, 0},
        {{NAN, nextafter(0.01, 0), NAN, NAN, NAN, NAN}, RWEDGE_DOUBT_ROUNDING},
        {{NAN, nextafter(1e4, 1e5), NAN, NAN, NAN, NAN}, RWEDGE_DOUBT_ROUNDING},
        {{NAN, 0, NAN, NAN, NAN, NAN}, 0},
        {{NAN, wrong, NAN, NAN, NAN, NAN}, RWEDGE_DOUBT_ROUNDING},
        {{NAN, right, NAN, NAN, NAN, NAN}, 0},
        {{NAN, NAN, NAN, NAN, 1e-5, NAN}, 0},
        {{NAN, NAN, NAN, NAN, 0.1, NAN}, 0},
        {{NAN, NAN, NAN, NAN, nextafter(1e-5, 0), NAN}, RWEDGE_DOUBT_STRENGTH},
        {{NAN, NAN, NAN, NAN, nextafter(0.1, 1), NAN}, RWEDGE_DOUBT_STRENGTH},
        {{NAN, NAN, NAN, NAN, 0, NAN}, 0},
        {{1.15, 1e-3, 0.1, 0.6, 1, 0.5}, 1 + 2 + 4 + 8 + 16}, /* they add up */
    };
    feclearexcept(FE_ALL_EXCEPT);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double *v = cases[i].v;
        assert_int_equal(rwedge_validity(v[0], v[1], v[2], v[3], v[4], v[5]), cases[i].doubt);
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

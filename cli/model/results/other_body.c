/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The strength of body 2: it becomes body 1, seen from its own side. The result at (x, y) belongs
 * to (-x, -y). */
#include "results.h"

#include <math.h>

static void swap(input_texts *texts, int one, int other)
{
    const char *text = texts->text[one];
    texts->text[one] = texts->text[other];
    texts->text[other] = text;
}

/* What is wrong with a modulus is said by its own name. */
static bool check_bodies(const input_texts *texts, complaint *why)
{
    double value;
    for (int i = INPUT_E1; i <= INPUT_NU2; i++)
        if (input_is_given(texts, i) && !input_read(texts, i, &value, why))
            return false;
        else if (input_is_given(texts, i) && isinf(value))
            return complain(why, "body 2 is rigid, so it has no stresses");
    return true;
}

bool other_body_take(input_texts *texts, complaint *why)
{
    static const int one_sided[] = {INPUT_M, INPUT_TILT, INPUT_SIGMA, INPUT_PROFILE};
    for (size_t i = 0; i < sizeof one_sided / sizeof one_sided[0]; i++)
        if (input_is_given(texts, one_sided[i]))
            return complain(why, "not with %s; allowed: P and Q on a pad with two equal sides",
                            input_kinds[one_sided[i]].column);
    if (!check_bodies(texts, why))
        return false;
    if (input_is_given(texts, INPUT_E2)) {
        swap(texts, INPUT_E1, INPUT_E2);
        swap(texts, INPUT_NU1, INPUT_NU2);
    }
    return true;
}

static void exchange(cell *one, cell *other)
{
    const cell kept = *one;
    *one = *other;
    *other = kept;
}

void other_body_mirror(results *answer)
{
    static const int turned[] = {RESULT_BETA,       RESULT_MU,    RESULT_YIELD_X,    RESULT_YIELD_Y,
                                 RESULT_P0_X,       RESULT_TILT,  RESULT_MOMENT,     RESULT_LEFT,
                                 RESULT_STICK_LEFT, RESULT_RIGHT, RESULT_STICK_RIGHT};
    for (size_t i = 0; i < sizeof turned / sizeof turned[0]; i++)
        answer->value[turned[i]].number = 0 - answer->value[turned[i]].number;
    exchange(&answer->value[RESULT_LEFT], &answer->value[RESULT_RIGHT]);
    exchange(&answer->value[RESULT_STICK_LEFT], &answer->value[RESULT_STICK_RIGHT]);
    answer->hardest_x = 0 - answer->hardest_x;
    answer->hardest_y = 0 - answer->hardest_y;
    answer->is_of_body2 = true;
}

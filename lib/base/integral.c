/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/integral.h"

enum { PAIRS = 8 };

/* Positive zeros of the Legendre polynomial P_16, and their weights 2/((1-x^2) P'(x)^2). */
static const struct {
    double node, weight;
} RULE[PAIRS] = {
    {0.095012509837637440185, 0.18945061045506849629},
    {0.28160355077925891323, 0.18260341504492358887},
    {0.45801677765722738634, 0.16915651939500253819},
    {0.61787624440264374845, 0.14959598881657673208},
    {0.7554044083550030339, 0.12462897125553387205},
    {0.86563120238783174388, 0.09515851168249278481},
    {0.94457502307323257608, 0.062253523938647892863},
    {0.9894009349916499326, 0.027152459411754094852},
};

double rw_integral(rw_function f, const void *context, double lo, double hi)
{
    const double middle = lo + (hi - lo) / 2, half = (hi - lo) / 2;
    double sum = 0;
    for (int i = 0; i < PAIRS; i++) {
        const double offset = half * RULE[i].node;
        sum += RULE[i].weight * (f(middle - offset, context) + f(middle + offset, context));
    }
    return half * sum;
}

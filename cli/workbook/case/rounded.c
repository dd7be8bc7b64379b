/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rounded.h"

#include "number/number.h"

#include <math.h>

double rounded_to(double value, int digits)
{
    char text[NUMBER_SIZE];
    double rounded = value;
    if (isfinite(value)) {
        number_write(value, digits, '.', text);
        number_read(text, &rounded);
    }
    return rounded;
}

double workbook_rounded(double value)
{
    return rounded_to(value, 10);
}

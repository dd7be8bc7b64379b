/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "rounded.h"

#include "number/number.h"
#include "text/message.h"

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

double workbook_computed(double value)
{
    if (!isfinite(value))
        failure("the workbook: a value of its tables could not be computed");
    return workbook_rounded(value);
}

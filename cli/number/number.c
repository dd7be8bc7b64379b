/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The finite number that a text begins with. How many characters it has; 0 where none starts
 * there. */
static size_t number_begin(const char *text, double *value)
{
    char *end;
    const double read = strtod(text, &end);
    const size_t length = (size_t)(end - text);
    if (length == 0 || length > strspn(text, "+-.0123456789eE") || !isfinite(read))
        return 0;
    *value = read == 0 ? 0 : read;
    return length;
}

bool number_read(const char *text, double *value)
{
    double read;
    const size_t length = number_begin(text, &read);
    if (length == 0 || text[length] != '\0')
        return false;
    *value = read;
    return true;
}

int number_read_list(const char *text, size_t length, char separator, int most, double value[])
{
    for (int n = 0; n < most; n++) {
        const size_t own = number_begin(text, &value[n]);
        if (own > 0 && own == length)
            return n + 1;
        if (own == 0 || own > length || text[own] != separator)
            return 0;
        text += own + 1;
        length -= own + 1;
    }
    return 0;
}

bool number_read_cell(const char *text, char decimal_sign, double *value)
{
    /* no double needs more digits to be written exactly than this takes in any sensible form */
    char plain[512];
    text += strspn(text, " \t");
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
        length--;
    if (length >= sizeof plain || (decimal_sign != '.' && memchr(text, '.', length) != NULL))
        return false;
    memcpy(plain, text, length);
    plain[length] = '\0';
    char *sign = strchr(plain, decimal_sign);
    if (sign != NULL)
        *sign = '.';
    return number_read(plain, value);
}

bool number_read_whole(const char *text, int64_t lo, int64_t hi, int64_t *value)
{
    double read;
    if (text[strspn(text, "0123456789")] != '\0' || !number_read(text, &read) ||
        read < (double)lo || read > (double)hi)
        return false;
    *value = (int64_t)read;
    return true;
}

size_t number_write(double value, int digits, char decimal_sign, char text[NUMBER_SIZE])
{
    if (value == 0)
        value = 0; /* also -0 */
    /* to read back, 15 digits suffice for numbers that were typed, 17 for every double */
    int shown = digits < NUMBER_DIGITS ? digits : 15;
    do
        snprintf(text, NUMBER_SIZE, "%.*g", shown, value);
    while (digits >= NUMBER_DIGITS && strtod(text, NULL) != value && shown++ < NUMBER_DIGITS);
    char *point = strchr(text, '.');
    if (point != NULL)
        *point = decimal_sign;
    return strlen(text);
}

bool number_survives(const char *text, char decimal_sign, double *value)
{
    char again[NUMBER_SIZE];
    text += strspn(text, " \t");
    if (!number_read_cell(text, decimal_sign, value))
        return false;
    const size_t length = number_write(*value, NUMBER_DIGITS, decimal_sign, again);
    return strncmp(text, again, length) == 0 && text[length + strspn(text + length, " \t")] == '\0';
}

double number_rounded(double value, int digits)
{
    char text[NUMBER_SIZE];
    double rounded = value;
    if (isfinite(value) && digits < NUMBER_DIGITS) {
        number_write(value, digits, '.', text);
        number_read(text, &rounded);
    }
    return rounded;
}

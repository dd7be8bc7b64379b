/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t digits_length(const char *text)
{
    return strspn(text, "0123456789");
}

static size_t sign_length(const char *text)
{
    return *text == '+' || *text == '-' ? 1 : 0;
}

/* The length of an exponent such as "e-5"; 0 where there is none. */
static size_t exponent_length(const char *text)
{
    if (*text != 'e' && *text != 'E')
        return 0;
    const size_t before = 1 + sign_length(text + 1);
    const size_t digits = digits_length(text + before);
    return digits > 0 ? before + digits : 0;
}

size_t number_length(const char *text)
{
    const char *c = text + sign_length(text);
    const size_t whole = digits_length(c);
    c += whole;
    size_t fraction = 0;
    if (*c == '.') {
        fraction = digits_length(c + 1);
        c += 1 + fraction;
    }
    if (whole + fraction == 0)
        return 0;
    return (size_t)(c - text) + exponent_length(c);
}

bool number_read_part(const char *text, size_t length, double *value)
{
    char *end;
    const double read = strtod(text, &end);
    if (length == 0 || end != text + length || !isfinite(read))
        return false;
    *value = read == 0 ? 0 : read;
    return true;
}

bool number_read(const char *text, double *value)
{
    const size_t length = number_length(text);
    return text[length] == '\0' && number_read_part(text, length, value);
}

int number_read_list(const char *text, size_t length, char separator, int most, double value[])
{
    for (int n = 0; n < most; n++) {
        const size_t own = number_length(text);
        if (!number_read_part(text, own, &value[n]))
            return 0;
        if (own == length)
            return n + 1;
        if (own > length || text[own] != separator)
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
    const size_t length = digits_length(text);
    int64_t read = 0;
    for (size_t i = 0; i < length && read <= hi; i++)
        read = 10 * read + (text[i] - '0');
    if (length == 0 || text[length] != '\0' || read < lo || read > hi)
        return false;
    *value = read;
    return true;
}

static void print(double value, int digits, char text[NUMBER_SIZE])
{
    snprintf(text, NUMBER_SIZE, "%.*g", digits, value);
}

/* 15 digits suffice for numbers that were typed, 17 for every double. */
static void print_to_read_back(double value, char text[NUMBER_SIZE])
{
    for (int digits = 15; digits <= NUMBER_DIGITS; digits++) {
        print(value, digits, text);
        if (strtod(text, NULL) == value)
            return;
    }
}

size_t number_write(double value, int digits, char decimal_sign, char text[NUMBER_SIZE])
{
    if (value == 0)
        value = 0; /* also -0 */
    if (digits < NUMBER_DIGITS)
        print(value, digits, text);
    else
        print_to_read_back(value, text);
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

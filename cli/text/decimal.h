/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Decimal numbers kept exactly, so that the values of a range are the decimals that were meant:
 * 0.1 + 2 * 0.1 is not 0.3 in doubles, but 3/10 is. Only what a quotient of two exact doubles
 * can give is covered. */
#ifndef CLI_DECIMAL_H
#define CLI_DECIMAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* units / 10^places; |units| <= 2^53, and places < 0 for round numbers such as 3e5. */
typedef struct {
    int64_t units;
    int places;
} decimal;

/* Every integer up to this one, and every power of ten up to 10^22, is a double. */
#define DECIMAL_UNITS_MAX (INT64_C(1) << 53)
enum { DECIMAL_PLACES_MAX = 22 };

/* Reads length characters that number_length() has found; false where they need more than 2^53
 * units. */
bool decimal_read(const char *text, size_t length, decimal *number);

/* The same number in more decimal places; false where that needs more than 2^53 units. */
bool decimal_rescale(decimal *number, int places);

/* 10^places, 0 <= places <= 22. */
double decimal_power(int places);

#endif

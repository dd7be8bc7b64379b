/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers as text, the same in every locale: the tool never calls setlocale(), so the decimal
 * sign is a point unless asked otherwise. */
#ifndef CLI_NUMBER_H
#define CLI_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How many characters at the start of text are a decimal number: sign, digits, point, exponent. 0
 * where no number starts there. Spaces, "inf", "nan" and hexadecimal numbers, which strtod() would
 * accept, are no part of a number here. */
size_t number_length(const char *text);

/* Reads a whole text as a finite number, correctly rounded; -0 becomes 0. */
bool number_read(const char *text, double *value);

/* The same with blanks around it, and with that decimal sign: the text of a cell. */
bool number_read_cell(const char *text, char decimal_sign, double *value);

/* Whether a cell is a number that is written as it stands: "007", "0.10", "1E5", "+49" and twenty
 * digits are meant as texts. */
bool number_survives(const char *text, char decimal_sign, double *value);

/* The same as number_read() for the first length characters, which number_length() has found. */
bool number_read_part(const char *text, size_t length, double *value);

/* Reads a whole number without a sign, lo to hi. */
bool number_read_whole(const char *text, int64_t lo, int64_t hi, int64_t *value);

enum { NUMBER_SIZE = 32, NUMBER_DIGITS = 17 };

/* Writes a finite number with so many significant digits, 1 to 17. 17 promises that it reads
 * back to the same bits, and takes the shortest of 15, 16 and 17 digits that does. Returns the
 * length. */
size_t number_write(double value, int digits, char decimal_sign, char text[NUMBER_SIZE]);

#endif

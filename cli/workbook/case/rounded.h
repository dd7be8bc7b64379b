/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers with fewer digits: a last bit that differs between math libraries does not show. */
#ifndef CLI_ROUNDED_H
#define CLI_ROUNDED_H

/* A value that is not finite stays as it is. */
double rounded_to(double value, int digits);

/* To ten digits, as the sheets have them. */
double workbook_rounded(double value);

/* The same of a value of the library; ends the command where it could not be computed. */
double workbook_computed(double value);

#endif

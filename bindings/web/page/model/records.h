/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Records of texts and numbers, as one text that JavaScript takes apart. */
#ifndef PAGE_RECORDS_H
#define PAGE_RECORDS_H

/* What JavaScript calls. */
#define EXPORTED

/* Begins anew: the text before is lost. */
void records_begin(void);

/* A record: its kind, and a field for each letter of the form, t a text, n a double. */
void records_add(const char *kind, const char *form, ...);

/* More fields of the last record. */
void records_text(const char *text);
void records_number(double number); /* empty where it is not a number; inf is one */

/* In place of all that was added: what is wrong, and with what; or "". */
void records_refuse(const char *input, const char *why);

/* The whole; an empty text without memory. */
const char *records_end(void);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The texts of the form, as JavaScript hands them over. */
#ifndef PAGE_FIELD_TEXTS_H
#define PAGE_FIELD_TEXTS_H

#include "model/inputs.h"

/* From "name=text" of each input, a line each; it takes the lines apart in place. */
input_texts field_texts(char *lines);

#endif

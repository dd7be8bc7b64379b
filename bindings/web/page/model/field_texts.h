/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The texts of the form, as JavaScript hands them over. */
#ifndef PAGE_FIELD_TEXTS_H
#define PAGE_FIELD_TEXTS_H

#include "model/model.h"

/* From "name=text" of each input, a line each; it takes the lines apart in place. The text of
 * "profile" has its rows, that of "hull" the same for their convex hull. */
input_texts field_texts(char *lines);

/* What is to be known of the profile of the last texts; or "". */
const char *field_remark(void);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The profiles of pads, each from a file of its name. */
#ifndef CLI_PROFILES_H
#define CLI_PROFILES_H

#include "model/inputs.h"

/* How the files are read that come next. */
typedef struct {
    char decimal_sign;
    bool takes_hull;
} profile_style;

/* Reads a file, unless it has been read, and gives what is to be known of it: columns that are not
 * used, the hull; or "". What is wrong with it is kept too. Not while threads look for profiles. */
const char *profiles_read(const char *name, profile_style style);

/* Those that have been read: of input_texts. */
const pad_profile *profiles_named(const char *name, char complaint[COMPLAINT_SIZE]);

/* Forgets those that were read since so many had been. */
size_t profiles_count(void);
void profiles_forget(size_t count);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads one after the other, pasted as a table. */
#ifndef PAGE_LOAD_LIST_H
#define PAGE_LOAD_LIST_H

#include "model/model.h"

#include <stddef.h>

typedef struct {
    load to;
    int line; /* of the pasted text; 0 where the form gives it */
} listed_load;

typedef struct {
    listed_load *load;
    size_t count;
    char unused[COMPLAINT_SIZE]; /* columns with numbers */
} load_list;

void load_list_add(load_list *loads, load to, int line);

/* False, with the complaint, where a row is no load. */
bool load_list_read(const char *text, char decimal_sign, load_list *loads,
                    char complaint[COMPLAINT_SIZE]);

/* Adds records of the loads, and of the columns that are not used. */
void load_list_write(const load_list *loads);

void load_list_free(load_list *loads);

#endif

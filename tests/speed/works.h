/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What bench.c takes times of. */
#ifndef WORKS_H
#define WORKS_H

#include <stddef.h>

/* Something to do, n times, with two numbers. It returns a number that depends on all of it. A call
 * that fails ends the program. */
typedef struct work work;

struct work {
    const char *name;
    double (*call)(const work *w);
    double first, second;
    long n;
};

extern const work works[];
extern const size_t works_count;

/* Places, and the stresses of a cycle. */
void set_places(void);

/* Points below a contact and beside it, and room for what is computed of them. */
enum { MANY = 1000000 };
extern double xs[MANY], ys[MANY], out[3][MANY];

#endif

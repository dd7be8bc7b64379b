/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the bits of many results of every function, for comparison between compilers. The fit of a
 * series is left out, because its bits depend on LAPACK. */
#include "every_function.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { NUMBERS = 800 };

static void print(void *context, const char *what, double value)
{
    (void)context;
    uint64_t bits;
    if (strcmp(what, "fit") == 0)
        return;
    memcpy(&bits, &value, sizeof bits);
    printf("%s %016" PRIx64 "\n", what, bits);
}

int main(void)
{
    shared_handles shared;
    if (!shared_create(&shared))
        return 1;
    for (int i = 0; i < NUMBERS; i++)
        every_function(&shared, i, print, NULL);
    shared_destroy(&shared);
    return 0;
}

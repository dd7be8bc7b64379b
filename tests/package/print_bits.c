/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the bits of many results of every function, for comparison between compilers. It fails
 * where a function has no result, because then nothing was compared. */
#include "every_function.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { NUMBERS = 40, MOST_FUNCTIONS = 1000 };

static bool has_result[MOST_FUNCTIONS];

static void note(const char *function)
{
    for (int i = 0; i < MOST_FUNCTIONS && function_of(i) != NULL; i++)
        has_result[i] |= strcmp(function_of(i), function) == 0;
}

static void print(void *context, const char *function, bool is_status, double value)
{
    (void)context;
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value == value)
        printf("%s %016" PRIx64 "\n", function, bits);
    else
        printf("%s nan\n", function);
    if (is_status && value == RWEDGE_OK)
        note(function);
}

int main(void)
{
    shared_handles shared;
    int status = 0;
    if (!shared_create(&shared))
        return 1;
    for (int i = 0; i < NUMBERS; i++)
        every_function(&shared, i, print, NULL);
    shared_destroy(&shared);
    for (int i = 0; function_of(i) != NULL; i++)
        if (i >= MOST_FUNCTIONS || !has_result[i]) {
            fprintf(stderr,
                    "FAILED: no random arguments of rwedge_%s() have a result: give some in "
                    "hints[] of tests/support/every_function.c\n",
                    function_of(i));
            status = 1;
        }
    return status;
}

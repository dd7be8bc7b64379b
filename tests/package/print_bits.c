/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the bits of many results of every function, for comparison between compilers. It fails
 * where a function has no result, because then nothing was compared. */
#include "calls.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { NUMBERS = 40, ARRAY = 21 /* full vectors, and some left over */ };

static void print(const char *name, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value == value)
        printf("%s %016" PRIx64 "\n", name, bits);
    else
        printf("%s nan\n", name);
}

/* Whether there was a result. */
static bool print_call(const public_call *call, int number)
{
    double v[CALL_ARGUMENTS], out[CALL_OUTPUTS];
    uint64_t state = (uint64_t)number << 32;
    int32_t status;
    draw_inside(call, &state, v);
    complaint_of(call, v, out, &status);
    print(call->entry->name, status);
    for (int i = 0; status == RWEDGE_OK && i < call->outputs; i++)
        print(call->entry->name, out[i]);
    return status == RWEDGE_OK;
}

int main(void)
{
    size_t failed = 0;
    array_size = ARRAY;
    const public_call *calls = public_calls();
    for (size_t i = 0; i < ENTRY_COUNT; i++) {
        bool has_result = false;
        for (int number = 0; number < NUMBERS; number++)
            has_result |= print_call(&calls[i], number);
        /* random numbers are no state, and no loop */
        if (strcmp(calls[i].entry->name, "contact_restore") == 0 ||
            strcmp(calls[i].entry->name, "contact_loop_fit") == 0)
            continue;
        if (!has_result)
            fprintf(stderr,
                    "FAILED: no random arguments of %s() have a result: give some in hints[] of "
                    "tests/embedding/calls/draw.c\n",
                    calls[i].entry->name);
        failed += !has_result;
    }
    return failed > 0;
}

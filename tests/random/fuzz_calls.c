/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program of libFuzzer: any public function with any arguments keeps the header's rules for
 * errors. */
#include "calls.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size); /* libFuzzer's name */

typedef struct {
    const uint8_t *data;
    size_t left;
} input;

/* 0 when there are no more. */
static uint8_t take_byte(input *in)
{
    if (in->left == 0)
        return 0;
    in->left--;
    return *in->data++;
}

static uint64_t take_bytes(input *in, int count)
{
    uint64_t bytes = 0;
    for (int i = 0; i < count; i++)
        bytes = bytes << 8 | take_byte(in);
    return bytes;
}

/* Any double. */
static double take_double(input *in)
{
    const uint64_t bits = take_bytes(in, 8);
    double v;
    memcpy(&v, &bits, sizeof v);
    return v;
}

/* Any number of terms; but those that are allowed and take seconds are made fewer. */
static double take_whole(input *in)
{
    const int32_t n = (int32_t)take_bytes(in, 4);
    return n > 65536 && n <= 1 << 24 ? n % 65536 : n;
}

/* At an edge, any double, or in between. */
static double take_argument(input *in, const entry_argument *a)
{
    const uint8_t choice = take_byte(in);
    if (choice < 64)
        return edge(a, take_byte(in) % edge_count(a));
    if (choice < 128)
        return a->whole ? take_whole(in) : take_double(in);
    if (a->whole)
        return take_byte(in);
    const double v = (double)take_bytes(in, 2) / 65535;
    return choice % 2 == 0 ? v : exp(40 * v - 20);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    const public_call *call = &public_calls()[take_byte(&in) % ENTRY_COUNT];
    double v[CALL_ARGUMENTS] = {0}, out[CALL_OUTPUTS];
    for (int i = 0; i < call->arguments; i++)
        v[i] = take_argument(&in, call->argument[i]);
    int32_t status;
    const char *complaint = complaint_of(call, v, out, &status);
    if (complaint == NULL)
        return 0;
    for (int i = 0; i < call->arguments; i++)
        fprintf(stderr, "%s %.17g\n", call->argument[i]->name, v[i]);
    fprintf(stderr, "%s: %s\n", call->name, complaint);
    abort();
}

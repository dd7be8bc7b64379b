/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "rwedge solve --input" on any file, from its header to the last row, with some of the options. */
#include "rows/rows.h"
#include "solve/solve.h"
#include "file.h"
#include "input.h"
#include "text/text.h"
#include "until_exit.h"

static void set_constants(uint8_t kind, input_texts *constants)
{
    static const char *const usual[INPUT_COUNT] = {
        [INPUT_E1] = "200e3", [INPUT_NU1] = "0.3", [INPUT_THETA] = "0.01", [INPUT_A] = "2",
        [INPUT_P] = "2000",   [INPUT_Q] = "300",   [INPUT_F] = "0.3",      [INPUT_K] = "300"};
    for (int i = 0; i < INPUT_COUNT; i++)
        if (kind % 8 != 0 && !(kind % 8 == 1 && i == INPUT_P) && !(kind % 8 == 2 && i == INPUT_A))
            constants->text[i] = usual[i];
}

typedef struct {
    batch what;
    output_options how;
    int status;
} run;

static void run_batch(void *of_run)
{
    run *r = of_run;
    r->status = batch_run(&r->what, &r->how);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    const uint8_t kind = take_byte(&in);
    const bool comma = kind / 8 % 4 == 1;
    run r = {.what = {.path = file_of(in.data, in.left),
                      .threads = 1,
                      .wanted = {.yield_factor = kind >= 0xf8}},
             .how = {.format = kind / 8 % 4 == 2 ? &json_format : &delimited_format,
                     .digits = 17,
                     .decimal_sign = comma ? ',' : '.',
                     .separator = comma ? ';' : ',',
                     .path = "/dev/null",
                     .quiet = true}};
    set_constants(kind, &r.what.constants);
    const int ended = until_exit(run_batch, &r), status = ended == NO_EXIT ? r.status : ended;
    CLAIM(status == STATUS_DONE || status == STATUS_FAILED || status == STATUS_USAGE, "%d", status);
    return 0;
}

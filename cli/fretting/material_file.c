/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fretting.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include <jansson.h>

/* The option that a constant of the file stands for. */
static int option_of(int constant)
{
    const int inputs[] = {INPUT_E1, INPUT_NU1, INPUT_YIELD_STRESS};
    return constant < MATERIAL_FS_K ? OPTION_INPUT + inputs[constant - MATERIAL_E]
                                    : OPTION_OF(constant);
}

static void set(const char *file, const char *name, double value, material *all)
{
    const int i = material_constant(name);
    if (i < 0)
        failure("%s: %.60s: no constant that is known here; see rwedge fretting in its manual",
                file, name);
    all->value[i] = value;
}

/* ---- The file ---- */

static void read_json(const char *path, material *all)
{
    json_error_t error;
    json_t *top = json_load_file(path, JSON_REJECT_DUPLICATES, &error), *value;
    const char *name;
    if (top == NULL && error.line < 1) /* not opened */
        failure("%s: %s", path, strerror(errno));
    if (top == NULL)
        failure("%s: line %d: %s", path, error.line, error.text);
    if (!json_is_object(top))
        failure("%s: must be an object of names and numbers", path);
    json_object_foreach(top, name, value)
    {
        if (material_is_remark(name))
            continue;
        if (!json_is_number(value))
            failure("%s: %.60s: must be a number", path, name);
        set(path, name, json_number_value(value), all);
    }
    json_decref(top);
}

static void read_csv(const char *path, const char *encoding, material *all)
{
    csv_input *in = csv_input_open(path, ',', encoding);
    while (csv_input_next(in) == CSV_ROW) {
        const char *const *cells = in->cell;
        double value;
        if (in->count < 2)
            failure("%s: line %" PRId64 ": must be a name and a number", path, in->line);
        if (material_is_remark(cells[0]))
            continue;
        if (!number_read_cell(cells[1], '.', &value))
            failure("%s: line %" PRId64 ": %.60s: must be a number", path, in->line,
                    cells[0]);
        set(path, cells[0], value, all);
    }
    csv_input_check(in);
    csv_input_close(in);
}

/* ---- All ---- */

/* Either all of these or none. */
static void need_group(const char *path, const material *all, int first, int last)
{
    int missing = -1, there = -1;
    for (int i = first; i <= last; i++)
        *(isnan(all->value[i]) ? &missing : &there) = i;
    if (missing >= 0 && there >= 0)
        failure("%s: %s: missing; needed beside %s", path, material_names[missing],
                material_names[there]);
}

/* What the file has stands for options that are not given. k without a yield stress, and su without
 * t_A, say nothing. */
static void hand_over(const material *all, arguments *line)
{
    static char texts[MATERIAL_COUNT][NUMBER_SIZE];
    char **value = line->value;
    for (int i = MATERIAL_E; i < MATERIAL_COUNT; i++) {
        const int option = option_of(i);
        const bool is_idle =
            (i == MATERIAL_FS_K && value[OPTION_INPUT + INPUT_YIELD_STRESS] == NULL) ||
            (i == MATERIAL_SU && value[OPTION_OF(MATERIAL_T_A)] == NULL) ||
            (i == MATERIAL_YIELD_STRESS && value[OPTION_INPUT + INPUT_K] != NULL);
        if (isnan(all->value[i]) || value[option] != NULL || is_idle)
            continue;
        number_write(all->value[i], NUMBER_DIGITS, '.', texts[i]);
        value[option] = texts[i];
    }
}

void material_read(const char *path, arguments *line, material *all)
{
    *all = material_unknown();
    if (path == NULL)
        return;
    const char *ending = strrchr(path, '.');
    if (ending != NULL && strcasecmp(ending, ".json") == 0)
        read_json(path, all);
    else
        read_csv(path, line->value[OPTION_ENCODING], all);
    need_group(path, all, MATERIAL_SF, MATERIAL_C);
    need_group(path, all, MATERIAL_G, MATERIAL_C0);
    need_group(path, all, MATERIAL_DK_TH, MATERIAL_DS0);
    hand_over(all, line);
}

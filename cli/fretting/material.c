/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "material.h"

#include "criteria.h"

#include "input/csv_input.h"
#include "text/message.h"
#include "number/number.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include <jansson.h>
#include <rwedge.h>

/* Constants that options have too. */
static const struct {
    const char *name;
    int option;
} of_options[] = {
    {"E", OPTION_INPUT + INPUT_E1},
    {"nu", OPTION_INPUT + INPUT_NU1},
    {"yield_stress", OPTION_INPUT + INPUT_YIELD_STRESS},
    {"fs_k", OPTION_FS_K},
    {"findley_k", OPTION_FINDLEY_K},
    {"kappa", OPTION_KAPPA},
    {"t_A", OPTION_T_A},
    {"su", OPTION_SU},
    {"crossland_alpha", OPTION_CROSSLAND_ALPHA},
    {"dang_van_alpha", OPTION_DANG_VAN_ALPHA},
};
enum { OF_OPTIONS = sizeof of_options / sizeof of_options[0] };

static const char *const names[MATERIAL_COUNT] = {"swt_limit",
                                                  "fs_limit",
                                                  "findley_limit",
                                                  "lambda",
                                                  "crossland_limit",
                                                  "dang_van_limit",
                                                  "sf",
                                                  "b",
                                                  "ef",
                                                  "c",
                                                  "G",
                                                  "tf",
                                                  "b0",
                                                  "gf",
                                                  "c0",
                                                  "dK_th",
                                                  "ds0"};

/* ---- One constant ---- */

static char texts[OF_OPTIONS][NUMBER_SIZE];

static void set(const char *file, const char *name, double value, material *all)
{
    for (int i = 0; i < MATERIAL_COUNT; i++)
        if (strcmp(name, names[i]) == 0) {
            all->value[i] = value;
            return;
        }
    for (int i = 0; i < OF_OPTIONS; i++)
        if (strcmp(name, of_options[i].name) == 0) {
            number_write(value, NUMBER_DIGITS, '.', texts[i]);
            return;
        }
    failure("%s: %.60s: no constant that is known here; see rwedge fretting in its manual", file,
            name);
}

static bool is_remark(const char *name)
{
    return strcmp(name, "name") == 0 || strcmp(name, "source") == 0;
}

/* ---- The file ---- */

static void read_json(const char *path, material *all)
{
    json_error_t error;
    json_t *top = json_load_file(path, JSON_REJECT_DUPLICATES, &error), *value;
    const char *name;
    if (top == NULL)
        failure("%s: line %d: %s", path, error.line, error.text);
    if (!json_is_object(top))
        failure("%s: must be an object of names and numbers", path);
    json_object_foreach(top, name, value)
    {
        if (is_remark(name))
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
    csv_event event;
    while ((event = csv_input_next(in)) == CSV_ROW) {
        const char *const *cells = csv_input_cells(in);
        double value;
        if (csv_input_count(in) < 2)
            failure("%s: line %" PRId64 ": must be a name and a number", path, csv_input_line(in));
        if (is_remark(cells[0]))
            continue;
        if (!number_read_cell(cells[1], '.', &value))
            failure("%s: line %" PRId64 ": %.60s: must be a number", path, csv_input_line(in),
                    cells[0]);
        set(path, cells[0], value, all);
    }
    if (event != CSV_END)
        csv_input_fail(in);
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
        failure("%s: %s: missing; needed beside %s", path, names[missing], names[there]);
}

/* What the file has stands for options that are not given. k without a yield stress, and su without
 * t_A, say nothing. */
static void hand_over(arguments *line)
{
    char **value = line->value;
    for (int i = 0; i < OF_OPTIONS; i++) {
        const int option = of_options[i].option;
        const bool is_idle =
            (option == OPTION_FS_K && value[OPTION_INPUT + INPUT_YIELD_STRESS] == NULL) ||
            (option == OPTION_SU && value[OPTION_T_A] == NULL) ||
            (option == OPTION_INPUT + INPUT_YIELD_STRESS && value[OPTION_INPUT + INPUT_K] != NULL);
        if (texts[i][0] != '\0' && value[option] == NULL && !is_idle)
            value[option] = texts[i];
    }
}

void material_read(const char *path, arguments *line, material *all)
{
    for (int i = 0; i < MATERIAL_COUNT; i++)
        all->value[i] = NAN;
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
    hand_over(line);
}

double material_allowable(const material *all, int criterion)
{
    const int limit = criterion_kinds[criterion].limit;
    return limit == MATERIAL_COUNT ? 1 : all->value[limit];
}

bool material_has_life(const material *all, int criterion)
{
    return !isnan(all->value[criterion == CRITERION_SWT ? MATERIAL_SF : MATERIAL_G]);
}

double material_length(const material *all)
{
    return rwedge_critical_distance(all->value[MATERIAL_DK_TH], all->value[MATERIAL_DS0]);
}

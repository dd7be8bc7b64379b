/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include <math.h>
#include <string.h>

const test_column test_columns[TEST_COLUMNS] = {
    [TEST_P0] = {"p0", "the largest pressure under P alone, in place of P", "stress", SHARE_NONE},
    [TEST_Q_MAX] = {"Q_max", "the largest Q of the cycle", "force/length", SHARE_OF_WIDTH},
    [TEST_Q_MIN] = {"Q_min", "the smallest; -Q_max unless given", "force/length", SHARE_OF_WIDTH},
    [TEST_SIGMA_MAX] = {"sigma_max", "the largest sigma, with Q_max; 0 unless given", "stress",
                        SHARE_OF_SECTION},
    [TEST_SIGMA_MIN] = {"sigma_min", "the smallest; -sigma_max unless given", "stress",
                        SHARE_OF_SECTION},
    [TEST_SIGMA_BEFORE] = {"sigma_before", "sigma while P comes; 0 unless given", "stress",
                           SHARE_OF_SECTION},
    [TEST_LOADS] = {"loads", "a file of loads, the cycle, in place of Q and sigma", "name",
                    SHARE_NONE},
    [TEST_LIFE] = {"life_tested", "the life measured, in passes of the loads; >1e7: a run-out",
                   "none", SHARE_NONE},
};

bool series_has(const series *all, int i)
{
    return all->column[i] < all->names.count;
}

/* What a contact has is an input; what a crack has is not asked for. */
static bool is_column(int constant)
{
    static const char *const others[] = {"E",   "nu",      "yield_stress", "dK_th",
                                         "ds0", "paris_C", "paris_m",      "K_c"};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (strcmp(material_name(constant), others[i]) == 0)
            return false;
    return true;
}

/* ---- Finding them ---- */

static bool find_test_columns(series *all, header *names, complaint *why)
{
    for (int i = 0; i < TEST_COLUMNS; i++) {
        const test_column *kind = &test_columns[i];
        if (!header_column(names, kind->name, &all->column[i], why))
            return false;
        if (all->column[i] == names->count)
            continue;
        names->is_used[all->column[i]] = true;
        if (strcmp(kind->unit, "name") != 0 && i != TEST_LIFE &&
            !header_need(names, all->column[i], kind->name, kind->unit, kind->of, NEED_NOTHING,
                         why))
            return false;
    }
    return true;
}

static bool find_constants(series *all, header *names, complaint *why)
{
    for (int i = 0; i < material_count(); i++) {
        all->constant[i] = names->count;
        if (!is_column(i))
            continue;
        const char *name = material_name(i);
        if (!header_column(names, name, &all->constant[i], why))
            return false;
        if (all->constant[i] < names->count &&
            !header_need(names, all->constant[i], name, material_unit(i), SHARE_NONE, NEED_NOTHING,
                         why))
            return false;
    }
    return true;
}

/* A Q or a sigma may be an amplitude or a range: which is not guessed. */
static bool refuse_bare(const series *all, int input, int instead, complaint *why)
{
    const char *name = input_kinds[input].column, *other = test_columns[instead].name;
    const header *names = &all->names;
    if (series_has(all, instead) || !header_has(names, name))
        return true;
    complain(why, "column %s: a test has %s, and the smallest where that is not its negative", name,
             other);
    if (names->how->is_command)
        list_add(why->text, sizeof why->text, "; ", "--column %s=%s takes it", other, name);
    return false;
}

static bool has_input(const series *all, int input)
{
    return header_has_input(&all->names, input) || input_is_given(&all->constants, input);
}

static bool gives_loads(const series *all, complaint *why)
{
    const bool has_log = series_has(all, TEST_LOADS);
    const char *lacks = !has_input(all, INPUT_P) && !series_has(all, TEST_P0) ? "P or p0"
                        : !series_has(all, TEST_Q_MAX) && !series_has(all, TEST_SIGMA_MAX)
                            ? "Q_max or sigma_max"
                            : NULL;
    if (has_log || lacks == NULL)
        return true;
    complain(why, "column %s: missing; or loads, the name of a file%s", lacks,
             header_hint(all->names.name, all->names.count));
    if (all->names.how->is_command)
        header_write_names(&all->names, why);
    return false;
}

/* Some number must stand below the header, where the inputs need none. */
static void need_one(series *all, header *names)
{
    static const int wanted[] = {TEST_Q_MAX, TEST_SIGMA_MAX};
    const bool has_log = series_has(all, TEST_LOADS);
    if (header_has_input(names, INPUT_P) && (has_log || series_has(all, TEST_P0)))
        names->needed[names->column[INPUT_P]] = NEED_NOTHING; /* may be empty */
    for (int i = 0; i < 2 && !has_log; i++)
        if (series_has(all, wanted[i])) {
            names->needed[all->column[wanted[i]]] = NEED_NUMBER;
            return;
        }
}

bool series_find(series *all, header *names, complaint *why)
{
    const input_texts *options = &all->constants;
    if (!header_find(0, INPUT_Q, options, names, why) ||
        !header_find(INPUT_F, INPUT_COUNT, options, names, why) ||
        !find_test_columns(all, names, why) || !find_constants(all, names, why))
        return false;
    all->names = *names;
    if (!refuse_bare(all, INPUT_Q, TEST_Q_MAX, why) ||
        !refuse_bare(all, INPUT_SIGMA, TEST_SIGMA_MAX, why) || !gives_loads(all, why))
        return false;
    need_one(all, names);
    all->names = *names;
    return true;
}

material series_constants(const series *all, const material *given)
{
    material constants = *given;
    for (int i = 0; i < material_count(); i++)
        if (all->constant[i] < all->names.count)
            constants.value[i] = 1;
    return constants;
}

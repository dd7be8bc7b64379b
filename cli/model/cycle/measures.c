/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <stdio.h>
#include <string.h>

/* The columns of 1.x, in their order: the library's number, whether it is damage, the part. */
typedef struct {
    int32_t number;
    bool is_damage;
    measure_part part;
} place;

static const place first_columns[] = {
    [MEASURE_STRESS_RANGE] = {RWEDGE_MEASURE_STRESS_RANGE, false, PART_VALUE},
    [MEASURE_SWT] = {RWEDGE_MEASURE_SWT, false, PART_VALUE},
    [MEASURE_SWT_ANGLE] = {RWEDGE_MEASURE_SWT, false, PART_ANGLE},
    {RWEDGE_MEASURE_FATEMI_SOCIE, false, PART_VALUE},
    {RWEDGE_MEASURE_FATEMI_SOCIE, false, PART_ANGLE},
    [MEASURE_SLIP_RANGE] = {RWEDGE_MEASURE_SLIP_RANGE, false, PART_VALUE},
    [MEASURE_RUIZ_F1] = {RWEDGE_MEASURE_RUIZ_F1, false, PART_VALUE},
    [MEASURE_RUIZ_F2] = {RWEDGE_MEASURE_RUIZ_F2, false, PART_VALUE},
    [MEASURE_ENERGY_PER_AREA] = {RWEDGE_MEASURE_ENERGY_PER_AREA, false, PART_VALUE},
    {RWEDGE_MEASURE_SWT, false, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_FATEMI_SOCIE, false, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_FINDLEY, false, PART_VALUE},
    {RWEDGE_MEASURE_FINDLEY, false, PART_ANGLE},
    {RWEDGE_MEASURE_FINDLEY, false, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_MODIFIED_WOHLER, false, PART_VALUE},
    {RWEDGE_MEASURE_MODIFIED_WOHLER, false, PART_ANGLE},
    {RWEDGE_MEASURE_MODIFIED_WOHLER, false, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_MCDIARMID, false, PART_VALUE},
    {RWEDGE_MEASURE_MCDIARMID, false, PART_ANGLE},
    {RWEDGE_MEASURE_MCDIARMID, false, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_CROSSLAND, false, PART_VALUE},
    {RWEDGE_MEASURE_DANG_VAN, false, PART_VALUE},
    {RWEDGE_MEASURE_SWT, true, PART_VALUE},
    {RWEDGE_MEASURE_SWT, true, PART_ANGLE},
    {RWEDGE_MEASURE_SWT, true, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_SWT, true, PART_CYCLES},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_VALUE},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_ANGLE},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_OUT_OF_PLANE},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_CYCLES},
};
enum { FIRST_COLUMNS = sizeof first_columns / sizeof first_columns[0] };

/* ---- What a column is called ---- */

static void name_column(place of, measure_kind *kind)
{
    static const char *const ends[PART_COUNT] = {"", "_angle", "_out_of_plane", "_cycles"};
    const bool is_short =
        of.number == RWEDGE_MEASURE_FATEMI_SOCIE && (of.is_damage || of.part != PART_VALUE);
    const char *name = is_short ? "fs" : rwedge_criterion_name(of.number);
    const bool has_word = of.is_damage && of.part != PART_CYCLES;
    snprintf(kind->column, sizeof kind->column, "%s%s%s", name, has_word ? "_damage" : "",
             ends[of.part]);
}

static const char *meaning_of(place of)
{
    if (of.part == PART_OUT_OF_PLANE)
        return "from its normal to the plane of x and y, 0 to 90 deg";
    if (of.part == PART_CYCLES)
        return "how many cycles that plane has in a pass of the loads";
    if (of.part == PART_ANGLE)
        return of.number == RWEDGE_MEASURE_SWT && !of.is_damage
                   ? "from the surface's normal to that of the plane, deg"
                   : "that of its plane";
    return of.is_damage ? "Miner's sum of a pass of the loads, of its worst plane"
                        : rwedge_criterion_text(of.number);
}

static measure_kind kind_of(place of)
{
    const bool is_value = of.part == PART_VALUE, is_angle = !is_value && of.part != PART_CYCLES;
    const int criterion = of.number + (of.is_damage ? DAMAGE : 0);
    measure_kind kind = {.meaning = meaning_of(of),
                         .unit = is_angle                    ? "deg"
                                 : is_value && !of.is_damage ? rwedge_criterion_unit(of.number)
                                                             : "none",
                         .criterion = criterion_exists(criterion) ? criterion : NO_CRITERION,
                         .part = of.part,
                         .number = is_value && !of.is_damage ? of.number : -1};
    snprintf(kind.title, sizeof kind.title, "%s%s", of.is_damage ? "Damage by the " : "",
             rwedge_criterion_title(of.number));
    name_column(of, &kind);
    return kind;
}

/* ---- All columns ---- */

static bool is_among_first(int32_t number)
{
    for (int i = 0; i < FIRST_COLUMNS; i++)
        if (first_columns[i].number == number)
            return true;
    return false;
}

/* Those of criteria that the library has got since. */
static void add_others(measure_kind kinds[COLUMN_COUNT])
{
    int next = COLUMN_WEAR + 1;
    for (int32_t number = 0; number < rwedge_criterion_count(); number++)
        for (int damage = 0; damage <= 1 && !is_among_first(number); damage++)
            for (int part = 0; part < PART_COUNT && next < COLUMN_COUNT; part++)
                if (criterion_exists(number + damage * DAMAGE) && (damage || part != PART_CYCLES))
                    kinds[next++] = kind_of((place){number, damage, (measure_part)part});
}

/* Made once, before any thread. */
const measure_kind *measure_kind_of(int column)
{
    static measure_kind kinds[COLUMN_COUNT];
    if (kinds[0].column[0] == '\0') {
        for (int i = FIRST_COLUMNS; i < COLUMN_COUNT; i++)
            kinds[i].criterion = NO_CRITERION;
        for (int i = FIRST_COLUMNS - 1; i >= 0; i--)
            kinds[i] = kind_of(first_columns[i]);
        kinds[COLUMN_WEAR] =
            (measure_kind){"wear_depth",   "worn in the cycle, --archard times energy_per_area",
                           "length",       NO_CRITERION,
                           PART_VALUE,     -1,
                           "Depth of wear"};
        add_others(kinds);
    }
    return &kinds[column];
}

int measure_column(int criterion, measure_part part)
{
    int i = COLUMN_COUNT - 1;
    while (i >= 0 &&
           (measure_kind_of(i)->criterion != criterion || measure_kind_of(i)->part != part))
        i--;
    return i;
}

int measure_criterion(int column)
{
    const measure_kind *kind = measure_kind_of(column);
    return kind->part == PART_VALUE ? kind->criterion : NO_CRITERION;
}

int measure_damage(int criterion)
{
    const bool has_damage = !criterion_is_damage(criterion) && criterion_exists(criterion + DAMAGE);
    return has_damage ? criterion + DAMAGE : criterion;
}

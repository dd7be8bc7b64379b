/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cycle.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A measure of the library or its damage, the part, and when it is written. */
typedef struct {
    int32_t number;
    bool is_damage;
    measure_part part;
    column_condition condition;
} place;

/* The columns of 1.x. Those of criteria that the library has got since follow. */
static const place first_columns[] = {
    {RWEDGE_MEASURE_STRESS_RANGE, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_SWT, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_SWT, false, PART_ANGLE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_FATEMI_SOCIE, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_FATEMI_SOCIE, false, PART_ANGLE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_SLIP_RANGE, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_RUIZ_F1, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_RUIZ_F2, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_ENERGY_PER_AREA, false, PART_VALUE, COLUMN_ALWAYS},
    {RWEDGE_MEASURE_SWT, false, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FATEMI_SOCIE, false, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FINDLEY, false, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FINDLEY, false, PART_ANGLE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FINDLEY, false, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_MODIFIED_WOHLER, false, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_MODIFIED_WOHLER, false, PART_ANGLE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_MODIFIED_WOHLER, false, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_MCDIARMID, false, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_MCDIARMID, false, PART_ANGLE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_MCDIARMID, false, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_CROSSLAND, false, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_DANG_VAN, false, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_SWT, true, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_SWT, true, PART_ANGLE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_SWT, true, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_SWT, true, PART_CYCLES, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_VALUE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_ANGLE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_OUT_OF_PLANE, COLUMN_OF_CRITERION},
    {RWEDGE_MEASURE_FATEMI_SOCIE, true, PART_CYCLES, COLUMN_OF_CRITERION},
};
enum { FIRST_COLUMNS = sizeof first_columns / sizeof first_columns[0] };

/* ---- Multiples ---- */

static bool is_of_friction(int32_t number)
{
    return number >= RWEDGE_MEASURE_SLIP_RANGE && number <= RWEDGE_MEASURE_ENERGY_PER_AREA;
}

static double archard(const criteria *asked)
{
    return asked->archard;
}

/* Multiples of measures, in their own words; each is a column after those above. */
static const struct {
    int32_t number;
    column_condition condition;
    const char *column, *meaning, *unit, *title;
    double (*times)(const criteria *asked);
} multiples[] = {
    {RWEDGE_MEASURE_ENERGY_PER_AREA, COLUMN_OF_ARCHARD, "wear_depth",
     "worn in a pass of the loads, --archard times energy_per_area", "length", "Depth of wear",
     archard},
};
enum { MULTIPLES = sizeof multiples / sizeof multiples[0] };

static measure_kind multiple_kind(int i)
{
    measure_kind kind = {.number = multiples[i].number,
                         .part = PART_MULTIPLE,
                         .condition = multiples[i].condition,
                         .criterion = NO_CRITERION,
                         .meaning = multiples[i].meaning,
                         .unit = multiples[i].unit,
                         .is_of_friction = is_of_friction(multiples[i].number),
                         .times = multiples[i].times};
    snprintf(kind.column, sizeof kind.column, "%s", multiples[i].column);
    snprintf(kind.title, sizeof kind.title, "%s", multiples[i].title);
    return kind;
}

/* ---- What a column is called ---- */

static void name_column(place of, measure_kind *kind)
{
    static const char *const ends[CRITERION_PARTS] = {"", "_angle", "_out_of_plane", "_cycles"};
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

static const char *unit_of(place of)
{
    if (of.part == PART_ANGLE || of.part == PART_OUT_OF_PLANE)
        return "deg";
    return of.part == PART_VALUE && !of.is_damage ? rwedge_criterion_unit(of.number) : "none";
}

static measure_kind kind_of(place of)
{
    const int criterion = of.number + (of.is_damage ? DAMAGE : 0);
    const bool is_criterion = criterion_exists(criterion);
    measure_kind kind = {.number = of.number,
                         .is_damage = of.is_damage,
                         .part = of.part,
                         .condition = of.condition,
                         .is_of_friction = is_of_friction(of.number),
                         .criterion = is_criterion ? criterion : NO_CRITERION};
    kind.meaning = meaning_of(of);
    kind.unit = unit_of(of);
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

typedef struct {
    measure_kind list[COLUMN_MAX];
    int count;
} all_columns;

/* Adds the columns of criteria that the library has got since. */
static void add_others(all_columns *all)
{
    for (int32_t number = 0; number < rwedge_criterion_count(); number++)
        for (int damage = 0; damage <= 1 && !is_among_first(number); damage++)
            for (int part = 0; part < CRITERION_PARTS && all->count < COLUMN_MAX; part++)
                if (criterion_exists(number + damage * DAMAGE) && (damage || part != PART_CYCLES))
                    all->list[all->count++] =
                        kind_of((place){number, damage, (measure_part)part, COLUMN_OF_CRITERION});
}

/* Made once, before any thread. */
static const all_columns *columns_known(void)
{
    static all_columns all;
    if (all.count > 0)
        return &all;
    for (int i = 0; i < FIRST_COLUMNS; i++)
        all.list[i] = kind_of(first_columns[i]);
    for (int i = 0; i < MULTIPLES; i++)
        all.list[FIRST_COLUMNS + i] = multiple_kind(i);
    all.count = FIRST_COLUMNS + MULTIPLES;
    add_others(&all);
    return &all;
}

int measure_count(void)
{
    return columns_known()->count;
}

const measure_kind *measure_kind_of(int column)
{
    return &columns_known()->list[column];
}

int measure_column_named(const char *name)
{
    int i = measure_count() - 1;
    while (i >= 0 && strcmp(measure_kind_of(i)->column, name) != 0)
        i--;
    return i;
}

int measure_column_of(int32_t number, bool is_damage, measure_part part)
{
    const all_columns *all = columns_known();
    int i = all->count - 1;
    while (i >= 0 && (all->list[i].number != number || all->list[i].is_damage != is_damage ||
                      all->list[i].part != part))
        i--;
    return i;
}

int measure_column(int criterion, measure_part part)
{
    const bool is_damage = criterion_is_damage(criterion);
    return measure_column_of(is_damage ? criterion - DAMAGE : criterion, is_damage, part);
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

bool column_is_wanted(const criteria *asked, int column)
{
    const measure_kind *kind = measure_kind_of(column);
    switch (kind->condition) {
    case COLUMN_OF_ARCHARD:
        return !isnan(asked->archard);
    case COLUMN_OF_CRITERION:
        return asked->is_wanted[kind->criterion];
    default:
        return true;
    }
}

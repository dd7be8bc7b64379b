/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "entry.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char HEADER[] = "a_over_b,f,nu,P_over_bk,x_over_b,y_over_b,branch,";
enum { COLUMNS = 7, LONGEST_LINE = 512 };

static bool complain(const char *file, size_t line, const char *what)
{
    fprintf(stderr, "certificate: %s:%zu: %s\n", file, line, what);
    return false;
}

static bool set_decimal(arb_t number, const char *text)
{
    return *text && arb_set_str(number, text, BITS) == 0 && arb_is_finite(number);
}

static void set_kappa(arb_t kappa, const arb_t nu)
{
    arb_mul_2exp_si(kappa, nu, 1);
    arb_sub_ui(kappa, kappa, 1, BITS);
    arb_mul(kappa, kappa, kappa, BITS);
    arb_div_ui(kappa, kappa, 3, BITS);
}

static void entry_init(entry *e)
{
    memset(e, 0, sizeof *e);
    arb_init(e->alpha), arb_init(e->f), arb_init(e->kappa), arb_init(e->limit), arb_init(e->least),
        arb_init(e->most);
    acb_init(e->place);
}

static void entry_clear(entry *e)
{
    arb_clear(e->alpha), arb_clear(e->f), arb_clear(e->kappa), arb_clear(e->limit),
        arb_clear(e->least), arb_clear(e->most);
    acb_clear(e->place);
}

static bool entry_parse(entry *e, char *const cell[COLUMNS])
{
    if (strlen(cell[0]) >= sizeof e->a_over_b || !set_decimal(e->alpha, cell[0]) ||
        !set_decimal(e->f, cell[1]) || !set_decimal(e->kappa, cell[2]) ||
        !set_decimal(e->limit, cell[3]) || !set_decimal(acb_realref(e->place), cell[4]) ||
        !set_decimal(acb_imagref(e->place), cell[5]))
        return false;
    strcpy(e->a_over_b, cell[0]);
    set_kappa(e->kappa, e->kappa);
    e->at_surface = strcmp(cell[6], "surface") == 0;
    return arb_is_positive(e->alpha) && !arb_is_negative(e->f) && arb_is_positive(e->limit) &&
           !arb_is_negative(acb_imagref(e->place)) &&
           (e->at_surface || strcmp(cell[6], "subsurface") == 0);
}

/* The first COLUMNS cells of the line, cut apart in place. */
static bool cut(char *line, char *cell[COLUMNS])
{
    for (int i = 0; i < COLUMNS; i++) {
        cell[i] = line;
        line = strchr(line, ',');
        if (!line)
            return false;
        *line++ = '\0';
    }
    return true;
}

bool entries_read(entry **entries, size_t *count, const char *file)
{
    FILE *stream = fopen(file, "r");
    if (!stream)
        return complain(file, 0, "cannot be read");
    char line[LONGEST_LINE];
    bool good = fgets(line, sizeof line, stream) && strncmp(line, HEADER, sizeof HEADER - 1) == 0;
    if (!good)
        complain(file, 1, "not a table of elastic limits");
    for (size_t number = 2; good && fgets(line, sizeof line, stream); number++) {
        entry *more = realloc(*entries, (*count + 1) * sizeof *more);
        if (!more)
            abort();
        *entries = more;
        entry *e = &more[(*count)++];
        entry_init(e);
        e->file = file;
        e->line = number;
        char *cell[COLUMNS];
        good = cut(line, cell) && entry_parse(e, cell);
        if (!good)
            complain(file, number, "not an entry");
    }
    fclose(stream);
    return good;
}

void entries_free(entry *entries, size_t count)
{
    for (size_t i = 0; i < count; i++)
        entry_clear(&entries[i]);
    free(entries);
}

static int compare(const void *left, const void *right)
{
    const entry *a = left, *b = right;
    const int by_alpha = arf_cmp(arb_midref(a->alpha), arb_midref(b->alpha));
    if (by_alpha)
        return by_alpha;
    const int by_file = strcmp(a->file, b->file);
    return by_file ? by_file : (a->line > b->line) - (a->line < b->line);
}

void entries_sort(entry *entries, size_t count)
{
    qsort(entries, count, sizeof *entries, compare);
}

double entry_distance(const entry *e)
{
    const double stated = ball_lower(e->limit);
    return fmax(fabs(ball_lower(e->most) - stated), fabs(ball_lower(e->least) - stated)) / stated;
}

bool entry_is_rounded(const entry *e)
{
    enum { DIGITS = 10 };
    arb_t half_unit, upper, lower;
    arb_init(half_unit), arb_init(upper), arb_init(lower);
    arb_set_ui(half_unit, 10);
    arb_pow_ui(half_unit, half_unit, DIGITS - 1 - (ulong)floor(log10(ball_lower(e->limit))), BITS);
    arb_inv(half_unit, half_unit, BITS);
    arb_mul_2exp_si(half_unit, half_unit, -1);
    arb_add(upper, e->limit, half_unit, BITS);
    arb_sub(lower, e->limit, half_unit, BITS);
    const bool rounded = arb_le(e->most, upper) && arb_ge(e->least, lower);
    arb_clear(half_unit), arb_clear(upper), arb_clear(lower);
    return rounded;
}

double entry_limit_there(const entry *e)
{
    return ball_lower(e->most);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- Quantities ---- What stands between braces in a formula. */

typedef struct {
    const char *name, *symbol;
    double value;
} quantity;

enum { QUANTITIES = 32 }; /* more than there are names below */

typedef struct {
    quantity all[QUANTITIES];
    int quantities, count;
    equation *to;
} list;

static double quantity_value(const list *into, const char *name)
{
    for (int i = 0; i < into->quantities; i++)
        if (strcmp(into->all[i].name, name) == 0)
            return into->all[i].value;
    return NAN;
}

static void know(list *into, const char *name, const char *symbol, double value)
{
    into->all[into->quantities++] = (quantity){name, symbol, value};
}

static void put_quantity(const quantity *it, bool as_number, char *text, size_t size)
{
    char digits[NUMBER_SIZE];
    if (!as_number) {
        list_add(text, size, "", "%s", it->symbol);
        return;
    }
    number_write(it->value, 6, '.', digits);
    list_add(text, size, "", it->value < 0 ? "(%s)" : "%s", digits);
}

/* The formula with symbols, or with numbers, in place of its names. */
static void put_formula(const list *from, const char *formula, bool as_number, char *text,
                        size_t size)
{
    text[0] = '\0';
    while (*formula != '\0') {
        const int plain = (int)strcspn(formula, "{");
        list_add(text, size, "", "%.*s", plain, formula);
        formula += plain;
        if (*formula == '\0')
            return;
        const size_t length = strcspn(++formula, "}");
        for (int i = 0; i < from->quantities; i++)
            if (strlen(from->all[i].name) == length &&
                strncmp(from->all[i].name, formula, length) == 0)
                put_quantity(&from->all[i], as_number, text, size);
        formula += length + 1;
    }
}

/* A result that is empty has no equation. Its name is known to those that follow. */
static void add(list *into, const char *name, const char *symbol, const char *formula, double value,
                const char *unit)
{
    equation *next = &into->to[into->count];
    if (isnan(value) || into->count == EQUATIONS_MAX)
        return;
    *next = (equation){.name = symbol, .value = value, .unit = unit};
    put_formula(into, formula, false, next->symbols, sizeof next->symbols);
    put_formula(into, formula, true, next->numbers, sizeof next->numbers);
    into->count++;
    if (isnan(quantity_value(into, name)))
        know(into, name, symbol, value);
}

static double result_number(const results *answer, int result)
{
    const cell *value = &answer->value[result];
    return value->text == NULL ? value->number : NAN;
}

/* ---- Bodies ---- */

static void add_compliance(const contact_case *setup, list *into)
{
    const bool is_rigid = isinf(setup->E2);
    const char *formula = setup->is_plane_stress ? (is_rigid ? "2/{E1}" : "2/{E1} + 2/{E2}")
                          : is_rigid             ? "2·(1 − {nu1}²)/{E1}"
                                     : "2·(1 − {nu1}²)/{E1} + 2·(1 − {nu2}²)/{E2}";
    know(into, "E1", "E₁", setup->E1);
    know(into, "nu1", "ν₁", setup->nu1);
    know(into, "E2", "E₂", setup->E2);
    know(into, "nu2", "ν₂", setup->nu2);
    add(into, "A", "A", formula, setup->A, "1/stress");
}

/* ---- The contact under P alone ---- */

static void add_wedge(const results *answer, list *into)
{
    add(into, "R", "R", "{a}/{theta}", result_number(answer, RESULT_RADIUS), "length");
    add(into, "N", "N", "(asin({a}/{b}) + {a}/{b}·sqrt(1 − ({a}/{b})²))·{b}/{a}",
        result_number(answer, RESULT_AP_OVER_THETA_B), "none");
    add(into, "b", "b", "{A}·{P}/({theta}·{N})", result_number(answer, RESULT_B), "length");
    add(into, "p0", "p₀",
        "2/π·{theta}/{A}·(asin({a}/{b})·{b}/{a} + ln((1 + sqrt(1 − ({a}/{b})²))·{b}/{a}))",
        result_number(answer, RESULT_P0), "stress");
    add(into, "", "p(a)",
        "2/π·{theta}/{A}·(asin({a}/{b})·{b}/{a}·sqrt(1 − ({a}/{b})²) + ln({b}/{a}))",
        result_number(answer, RESULT_P_TRANSITION), "stress");
}

static void add_sharp_wedge(const results *answer, list *into)
{
    add(into, "N", "N", "2", result_number(answer, RESULT_AP_OVER_THETA_B), "none");
    add(into, "b", "b", "{A}·{P}/({theta}·{N})", result_number(answer, RESULT_B), "length");
}

static void add_cylinder(const results *answer, list *into)
{
    add(into, "b", "b", "sqrt(2·{A}·{P}·{R}/π)", result_number(answer, RESULT_B), "length");
    add(into, "p0", "p₀", "2·{P}/(π·{b})", result_number(answer, RESULT_P0), "stress");
}

static void add_flat(const contact_case *setup, list *into)
{
    add(into, "", "P", "{b}²·(acos({a}/{b}) − {a}/{b}·sqrt(1 − ({a}/{b})²))/({A}·{R})", setup->P,
        "force/length");
}

/* ---- Friction ---- */

/* How the stick zone follows from b, of each way to touch. */
typedef enum { TOUCH_SHARP, TOUCH_ROUNDED, TOUCH_HERTZ, TOUCH_FLAT } touch;

static touch touch_of(const contact_case *setup, double b)
{
    const pad *shape = &setup->shape;
    return shape->kind == PAD_FLAT                        ? TOUCH_FLAT
           : shape->kind == PAD_CYLINDER || shape->a >= b ? TOUCH_HERTZ
           : shape->a == 0                                ? TOUCH_SHARP
                                                          : TOUCH_ROUNDED;
}

/* The stick zone is the contact under the load P (1 - Q/(fP)). */
static void add_stick_zone(touch way, const results *answer, list *into)
{
    const double ratio = fabs(result_number(answer, RESULT_Q_OVER_FP)),
                 c = result_number(answer, RESULT_C);
    const bool is_narrow = c <= quantity_value(into, "a");
    if (!(c > 0) || !(ratio > 0))
        return;
    if (way == TOUCH_HERTZ || way == TOUCH_SHARP) {
        add(into, "c", "c", way == TOUCH_HERTZ ? "{b}·sqrt(1 − {q})" : "{b}·(1 − {q})", c,
            "length");
        return;
    }
    know(into, "c", "c", c);
    add(into, "", "1 − Q/(fP)",
        way == TOUCH_FLAT ? "{c}²·(acos({a}/{c}) − {a}/{c}·sqrt(1 − ({a}/{c})²))/"
                            "({b}²·(acos({a}/{b}) − {a}/{b}·sqrt(1 − ({a}/{b})²)))"
        : is_narrow       ? "π·{c}²/(2·{a}·{b}·{N})"
                    : "{c}²·(asin({a}/{c}) + {a}/{c}·sqrt(1 − ({a}/{c})²))/({a}·{b}·{N})",
        1 - ratio, "none");
}

static void add_friction(const contact_case *setup, touch way, const results *answer, list *into)
{
    const double ratio = result_number(answer, RESULT_Q_OVER_FP);
    add(into, "q", "Q/(fP)", "{Q}/({f}·{P})", ratio, "none");
    if (fabs(ratio) < 1 && setup->sigma == 0 && !setup->has_history)
        add_stick_zone(way, answer, into);
    add(into, "", "σ of full sliding",
        way == TOUCH_FLAT    ? "2·{f}·({b} − {a})/({A}·{R})"
        : way == TOUCH_HERTZ ? "2·{f}·{b}/({A}·{R})"
                             : "2·{f}·{theta}/{A}",
        result_number(answer, RESULT_TENSION_SLIDING), "stress");
}

/* ---- Strength ---- */

static void add_strength(const contact_case *setup, const results *answer, list *into)
{
    const double P_yield = result_number(answer, RESULT_P_YIELD),
                 P_shakedown = result_number(answer, RESULT_P_SHAKEDOWN);
    if (isnan(setup->k))
        return;
    know(into, "Y", "Y", setup->k * SQRT_3);
    add(into, "k", "k", "{Y}/sqrt(3)", setup->k, "stress");
    add(into, "", "P/(bk)", "{P}/({b}·{k})", result_number(answer, RESULT_LOAD_OVER_BK), "none");
    if (P_yield > 0)
        know(into, "P_yield", "P_yield", P_yield);
    if (P_shakedown > 0)
        know(into, "P_shakedown", "P_shakedown", P_shakedown);
    add(into, "", "safety", "{P_yield}/{P}",
        P_yield > 0 ? result_number(answer, RESULT_SAFETY) : NAN, "none");
    add(into, "", "safety of shakedown", "{P_shakedown}/{P}",
        P_shakedown > 0 ? result_number(answer, RESULT_SAFETY_SHAKEDOWN) : NAN, "none");
}

/* ---- All ---- */

static void add_contact(const contact_case *setup, const results *answer, list *into)
{
    const pad *shape = &setup->shape;
    const double b = result_number(answer, RESULT_B);
    const touch way = touch_of(setup, b);
    know(into, "a", "a", way == TOUCH_FLAT ? shape->flat : shape->a);
    if (way == TOUCH_HERTZ || way == TOUCH_FLAT)
        know(into, "R", "R", shape->radius);
    if (way == TOUCH_ROUNDED || way == TOUCH_FLAT)
        know(into, "b", "b", b); /* the root of what follows */
    if (way == TOUCH_ROUNDED)
        add_wedge(answer, into);
    else if (way == TOUCH_SHARP)
        add_sharp_wedge(answer, into);
    else if (way == TOUCH_HERTZ)
        add_cylinder(answer, into);
    else
        add_flat(setup, into);
    if (setup->f > 0)
        add_friction(setup, way, answer, into);
}

/* Under a moment the contact is another one. */
int equations_of(const contact_case *setup, const results *answer, equation to[EQUATIONS_MAX])
{
    list into = {.to = to};
    add_compliance(setup, &into);
    know(&into, "theta", "θ", setup->shape.theta);
    know(&into, "P", "P", setup->P);
    know(&into, "Q", "Q", setup->Q);
    know(&into, "f", "f", setup->f);
    if (setup->shape.kind != PAD_PROFILE && setup->M == 0 && !setup->is_held && !setup->is_coupled)
        add_contact(setup, answer, &into);
    else
        know(&into, "b", "b", result_number(answer, RESULT_B));
    add_strength(setup, answer, &into);
    return into.count;
}

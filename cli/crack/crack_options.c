/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "crack.h"

#include <math.h>
#include <string.h>

struct poptOption crack_option_table[] = {
    {VALUE("edge", OPTION_EDGE), "The mouth: an edge of the largest contact of the cycle",
     "left|right"},
    {VALUE("x", OPTION_X), "Or its place", "NUMBER"},
    {VALUE("angle", OPTION_ANGLE),
     "From the surface's normal towards +x, -75 to 75 deg (default 0)", "NUMBER"},
    {VALUE("angle-range", OPTION_ANGLE_RANGE), "Or several; the worst is named", "RANGE"},
    {VALUE("lengths", OPTION_LENGTHS), "Lengths of the crack, ascending", "RANGE"},
    {VALUE("from", OPTION_FROM), "Or 25 lengths from this one", "NUMBER"},
    {VALUE("to", OPTION_TO), "to that one, each longer by the same factor", "NUMBER"},
    {VALUE("shear", OPTION_SHEAR),
     "How K_II counts: not at all, while the crack is open, always (default: all three)",
     "none|locked|free"},
    {VALUE("dK-th", OPTION_DK_TH), "Threshold of long cracks, a range of K", "NUMBER"},
    {VALUE("ds0", OPTION_DS0), "Plain fatigue limit, a range of stress: for short cracks",
     "NUMBER"},
    {VALUE("C", OPTION_PARIS_C), "Growth a cycle is C (dK^m - threshold^m)", "NUMBER"},
    {VALUE("m", OPTION_PARIS_M), "its exponent, 0.1 to 100", "NUMBER"},
    {VALUE("K-c", OPTION_K_C), "K at which it breaks", "NUMBER"},
    POPT_TABLEEND,
};

/* ---- Constants ---- */

static const struct {
    int option;
    const char *flag, *name; /* that of a material */
} constants_of_law[] = {{OPTION_PARIS_M, "--m", "paris_m"},
                        {OPTION_DK_TH, "--dK-th", "dK_th"},
                        {OPTION_DS0, "--ds0", "ds0"},
                        {OPTION_K_C, "--K-c", "K_c"},
                        {OPTION_PARIS_C, "--C", "paris_C"}};
enum { LAW_COUNT = sizeof constants_of_law / sizeof constants_of_law[0] };

static const char *flag_of(const char *name)
{
    int i = 0;
    while (strcmp(constants_of_law[i].name, name) != 0)
        i++;
    return constants_of_law[i].flag;
}

/* An option stands for what the material has; the exponent comes before what needs it. */
static void take_option(const arguments *line, int i, material *all)
{
    const char *text = line->value[constants_of_law[i].option];
    const int constant = material_constant(constants_of_law[i].name);
    complaint why;
    if (text == NULL || material_take(constant, text, '.', units_of(line), all, &why))
        return;
    const bool lacks_unit = strncmp(why.text, "needs its unit", 14) == 0;
    usage_error("%s %s: %s%s", constants_of_law[i].flag, text, why.text,
                lacks_unit
                    ? ", beside --units; or --K-in m where its root is of m, as in MPa sqrt(m), "
                      "mm where it is of mm, 31.6 times as large"
                    : "");
}

void crack_law_read(const arguments *line, const material *constants, crack_law *law)
{
    const char *exponent = line->value[OPTION_PARIS_M];
    material all = *constants;
    if (line->value[OPTION_PARIS_C] != NULL && exponent == NULL &&
        isnan(material_value(constants, "paris_m")))
        usage_error("--m: missing; needed beside --C");
    for (int i = 0; i < LAW_COUNT; i++)
        take_option(line, i, &all);
    *law = crack_law_of(&all);
    if (law->m < crack_least_m || law->m > crack_most_m)
        usage_error("--m %s: must be a number from %g to %g", exponent != NULL ? exponent : "",
                    crack_least_m, crack_most_m);
    const char *beside, *lacks = crack_law_lacks(law, &beside);
    if (lacks != NULL)
        usage_error("%s: missing; needed beside %s", flag_of(lacks), flag_of(beside));
    if (isnan(law->dK_th) && isnan(law->C) && isnan(law->K_c) && line->value[OPTION_K_IN] != NULL)
        usage_error("--K-in %s: needs --dK-th, --C or --K-c", line->value[OPTION_K_IN]);
    units_say_of_K(line);
}

/* ---- The crack ---- */

static double read_number(const arguments *line, int option, const char *name, double low,
                          double high)
{
    const char *text = line->value[option];
    double value;
    if (!(number_read(text, &value) && value >= low && value <= high))
        usage_error("--%s %s: must be a number from %g to %g", name, text, low, high);
    return value;
}

static double read_mouth(const arguments *line, const last_cycle *last)
{
    const char *edge = line->value[OPTION_EDGE], *x = line->value[OPTION_X];
    if ((edge != NULL) == (x != NULL))
        usage_error("--edge: %s; one of --edge left, --edge right and --x NUMBER is needed",
                    edge == NULL ? "missing" : "given together with --x");
    if (x != NULL)
        return read_number(line, OPTION_X, "x", -1e60, 1e60);
    const bool is_left = strcmp(edge, "left") == 0;
    if (!is_left && strcmp(edge, "right") != 0)
        usage_error("--edge %s: must be left or right", edge);
    if (isnan(last->left))
        usage_error("--edge %s: there is no contact in the cycle; allowed: --x", edge);
    return is_left ? last->left : last->right;
}

static void read_angles(const arguments *line, crack_plan *plan)
{
    const char *one = line->value[OPTION_ANGLE], *several = line->value[OPTION_ANGLE_RANGE];
    double outside;
    if (one != NULL && several != NULL)
        usage_error("--angle %s: given together with --angle-range; allowed: one of the two", one);
    plan->has_angles = several != NULL;
    range_option(plan->has_angles ? "angle-range" : "angle",
                 several != NULL ? several
                 : one != NULL   ? one
                                 : "0",
                 &plan->angles);
    if (!range_within(&plan->angles, -75, 75, &outside))
        usage_error("--angle%s %s: %g is outside -75 to 75 degrees",
                    plan->has_angles ? "-range" : "", several != NULL ? several : one, outside);
    if (one != NULL && plan->angles.count != 1)
        usage_error("--angle %s: must be one number; several are --angle-range", one);
}

enum { LENGTHS_MAX = 10000, LENGTHS_USUAL = 25 };

static void read_from_to(const arguments *line, crack_plan *plan)
{
    if (line->value[OPTION_FROM] == NULL || line->value[OPTION_TO] == NULL)
        usage_error("--%s: missing; --lengths, or --from and --to, are needed",
                    line->value[OPTION_FROM] != NULL ? "to"
                    : line->value[OPTION_TO] != NULL ? "from"
                                                     : "lengths");
    const double from = read_number(line, OPTION_FROM, "from", 1e-60, 1e60),
                 to = read_number(line, OPTION_TO, "to", 1e-60, 1e60);
    if (from >= to)
        usage_error("--from %s: must be below --to %s", line->value[OPTION_FROM],
                    line->value[OPTION_TO]);
    plan->crack.lengths = LENGTHS_USUAL;
    plan->crack.length = memory_zeroed(plan->crack.lengths, sizeof *plan->crack.length);
    crack_lengths(from, to, plan->crack.lengths, plan->crack.length);
}

static void read_lengths(const arguments *line, crack_plan *plan)
{
    const char *text = line->value[OPTION_LENGTHS];
    range values;
    if (text == NULL) {
        read_from_to(line, plan);
        return;
    }
    if (line->value[OPTION_FROM] != NULL || line->value[OPTION_TO] != NULL)
        usage_error("--lengths %s: given together with --%s; allowed: one of the two", text,
                    line->value[OPTION_FROM] != NULL ? "from" : "to");
    range_option("lengths", text, &values);
    if (values.count > LENGTHS_MAX)
        usage_error("--lengths %s: must not have more than %d values", text, LENGTHS_MAX);
    plan->crack.lengths = (size_t)values.count;
    plan->crack.length = memory_zeroed(plan->crack.lengths, sizeof *plan->crack.length);
    for (size_t i = 0; i < plan->crack.lengths; i++) {
        plan->crack.length[i] = range_value(&values, (int64_t)i);
        if (!(plan->crack.length[i] >= 1e-60 && plan->crack.length[i] <= 1e60) ||
            (i > 0 && plan->crack.length[i] <= plan->crack.length[i - 1]))
            usage_error("--lengths %s: must ascend, and be 1e-60 to 1e60", text);
    }
}

static void read_shear(const char *text, crack_plan *plan)
{
    bool is_known = text == NULL;
    for (int i = 0; i < SHEARS; i++) {
        plan->crack.is_wanted[i] = text == NULL || strcmp(text, shear_names[i]) == 0;
        is_known = is_known || plan->crack.is_wanted[i];
    }
    if (!is_known)
        usage_error("--shear %s: must be none, locked or free", text);
}

/* The unit of the lengths, which constants of K need. */
static const char *unit_of_length(const arguments *line)
{
    static const struct {
        double metres;
        const char *name;
    } units[] = {{1, "m"}, {1e-3, "mm"}, {1e-6, "um"}, {0.0254, "in"}};
    const unit_system *working = units_of(line);
    for (size_t i = 0; i < sizeof units / sizeof units[0] && working->is_known; i++)
        if (working->length == units[i].metres)
            return units[i].name;
    return working->is_known ? "units of length" : "mm";
}

void crack_read(const arguments *line, const last_cycle *last, crack_plan *plan)
{
    plan->crack.last = last;
    plan->crack.unit = unit_of_length(line);
    plan->crack.x = read_mouth(line, last);
    read_angles(line, plan);
    read_lengths(line, plan);
    read_shear(line->value[OPTION_SHEAR], plan);
}

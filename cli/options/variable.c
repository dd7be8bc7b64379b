/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "options.h"

#include "text/text.h"

#include <math.h>
#include <string.h>

const table_variable variables[FIGURE_VARIABLES] = {
    [A_OVER_B] = {"a-over-b", "a_over_b", "a/b", 0, HUGE_VAL, "a number not below 0", "0.1:1:0.1"},
    [FRICTION] = {"friction", "f", "the coefficient of friction", 0, 1e6, "a number from 0 to 1e6",
                  "0:0.8:0.0125"},
    [NU] = {"nu", "nu", "Poisson's ratio", 0, 0.5, "a number from 0 to 0.5", "0.3"},
    [Q_OVER_FP] = {"q-over-fp", "Q_over_fP", "Q/(fP)", 0, 1, "a number from 0 to 1", "0:1:0.05"},
    [BETA_F] = {"beta-f", "beta_f", "beta times f", -1, 1, "a number from -1 to 1", "-0.05,0,0.05"},
    [C_OVER_B] = {"c-over-b", "c_over_b", "c/b", 0, 1, "a number from 0 to 1", ""},
    [SIGMA_OVER_MAX] = {"sigma-over-max", "sigma_over_max", "the bulk tension", -1, 1,
                        "a number from -1 to 1", ""},
};

static void read_range(const char *option, const char *text, range *values)
{
    const char *reason = range_read(text, values);
    if (reason != NULL)
        usage_error("--%s %s: %s", option, text, reason);
}

void range_option(const char *option, const char *text, range *values)
{
    read_range(option, text, values);
    range_say_pair(option, text, text, strlen(text));
}

static void read_values(const table_variable *variable, const char *text, range *values)
{
    char value[NUMBER_SIZE];
    double outside;
    read_range(variable->option, text, values);
    if (range_within(values, variable->lo, variable->hi, &outside))
        return;
    number_write(outside, NUMBER_DIGITS, '.', value);
    const bool is_one = strpbrk(text, ":,") == NULL;
    usage_error("--%s %s: %s must be %s%s%s%s", variable->option, text, variable->name,
                variable->domain, is_one ? "" : ", not ", is_one ? "" : value,
                strchr(text, ',') != NULL ? " (a comma separates the numbers of a list)" : "");
}

void variable_read(const table_variable *variable, const char *text, range *values)
{
    if (text == NULL)
        text = variable->usual;
    read_values(variable, text, values);
    range_say_pair(variable->option, text, text, strlen(text));
}

double variable_read_one(const table_variable *variable, const char *text)
{
    range values;
    read_values(variable, text, &values);
    if (values.count > 1)
        usage_error("--%s %s: must be one number", variable->option, text);
    return range_value(&values, 0);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "header.h"

#include "text/list.h"
#include "text/message.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool copy_names(const csv_input *in, header *names)
{
    names->name = calloc(csv_input_count(in), sizeof *names->name);
    for (size_t i = 0; names->name != NULL && i < csv_input_count(in); i++, names->count++) {
        names->name[i] = strdup(csv_input_cell(in, i));
        if (names->name[i] == NULL)
            break;
    }
    if (names->count == csv_input_count(in))
        return true;
    failure("out of memory");
    return false;
}

/* Letters beyond ASCII count, byte by byte. */
static bool is_filler(char c)
{
    return (unsigned char)c < 0x80 && !isalnum((unsigned char)c);
}

/* Whether two names have the same letters and digits, whatever stands between them. The first has
 * `length` bytes. */
static bool is_like(const char *a, size_t length, const char *b)
{
    for (const char *end = a + length;; a++, b++) {
        while (a < end && is_filler(*a))
            a++;
        while (*b != '\0' && is_filler(*b))
            b++;
        if (a == end || *b == '\0')
            return a == end && *b == '\0';
        if (tolower((unsigned char)*a) != tolower((unsigned char)*b))
            return false;
    }
}

/* ---- Columns that are inputs ---- */

static bool find(const csv_input *in, int input, header *names)
{
    char column[INPUT_NAME_SIZE];
    input_column(input, column);
    for (size_t i = 0; i < names->count; i++) {
        if (strcmp(names->name[i], column) != 0)
            continue;
        if (names->column[input] < names->count) {
            failure("%s: column %s: there twice; allowed: once", csv_input_name(in), column);
            return false;
        }
        names->column[input] = i;
    }
    return true;
}

/* ---- Columns that are probably meant for an input ---- */

/* Other usual names of inputs. Where the input is given by its own name too, they are columns like
 * any other. */
static const struct {
    const char *name;
    int input;
} synonyms[] = {
    {"mu", INPUT_F},
    {"\xce\xbc", INPUT_F}, /* the Greek letter */
    {"\xc2\xb5", INPUT_F}, /* the sign for micro, which keyboards have */
    {"friction", INPUT_F},
    {"friction_coefficient", INPUT_F},
    {"coefficient_of_friction", INPUT_F},
    {"cof", INPUT_F},
    {"Reibwert", INPUT_F},
    {"Reibbeiwert", INPUT_F},
    {"Reibungszahl", INPUT_F},
    {"Reibungskoeffizient", INPUT_F},
    {"frottement", INPUT_F},
    {"coefficient_de_frottement", INPUT_F},
    {"attrito", INPUT_F},
    {"coefficiente_di_attrito", INPUT_F},
    {"rozamiento", INPUT_F},
    {"coeficiente_de_rozamiento", INPUT_F},
    {"coeficiente_de_fricci\xc3\xb3n", INPUT_F},
    {"tangential_force", INPUT_Q},
    {"tangential_load", INPUT_Q},
    {"shear_force", INPUT_Q},
    {"shear_load", INPUT_Q},
    {"Querkraft", INPUT_Q},
    {"Tangentialkraft", INPUT_Q},
    {"force_tangentielle", INPUT_Q},
    {"effort_tangentiel", INPUT_Q},
    {"forza_tangenziale", INPUT_Q},
    {"fuerza_tangencial", INPUT_Q},
    {"moment", INPUT_M},
    {"bulk_tension", INPUT_SIGMA},
    {"bulk_stress", INPUT_SIGMA},
    {"\xcf\x83", INPUT_SIGMA},
    {"load", INPUT_P},
    {"force", INPUT_P},
    {"normal_force", INPUT_P},
    {"normal_load", INPUT_P},
    {"Normalkraft", INPUT_P},
    {"force_normale", INPUT_P},
    {"effort_normal", INPUT_P},
    {"forza_normale", INPUT_P},
    {"fuerza_normal", INPUT_P},
    {"sigma_y", INPUT_YIELD_STRESS},
    {"\xcf\x83y", INPUT_YIELD_STRESS}, /* sigma */
    {"Sy", INPUT_YIELD_STRESS},
    {"Re", INPUT_YIELD_STRESS},
    {"ReH", INPUT_YIELD_STRESS},
    {"Rp0.2", INPUT_YIELD_STRESS},
    {"yield", INPUT_YIELD_STRESS},
    {"yield_strength", INPUT_YIELD_STRESS},
    {"Streckgrenze", INPUT_YIELD_STRESS},
    {"Dehngrenze", INPUT_YIELD_STRESS},
    {"Fliessgrenze", INPUT_YIELD_STRESS},
    {"Flie\xc3\x9fgrenze", INPUT_YIELD_STRESS},
    {"limite_elastique", INPUT_YIELD_STRESS},
    {"limite_\xc3\xa9lastique", INPUT_YIELD_STRESS},
    {"limite_d'\xc3\xa9lasticit\xc3\xa9", INPUT_YIELD_STRESS},
    {"snervamento", INPUT_YIELD_STRESS},
    {"tensione_di_snervamento", INPUT_YIELD_STRESS},
    {"l\xc3\xadmite_el\xc3\xa1stico", INPUT_YIELD_STRESS},
    {"tau_y", INPUT_K},
    {"\xcf\x84y", INPUT_K}, /* tau */
    {"E", INPUT_E1},
    {"E-Modul", INPUT_E1},
    {"youngs_modulus", INPUT_E1},
    {"module_d'Young", INPUT_E1},
    {"module_de_Young", INPUT_E1},
    {"modulo_di_Young", INPUT_E1},
    {"m\303\263dulo_de_Young", INPUT_E1}, /* \xb3 would take the d */
    {"nu", INPUT_NU1},
    {"\xce\xbd", INPUT_NU1},
    {"\xce\xbd\x31", INPUT_NU1},
    {"\xce\xbd\x32", INPUT_NU2},
    {"poissons_ratio", INPUT_NU1},
    {"poisson", INPUT_NU1},
    {"Querdehnzahl", INPUT_NU1},
    {"Querkontraktionszahl", INPUT_NU1},
    {"coefficient_de_Poisson", INPUT_NU1},
    {"coefficiente_di_Poisson", INPUT_NU1},
    {"coeficiente_de_Poisson", INPUT_NU1},
    {"\xce\xb8", INPUT_THETA},
    {"angle", INPUT_THETA},
    {"R", INPUT_RADIUS},
};

static bool is_given(const header *names, const input_texts *options, int input)
{
    return names->column[input] < names->count || (options != NULL && options->text[input] != NULL);
}

/* Whether the input is given, or its alternative is, as the radius for a. */
static bool is_given_somehow(const header *names, const input_texts *options, int input)
{
    return is_given(names, options, input) ||
           (input_alternative(input) >= 0 && is_given(names, options, input_alternative(input)));
}

/* The input whose name this nearly is: "Yield stress", " f" and "Q [N/mm]" are slips. But p beside
 * P, or F beside f, may be another thing. */
static int slip_for(const header *names, const char *name, size_t length,
                    const bool wanted[INPUT_COUNT], const input_texts *options)
{
    for (int i = 0; i < INPUT_COUNT; i++) {
        char column[INPUT_NAME_SIZE];
        if (!wanted[i] || !is_like(name, length, input_column(i, column)))
            continue;
        if (column[1] != '\0' || memchr(name, column[0], length) != NULL ||
            !is_given_somehow(names, options, i))
            return i;
    }
    return INPUT_COUNT;
}

static int synonym_for(const header *names, const char *name, size_t length,
                       const bool wanted[INPUT_COUNT], const input_texts *options)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof synonyms[0]; i++)
        if (wanted[synonyms[i].input] && is_like(name, length, synonyms[i].name) &&
            !is_given_somehow(names, options, synonyms[i].input))
            return synonyms[i].input;
    return INPUT_COUNT;
}

bool header_is_input(const header *names, size_t column)
{
    for (int i = 0; i < INPUT_COUNT; i++)
        if (names->column[i] == column)
            return true;
    return false;
}

/* If a column that is meant for an input passed through, nobody would notice: friction, for one, is
 * 0 by default. */
static bool check_other(const csv_input *in, const header *names, size_t column,
                        const bool wanted[INPUT_COUNT], const input_texts *options)
{
    const char *name = names->name[column];
    const size_t before_unit = strcspn(name, "[(");
    bool has_unit = false;
    /* "theta (deg)" is theta_deg */
    int meant = slip_for(names, name, strlen(name), wanted, options);
    if (meant == INPUT_COUNT) {
        has_unit = name[before_unit] != '\0';
        meant = slip_for(names, name, before_unit, wanted, options);
    }
    const bool slip = meant < INPUT_COUNT;
    if (!slip)
        meant = synonym_for(names, name, before_unit, wanted, options);
    if (meant == INPUT_COUNT)
        return true;
    char allowed[INPUT_NAME_SIZE];
    failure("%s: column '%.60s': allowed: %s%s%s", csv_input_name(in), name,
            input_column(meant, allowed),
            has_unit && meant == INPUT_THETA ? " in radians or theta_deg" : "",
            slip ? "" : ", or another name if it is something else");
    return false;
}

/* ---- The row ---- */

bool header_read(csv_input *in, const bool wanted[INPUT_COUNT], const input_texts *options,
                 header *names)
{
    *names = (header){0};
    const csv_event event = csv_input_next(in);
    if (event == CSV_FAILED)
        return false;
    if (event != CSV_ROW) {
        failure("%s: %s; needed: a header row with the names of the columns", csv_input_name(in),
                event == CSV_END ? "empty" : "misplaced quotes in the first row");
        return false;
    }
    if (!copy_names(in, names))
        return false;
    names->separator = csv_input_separator(in);
    for (int i = 0; i < INPUT_COUNT; i++)
        names->column[i] = names->count;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (wanted[i] && !find(in, i, names))
            return false;
    for (size_t i = 0; i < names->count; i++)
        if (!header_is_input(names, i) && !check_other(in, names, i, wanted, options))
            return false;
    return true;
}

void header_free(header *names)
{
    for (size_t i = 0; i < names->count; i++)
        free(names->name[i]);
    free(names->name);
    *names = (header){0};
}

/* A column that says which row it is, not what is computed. */
static bool is_label(const char *name)
{
    static const char *const labels[] = {"case", "id",    "key",    "line", "load", "name",
                                         "no",   "nr",    "number", "row",  "step", "time",
                                         "t",    "cycle", "point",  "label"};
    for (size_t i = 0; i < sizeof labels / sizeof labels[0]; i++)
        if (is_like(name, strcspn(name, "[("), labels[i]))
            return true;
    return false;
}

void header_name_unused(const header *names, const char *file)
{
    char unused[1000] = "";
    for (size_t i = 0; i < names->count; i++)
        if (names->has_numbers[i] && !header_is_input(names, i) && !is_label(names->name[i]))
            list_add(unused, sizeof unused, ", ", "'%.60s'", names->name[i]);
    if (unused[0] != '\0')
        notice("%s: columns with numbers that are not used: %s", file, unused);
}

bool header_has(const header *names, const char *name)
{
    for (size_t i = 0; i < names->count; i++)
        if (strcmp(names->name[i], name) == 0)
            return true;
    return false;
}

bool header_fits(const header *names, size_t cells, char complaint[COMPLAINT_SIZE])
{
    if (cells == names->count)
        return true;
    snprintf(complaint, COMPLAINT_SIZE, "%zu cells in this row, %zu in the header%s", cells,
             names->count, csv_surplus_hint(cells, names->count, names->separator));
    return false;
}

const char *header_separator_hint(const header *names)
{
    if (names->count != 1)
        return "";
    if (strchr(names->name[0], ';') != NULL)
        return "; the columns seem to be separated by ';': --decimal-comma reads that";
    if (strchr(names->name[0], ',') != NULL)
        return "; the columns seem to be separated by ',': leave --decimal-comma out";
    return strchr(names->name[0], '\t') != NULL
               ? "; the columns seem to be separated by tabs; allowed: commas"
               : "";
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about the input that gives a safety. */
#include "field_texts.h"
#include "records.h"

#include "model/results/results.h"

/* Of the case of the form, whose own text of that input does not count: the number that gives the
 * safety, or why there is none. */
EXPORTED const char *page_find(char *lines, const char *name, double safety)
{
    const input_texts texts = field_texts(lines);
    const int input = inverse_input(name);
    contact_case setup;
    double value;
    char complaint[COMPLAINT_SIZE];
    if (!inverse_find(&texts, input, safety, &setup, &value, complaint)) {
        records_refuse("", complaint);
        return records_end();
    }
    records_begin();
    records_add("input", "tn", name, value);
    return records_end();
}

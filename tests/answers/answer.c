/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the calls of calls.py from standard input and answers each with one line: the call, and
 * the bits of its results as 16 hexadecimal digits. Every NaN is "nan"; a refused call is "error".
 * Every language that the library is called from has such a program, and all print the same lines.
 * This one is compiled as C and as C++. */
#include "entries.h"
#include "rwedge.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1024 }; /* numbers of an array */

/* One contact and one series at a time: what makes one begins the next. */
static rwedge_contact *contact;
static rwedge_series *series;

typedef struct {
    double v[MOST];
    size_t n, rows;
} numbers;

static numbers before; /* what the line before gave */

static void *object_of(const entry *call)
{
    return strcmp(call->family, "contact") == 0 ? (void *)contact : (void *)series;
}

static void replace(const entry *call, void *made)
{
    if (strcmp(call->family, "contact") == 0) {
        rwedge_contact_destroy(contact);
        contact = (rwedge_contact *)made;
    } else {
        rwedge_series_destroy(series);
        series = (rwedge_series *)made;
    }
}

static numbers numbers_of(const char *text)
{
    if (*text == '@')
        return before;
    numbers a = {{0}, 0, 1};
    for (char *end; a.n < MOST && *text && *text != ','; text = end) {
        a.v[a.n++] = strtod(text, &end);
        a.rows += *end == ';';
        end += *end == ';';
    }
    return a;
}

/* Reads the arguments and the sizes of their arrays; 0 where there are not as many. */
static int read_arguments(const entry *call, const char *text, numbers passed[], size_t n[])
{
    for (int j = 0; j < call->arguments; j++) {
        text = strchr(text, ',');
        if (!text)
            return 0;
        passed[j] = numbers_of(++text);
        const signed char *sizes = call->argument[j].sizes;
        if (sizes[0] >= 0)
            n[(int)sizes[0]] = sizes[1] < 0 ? passed[j].n : passed[j].rows;
        if (sizes[1] >= 0)
            n[(int)sizes[1]] = passed[j].n / passed[j].rows;
    }
    for (int j = 0; j < call->sizes; j++)
        if (call->size[j].teller) {
            double told;
            double *const r[] = {&told};
            entry_named(call->size[j].teller)->call(object_of(call), NULL, NULL, r, NULL);
            n[j] = (size_t)told;
        }
    return strchr(text, ',') == NULL;
}

static void print_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value == value)
        printf(",%08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffff));
    else
        printf(",nan");
}

static void print_results(const entry *call, const double results[][MOST], const size_t n[])
{
    before.n = 0;
    for (int j = 0; j < call->results; j++) {
        size_t count = 1;
        for (int k = 0; k < 2; k++)
            count *= call->result[j].sizes[k] < 0 ? 1 : n[(int)call->result[j].sizes[k]];
        for (size_t i = 0; i < count && i < MOST; i++) {
            print_bits(results[j][i]);
            if (before.n < MOST)
                before.v[before.n++] = results[j][i];
        }
    }
}

/* 0, or 1 with a message where the call is none of ours. */
static int answer(const char *line)
{
    static numbers passed[ENTRY_ARGUMENTS + 1];
    static double results[ENTRY_RESULTS][MOST];
    const double *v[ENTRY_ARGUMENTS];
    double *r[ENTRY_RESULTS];
    size_t n[ENTRY_SIZES] = {0};
    void *made = NULL;
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(line, ":"), line);
    const entry *call = entry_named(name);
    if (!call || !read_arguments(call, line, passed, n)) {
        fprintf(stderr, "%s: no such call\n", line);
        return 1;
    }
    for (int j = 0; j < ENTRY_ARGUMENTS; j++)
        v[j] = passed[j].v;
    for (int j = 0; j < ENTRY_RESULTS; j++)
        r[j] = results[j];
    printf("%s", line);
    if (call->call(object_of(call), n, v, r, &made) != RWEDGE_OK) {
        printf(",error");
    } else {
        if (call->makes_object)
            replace(call, made);
        print_results(call, (const double(*)[MOST])results, n);
    }
    printf("\n");
    return 0;
}

int main(void)
{
    char line[1024];
    int failed = 0;
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\r\n")] = 0;
        failed |= answer(line);
    }
    rwedge_contact_destroy(contact);
    rwedge_series_destroy(series);
    return failed;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers the calls of calls.csv from standard input: each line back with the bits of its
 * results, as 16 hexadecimal digits ("nan" for every NaN). Every language that the library is
 * called from has such a program, and all print the same lines. Compiled as C and as C++. */
#include "rwedge.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_ARGUMENTS = 5, MAX_RESULTS = 3 };

/* One contact at a time: contact_create begins the next. */
static rwedge_contact *contact;

static double load(const double *v)
{
    return rwedge_load(v[0]);
}
static double a_over_b(const double *v)
{
    return rwedge_a_over_b(v[0]);
}
static double pressure(const double *v)
{
    return rwedge_pressure(v[0], v[1]);
}
static double peak_pressure(const double *v)
{
    return rwedge_peak_pressure(v[0]);
}
static double transition_pressure(const double *v)
{
    return rwedge_transition_pressure(v[0]);
}
static double max_tension(const double *v)
{
    return rwedge_max_tension(v[0]);
}
static double stick_width(const double *v)
{
    return rwedge_stick_width(v[0], v[1]);
}
static double shear_ratio(const double *v)
{
    return rwedge_shear_ratio(v[0], v[1]);
}
static double shear(const double *v)
{
    return rwedge_shear(v[0], v[1], v[2]);
}
static double elastic_limit(const double *v)
{
    return rwedge_elastic_limit(v[0], v[1], v[2]);
}
static double critical_friction(const double *v)
{
    return rwedge_critical_friction(v[0], v[1]);
}
static double coefficient(const double *v)
{
    return rwedge_coefficient(v[0], (int32_t)v[1]);
}
static double compliance(const double *v)
{
    return rwedge_compliance(v[0], v[1], v[2], v[3]);
}
static double dundurs_beta(const double *v)
{
    return rwedge_dundurs_beta(v[0], v[1], v[2], v[3]);
}
static double radius(const double *v)
{
    return rwedge_radius(v[0], v[1]);
}
static double rounding(const double *v)
{
    return rwedge_rounding(v[0], v[1]);
}
static double half_width(const double *v)
{
    return rwedge_half_width(v[0], v[1], v[2], v[3]);
}
static double normal_load(const double *v)
{
    return rwedge_normal_load(v[0], v[1], v[2], v[3]);
}

static double contact_half_width(const double *v)
{
    (void)v;
    return rwedge_contact_half_width(contact);
}

static double contact_stick_half_width(const double *v)
{
    (void)v;
    return rwedge_contact_stick_half_width(contact);
}

static double contact_dissipated_energy(const double *v)
{
    (void)v;
    return rwedge_contact_dissipated_energy(contact);
}

static int32_t yield_point(const double *v, double *r)
{
    return rwedge_yield_point(v[0], v[1], v[2], &r[0], &r[1], &r[2]);
}

static int32_t subsurface_yield(const double *v, double *r)
{
    return rwedge_subsurface_yield(v[0], v[1], v[2], &r[0], &r[1], &r[2]);
}

static int32_t surface_yield(const double *v, double *r)
{
    return rwedge_surface_yield(v[0], v[1], v[2], &r[0], &r[1]);
}

static int32_t stress(const double *v, double *r)
{
    return rwedge_stress(v[0], v[1], v[2], v[3], v[4], &r[0], &r[1], &r[2]);
}

static int32_t contact_create(const double *v, double *r)
{
    (void)r;
    rwedge_contact_destroy(contact);
    contact = NULL;
    return rwedge_contact_create(v[0], v[1], v[2], v[3], &contact);
}

static int32_t contact_load(const double *v, double *r)
{
    (void)r;
    return rwedge_contact_load(contact, v[0], v[1]);
}

static int32_t contact_tractions(const double *v, double *r)
{
    return rwedge_contact_tractions(contact, 1, &v[0], &r[0], &r[1]);
}

static int32_t contact_stresses(const double *v, double *r)
{
    return rwedge_contact_stresses(contact, 1, &v[0], &v[1], &r[0], &r[1], &r[2]);
}

static int32_t contact_slip(const double *v, double *r)
{
    return rwedge_contact_slip(contact, 1, &v[0], &r[0]);
}

static int32_t contact_yield_factor(const double *v, double *r)
{
    return rwedge_contact_yield_factor(contact, v[0], v[1], &r[0], &r[1], &r[2]);
}

static const struct call {
    const char *name;
    int arguments, results;
    double (*value)(const double *v); /* a formula, or */
    int32_t (*status)(const double *v, double *r);
} calls[] = {
    {"compliance", 4, 1, compliance, NULL},
    {"dundurs_beta", 4, 1, dundurs_beta, NULL},
    {"load", 1, 1, load, NULL},
    {"a_over_b", 1, 1, a_over_b, NULL},
    {"pressure", 2, 1, pressure, NULL},
    {"peak_pressure", 1, 1, peak_pressure, NULL},
    {"transition_pressure", 1, 1, transition_pressure, NULL},
    {"coefficient", 2, 1, coefficient, NULL},
    {"max_tension", 1, 1, max_tension, NULL},
    {"stick_width", 2, 1, stick_width, NULL},
    {"shear_ratio", 2, 1, shear_ratio, NULL},
    {"shear", 3, 1, shear, NULL},
    {"elastic_limit", 3, 1, elastic_limit, NULL},
    {"critical_friction", 2, 1, critical_friction, NULL},
    {"radius", 2, 1, radius, NULL},
    {"rounding", 2, 1, rounding, NULL},
    {"half_width", 4, 1, half_width, NULL},
    {"normal_load", 4, 1, normal_load, NULL},
    {"stress", 5, 3, NULL, stress},
    {"yield_point", 3, 3, NULL, yield_point},
    {"subsurface_yield", 3, 3, NULL, subsurface_yield},
    {"surface_yield", 3, 2, NULL, surface_yield},
    {"contact_create", 4, 0, NULL, contact_create},
    {"contact_load", 2, 0, NULL, contact_load},
    {"contact_half_width", 0, 1, contact_half_width, NULL},
    {"contact_stick_half_width", 0, 1, contact_stick_half_width, NULL},
    {"contact_dissipated_energy", 0, 1, contact_dissipated_energy, NULL},
    {"contact_tractions", 1, 2, NULL, contact_tractions},
    {"contact_stresses", 2, 3, NULL, contact_stresses},
    {"contact_slip", 1, 1, NULL, contact_slip},
    {"contact_yield_factor", 2, 3, NULL, contact_yield_factor},
};

static const struct call *call_named(const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i++)
        if (strlen(calls[i].name) == length && strncmp(calls[i].name, name, length) == 0)
            return &calls[i];
    return NULL;
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

/* 0, or 1 with a message where the call is none of ours or fails: the calls that fail are the
 * business of each language. */
static int answer(const char *line)
{
    double v[MAX_ARGUMENTS], r[MAX_RESULTS];
    const size_t length = strcspn(line, ",");
    const struct call *call = call_named(line, length);
    const char *rest = line + length;
    int n = 0;
    for (; *rest == ',' && n < MAX_ARGUMENTS; n++) {
        char *end;
        v[n] = strtod(rest + 1, &end);
        rest = end;
    }
    if (!call || n != call->arguments || *rest) {
        fprintf(stderr, "%s: no such call\n", line);
        return 1;
    }
    int32_t status = RWEDGE_OK;
    if (call->value)
        r[0] = call->value(v);
    else
        status = call->status(v, r);
    if (status != RWEDGE_OK) {
        fprintf(stderr, "%s: %s\n", line, rwedge_strerror(status));
        return 1;
    }
    printf("%s", line);
    for (int i = 0; i < call->results; i++)
        print_bits(r[i]);
    printf("\n");
    return 0;
}

int main(void)
{
    char line[256];
    int failed = 0;
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\r\n")] = 0;
        failed |= answer(line);
    }
    rwedge_contact_destroy(contact);
    return failed;
}

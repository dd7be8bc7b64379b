/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes contacts of an earlier version of the library as numbers, for state-VERSION.csv: README.md
 * says how. A row is what the contact is, what it answers, and rwedge_contact_state(). */
#include "rwedge.h"

#include <stdio.h>
#include <stdlib.h>

enum { PLACES = 5, MOST_LOADS = 4 };

static const double A = 2e-5, F = 0.5;

typedef struct {
    const char *name;
    double loads[MOST_LOADS][4]; /* those with P = 0 after the first are left out */
    double strain, tolerance;
} history;

static void numbers(int n, const double value[])
{
    for (int i = 0; i < n; i++)
        printf(",%.17g", value[i]);
}

static int fails(const char *name, const char *what)
{
    fprintf(stderr, "%s: %s\n", name, what);
    return EXIT_FAILURE;
}

static int write_row(const history *h, int kind, const double pad[3], rwedge_contact *contact)
{
    double left, right, x[PLACES], p[PLACES], q[PLACES], error = 0;
#ifdef ANY_PAD
    if (h->strain > 0 && rwedge_contact_set_strain(contact, h->strain) != RWEDGE_OK)
        return fails(h->name, "strain");
    if (rwedge_contact_allow_error(contact, h->tolerance) != RWEDGE_OK)
        return fails(h->name, "tolerance");
#endif
    for (int i = 0; i < MOST_LOADS; i++) {
        const double *to = h->loads[i];
        if (i > 0 && to[0] == 0)
            continue;
        if (rwedge_contact_apply(contact, to[0], to[1], to[2], to[3]) != RWEDGE_OK)
            return fails(h->name, "load");
    }
    if (rwedge_contact_edges(contact, &left, &right) != RWEDGE_OK)
        return fails(h->name, "edges");
    for (int i = 0; i < PLACES; i++)
        x[i] = left + (right - left) * (i + 0.7) / PLACES;
    if (rwedge_contact_tractions(contact, PLACES, x, p, q) != RWEDGE_OK)
        return fails(h->name, "tractions");
#ifdef ANY_PAD
    error = rwedge_contact_error(contact);
#endif
    const double end[] = {A, F, h->strain > 0 ? h->strain : A / 4, h->tolerance, error};
    const size_t size = rwedge_contact_state_size(contact);
    double *state = malloc(size * sizeof *state);
    if (!state || rwedge_contact_state(contact, size, state) != RWEDGE_OK)
        return fails(h->name, "state");
    printf("%s,%d", h->name, kind);
    numbers(3, pad);
    numbers(5, end);
    numbers(PLACES, x);
    numbers(PLACES, p);
    numbers(PLACES, q);
    printf(",%zu", size);
    numbers((int)size, state);
    printf("\n");
    free(state);
    return EXIT_SUCCESS;
}

/* Each history with a contact that is made anew. */
static int write_rows(size_t n, const history rows[], int kind, const double pad[3],
                      int32_t (*make)(rwedge_contact **contact))
{
    int status = EXIT_SUCCESS;
    for (size_t i = 0; i < n && status == EXIT_SUCCESS; i++) {
        rwedge_contact *contact = NULL;
        if (make(&contact) != RWEDGE_OK)
            return fails(rows[i].name, "contact");
        status = write_row(&rows[i], kind, pad, contact);
        rwedge_contact_destroy(contact);
    }
    return status;
}

#define ROWS(rows) (sizeof(rows) / sizeof *(rows)), rows

static int32_t wedge(rwedge_contact **contact)
{
    return rwedge_contact_create(0.05, 0.3, A, F, contact);
}

static const double WEDGE[] = {0.05, 0.3, 0};
static const history OF_WEDGE[] = {
    {.name = "wedge", .loads = {{1000, 0, 0, 0}, {1000, 0, 300, 0}, {1200, 0, -200, 0}}},
    {.name = "wedge sliding", .loads = {{1000, 0, 0, 0}, {1000, 0, 500, 0}}},
    {.name = "wedge off the centre",
     .loads = {{1000, 100, 0, 0}, {1000, 100, 300, 10}, {1000, 100, 100, 5}}},
    {.name = "small wedge", .loads = {{1e-6, 0, 0, 0}}},
};

#ifdef ANY_PAD
static const history COMPUTED_WEDGE[] = {
    {.name = "wedge computed",
     .loads = {{1000, 0, 0, 0}, {1300, 20, 100, 200}, {1200, 20, -100, 10}},
     .strain = 0.3 * 2e-5,
     .tolerance = 1e-3},
};

static int32_t cylinder(rwedge_contact **contact)
{
    return rwedge_contact_create_flat(0, 20, A, F, contact);
}

static const double CYLINDER[] = {0, 0, 20};
static const history OF_CYLINDER[] = {
    {.name = "cylinder", .loads = {{500, 0, 0, 0}, {500, 0, 200, 10}}, .strain = 0.3 * 2e-5},
    {.name = "cylinder computed",
     .loads = {{500, 0, 0, 0}, {600, 0, 100, 200}, {590, 10, 0, -60}},
     .tolerance = 1e-2},
};

static int32_t flat(rwedge_contact **contact)
{
    return rwedge_contact_create_flat(1, 20, A, F, contact);
}

static const double FLAT[] = {0, 1, 20};
static const history OF_FLAT[] = {
    {.name = "flat", .loads = {{500, 0, 0, 0}, {500, 0, 200, 0}, {500, 0, -100, 0}}},
    {.name = "flat computed",
     .loads = {{500, 20, 0, 0}, {600, 10, 100, 80}, {550, 0, -100, -60}},
     .tolerance = 1e-3},
};

static int32_t profile(rwedge_contact **contact)
{
    static const double x[] = {-2, -1, 0, 1, 2}, slope[] = {-0.1, -0.05, 0, 0.03, 0.1};
    return rwedge_contact_create_profile(5, x, slope, A, F, contact);
}

static const double PROFILE[] = {0, 0, 0};
static const history OF_PROFILE[] = {
    {.name = "profile", .loads = {{500, 20, 0, 0}, {500, 20, 200, 0}}},
    {.name = "profile computed",
     .loads = {{500, 0, 0, 0}, {600, 10, 100, 200}, {590, 0, 0, -60}},
     .tolerance = 1e-3},
};
#endif

int main(void)
{
    printf("name,kind,theta,a,R,A,f,strain,tolerance,error");
    for (int i = 0; i < 3 * PLACES; i++)
        printf(",%c%d", "xpq"[i / PLACES], i % PLACES + 1);
    printf(",size,state\n");
    int status = write_rows(ROWS(OF_WEDGE), 0, WEDGE, wedge);
#ifdef ANY_PAD
    status |= write_rows(ROWS(COMPUTED_WEDGE), 0, WEDGE, wedge);
    status |= write_rows(ROWS(OF_CYLINDER), 1, CYLINDER, cylinder);
    status |= write_rows(ROWS(OF_FLAT), 2, FLAT, flat);
    status |= write_rows(ROWS(OF_PROFILE), 3, PROFILE, profile);
#endif
    return status;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "series.h"

#include <math.h>
#include <stdlib.h>

bool series_shows(const series *all, int criterion)
{
    const criteria *asked = &all->asked;
    return !criterion_is_damage(criterion) && asked->is_computed[criterion] &&
           (!asked->is_listed || asked->is_wanted[criterion] ||
            (criterion_exists(criterion + DAMAGE) && asked->is_wanted[criterion + DAMAGE]));
}

int series_of_lives(const series *all)
{
    for (int i = 0; i < DAMAGE; i++)
        if (criterion_exists(i) && series_shows(all, i) && all->asked.is_computed[i + DAMAGE])
            return i;
    return NO_CRITERION;
}

/* ---- Loads ---- */

static bool refuse_status(int32_t status, const char *subject, complaint *why)
{
    return status == RWEDGE_OK || complain(why, "%s: %s", subject, rwedge_strerror(status));
}

static bool apply(const test_case *test, load next, const char *word, rwedge_contact *contact,
                  complaint *why)
{
    complaint reason;
    return loads_apply_next(next, &test->setup.shape, test->setup.f, contact, &reason) ||
           complain(why, "%s%s", word, reason.text);
}

static void note(const test_case *test, const rwedge_contact *contact, doubts *all)
{
    doubts_add(all, doubts_of_state(&test->setup, contact));
    all->bits |= doubt_of_sliding(contact);
}

/* All cycles, the last of which counts. */
static bool go_through(const series *all, test_run *run, rwedge_contact *contact, complaint *why)
{
    const test_case *test = &run->test;
    for (size_t i = 0; i < test->before_count; i++)
        if (!apply(test, test->before[i], "before the cycle: ", contact, why))
            return false;
    for (int64_t cycle = 1; cycle <= all->cycles; cycle++) {
        if (cycle == all->cycles)
            last_cycle_begin(&test->setup, &test->asked, contact, test->count, &run->last);
        for (size_t i = 0; i < test->count; i++) {
            if (!apply(test, test->cycle[i], "", contact, why))
                return false;
            if (cycle < all->cycles)
                continue;
            last_cycle_add(test->cycle[i], contact, &run->last);
            note(test, contact, &run->results.doubts);
        }
    }
    return true;
}

/* ---- Results ---- */

static void measure_contact(const rwedge_contact *contact, test_run *run)
{
    test_results *to = &run->results;
    double x;
    to->left = run->last.left;
    to->right = run->last.right;
    to->stick_left = to->stick_right = to->peak_pressure = NAN;
    rwedge_cycle_permanent_stick(run->last.cycle, &to->stick_left, &to->stick_right);
    rwedge_contact_peak_pressure(contact, &to->peak_pressure, &x);
}

static bool find_worst(test_run *run, complaint *why)
{
    measured along;
    int32_t status = stops_find(&run->last, &along)
                         ? last_cycle_measure(&run->last, along.count, along.place)
                         : RWEDGE_ENOMEM;
    const bool touches = along.count > 0 || status == RWEDGE_ENOMEM;
    if (status == RWEDGE_OK && touches)
        status = worst_places(&run->last, &along, run->worst);
    free(along.place);
    if (!touches)
        return complain(why, "there is no contact in the cycle");
    return refuse_status(status, "the worst place", why);
}

bool test_go(const series *all, test_run *run, complaint *why)
{
    rwedge_contact *contact = run->test.setup.contact;
    run->is_run = go_through(all, run, contact, why) &&
                  refuse_status(last_cycle_end(&run->last), "the cycle", why) &&
                  find_worst(run, why);
    if (run->is_run)
        measure_contact(contact, run);
    return run->is_run;
}

void test_free(test_run *run)
{
    last_cycle_free(&run->last);
    rwedge_contact_destroy(run->test.setup.contact);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the page asks about a crack in the cycle that it asked about last. */
#include "page.h"

#include "model/cracks/cracks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LENGTHS = 41 };

typedef struct {
    crack_case crack;
    double angle; /* degrees */
    double length[LENGTHS];
    crack_growth growth[SHEARS];
} crack_question;

/* ---- What is asked ---- */

static bool check_law(const crack_law *law)
{
    const char *beside, *lacks = crack_law_lacks(law, &beside);
    if (lacks != NULL)
        return json_refuse("", "%s: missing; needed beside %s", lacks, beside);
    if (law->m < crack_least_m || law->m > crack_most_m)
        return json_refuse("", "paris_m: must be a number from %g to %g", crack_least_m,
                           crack_most_m);
    return true;
}

static bool read_between(const char *name, const char *text, double low, double high, double *value)
{
    if (number_read_cell(text, '.', value) && *value >= low && *value <= high)
        return true;
    return json_refuse("", "%s %.40s: must be a number from %g to %g", name, text, low, high);
}

static bool read_crack(const char *edge, const char *angle, const char *from, const char *to,
                       crack_question *q)
{
    double first, last;
    const material *constants;
    q->crack.last = cycle_answered(&constants);
    if (q->crack.last == NULL)
        return json_refuse("", "there is no cycle");
    q->crack.law = crack_law_of(constants);
    if (!read_between("the angle", angle, -75, 75, &q->angle) ||
        !read_between("the first length", from, 1e-60, 1e60, &first) ||
        !read_between("the last length", to, 1e-60, 1e60, &last))
        return false;
    if (first >= last)
        return json_refuse("", "the last length must be above the first");
    q->crack.x = strcmp(edge, "right") == 0 ? q->crack.last->right : q->crack.last->left;
    q->crack.length = q->length;
    q->crack.lengths = LENGTHS;
    crack_lengths(first, last, LENGTHS, q->length);
    for (int shear = 0; shear < SHEARS; shear++)
        q->crack.is_wanted[shear] = true;
    return true;
}

/* ---- Answers ---- */

static bool refuse_status(int32_t status)
{
    return status == RWEDGE_OK ||
           json_refuse("", "This cannot be computed: %s", rwedge_strerror(status));
}

/* The range of K by each way in which K_II counts, and the threshold. */
static bool write_ranges(const crack_question *q)
{
    const crack_ranges r = crack_ranges_of(&q->crack, q->angle, NULL);
    const bool is_done = refuse_status(r.status);
    for (size_t j = 0; j < LENGTHS && is_done; j++) {
        json_add("{'length':[%n],'threshold':[%n],'dK':{", q->length[j],
                 crack_threshold(&q->crack.law, q->length[j]));
        for (size_t shear = 0; shear < SHEARS; shear++)
            json_add("%t:[%n]", shear_names[shear],
                     hypot(r.I[shear * LENGTHS + j], r.II[shear * LENGTHS + j]));
        json_add("}}");
    }
    free(r.I);
    return is_done;
}

/* Where it stops, by each way, and all in a sentence. */
static bool write_verdict(crack_question *q)
{
    char text[CRACK_SENTENCE];
    if (!crack_has_threshold(&q->crack.law) && !crack_has_rate(&q->crack.law))
        return true;
    for (int shear = 0; shear < SHEARS; shear++) {
        crack_growth *g = &q->growth[shear];
        *g = crack_verdict_of(&q->crack, q->angle, shear);
        if (!refuse_status(g->status))
            return false;
        json_add("{'verdict':{%t:{'arrest':%n,'cycles':%n,'least':%n,'leastAt':%n}}}",
                 shear_names[shear], crack_grows(g) ? NAN : g->end,
                 crack_has_rate(&q->crack.law) ? g->cycles : NAN, g->least, g->least_at);
    }
    crack_sentence_of_all(&q->crack, q->growth, text);
    json_add("{'sentence':%t}", text);
    return true;
}

static void write_doubt(const crack_question *q)
{
    char text[CRACK_SENTENCE];
    crack_length_said(&q->crack, text);
    json_add("{'doubt':%t}", text);
}

/* A crack at an edge of the largest contact, of an angle in degrees, between two lengths, with the
 * constants of the cycle's material: the range of K over its length, the threshold, what becomes of
 * it; or what is wrong. `unit` is that of the length. */
EXPORTED const char *page_crack(const char *edge, const char *angle, const char *from,
                                const char *to, const char *unit)
{
    crack_question q = {.crack = {.unit = unit}};
    json_begin();
    if (read_crack(edge, angle, from, to, &q) && check_law(&q.crack.law) && write_ranges(&q) &&
        write_verdict(&q))
        write_doubt(&q);
    return json_end();
}

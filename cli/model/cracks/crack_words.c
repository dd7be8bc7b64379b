/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cracks.h"

#include <math.h>

static const char *const assumption[SHEARS] = {"mode I", "K_II while it is open",
                                               "K_II of free faces"};

/* Adds what becomes of it between two lengths; of a law without C no cycles. */
static void add_end(const crack_case *crack, const crack_growth *g, char text[CRACK_SENTENCE])
{
    const double first = crack->length[0], last = crack->length[crack->lengths - 1];
    const size_t size = CRACK_SENTENCE;
    if (!crack_grows(g) && g->end == first)
        list_add(text, size, "", "does not grow: dK is %.3g of the threshold at %.4g %s", g->first,
                 first, crack->unit);
    else if (!crack_grows(g))
        list_add(text, size, "", "arrests at %.4g %s", g->end, crack->unit);
    else if (isfinite(g->end))
        list_add(text, size, "", "breaks at %.4g %s, where K is K_c", g->end, crack->unit);
    else
        list_add(text, size, "", "grows through to %.4g %s", last, crack->unit);
    if (crack_grows(g) && crack_has_rate(&crack->law))
        list_add(text, size, "", ", in %.6g cycles", g->cycles);
}

void crack_sentence(const crack_case *crack, int shear, const crack_growth *g,
                    char text[CRACK_SENTENCE])
{
    text[0] = '\0';
    list_add(text, CRACK_SENTENCE, "",
             shear == RWEDGE_FACES_MODE_I ? "By %s the crack " : "With %s the crack ",
             assumption[shear]);
    add_end(crack, g, text);
    if (crack_grows(g) && crack_has_threshold(&crack->law) && isfinite(g->least))
        list_add(text, CRACK_SENTENCE, "", "; closest to the threshold, %.3g, at %.4g %s", g->least,
                 g->least_at, crack->unit);
}

int crack_sentence_of_all(const crack_case *crack, const crack_growth growth[SHEARS],
                          char text[CRACK_SENTENCE])
{
    int ways = 0;
    text[0] = '\0';
    for (int shear = 0; shear < SHEARS; shear++) {
        if (!crack->is_wanted[shear])
            continue;
        list_add(text, CRACK_SENTENCE, "; ", "%s %s %s ",
                 shear == RWEDGE_FACES_MODE_I ? "By"
                 : ways == 0                  ? "With"
                                              : "with",
                 assumption[shear], ways == 0 ? "the crack" : "it");
        add_end(crack, &growth[shear], text);
        ways++;
    }
    return ways;
}

/* ---- What the model leaves out ---- */

void crack_length_said(const crack_case *crack, char text[CRACK_SENTENCE])
{
    const double tenth = (crack->last->right - crack->last->left) / 20;
    text[0] = '\0';
    if (crack->length[crack->lengths - 1] > tenth)
        list_add(text, CRACK_SENTENCE, "",
                 "the contact is taken as if there were no crack: beyond a length of %.4g, a tenth "
                 "of its half-width, it changes the tractions, and what that does to K is not "
                 "measured",
                 tenth);
}

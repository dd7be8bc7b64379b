/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "model.h"

#include <math.h>
#include <stdio.h>

/* Doubts beside the library's bits. */
enum {
    DOUBT_STATE = 1 << 20,
    DOUBT_SLOPE = 1 << 21,
    DOUBT_ZONES = 1 << 22,
    DOUBT_SLIDES = 1 << 23,
    DOUBT_BEYOND = 1 << 24,
    DOUBT_AWAY = 1 << 25,
    DOUBT_LOBE = 1 << 26,
    DOUBT_FAR = 1 << 27
};

static const double STEEP = 0.1;
/* A hull that raises the pad by less of its rise has raised p0 of scans with noise by less than 2
 * %. */
static const double HULL_LEAST = 1e-3;
/* What friction of unlike bodies changes by less than this is not told: edges are that exact. */
static const double COUPLING_LEAST = 1e-4;

/* P acts at x = 0, wherever a profile has it: at one end of a scan, say. A moment may be meant to
 * move the contact. */
static int32_t doubt_of_origin(const contact_case *setup, double left, double right)
{
    const pad_profile *places = setup->shape.places;
    if (places == NULL || !(right > left))
        return 0;
    if (left < places->left || right > places->right)
        return DOUBT_BEYOND;
    const double lowest = pad_profile_lowest(places);
    const bool is_moved = setup->M != 0 || setup->is_held || setup->has_history;
    return is_moved || (lowest >= left && lowest <= right) ? 0 : DOUBT_AWAY;
}

/* The pressure at an edge depends on a little of the height there. */
static int32_t doubt_of_lobe(const contact_case *setup, double left, double right)
{
    const double NOISES = 10;
    const pad_profile *places = setup->shape.places;
    if (places == NULL || places->arcs == 0 || !(right > left))
        return 0;
    const double rise =
        fmin(pad_fit_lobe(places, left, right, false), pad_fit_lobe(places, left, right, true));
    return rise < NOISES * places->rms ? DOUBT_LOBE : 0;
}

static const char *text_of(int32_t bit)
{
    static const struct {
        int32_t bit;
        const char *text;
    } texts[] = {
        {DOUBT_STATE, "a load yields the body: its stresses exceed the yield stress"},
        {DOUBT_ZONES, "several zones stick and it slips between them: stick_left and stick_right "
                      "mean the outermost edges"},
        {DOUBT_SLIDES, "it slides fully: the loads do not tell how far nor what that dissipates"},
        {DOUBT_FAR, "it slides by more than its half-width, so that places leave it: is the "
                    "displacement in the unit of the other lengths, and from the middle?"},
        {DOUBT_SLOPE,
         "the pad rises by more than 0.1 rad in the contact: it is hardly a half-plane"},
        {DOUBT_BEYOND, "P acts at x = 0 and the contact reaches beyond the places of the profile: "
                       "--origin lowest, --M or --tilt moves it"},
        {DOUBT_AWAY,
         "P acts at x = 0 and the contact is away from the lowest place of the profile: "
         "--origin lowest, --M or --tilt moves it"},
        {DOUBT_LOBE, "the fit does not resolve the pressure at an edge of the contact: the profile "
                     "rises there by less than ten times the noise"}};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        if (texts[i].bit == bit)
            return texts[i].text;
    return rwedge_validity_text(bit);
}

doubts doubts_of(const contact_case *setup, double left, double right, double safety)
{
    const pad *shape = &setup->shape;
    const bool is_wedge = shape->kind == PAD_WEDGE, touches = right > left;
    const int32_t bits = rwedge_validity(
        is_wedge ? shape->theta : NAN,
        is_wedge && touches ? shape->a / (right / 2 - left / 2) : NAN,
        setup->is_coupled ? 0 : setup->beta, setup->f, setup->k / setup->E1, safety);
    const bool is_steep = !is_wedge && touches && pad_steepest(shape, left, right) > STEEP;
    const double hull =
        touches && shape->places != NULL ? pad_profile_hull_share(shape->places, left, right) : 0;
    return (doubts){.bits = bits | (is_steep ? DOUBT_SLOPE : 0) |
                            doubt_of_origin(setup, left, right) | doubt_of_lobe(setup, left, right),
                    .hull = hull < HULL_LEAST ? 0 : hull};
}

int32_t doubt_of_zones(const rwedge_contact *contact)
{
    stick_zones zones = stick_zones_of(contact);
    stick_zones_free(&zones);
    return zones.count > 1 ? DOUBT_ZONES : 0;
}

int32_t doubt_of_sliding(const rwedge_contact *contact)
{
    double left, right;
    const bool touches = rwedge_contact_half_width(contact) > 0;
    return touches && rwedge_contact_stick_zone(contact, &left, &right) == RWEDGE_EABSENT
               ? DOUBT_SLIDES
               : 0;
}

int32_t doubt_of_way(const rwedge_contact *contact)
{
    const double b = rwedge_contact_half_width(contact);
    return b > 0 && fabs(rwedge_contact_displacement(contact, b)) > b ? DOUBT_FAR : 0;
}

doubts doubts_of_error(const rwedge_contact *contact)
{
    return (doubts){.error = rwedge_contact_error(contact),
                    .tolerance = rwedge_contact_tolerance(contact)};
}

bool doubts_matter(doubts all)
{
    return all.bits != 0 || all.hull > 0 || all.error > all.tolerance;
}

void doubts_add(doubts *all, doubts more)
{
    all->bits |= more.bits;
    all->error = fmax(all->error, more.error);
    all->tolerance = fmax(all->tolerance, more.tolerance);
    all->hull = fmax(all->hull, more.hull);
    if (fabs(more.coupled.swing) > fabs(all->coupled.swing))
        all->coupled = more.coupled;
}

doubts doubts_of_factor(const contact_case *setup, const rwedge_contact *contact, double factor)
{
    const pad *shape = &setup->shape;
    double left = 0, right = 0;
    rwedge_contact_edges(contact, &left, &right);
    doubts all = doubts_of_error(contact);
    all.bits = doubt_of_zones(contact);
    all.coupled = coupling_of(setup, contact, true);
    if (!(factor < 1)) {
        doubts_add(&all, doubts_of(setup, left, right, NAN));
        return all;
    }
    const double P = loads_of(contact).P, P_yield = /* not known of other pads */
                                          rwedge_yield_load(shape->theta, shape->a, setup->A,
                                                            setup->f, setup->nu1, setup->k);
    doubts_add(&all, doubts_of(setup, left, right, P_yield / P));
    all.bits |= P > P_yield ? 0 : DOUBT_STATE;
    return all;
}

doubts doubts_of_state(const contact_case *setup, const rwedge_contact *contact)
{
    double factor = NAN;
    if (!isnan(setup->k))
        rwedge_contact_yield_factor(contact, setup->nu1, setup->k, &factor, NULL, NULL);
    return doubts_of_factor(setup, contact, factor);
}

/* A part in percent, with two digits, or all that stand before the point. */
static const char *percent(double part, char text[NUMBER_SIZE])
{
    snprintf(text, NUMBER_SIZE, fabs(part) < 0.995 ? "%.2g" : "%.0f", 100 * fabs(part));
    return text;
}

/* "unlike bodies: the contact swings by 3.1 % of b to the trailing edge, and ..." */
static bool write_coupling(coupling of, char text[DOUBT_SIZE])
{
    const bool swings = fabs(of.swing) >= COUPLING_LEAST,
               has_tension = fabs(of.tension) >= COUPLING_LEAST;
    char part[NUMBER_SIZE];
    snprintf(text, DOUBT_SIZE, "unlike bodies: ");
    if (swings)
        list_add(text, DOUBT_SIZE, "", "the contact swings by %s %% of b to the %s edge",
                 percent(of.swing, part), of.swing < 0 ? "trailing" : "leading");
    if (has_tension)
        list_add(text, DOUBT_SIZE, swings ? ", and " : "",
                 "the tension beside the trailing %s is %s %% %s that of similar bodies",
                 swings ? "one" : "edge", percent(of.tension, part),
                 of.tension < 0 ? "below" : "above");
    return swings || has_tension;
}

bool doubts_next(doubts *left, char text[DOUBT_SIZE])
{
    const int32_t bit = left->bits & -left->bits;
    const bool is_hull = left->hull > 0, is_computed = left->error > 0;
    left->bits -= bit;
    if (bit != 0) {
        snprintf(text, DOUBT_SIZE, "%s", text_of(bit));
        return true;
    }
    if (is_hull) {
        const double percent = 100 * left->hull;
        snprintf(
            text, DOUBT_SIZE,
            "in the contact the hull lowers the pad by up to %.*f %% of its rise there: p0 may "
            "be far too high; --fit is for noise",
            percent >= 10  ? 0
            : percent >= 1 ? 1
                           : 2,
            percent);
        left->hull = 0;
        return true;
    }
    const coupling coupled = left->coupled;
    left->coupled = (coupling){0};
    if (write_coupling(coupled, text))
        return true;
    snprintf(text, DOUBT_SIZE, "computed numerically: tractions to about %.1g of f p0",
             left->error);
    left->error = 0;
    return is_computed;
}

void doubts_write(doubts all, char *text, size_t size)
{
    char next[DOUBT_SIZE];
    while (doubts_next(&all, next))
        list_add(text, size, "; ", "%s", next);
}

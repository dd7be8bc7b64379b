/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "table.h"

#include "model/results/results.h"

#include <math.h>
#include <string.h>

#include <rwedge.h>

/* ---- Of a flat pad ---- */

const table_variable flat_over_b = {
    "a-over-b",
    "a_over_b",
    "a/b of a flat pad",
    0,
    0.999,
    "a number from 0 to 0.999",
    "0,0.2,0.4,0.5,0.6,0.7,0.8,0.9,0.95,0.99",
};

/* The radius of the rounding, over b, with A of 1: the load of a flat pad is Hertz' load less a
 * rounded wedge's. */
static const double RADIUS = 2;

static double load_of(double alpha)
{
    return (PI / 2 - (alpha > 0 ? alpha * rwedge_load(alpha) : 0)) / RADIUS;
}

/* Destroy the contact in either case. */
static int32_t slide(double alpha, double f, rwedge_contact **contact)
{
    *contact = NULL;
    const int32_t status = rwedge_contact_create_flat(alpha, RADIUS, 1, f, contact);
    const double P = load_of(alpha);
    return status == RWEDGE_OK ? rwedge_contact_load(*contact, P, f * P) : status;
}

/* The stress hardly changes around its top. */
static double rounded(double place)
{
    return round(1e5 * place) / 1e5;
}

/* Without friction there is a top below each edge. */
static int32_t flat_elastic_limit(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], f = value[FRICTION], nu = value[NU];
    double factor, x, y;
    rwedge_contact *contact;
    int32_t status = slide(alpha, f, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_yield_factor(contact, nu, 1, &factor, &x, &y);
    rwedge_contact_destroy(contact);
    if (status != RWEDGE_OK)
        return status;
    row[0] = cell_number(load_of(alpha) * factor);
    row[1] = cell_number(rounded(f == 0 ? fabs(x) : x));
    row[2] = cell_number(rounded(y));
    row[3] = cell_text(y > 0 ? "subsurface" : "surface");
    return RWEDGE_OK;
}

/* The state is mirror-symmetric without friction too: one depth governs. */
static int32_t flat_shakedown_limit(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B];
    double factor, y;
    rwedge_contact *contact;
    int32_t status = slide(alpha, value[FRICTION], &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_shakedown_factor(contact, value[NU], 1, &factor, &y);
    rwedge_contact_destroy(contact);
    if (status != RWEDGE_OK)
        return status;
    row[0] = cell_number(load_of(alpha) * factor);
    row[1] = cell_number(rounded(y));
    row[2] = cell_text(y > 0 ? "subsurface" : "surface");
    return RWEDGE_OK;
}

static int32_t flat_contact_law(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], total = RADIUS * load_of(alpha), middle = 0;
    double p, q, peak, x;
    rwedge_contact *contact;
    int32_t status = slide(alpha, 0, &contact);
    if (status == RWEDGE_OK)
        status = rwedge_contact_tractions(contact, 1, &middle, &p, &q);
    if (status == RWEDGE_OK)
        status = rwedge_contact_peak_pressure(contact, &peak, &x);
    row[0] = cell_number(total);
    row[1] = cell_number(total / (alpha * alpha));
    if (status == RWEDGE_OK) {
        row[2] = cell_number(RADIUS * peak);
        row[3] = cell_number(-RADIUS * p);
    }
    rwedge_contact_destroy(contact);
    return status;
}

/* ---- Of the wedge ---- */

/* RWEDGE_EABSENT is an answer: the branch does not exist there. */
static int32_t existing(int32_t status)
{
    return status == RWEDGE_EABSENT ? RWEDGE_OK : status;
}

/* It yields at the end of the lower branch. The sharp wedge yields at its apex, and has none. */
static int32_t elastic_limit(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], f = value[FRICTION], nu = value[NU];
    double below = NAN, surface = NAN, x = 0, y = 0, x_below = 0, y_below = 0;
    int32_t status = RWEDGE_OK;
    if (alpha > 0)
        status = existing(rwedge_subsurface_yield(alpha, f, nu, &below, &x_below, &y_below));
    if (alpha > 0 && status == RWEDGE_OK)
        status = existing(rwedge_surface_yield(alpha, f, nu, &surface, &x));
    double limit = fmin(below, surface);
    const bool is_below = limit == below;
    if (status == RWEDGE_OK && isnan(limit))
        status = rwedge_yield_point(alpha, f, nu, &limit, &x, &y);
    row[0] = cell_number(limit);
    row[1] = cell_number(is_below ? x_below : x);
    row[2] = cell_number(is_below ? y_below : y);
    row[3] = cell_text(is_below ? "subsurface" : "surface");
    row[4] = cell_number(below);
    row[5] = cell_number(surface);
    return status;
}

static int32_t shakedown_limit(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], f = value[FRICTION], nu = value[NU];
    double limit = NAN, y = 0, below = NAN, surface = NAN, y_below;
    int32_t status = rwedge_shakedown_limit(alpha, f, nu, &limit, &y);
    if (alpha > 0 && status == RWEDGE_OK)
        status = existing(rwedge_subsurface_shakedown(alpha, f, nu, &below, &y_below));
    if (alpha > 0 && status == RWEDGE_OK)
        status = existing(rwedge_surface_shakedown(alpha, f, nu, &surface));
    row[0] = cell_number(limit);
    row[1] = cell_number(rounded(y));
    row[2] = cell_text(y > 0 ? "subsurface" : "surface");
    row[3] = cell_number(below);
    row[4] = cell_number(surface);
    return status;
}

static int32_t max_tension(const double value[], cell row[])
{
    const double over_f = rwedge_max_tension(value[A_OVER_B]);
    row[0] = cell_number(value[FRICTION] * over_f);
    row[1] = cell_number(over_f);
    return RWEDGE_OK;
}

/* The sharp wedge, a = 0, has infinite entries: they stay empty. */
static int32_t contact_law(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], total = rwedge_load(alpha);
    row[0] = cell_number(total);
    row[1] = cell_number(total / alpha);
    row[2] = cell_number(rwedge_peak_pressure(alpha));
    row[3] = cell_number(rwedge_transition_pressure(alpha));
    return RWEDGE_OK;
}

static int32_t critical_friction(const double value[], cell row[])
{
    const double alpha = value[A_OVER_B], nu = value[NU];
    const double f = alpha > 0 ? rwedge_critical_friction(alpha, nu) : NAN;
    const double limit = alpha > 0 ? rwedge_elastic_limit(alpha, f, nu) : NAN;
    if (alpha > 0 && !isfinite(limit))
        return RWEDGE_ENOCONV;
    row[0] = cell_number(f);
    row[1] = cell_number(limit);
    return RWEDGE_OK;
}

static int32_t stick_zone(const double value[], cell row[])
{
    row[0] = cell_number(rwedge_stick_width(value[A_OVER_B], value[Q_OVER_FP]));
    return RWEDGE_OK;
}

/* ---- Of unlike bodies that slide, the rotation of the wedge being held ---- */

static const char OF_UNLIKE[] = "an a_over_b of 0, or from 0.001 to 1000";

/* beta is 1/2 at most: there is no pair of bodies with more, and no value. */
static bool is_pair(const double value[])
{
    return fabs(value[BETA_F]) <= value[FRICTION] / 2;
}

static int32_t unlike_elastic_limit(const double value[], cell row[])
{
    double limit = NAN, x = NAN, y = NAN;
    const int32_t status = is_pair(value)
                               ? rwedge_sliding_limit(value[A_OVER_B], value[BETA_F],
                                                      value[FRICTION], value[NU], 1, &limit, &x, &y)
                               : RWEDGE_OK;
    row[0] = cell_number(limit);
    row[1] = cell_number(rounded(x));
    row[2] = cell_number(rounded(y));
    row[3] = cell_text(isnan(y) ? "" : y > 0 ? "subsurface" : "surface");
    return status;
}

static int32_t unlike_max_tension(const double value[], cell row[])
{
    double total, middle, tilt, over_f;
    const int32_t status =
        rwedge_sliding_law(value[A_OVER_B], value[BETA_F], 1, &total, &middle, &tilt, &over_f);
    if (status != RWEDGE_OK)
        return status;
    row[0] = cell_number(value[FRICTION] * over_f);
    row[1] = cell_number(over_f);
    row[2] = cell_number(total);
    row[3] = cell_number(middle);
    return status;
}

const table tables[TABLE_COUNT] = {
    {.name = "elastic-limit",
     .summary = "load at first yield P/(bk), where, and on which branch",
     .has = {[A_OVER_B] = true, [FRICTION] = true, [NU] = true},
     .across = FRICTION,
     .quantity = {"P_over_bk", "x_over_b", "y_over_b", "branch", "P_over_bk_subsurface",
                  "P_over_bk_surface"},
     .row = elastic_limit},
    {.name = "max-tension",
     .summary = "tension at the trailing edge, b sigma/P and b sigma/(fP)",
     .has = {[A_OVER_B] = true, [FRICTION] = true},
     .across = FRICTION,
     .quantity = {"b_sigma_over_P", "b_sigma_over_fP"},
     .row = max_tension},
    {.name = "contact-law",
     .summary = "load, peak pressure, and pressure where the rounding ends",
     .has = {[A_OVER_B] = true},
     .across = VARIABLE_COUNT,
     .quantity = {"AP_over_theta_b", "AP_over_theta_a", "peak_pressure", "transition_pressure"},
     .row = contact_law},
    {.name = "critical-friction",
     .summary = "friction at which yield jumps to the surface, and its load",
     .has = {[A_OVER_B] = true, [NU] = true},
     .across = NU,
     .quantity = {"f_critical", "P_over_bk"},
     .row = critical_friction},
    {.name = "stick-zone",
     .summary = "half-width of the stick zone c/b",
     .has = {[A_OVER_B] = true, [Q_OVER_FP] = true},
     .across = Q_OVER_FP,
     .quantity = {"c_over_b"},
     .row = stick_zone},
    {.name = "shakedown-limit",
     .summary = "load P/(bk) that is carried pass after pass, and its depth",
     .has = {[A_OVER_B] = true, [FRICTION] = true, [NU] = true},
     .across = FRICTION,
     .quantity = {"P_over_bk", "y_over_b", "branch", "P_over_bk_subsurface", "P_over_bk_surface"},
     .row = shakedown_limit,
     .allowed = "an a_over_b of 0, or of 0.001 and more"},
    {.name = "elastic-limit",
     .summary = "load at first yield P/(bk) of a flat pad, and where",
     .has = {[A_OVER_B] = true, [FRICTION] = true, [NU] = true},
     .across = FRICTION,
     .quantity = {"P_over_bk", "x_over_b", "y_over_b", "branch"},
     .row = flat_elastic_limit,
     .ratio = &flat_over_b},
    {.name = "contact-law",
     .summary = "load of a flat pad, largest and middle pressure",
     .has = {[A_OVER_B] = true},
     .across = VARIABLE_COUNT,
     .quantity = {"APR_over_b2", "APR_over_a2", "largest_pressure", "middle_pressure"},
     .row = flat_contact_law,
     .ratio = &flat_over_b},
    {.name = "shakedown-limit",
     .summary = "P/(bk) a flat pad carries pass after pass, depth",
     .has = {[A_OVER_B] = true, [FRICTION] = true, [NU] = true},
     .across = FRICTION,
     .quantity = {"P_over_bk", "y_over_b", "branch"},
     .row = flat_shakedown_limit,
     .ratio = &flat_over_b},
    {.name = "elastic-limit",
     .summary = "P/(bk) at first yield of unlike bodies, and where",
     .has = {[A_OVER_B] = true, [FRICTION] = true, [NU] = true, [BETA_F] = true},
     .across = FRICTION,
     .quantity = {"P_over_bk", "x_over_b", "y_over_b", "branch"},
     .row = unlike_elastic_limit,
     .allowed = OF_UNLIKE},
    {.name = "max-tension",
     .summary = "tension at the edge of unlike bodies, and the middle",
     .has = {[A_OVER_B] = true, [FRICTION] = true, [BETA_F] = true},
     .across = FRICTION,
     .quantity = {"b_sigma_over_P", "b_sigma_over_fP", "AP_over_theta_b", "swing"},
     .row = unlike_max_tension,
     .allowed = OF_UNLIKE},
};

const column_kind table_columns[COLUMN_KINDS] = {
    {"a_over_b", "rounding over contact; 1 and more is Hertz' contact", "none"},
    {"f", "coefficient of friction", "none"},
    {"nu", "Poisson's ratio of the half-plane, plane strain", "none"},
    {"P_over_bk", "elastic limit P/(bk) in full sliding, or that of shakedown", "none"},
    {"x_over_b", "where it yields first; x > 0 is towards the leading edge", "b"},
    {"y_over_b", "and how deep", "b"},
    {"branch", "surface or subsurface: where that point is", "text"},
    {"P_over_bk_subsurface", "the limit of the point below the surface alone", "none"},
    {"P_over_bk_surface", "the limit of the surface alone", "none"},
    {"b_sigma_over_P", "tension at the trailing edge b sigma/P in full sliding", "none"},
    {"b_sigma_over_fP", "the same over f, b sigma/(fP)", "none"},
    {"AP_over_theta_b", "load A P/(theta b)", "none"},
    {"AP_over_theta_a", "load A P/(theta a)", "none"},
    {"peak_pressure", "pressure at x = 0", "theta/A"},
    {"transition_pressure", "pressure where the rounding meets the flank, x = a", "theta/A"},
    {"f_critical", "friction from which on yield starts at the surface", "none"},
    {"Q_over_fP", "tangential force over its sliding value", "none"},
    {"c_over_b", "half-width of the stick zone; 0 slides", "b"},
    {"APR_over_b2", "load A P R/b^2", "none"},
    {"APR_over_a2", "load A P R/a^2", "none"},
    {"largest_pressure", "largest pressure, near the edges", "b/(A R)"},
    {"middle_pressure", "pressure at x = 0", "b/(A R)"},
    {"beta_f", "Dundurs' beta of half-plane and wedge, times f", "none"},
    {"swing", "middle of the contact; below 0 towards the trailing edge", "b"},
};

const table *table_named(const char *name, bool is_flat, bool is_unlike)
{
    for (int i = 0; i < TABLE_COUNT; i++)
        if (strcmp(tables[i].name, name) == 0 && (tables[i].ratio != NULL) == is_flat &&
            tables[i].has[BETA_F] == is_unlike)
            return &tables[i];
    return NULL;
}

const table_variable *table_variable_of(const table *chosen, int variable)
{
    return variable == A_OVER_B && chosen->ratio != NULL ? chosen->ratio : &variables[variable];
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "entry.hpp"

#include <fstream>
#include <math.h>
#include <sstream>
#include <stdexcept>
#include <stdio.h>
#include <string.h>

static const char HEADER[] = "a_over_b,f,nu,P_over_bk,x_over_b,y_over_b,branch,";

static bool complain(const char *file, size_t line, const char *fault)
{
    fprintf(stderr, "certificate: %s:%zu: %s\n", file, line, fault);
    return false;
}

/* The cell up to the next comma; a line that has none left is no entry. */
static std::string next_cell(std::istringstream &line)
{
    std::string cell;
    if (!std::getline(line, cell, ',') || line.eof())
        throw std::invalid_argument("too few cells");
    return cell;
}

static ball decimal(const std::string &text)
{
    ball number;
    if (text.empty() || arb_set_str(number.raw(), text.c_str(), bits) != 0 || !is_finite(number))
        throw std::invalid_argument("not a number");
    return number;
}

static entry entry_of(std::istringstream line)
{
    entry e = {};
    e.a_over_b = next_cell(line);
    e.alpha = decimal(e.a_over_b);
    e.f = decimal(next_cell(line));
    e.kappa = sqr(2 * decimal(next_cell(line)) - 1) / 3;
    e.limit = decimal(next_cell(line));
    const ball x = decimal(next_cell(line)), y = decimal(next_cell(line));
    e.place = complex_ball(x, y);
    const std::string branch = next_cell(line);
    e.at_surface = branch == "surface";
    if (!(e.alpha > 0) || e.f < 0 || !(e.limit > 0) || y < 0 ||
        !(e.at_surface || branch == "subsurface"))
        throw std::invalid_argument("outside the domain");
    return e;
}

/* Is the a/b in the comma list? NULL lists all. */
static bool is_wanted(const std::string &a_over_b, const char *list)
{
    return !list || ("," + std::string(list) + ",").find("," + a_over_b + ",") != std::string::npos;
}

bool read_entries(groups *all, const char *file, const char *list)
{
    std::ifstream stream(file);
    if (!stream)
        return complain(file, 0, "cannot be read");
    std::string text;
    if (!std::getline(stream, text) || text.compare(0, strlen(HEADER), HEADER) != 0)
        return complain(file, 1, "not a table of elastic limits");
    for (size_t number = 2; std::getline(stream, text); number++)
        try {
            entry e = entry_of(std::istringstream(text));
            e.file = file;
            e.line = number;
            if (is_wanted(e.a_over_b, list))
                (*all)[middle(e.alpha)].entries.push_back(e);
        } catch (const std::invalid_argument &) {
            return complain(file, number, "not an entry");
        }
    return true;
}

double distance_of(const entry &e)
{
    const double stated = lower_bound(e.limit);
    return fmax(fabs(lower_bound(e.most) - stated), fabs(lower_bound(e.least) - stated)) / stated;
}

bool is_rounded(const entry &e)
{
    enum { DIGITS = 10 };
    const auto unit = DIGITS - 1 - (ulong)floor(log10(lower_bound(e.limit)));
    ball power = 10;
    arb_pow_ui(power.raw(), power.raw(), unit, bits);
    const ball half_unit = scaled(1 / power, -1);
    return e.most <= e.limit + half_unit && e.least >= e.limit - half_unit;
}

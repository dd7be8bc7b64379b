/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The accuracy of every function of the library: certified errors at random arguments, as a
 * table in Markdown.
 *
 *     accuracy [calls [seed [function]]]
 *
 * The exit status is 1 if an error exceeds what the header promises. If the header promises
 * nothing, the bound of the row counts. The figures depend only on calls and seed. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <algorithm>
#include <vector>

#include "balls/parallel.hpp"
#include "rows/rows.hpp"

static const row *const SECTIONS[] = {
    LAW_ROWS,       STRESS_ROWS,          GRADIENT_ROWS, STRENGTH_ROWS, DESIGN_ROWS, HISTORY_ROWS,
    ECCENTRIC_ROWS, ECCENTRIC_FIELD_ROWS, PAD_ROWS,      MEASURE_ROWS,  PLANE_ROWS,  LIFE_ROWS};

/* The error of each of so many calls. */
static std::vector<double> measure(const row *claim, uint64_t seed, size_t count)
{
    std::vector<double> errors(count);
    in_parallel(count, [&](size_t i) {
        probe call;
        errors[i] = probe_error(claim, seed, i, &call);
    });
    return errors;
}

/* ---- Reporting ---- */

static void print_call(FILE *stream, const probe *call, const char *format)
{
    for (int i = 0; i < call->arguments; i++) {
        fprintf(stream, "%s%s=", i ? " " : "", call->name[i]);
        fprintf(stream, format, call->value[i]);
    }
}

/* What reproduces a call: all digits, and the loads of a history. */
static void print_breach(const row *claim, const probe *call, double error)
{
    fprintf(stderr, "%s: error %.3g, bound %.3g at ", claim->function, error, claim->promised);
    print_call(stderr, call, "%.17g");
    for (int i = 0; i < call->loads; i++)
        fprintf(stderr, " (%.17g, %.17g)", call->P[i], call->Q[i]);
    for (int i = 0; i < RESULTS_MAX && call->result[i] != 0; i++)
        fprintf(stderr, "%s%.17g", i ? ", " : " -> ", call->result[i]);
    fprintf(stderr, "\n");
}

/* Whether the promise was kept. */
static bool report(const row *claim, size_t calls, uint64_t seed)
{
    const double wanted = ceil((double)calls * claim->part);
    std::vector<double> errors = measure(claim, seed, (size_t)wanted);
    const auto largest = std::max_element(errors.begin(), errors.end());
    const size_t worst = (size_t)(largest - errors.begin()), count = errors.size();
    const double error = *largest;
    std::sort(errors.begin(), errors.end());
    const double usual = errors[(count - 1) * 999 / 1000];
    probe call;
    probe_error(claim, seed, worst, &call);
    const bool kept = error <= claim->promised;
    printf("| `%s` | %s | %zu | %.3g | %.3g | %.1e %s | %s%s | ", claim->function, claim->domain,
           count, error / DBL_EPSILON, usual / DBL_EPSILON, error, claim->measure, claim->promise,
           kept ? "" : " **broken**");
    print_call(stdout, &call, "%.4g");
    printf(" |\n");
    fflush(stdout);
    if (!kept)
        print_breach(claim, &call, error);
    return kept;
}

int main(int count, char *arguments[])
{
    const double calls = count > 1 ? strtod(arguments[1], NULL) : 2000;
    const uint64_t seed = count > 2 ? strtoull(arguments[2], NULL, 10) : 1;
    if (!(calls >= 1 && calls <= 1e9)) {
        fprintf(stderr, "usage: accuracy [calls [seed [function]]]\n");
        return 2;
    }
    bool kept = true, is_known = false;
    printf("| `rwedge_` | domain sampled | calls | worst, eps | 99.9 %%, eps | worst, and of what "
           "| promised | worst at |\n"
           "|---|---|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof SECTIONS / sizeof SECTIONS[0]; i++)
        for (const row *claim = SECTIONS[i]; claim->function; claim++)
            if (count < 4 || strstr(claim->function, arguments[3])) {
                is_known = true;
                kept &= report(claim, (size_t)calls, seed);
            }
    flint_cleanup();
    if (!is_known) {
        fprintf(stderr, "accuracy: no row has \"%s\" in its first column\n", arguments[3]);
        return 2;
    }
    return kept ? EXIT_SUCCESS : EXIT_FAILURE;
}

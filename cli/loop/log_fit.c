/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows of a log as the library takes them, and what it tells of them. */
#include "loop.h"

#include <math.h>
#include <stdlib.h>

static bool is_fitted(int32_t status, size_t count, complaint *why)
{
    if (status == RWEDGE_ERANGE)
        return complain(why, "%zu rows: too few for a loop; needed: 8", count);
    if (status == RWEDGE_EABSENT)
        return complain(why, "no loop: P, Q or the displacement stays 0, or does not change");
    if (status == RWEDGE_ENOCONV)
        return complain(why,
                        "no friction is found with which the contact follows these displacements");
    return status == RWEDGE_OK || complain(why, "%s", rwedge_strerror(status));
}

/* The root of the mean square; three numbers are fitted. */
static double left_of(size_t count, const load row[], const double fitted[])
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (fitted[i] - row[i].Q) * (fitted[i] - row[i].Q);
    return count > LOOP_PARTS ? sqrt(sum / (double)(count - LOOP_PARTS)) : NAN;
}

/* The bodies are apart where P is negative. */
bool log_fit_find(const rwedge_contact *contact, size_t count, const load row[], log_fit *fit,
                  complaint *why)
{
    if (!loop_dissipates(count, row, why))
        return false;
    double *P = memory_zeroed(5 * count + 1, sizeof *P), *M = P + count, *sigma = M + count,
           *displacement = sigma + count, *Q = displacement + count;
    for (size_t i = 0; i < count; i++) {
        P[i] = fmax(row[i].P, 0);
        M[i] = row[i].P > 0 ? row[i].M : 0;
        sigma[i] = row[i].sigma;
        displacement[i] = row[i].displacement;
        Q[i] = row[i].Q;
    }
    double told[LOOP_PARTS] = {0}, regime = 0;
    *fit = (log_fit){.Q = memory_zeroed(count + 1, sizeof *fit->Q)};
    const int32_t status =
        rwedge_contact_loop_fit(contact, count, P, M, sigma, displacement, Q, fit->value,
                                fit->uncertainty, told, &regime, fit->Q);
    fit->noise = left_of(count, row, fit->Q);
    free(P);
    fit->regime = (int)regime;
    for (int j = 0; j < LOOP_PARTS; j++)
        if (told[j] == 0)
            fit->value[j] = fit->uncertainty[j] = NAN;
    return is_fitted(status, count, why);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fatigue parameters of cycles of stresses, on the worst of the planes that contain z. With the
 * waves of plane_search.h, the normal strain of a plane is (1+nu)/E (mean s + n - s), mean being
 * 1-2nu in plane strain and 1 - 2nu/(1+nu) in plane stress, and its shear strain 2(1+nu)/E q. */
#include "measures/planes.h"
#include "planes/plane_search.h"

/* Point by point, the largest product of the two waves, times `unit`. */
static int32_t search(const rw_stress_field *f, rw_stress_cycle waves, double unit,
                      const rw_criterion_results *results)
{
    waves.loads = f->loads;
    waves.stride = f->points;
    for (size_t i = 0; i < f->points; i++) {
        waves.sxx = f->sxx + i;
        waves.syy = f->syy + i;
        waves.txy = f->txy + i;
        rw_direction phi;
        results->value[i] = unit * rw_plane_search(&waves, &phi);
        results->angle[i] = rw_plane_angle(phi.cosine, phi.sine);
        results->out_of_plane[i] = 0;
    }
    return RWEDGE_OK;
}

int32_t rw_smith_watson_topper_in_plane(const rw_stress_field *f, const double constants[],
                                        const rw_criterion_results *results)
{
    const double nu = f->nu, mean = f->is_plane_stress ? 1 - 2 * nu / (1 + nu) : 1 - 2 * nu;
    return search(f, (rw_stress_cycle){.gain = 1, .mean = mean, .normal = 1},
                  (1 + nu) / constants[0] / 2, results);
}

int32_t rw_fatemi_socie_in_plane(const rw_stress_field *f, const double constants[],
                                 const rw_criterion_results *results)
{
    const double gain = constants[1] / constants[2];
    return search(f, (rw_stress_cycle){.offset = 1, .gain = gain, .shear = 1},
                  (1 + f->nu) / constants[0], results);
}

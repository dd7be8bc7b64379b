/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a crack does is linear in the stresses that are on its line without it. The half-plane has
 * no length of its own: weights of an angle serve any length, place and load. */
#ifndef RW_WEIGHTS_H
#define RW_WEIGHTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The angles from the normal of the surface, rad, that have weights. */
bool rw_is_crack_angle(double angle);

/* The m places, in the length of the crack from its mouth, the tip first. */
void rw_crack_places(size_t m, double place[]);

/* Rows of 2 m weights each, m of the normal stress and m of the shear stress at the places: those
 * of K_I/sqrt(l) and K_II/sqrt(l), and of E'/l times the opening at the places at[0] ...
 * at[openings - 1], none of which is the tip. The opening of a place errs by m^-2, the mean from
 * one dislocation to the next does not. RWEDGE_ENOMEM, RWEDGE_ENOCONV. */
int32_t rw_crack_rows(double angle, size_t m, size_t openings, const size_t at[], double row[]);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Faces of a crack that press on each other without friction: no place overlaps, no place is pulled
 * together, and no place is both open and pressed. */
#ifndef RW_FACES_H
#define RW_FACES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A state is 2 + n numbers: K_I and K_II over the root of the length, and the openings of n places,
 * the one next to the tip first. It is free where faces pass through each other: then it is linear
 * in the loads. */
typedef struct {
    size_t n;
    double *influence; /* of a pressure at each place on each number of the state: rows of n */
    double *inverse;   /* of its part for the openings, n rows of n */
    double *A, *b, *pressure, *opening, *all_shut; /* room */
    size_t *at;
    bool *is_closed; /* n: of the state that was asked last */
} rw_faces;

/* Room for n places, `influence` without values. rw_faces_destroy() frees it, after an error too.
 * RWEDGE_ENOMEM. */
int32_t rw_faces_create(size_t n, rw_faces *faces);
void rw_faces_destroy(rw_faces *faces);

/* To be called once `influence` has its values. RWEDGE_ENOCONV. */
int32_t rw_faces_invert(rw_faces *faces);

/* K of a free state when faces press. K[0] below 0 means that the tip is closed: K_I is 0 there.
 * RWEDGE_ENOCONV. */
int32_t rw_faces_press(rw_faces *faces, const double free[], double K[2]);

/* K_II where K_I becomes 0 on the straight way between two free states, of which one has K_I > 0
 * when faces press and one has not. RWEDGE_ENOCONV. */
int32_t rw_faces_pass(rw_faces *faces, const double open[], const double closed[], double *K_II);

#endif

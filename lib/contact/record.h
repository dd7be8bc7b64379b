/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What many states of a contact leave of it: their shear as pieces of patches, or as a traction.
 * Each load leaves the first patches as they were, so that a state adds those alone that follow. */
#ifndef RW_CONTACT_RECORD_H
#define RW_CONTACT_RECORD_H

#include "contact/contact.h"

/* A patch whose pressure, times the weight and f, is a part of the shear. */
typedef struct {
    rw_patch patch;
    double weight;
} rw_piece;

/* Pieces in a row. */
typedef struct {
    rw_piece *all;
    size_t count, capacity;
} rw_pieces;

/* A state: how many pieces of the state before it keeps; how many more it has, the last being the
 * contact; its tension. */
typedef struct {
    size_t kept, own;
    double sigma;
    rw_traction shear;   /* where it is no sum of pieces */
    rw_traction pressed; /* f times the pressure where it is no patch's */
    bool is_lent;        /* both are those of another record */
} rw_entry;

typedef struct {
    rw_pieces own, now; /* those of all states; all pieces of the last state */
    rw_entry *entries;
    size_t count, capacity, most; /* most: pieces of one state */
} rw_record;

/* Adds the contact as it is. `lender`, or NULL, is a state of another record with the same shear,
 * which is to live as long. false where memory is short. */
bool rw_record_add(rw_record *record, const rwedge_contact *contact, const rw_entry *lender);
void rw_record_destroy(rw_record *record);

/* Places, and where their stresses after each state go: of a state one place after the other. */
typedef struct {
    size_t n;
    const double *x, *y;
    double *sxx, *syy, *txy;
} rw_stress_points;

/* The stresses after each state, as rwedge_contact_stresses() gives them; the pad, friction and
 * compliance are those of the contact. false where memory is short. */
bool rw_record_stresses(const rw_record *record, const rwedge_contact *contact,
                        const rw_stress_points *points);

#endif

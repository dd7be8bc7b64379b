/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers about the case of the form, as records. */
#ifndef PAGE_ANSWERS_H
#define PAGE_ANSWERS_H

#include "model/model.h"

/* Reads the case without its loads, which are given apart, and Poisson's ratio of body 1. In plane
 * stress the contact is one of Poisson's ratio 0. False where it is refused: the records say
 * why. */
bool answers_history(char *lines, bool is_plane_stress, contact_case *setup, load *form,
                     double *nu);

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers about the case of the form, as records. */
#ifndef PAGE_ANSWERS_H
#define PAGE_ANSWERS_H

#include "model/contact_case.h"

/* Reads the case without its loads, which are given apart. False where it is refused: the records
 * say why. */
bool answers_history(char *lines, contact_case *setup, load *form);

/* Keeps the contact, which may be NULL, for page_contact(); the one before is destroyed. */
void answers_keep(rwedge_contact *contact);

#endif

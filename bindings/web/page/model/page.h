/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PAGE_H
#define PAGE_H

#include "input/input.h"
#include "model/cycle/cycle.h"
#include "model/model.h"
#include "number/number.h"

#include <stddef.h>

/* What JavaScript calls. */
#define EXPORTED

/* ---- json ---- An answer: objects, which JavaScript puts together to one. */

/* Begins anew: the text before is lost. */
void json_begin(void);

/* A part of it: JSON with ' for ", in which %t stands for a text, null where there is none, and %n
 * for a double, null where it is not a number. Commas go between the parts. */
void json_add(const char *form, ...);

/* A number as a text, with all digits; "" where it is not a number. */
const char *json_digits(double number, char text[NUMBER_SIZE]);

/* What is wrong, and with which input; or "". */
void json_fault(const char *input, const char *why);

/* The same in place of all that was added, made as by printf; false. */
bool json_refuse(const char *input, const char *format, ...) PRINTF_LIKE(2, 3);

/* The whole. */
const char *json_end(void);

/* ---- field_texts ---- The texts of the form, as JavaScript hands them over. */

/* From "name=text" of each input, with U+001E between them; it takes them apart in place. The text
 * of "decimal_sign" is that of the others, a point where it is missing; that of "profile" has its
 * rows, whose decimal sign may be that of "profile_sign". "plane_stress" is in place of plane
 * strain, "strength_of" the body that k is of. "rotation" is "held" or "free", and "similar"
 * neglects what friction of unlike bodies does to the pressure. "hull", "fit", "heights" and
 * "origin" say how the profile is made of them, "units" the working units, "width" what forces of
 * the whole contact are divided by, "section" what a tension that is a force is, and "compliance"
 * how far a rig gives way that prescribes a displacement. */
input_texts field_texts(char *fields);

/* The units of the last texts; the name of their profile, NULL for none, and how it was made. */
const unit_system *field_units(void);
const char *field_profile(void);
const profile_making *field_making(void);

/* Whether k, of the last texts, is of body 2. */
bool field_is_of_pad(void);

/* What an input of the last texts has been divided by: 1, or the width, or the section. */
double field_share(int input);

/* How far a rig gives way that prescribes a displacement, of the last texts; NULL for no rig. */
const char *field_compliance(void);

/* What is to be known of the profile of the last texts; or "". */
const char *field_remark(void);

/* ---- conversions ---- Sets of units. */

/* Those of a text such as "mm,N,MPa"; of another text unknown ones. */
unit_system units_named(const char *words);

/* ---- resolution ---- How well a measured profile is resolved. */

/* Writes that of the form's profile, for a case whose contact is under its loads. */
void resolution_write(const contact_case *setup);

/* ---- answers ---- About the case of the form. */

/* The contact of an answer, for JavaScript, which takes it or not. */
void answers_hand_over(rwedge_contact *contact);

/* Reads the case without its loads, which are given apart, and Poisson's ratio of body 1. False
 * where it is refused: the answer says why. */
bool answers_history(char *fields, bool is_plane_stress, contact_case *setup, load *form,
                     double *nu);

/* ---- cycle ---- About a history of loads. */

/* The last cycle of the last answer, and the constants of its material; NULL where it has none. */
const last_cycle *cycle_answered(const material **constants);

/* ---- pasted ---- Rows that were pasted, read as the tool reads a file. */

/* What a file that is opened next has in it, whatever its name. The text must outlive the input. */
void pasted_offer(const char *text);

/* What is wrong with pasted rows; "" for nothing. */
const char *pasted_problem(const table_input *rows);

/* ---- load_list ---- Loads one after the other, pasted as a table. */

typedef struct {
    load to;
    int line; /* of the pasted text; 0 where the form gives it */
} listed_load;

typedef struct {
    listed_load *load;
    size_t count;
    double compliance; /* of the rig that drives all of them; NAN for none */
    complaint unused;  /* columns with numbers */
} load_list;

void load_list_add(load_list *loads, load to, int line);

/* False where a row is no load: the answer says why. With a compliance in the form a rig drives
 * them. */
bool load_list_read(const char *text, char decimal_sign, load_list *loads);

/* Adds the loads, and the columns that are not used. */
void load_list_write(const load_list *loads);

void load_list_free(load_list *loads);

#endif

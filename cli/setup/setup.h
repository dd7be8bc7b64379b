/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_SETUP_H
#define CLI_SETUP_H

#include "document/document.h"
#include "input/input.h"
#include "model/cycle/cycle.h"
#include "options/options.h"

/* ---- notices ---- What makes inputs and results doubtful, said on stderr. */

/* A line for each, after a word on where, or "". */
void doubts_say(doubts all, const char *where);

/* Ends the command where the library has not answered about the subject. */
void status_check(int32_t status, const char *subject);

/* Which columns of a file have numbers that nothing uses, in the rows that were noted. */
void unused_say(const header *names, const char *file);

/* ---- input_options ---- The inputs of a contact as options of a command. */

/* The numbers of their options; those of a command that has them start after the last. */
enum {
    OPTION_INPUT = OPTION_OWN,
    OPTION_HULL = OPTION_INPUT + INPUT_COUNT,
    OPTION_EXACT,
    OPTION_TOLERANCE,
    OPTION_UNITS,
    OPTION_WIDTH,
    OPTION_SECTION,
    OPTION_DROP,
    OPTION_FIT,
    OPTION_HEIGHTS,
    OPTION_ORIGIN,
    OPTION_PLANE_STRESS,
    OPTION_ROTATION,
    OPTION_SIMILAR,
    OPTION_MATERIAL,
    OPTION_K_IN,
    OPTION_COMPLIANCE,
    OPTION_CASE,
    OPTION_SAVE_CASE,
    OPTION_AFTER_INPUTS
};

#define MATERIAL_OPTION                                                                            \
    "material", '\0', POPT_ARG_STRING, NULL, OPTION_MATERIAL,                                      \
        "Constants of body 1: of \"rwedge materials\", of a JSON or CSV file, or {...}", "FILE"
#define PLANE_STRESS_OPTION                                                                        \
    "plane-stress", '\0', POPT_ARG_NONE, NULL, OPTION_PLANE_STRESS,                                \
        "Plane stress, of contact and criteria (default: plane strain)", NULL
#define ROTATION_OPTION                                                                            \
    "rotation", '\0', POPT_ARG_STRING, NULL, OPTION_ROTATION,                                      \
        "Of unlike bodies with friction: whether a rig holds the rotation of the pad", "held|free"
#define SIMILAR_OPTION                                                                             \
    "similar", '\0', POPT_ARG_NONE, NULL, OPTION_SIMILAR,                                          \
        "Neglect what friction of unlike bodies does to the pressure", NULL
#define K_IN_OPTION                                                                                \
    "K-in", '\0', POPT_ARG_STRING, NULL, OPTION_K_IN,                                              \
        "Unit of length in constants of K that have no unit: m as in MPa sqrt(m)", "m|mm"

/* Tables to include: the contact and its loads; its strength; bodies and shape but for nu1; how the
 * heights of a profile are taken; how loads without a closed form are taken. Only the last two are
 * filled before input_options_prepare(). */
extern struct poptOption input_option_table[], strength_option_table[], shape_option_table[],
    heights_option_table[], exactness_option_table[];

/* The head of the table of a command that asks a loaded contact. */
#define CONTACT_OPTIONS                                                                            \
    {INCLUDED(input_option_table), "The contact:", NULL},                                          \
    {                                                                                              \
        INCLUDED(strength_option_table), "Its strength:", NULL                                     \
    }

/* Fills the tables with the words of the inputs. */
void input_options_prepare(void);

/* How the profile of a command line is made of its file. */
profile_making profile_making_of(const arguments *line);

/* Takes the texts of a command line, and what a material gives; reads the profile. An impossible
 * tolerance is a mistake. */
void input_texts_from_options(const arguments *line, input_texts *texts);

/* Refuses --hull without a profile. */
void input_options_check_hull(const arguments *line);

/* ---- reading_options ---- How files are read: their units, columns and rows. */

/* For a command without inputs, too. */
extern struct poptOption reading_option_table[];

/* How the files of a command line are to be read. */
reading reading_of(const arguments *line, char decimal_sign);

/* ---- unit_options ---- The working units. */

/* The working units that a command line gives, or those that are assumed where it gives none. */
const unit_system *units_of(const arguments *line);
void units_assume(const unit_system *units);

/* Says that lengths are in mm, where a K in m is converted to them and nothing says their unit. */
void units_say_of_K(const arguments *line);

/* A size of a dimension that an option gives, above 0; NAN where it does not. */
double option_size(const arguments *line, int number, const char *name, const char *dimension,
                   const unit_system *units);

/* ---- material_file ---- Constants of a material, by --material: one that is shipped, a file, or
 * an object, {"su": 900}. What is wrong ends the command. */

/* They are read once. None where there is no option. */
const material *material_of(const arguments *line);

/* E, nu and the yield stress stand for inputs that are not given. */
void material_hand_over(const arguments *line, input_texts *texts);

/* ---- shipped ---- The materials that the tool has, as the files in tables/materials. */

typedef struct {
    const char *name, *text; /* JSON */
} shipped_material;
extern const shipped_material shipped_materials[]; /* ends with a name of NULL */

/* NULL where none has the name. */
const shipped_material *shipped_material_named(const char *name);

/* "; the nearest is sae-1015-normalized", or how to list them. */
const char *shipped_material_hint(const char *name);

/* ---- load_history ---- A history of loads, in straight steps, as the command line or a CSV file
 * gives it: read whole, and then applied, once or again and again. */

/* --load, --history, --encoding, and how exact loads are: a command's own table includes them, by
 * POPT_ARG_INCLUDE_TABLE. */
enum {
    OPTION_HISTORY = OPTION_AFTER_INPUTS,
    OPTION_LOAD, /* may be repeated */
    OPTION_AFTER_LOADS
};
extern struct poptOption load_option_table[];

typedef struct {
    const char *name; /* of the file, as messages call it; NULL where --load gave the loads */
    bool is_of_case;  /* loads without lines */
    header names;     /* what the columns of the file are */
    bool has_mark;    /* whether the file begins with the mark of Unicode */
    load *load;
    csv_row *row; /* of the file, where each stands; of --load its text and what follows */
    size_t count;
} load_history;

/* The file that the loads come from, a word or that of --history; NULL where there is none. */
const char *history_file(const arguments *line);
bool history_is_given(const arguments *line);

/* Refuses an encoding without a file, or one that iconv does not know; and loads beside those of a
 * history. */
void history_check(const arguments *line);

/* Loads of a case, which stand for a file of that name; of the whole contact where the units have
 * its width. */
void load_history_offer(const char *name, const unit_system *units, const load *to, size_t count);

/* Reads the file where there is one, else the list; or the list of --load. What has been read once
 * is given again. */
void load_history_read(const arguments *line, char decimal_sign, load_history *loads);
/* A file of what a rig measured: Q and its displacement. */
void load_history_read_measured(const arguments *line, char decimal_sign, load_history *loads);
void load_history_read_list(const arguments *line, load_history *loads);

/* Reads a file of loads, and says what was passed over. False, with the complaint. */
bool load_history_read_file(const char *file, const reading *how, load_history *loads,
                            complaint *why);

/* Gives --compliance to loads that are driven; refuses it where none is. */
void load_history_give_compliance(const arguments *line, load_history *loads);

/* Refuses a moment where the pad is held. Holds the pad of loads that have tilts, at the first. */
void load_history_check(const load_history *loads, contact_case *setup);

/* Applies them all, in order, to the contact of a case; the first refusal ends the command. Where
 * doubts is not NULL those of the states are added. */
void load_history_apply_all(const load_history *loads, const contact_case *setup, doubts *all);

/* Ends the command as a load cannot be applied, after a word such as ", cycle 2", or "". */
NO_RETURN void load_history_fail(const load_history *loads, size_t row, const char *word,
                                 const complaint *why);

/* Reads a case and its loads, from a file or a list, applies them all to its contact, and names
 * columns with numbers that are not used. */
void history_case(const arguments *line, const input_texts *texts, case_needs needs,
                  char decimal_sign, contact_case *setup);

/* Where it stands, as messages say it: "loads.csv: line 3". */
enum { LOAD_PLACE_SIZE = 300 };
const char *load_history_place(const load_history *loads, size_t row, char place[LOAD_PLACE_SIZE]);

/* ---- case_file ---- A case in a file: bodies, pad, loads, what is asked. Names that are none end
 * the command. */

/* Gives the values of --case to options that are not given, before anything else is read. A command
 * name of NULL is of any case: the file may be its word, and of what another command was asked it
 * takes the options that it has. */
void case_file_take(const char *command_name, arguments *line);

/* ---- case_writing ---- The same file written. */

/* The number of an option that says what is asked of a command; 0 of other options. */
int case_option_asked(const arguments *line, const char *name);

/* Refuses what --save-case cannot write; to be called before the work. */
void case_file_check(const arguments *line);

/* Writes a case, whole or not at all; NULL is standard output. Of no command it is what was read:
 * slopes that were made of a profile, a material's constants in the working units. */
void case_file_write(const char *command_name, const arguments *line, const char *path);

/* Writes the file of --save-case, whole or not at all, once the command is done. */
void case_file_save(const char *command_name, const arguments *line);

/* ---- loaded_contact ---- A loaded contact to look into, dimensional or in natural units: what
 * "profile" and "field" have in common. */

enum {
    OPTION_A_OVER_B = OPTION_AFTER_LOADS,
    OPTION_Q_OVER_FP,
    OPTION_C_OVER_B,
    OPTION_AFTER_LOADED
};

/* The contact, its strength and its loads: a command's own table includes them. */
extern struct poptOption loaded_contact_option_table[];

typedef struct {
    double left, right; /* both are 0 where there is none */
} zone;

typedef struct {
    contact_case setup; /* in natural units its shape, friction, nu1 and contact alone */
    zone touches;       /* in the contact's own unit */
    /* half-width and edges of the contact, as they are written: 1, -1 and 1 in natural units; 0
     * when separated */
    double b, left, right;
    double length_unit; /* of what is written, in the contact's own unit; so is the next */
    double slip_unit;
} loaded_contact;

/* Reads the options and applies the loads; decimal_sign is that of a file of loads. */
void loaded_contact_read(const arguments *line, char decimal_sign, loaded_contact *loaded);

/* Prints what the help of both commands says about them. */
void loaded_contact_describe(FILE *stream);

#endif

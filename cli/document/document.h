/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_DOCUMENT_H
#define CLI_DOCUMENT_H

#include "number/number.h"
#include "text/text.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- document ---- A JSON file, or a text that is JSON, as a tree of values. */

typedef enum { NODE_NOTHING, NODE_FLAG, NODE_NUMBER, NODE_TEXT, NODE_LIST, NODE_OBJECT } node_kind;

typedef struct node {
    node_kind kind;
    const char *name; /* in its object; NULL in a list */
    const char *text; /* of a text */
    double number;    /* that of a flag is 1 or 0 */
    size_t count;     /* of the parts of a list or an object */
    const struct node *part;
} node;

/* Reads an object. What is wrong ends the command: it names the file, the line and the column.
 * Names are there once. The tree stays until the end. */
const node *document_read(const char *path);

/* The same of a text, which messages call by that name. */
const node *document_read_text(const char *text, const char *name);

/* A part of an object; NULL where it has none of that name. */
const node *node_part(const node *object, const char *name);

/* A node as JSON on one line. Free it. */
char *node_written(const node *value);

/* The number, with all digits, or the text of a node; NULL of other nodes. Free it. */
char *node_words(const node *value);

/* A text as JSON writes it, between quotes; NULL where memory is short, or it is no UTF-8. Free
 * it. */
char *document_quoted(const char *text);

#endif

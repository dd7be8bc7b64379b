/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The only file that knows Jansson. It keeps numbers as integers or doubles, and no places: what is
 * wrong with a value is said by its name. */
#include "document.h"

#include "system/system.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

/* ---- The tree ---- */

static char *copy_of(const char *text)
{
    char *copy = memory_zeroed(strlen(text) + 1, 1);
    return strcpy(copy, text);
}

static void fill(json_t *from, node *to);

static void fill_list(json_t *from, node *to)
{
    to->count = json_array_size(from);
    node *part = memory_zeroed(to->count + 1, sizeof *part);
    for (size_t i = 0; i < to->count; i++)
        fill(json_array_get(from, i), &part[i]);
    to->part = part;
}

static void fill_object(json_t *from, node *to)
{
    const char *name;
    json_t *value;
    node *part = memory_zeroed(json_object_size(from) + 1, sizeof *part);
    json_object_foreach(from, name, value)
    {
        part[to->count].name = copy_of(name);
        fill(value, &part[to->count++]);
    }
    to->part = part;
}

static void fill(json_t *from, node *to)
{
    static const node_kind kinds[] = {
        [JSON_OBJECT] = NODE_OBJECT,  [JSON_ARRAY] = NODE_LIST,  [JSON_STRING] = NODE_TEXT,
        [JSON_INTEGER] = NODE_NUMBER, [JSON_REAL] = NODE_NUMBER, [JSON_TRUE] = NODE_FLAG,
        [JSON_FALSE] = NODE_FLAG,     [JSON_NULL] = NODE_NOTHING};
    to->kind = kinds[json_typeof(from)];
    if (to->kind == NODE_OBJECT)
        fill_object(from, to);
    else if (to->kind == NODE_LIST)
        fill_list(from, to);
    else if (to->kind == NODE_TEXT)
        to->text = copy_of(json_string_value(from));
    else if (to->kind == NODE_NUMBER)
        to->number = json_number_value(from) + 0;
    else
        to->number = json_is_true(from) ? 1 : 0;
}

/* ---- Reading ---- */

static const node *tree_of(json_t *top, const json_error_t *error, const char *name)
{
    if (top == NULL)
        failure("%s: line %d, column %d: %s", name, error->line, error->column, error->text);
    if (!json_is_object(top))
        failure("%s: must be an object, { \"NAME\": VALUE, ... }", name);
    node *tree = memory_zeroed(1, sizeof *tree);
    fill(top, tree);
    json_decref(top);
    return tree;
}

/* The mark of Unicode, which some editors write first, is passed over. */
const node *document_read(const char *path)
{
    json_error_t error;
    FILE *file = file_to_read(path);
    if (file == NULL)
        failure("%s: %s", path, file_problem(errno));
    int first = fgetc(file);
    if (first == 0xEF && fgetc(file) != EOF && fgetc(file) != EOF)
        first = fgetc(file);
    ungetc(first, file);
    json_t *top = json_loadf(file, JSON_REJECT_DUPLICATES, &error);
    fclose(file);
    return tree_of(top, &error, path);
}

const node *document_read_text(const char *text, const char *name)
{
    json_error_t error;
    json_t *top = json_loads(text, JSON_REJECT_DUPLICATES, &error);
    return tree_of(top, &error, name);
}

/* ---- Values ---- */

const node *node_part(const node *object, const char *name)
{
    for (size_t i = 0; i < object->count; i++)
        if (object->part[i].name != NULL && strcmp(object->part[i].name, name) == 0)
            return &object->part[i];
    return NULL;
}

char *node_words(const node *value)
{
    char digits[NUMBER_SIZE];
    if (value->kind == NODE_TEXT)
        return copy_of(value->text);
    if (value->kind != NODE_NUMBER)
        return NULL;
    number_write(value->number, NUMBER_DIGITS, '.', digits);
    return copy_of(digits);
}

/* Adds to a text, which it frees. */
static char *joined(char *text, const char *more)
{
    text = memory_resized(text, strlen(text) + strlen(more) + 1);
    return strcat(text, more);
}

static char *join_parts(const node *value)
{
    const bool is_object = value->kind == NODE_OBJECT;
    char *text = copy_of(is_object ? "{" : "[");
    for (size_t i = 0; i < value->count; i++) {
        char *part = node_written(&value->part[i]);
        char *name = is_object ? memory_checked(document_quoted(value->part[i].name)) : copy_of("");
        text = joined(joined(text, i > 0 ? ", " : ""), name);
        text = joined(joined(text, is_object ? ": " : ""), part);
        free(name);
        free(part);
    }
    return joined(text, is_object ? "}" : "]");
}

char *node_written(const node *value)
{
    if (value->kind == NODE_LIST || value->kind == NODE_OBJECT)
        return join_parts(value);
    if (value->kind == NODE_TEXT)
        return memory_checked(document_quoted(value->text));
    if (value->kind == NODE_NUMBER)
        return node_words(value);
    return copy_of(value->kind == NODE_NOTHING ? "null" : value->number == 1 ? "true" : "false");
}

char *document_quoted(const char *text)
{
    errno = 0;
    json_t *string = json_string(text);
    char *quoted = string != NULL ? json_dumps(string, JSON_ENCODE_ANY) : NULL;
    json_decref(string);
    return quoted;
}

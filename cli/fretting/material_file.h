/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A file of a material's constants, by name. */
#ifndef CLI_MATERIAL_FILE_H
#define CLI_MATERIAL_FILE_H

#include "model/cycle/material.h"
#include "options/arguments.h"

/* Reads a file, JSON by its ending or CSV; nothing where the path is NULL. Its other constants
 * stand for options that are not given. What is wrong ends the command. */
void material_read(const char *path, arguments *line, material *all);

#endif

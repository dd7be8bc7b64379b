/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Interpolation in the table of yield, of each branch apart.
 *   - In f and nu: J2 is nearly linear in f^2 and in (1-2 nu)^2/3.
 *   - In a/b: it is smooth in t = ln(tan(phi0/2)), nearly a parabola for a small tip.
 * So a parabola through three nodes of each is taken. These nodes are the patch of a case, and v
 * are the values of its cells. */
#ifndef CLI_INTERPOLATION_H
#define CLI_INTERPOLATION_H

#include "cells.h"
#include "yield_table.h"

/* The values of a branch, or its places. */
typedef const double branch[][NUS][FRICTIONS];

/* Fills the cells of the patch: its nodes, and their weights. */
void patch_find(const yield_table *table, double v[CELL_COUNT]);

/* The value at a node of t and a node of f, counted from 0; at a node of t; at three nodes of t
 * with these weights; and at the case. Each sets missing where a value that it takes is 0. */
double patch_at_friction(branch values, int tip, int f, const double v[CELL_COUNT], bool *missing);
double patch_at_tip(branch values, int tip, const double v[CELL_COUNT], bool *missing);
double patch_at_tips(branch values, int first, const double weight[3], const double v[CELL_COUNT],
                     bool *missing);
double patch_at_case(branch values, const double v[CELL_COUNT], bool *missing);

/* The weights of the nodes 0, 1 and 2 at u. */
void parabola(double u, double weight[3]);

#endif

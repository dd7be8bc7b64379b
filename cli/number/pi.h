/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pi, which C99 does not name. */
#ifndef CLI_PI_H
#define CLI_PI_H

static const double PI = 3.14159265358979323846;

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* C99 has no name for it. */
#ifndef CLI_PI_H
#define CLI_PI_H

static const double PI = 3.14159265358979323846;

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CLI_PROCESSORS_H
#define CLI_PROCESSORS_H

/* How many threads the machine can run at a time, at least 1. */
long processors(void);

#endif

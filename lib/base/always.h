/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conditions that are argued to be always or never true. They are checked all the same: the branch
 * costs nothing, and a mistake in the argument then does no harm. The name tells the reader and the
 * tools that no test reaches the other side. The condition must have no side effects, because it is
 * not always evaluated:
 *     RW_COVERAGE  the coverage build counts no branch there
 *     RW_CHECKED   the build with sanitizers stops where the argument is wrong
 * The reason stands beside each use. */
#ifndef RW_ALWAYS_H
#define RW_ALWAYS_H

#if defined(RW_COVERAGE)
#define ALWAYS(x) 1
#define NEVER(x) 0
#elif defined(RW_CHECKED)
#include <assert.h>
#define ALWAYS(x) ((x) ? 1 : (assert(0), 0))
#define NEVER(x) ((x) ? (assert(0), 1) : 0)
#else
#define ALWAYS(x) (x)
#define NEVER(x) (x)
#endif

#endif

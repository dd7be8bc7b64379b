/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tuned constants of computed loads, by their register. In a build with RWEDGE_TUNING they are
 * variables, which tests/random/test_tuned.c halves and doubles. */
#ifndef RW_TUNED_H
#define RW_TUNED_H

#ifdef RWEDGE_TUNING
#define RW_NUMBER(name, value) extern double name;
#define RW_COUNT(name, value) extern int name;
#else
#define RW_NUMBER(name, value) static const double name = value;
#define RW_COUNT(name, value) enum { name = value };
#endif

#include "base/tuned_register.h"

#undef RW_NUMBER
#undef RW_COUNT

#endif

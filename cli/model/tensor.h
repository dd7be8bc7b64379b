/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The stress at a point of body 1, and what follows from it. */
#ifndef CLI_TENSOR_H
#define CLI_TENSOR_H

#include <stdint.h>

#include <rwedge.h>

enum {
    TENSOR_SXX,
    TENSOR_SYY,
    TENSOR_TXY,
    TENSOR_VON_MISES,
    TENSOR_S1,
    TENSOR_SZZ,
    TENSOR_S2,
    TENSOR_TAU_MAX,
    TENSOR_S1_ANGLE, /* in degrees */
    TENSOR_COUNT
};

/* Of the columns; the first three need no words. */
typedef struct {
    const char *column, *meaning;
} tensor_kind;
extern const tensor_kind tensor_kinds[TENSOR_COUNT];

typedef struct {
    double value[TENSOR_COUNT];
} tensor;

tensor tensor_of(double sxx, double syy, double txy, double nu);

/* The tensor where the stress is infinite: all NAN. */
tensor tensor_unknown(void);

/* An angle of the library, in degrees. */
double degrees(double angle);

#endif

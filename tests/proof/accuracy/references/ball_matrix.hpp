/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Matrices of balls. */
#ifndef BALL_MATRIX_HPP
#define BALL_MATRIX_HPP

#include "balls/ball.hpp"
#ifdef BALLS_IN_FLINT
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

class ball_matrix
{
    arb_mat_t v;

  public:
    ball_matrix(slong rows, slong columns) { arb_mat_init(v, rows, columns); }
    ~ball_matrix() { arb_mat_clear(v); }
    ball_matrix(const ball_matrix &) = delete;
    ball_matrix &operator=(const ball_matrix &) = delete;

    ball operator()(slong i, slong j) const
    {
        ball entry;
        arb_set(entry.arb(), arb_mat_entry(v, i, j));
        return entry;
    }
    void add(slong i, slong j, const ball &x)
    {
        arb_add(arb_mat_entry(v, i, j), arb_mat_entry(v, i, j), x.arb(), bits);
    }
    friend bool solve(ball_matrix &x, const ball_matrix &matrix, const ball_matrix &right)
    {
        return arb_mat_solve(x.v, matrix.v, right.v, bits) != 0;
    }
};

#endif

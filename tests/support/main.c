/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the claims of a program: all, or those whose names fit the pattern that is given. */
#include "claims.h"

int main(int argc, char **argv)
{
    if (argc > 1)
        cmocka_set_test_filter(argv[1]);
    return run_claims();
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A sharp wedge carries 2 theta b/A, Eq. (15), and yields at once. */
#include <rwedge.h>

int main(void)
{
    return rwedge_load(0) == 2 && rwedge_elastic_limit(0, 0.1, 0.3) == 0 ? 0 : 1;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <unistd.h>

long processors(void)
{
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 1 ? 1 : online;
}

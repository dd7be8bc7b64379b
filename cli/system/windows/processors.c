/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "system/system.h"

#include <windows.h>

long processors(void)
{
    const DWORD active = GetActiveProcessorCount(ALL_PROCESSOR_GROUPS);
    return active < 1 ? 1 : (long)active;
}

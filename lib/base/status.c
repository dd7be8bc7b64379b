/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The version, and what a status means. */
#include "rwedge.h"

const char *rwedge_version(void)
{
    return RWEDGE_VERSION;
}

const char *rwedge_strerror(int32_t status)
{
    switch (status) {
    case RWEDGE_OK:
        return "success";
    case RWEDGE_EDOMAIN:
        return "an argument is outside its domain";
    case RWEDGE_ENULL:
        return "a pointer is NULL";
    case RWEDGE_ERANGE:
        return "a size is out of range";
    case RWEDGE_ENOCONV:
        return "an iteration did not converge";
    case RWEDGE_ENOMEM:
        return "out of memory";
    case RWEDGE_ESLIDING:
        return "the tangential force exceeds friction times the normal force";
    case RWEDGE_ERANK:
        return "the samples do not determine that many coefficients";
    case RWEDGE_EABSENT:
        return "what was asked for does not exist for these arguments";
    case RWEDGE_EPATH:
        return "the loads lead where there is no closed form, see rwedge_contact_allow_error()";
    default:
        return "unknown status";
    }
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON. */
#ifndef CLI_JSON_H
#define CLI_JSON_H

#include "records.h"

extern const record_format json_format;

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rwedge workbook: the spreadsheet that computes. */
#ifndef CLI_WORKBOOK_H
#define CLI_WORKBOOK_H

#include "options/command.h"

extern const command workbook_command;

#endif

/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ROWS_HPP
#define ROWS_HPP
#include "probe.hpp"
#include "references/contact.hpp"
extern "C" {
#include "rows/rows.h"
}
#endif

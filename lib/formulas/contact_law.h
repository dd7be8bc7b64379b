/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RW_CONTACT_LAW_H
#define RW_CONTACT_LAW_H

/* asin(q) - q, 0 <= q <= 1, with a small relative error. */
double rw_asin_excess(double q);

#endif

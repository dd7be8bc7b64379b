/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells a compiler that knows the format of printf() to check it. */
#ifndef CLI_PRINTF_LIKE_H
#define CLI_PRINTF_LIKE_H

#ifdef __MINGW32__ /* C's formats, not those of Windows */
#define PRINTF_LIKE(text, first) __attribute__((format(gnu_printf, text, first)))
#elif defined(__GNUC__)
#define PRINTF_LIKE(text, first) __attribute__((format(printf, text, first)))
#else
#define PRINTF_LIKE(text, first)
#endif

#endif

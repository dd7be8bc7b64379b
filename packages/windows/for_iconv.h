/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Read before musl's iconv, and in place of its locale_impl.h: a wide character of 32 bits, and a
 * locale that is UTF-8. */
#ifndef FOR_ICONV_H
#define FOR_ICONV_H

#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

typedef void *locale_t;
static locale_t the_locale;

#define hidden
#define wchar_t uint32_t
#define mbstate_t uint32_t
#define mbrtowc iconv_mbrtowc
#define wcrtomb iconv_wcrtomb
#define wctomb(bytes, character) ((int)iconv_wcrtomb(bytes, character, 0))
#define CURRENT_LOCALE the_locale
#define UTF8_LOCALE 0
#undef MB_CUR_MAX
#define MB_CUR_MAX 4

size_t iconv_mbrtowc(wchar_t *wide, const char *bytes, size_t count, mbstate_t *state);
size_t iconv_wcrtomb(char *bytes, wchar_t wide, mbstate_t *state);

#endif

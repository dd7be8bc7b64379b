/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers as text. They are read as strtod() reads them; what is written reads back. */
#include "input.h"
#include "number/number.h"

static char *text_of(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    if (text == NULL)
        abort();
    if (size > 0)
        memcpy(text, data, size);
    text[size] = '\0';
    return text;
}

static void check_read(const char *text)
{
    double value = 12345;
    const size_t length = number_length(text);
    CLAIM(length <= strlen(text), "%zu", length);
    CLAIM(strspn(text, "+-.0123456789eE") >= length, "%s", text);
    const bool read = number_read(text, &value);
    if (!read)
        CLAIM(value == 12345, "%s", text);
    else
        CLAIM(length == strlen(text) && isfinite(value) && !(value == 0 && signbit(value)) &&
                  value == strtod(text, NULL),
              "%s", text);
    for (int comma = 0; comma < 2; comma++)
        if (number_read_cell(text, comma ? ',' : '.', &value))
            CLAIM(isfinite(value), "%s", text);
    int64_t whole = -7;
    if (number_read_whole(text, 1, 1000, &whole))
        CLAIM(whole >= 1 && whole <= 1000 && (double)whole == strtod(text, NULL), "%s", text);
    else
        CLAIM(whole == -7, "%s", text);
}

static void check_write(input *in)
{
    const double value = take_double(in);
    const int digits = 1 + take_byte(in) % NUMBER_DIGITS;
    if (!isfinite(value))
        return;
    char text[NUMBER_SIZE];
    double again;
    CLAIM(number_write(value, digits, '.', text) == strlen(text), "%.17g", value);
    /* such may be rounded to 2e308 */
    CLAIM(number_read(text, &again) || fabs(value) >= 9.5e307, "%s", text);
    CLAIM(number_write(value, NUMBER_DIGITS, ',', text) < NUMBER_SIZE && strchr(text, '.') == NULL,
          "%s", text);
    CLAIM(number_read_cell(text, ',', &again) && again == value, "%s", text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input in = {data, size};
    char *text = text_of(data, size);
    check_read(text);
    free(text);
    check_write(&in);
    return 0;
}

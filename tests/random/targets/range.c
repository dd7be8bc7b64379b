/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ranges as text. A range is refused, or it is monotonic, from START and not beyond STOP. */
#include "input.h"
#include "number/number.h"

static void check_order(const range *values, const char *text)
{
    const double first = range_value(values, 0), last = range_value(values, values->count - 1);
    const int64_t stride = values->count < 50 ? 1 : values->count / 49;
    double before = first;
    for (int64_t i = 0; i < values->count; i += stride) {
        const double v = range_value(values, i);
        CLAIM(isfinite(v), "%s: %g", text, v);
        CLAIM(first <= last ? v >= before : v <= before, "%s: %.17g after %.17g", text, v, before);
        before = v;
    }
    const char *stop = strchr(text, ':') + 1;
    CLAIM(first == strtod(text, NULL), "%s begins with %.17g", text, first);
    const double end = strtod(stop, NULL);
    CLAIM(first <= end ? last <= end : last >= end, "%s ends with %.17g", text, last);
}

static void check_list(const range *values, const char *text)
{
    for (int64_t i = 0; i < values->count; i++) {
        const char *comma = strchr(text, ',');
        CLAIM(range_value(values, i) == strtod(text, NULL), "%s", text);
        CLAIM((comma == NULL) == (i + 1 == values->count), "%s", text);
        text = comma != NULL ? comma + 1 : text;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    if (text == NULL)
        abort();
    if (size > 0)
        memcpy(text, data, size);
    text[size] = '\0';
    range values;
    const char *complaint = range_read(text, &values);
    if (complaint == NULL) {
        CLAIM(values.count >= 1 && values.count <= RANGE_VALUES_MAX, "%s: %lld", text,
              (long long)values.count);
        if (strchr(text, ':') != NULL)
            check_order(&values, text);
        else
            check_list(&values, text);
        double outside = 0;
        const bool inside = range_within(&values, 0, 1, &outside);
        CLAIM(inside || !(outside >= 0 && outside <= 1), "%s: %g", text, outside);
    } else {
        CLAIM(values.items == NULL && complaint[0] != '\0', "%s", text);
    }
    range_free(&values);
    free(text);
    return 0;
}

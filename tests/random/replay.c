/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a target without libFuzzer: on its seeds, and on changes of them from a fixed sequence.
 *
 *     replay_TARGET CHANGES TARGET.seeds */
#include "input.h"

enum { INPUT_MAX = 4096, LINE_MAX = 5 * INPUT_MAX }; /* a byte is \0ooo at most */

/* One byte as printf %b has it: itself, \\, \n, \r, or \0 and three octal digits. */
static uint8_t next_byte(const char **text)
{
    const char c = *(*text)++;
    if (c != '\\')
        return (uint8_t)c;
    switch (*(*text)++) {
    case '\\':
        return '\\';
    case 'n':
        return '\n';
    case 'r':
        return '\r';
    case '0': {
        const char digits[] = {(*text)[0], (*text)[1], (*text)[2], '\0'};
        if (strspn(digits, "01234567") == 3) {
            *text += 3;
            return (uint8_t)strtol(digits, NULL, 8);
        }
    }
    }
    fprintf(stderr, "not a byte of a seed: \\%s", *text - 1);
    exit(1);
}

/* The next seed: its name, a space, its bytes. False at the end of the file. */
static bool read_seed(FILE *file, uint8_t data[INPUT_MAX], size_t *size)
{
    static char line[LINE_MAX];
    do {
        if (fgets(line, sizeof line, file) == NULL)
            return false;
    } while (line[0] == '#');
    const char *text = strchr(line, ' '), *end = strchr(line, '\n');
    if (text == NULL || end == NULL) {
        fprintf(stderr, "not a seed: %s", line);
        exit(1);
    }
    memset(data, 0, INPUT_MAX);
    *size = 0;
    for (text++; text < end && *size < INPUT_MAX;)
        data[(*size)++] = next_byte(&text);
    return true;
}

/* Some bytes are others, and the end is elsewhere. */
static size_t change(uint8_t data[INPUT_MAX], size_t size, uint64_t *seed)
{
    const size_t room = size + 32 < INPUT_MAX ? size + 32 : INPUT_MAX;
    for (uint64_t i = next_random(seed) % 8 + 1; i > 0; i--)
        data[next_random(seed) % room] = (uint8_t)next_random(seed);
    return next_random(seed) % 4 == 0 ? next_random(seed) % room : size;
}

int main(int argc, char **argv)
{
    FILE *file = argc == 3 ? fopen(argv[2], "r") : NULL;
    if (file == NULL) {
        fprintf(stderr, "usage: %s CHANGES TARGET.seeds\n", argv[0]);
        return 2;
    }
    const long changes = strtol(argv[1], NULL, 10);
    static uint8_t data[INPUT_MAX], changed[INPUT_MAX];
    size_t size;
    uint64_t seed = 1;
    long seeds = 0;
    for (; read_seed(file, data, &size); seeds++) {
        LLVMFuzzerTestOneInput(data, size);
        for (long j = 0; j < changes; j++) {
            memcpy(changed, data, sizeof data);
            LLVMFuzzerTestOneInput(changed, change(changed, size, &seed));
        }
    }
    fclose(file);
    printf("%ld seeds, %ld runs\n", seeds, seeds * (1 + changes));
    return seeds == 0;
}

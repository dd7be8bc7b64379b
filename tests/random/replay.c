/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a target without libFuzzer: on its seeds, and on changes of them from a fixed sequence.
 *
 *     replay_TARGET CHANGES SEED... */
#include "input.h"

enum { INPUT_MAX = 4096 };

static size_t read_seed(const char *path, uint8_t data[INPUT_MAX])
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        perror(path);
        exit(1);
    }
    memset(data, 0, INPUT_MAX);
    const size_t size = fread(data, 1, INPUT_MAX, file);
    fclose(file);
    return size;
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
    if (argc < 3) {
        fprintf(stderr, "usage: %s CHANGES SEED...\n", argv[0]);
        return 2;
    }
    const long changes = strtol(argv[1], NULL, 10);
    static uint8_t data[INPUT_MAX], changed[INPUT_MAX];
    uint64_t seed = 1;
    for (int i = 2; i < argc; i++) {
        const size_t size = read_seed(argv[i], data);
        LLVMFuzzerTestOneInput(data, size);
        for (long j = 0; j < changes; j++) {
            memcpy(changed, data, sizeof data);
            LLVMFuzzerTestOneInput(changed, change(changed, size, &seed));
        }
    }
    printf("%d seeds, %ld runs\n", argc - 2, (argc - 2) * (1 + changes));
    return 0;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Without libFuzzer: the files of the corpus, and changes of them drawn from a fixed sequence.
 *
 *     replay_TARGET CHANGES FILE... */
#include "input.h"

enum { INPUT_MAX = 4096 };

static uint64_t next_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15)); /* splitmix64 */
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static size_t read_file(const char *path, uint8_t data[INPUT_MAX])
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        perror(path);
        exit(1);
    }
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
        fprintf(stderr, "usage: %s CHANGES FILE...\n", argv[0]);
        return 2;
    }
    const long changes = strtol(argv[1], NULL, 10);
    uint64_t seed = 1;
    long runs = 0;
    for (int i = 2; i < argc; i++) {
        static uint8_t data[INPUT_MAX], changed[INPUT_MAX];
        const size_t size = read_file(argv[i], data);
        LLVMFuzzerTestOneInput(data, size);
        for (long j = 0; j < changes; j++) {
            memcpy(changed, data, sizeof data);
            LLVMFuzzerTestOneInput(changed, change(changed, size, &seed));
        }
        runs += 1 + changes;
    }
    printf("%d files, %ld runs\n", argc - 2, runs);
    return 0;
}

/* replay CORPUS LAST: hands each file of CORPUS/TARGET, and some hundred damaged ones of each target, to the targets that
 * libFuzzer has, in a build without it. LAST holds the input while it is read, so that it is there when one ends the
 * process. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "fuzz.h"
#include "random.h"

/* FUZZ_TARGETS comes from the build: FUZZ_TARGET(budget) FUZZ_TARGET(config) and so on. */
#define FUZZ_TARGET(name) int fuzz_##name(const uint8_t *bytes, size_t size);
FUZZ_TARGETS
#undef FUZZ_TARGET
static const struct target {
    const char *name;
    int (*run)(const uint8_t *bytes, size_t size);
} targets[] = {
#define FUZZ_TARGET(name) {#name, fuzz_##name},
    FUZZ_TARGETS};
enum { VARIANTS = 300, LARGEST = 1 << 20 };

struct corpus {
    struct aob_piece *pieces;
    size_t count, capacity;
};

static int is_input(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

static void load(struct corpus *corpus, const char *folder)
{
    struct dirent **entries = NULL;
    int count = scandir(folder, &entries, is_input, alphasort);
    for (int i = 0; i < count; i++) {
        char *path = aob_path_join(folder, entries[i]->d_name);
        struct aob_piece *piece = AOB_PUSH(corpus->pieces, corpus->count, corpus->capacity);
        piece->bytes = aob_file_read(path, LARGEST, &piece->size, NULL);
        fuzz_require(piece->bytes != NULL, "a file of the corpus can be read");
        free(path);
        free(entries[i]);
    }
    free(entries);
    fuzz_require(count > 0, "a target has a corpus");
}

/* One change of the bytes, of which there are `size`; gives how many there are then. Never more. */
static size_t change(uint8_t *bytes, size_t size, const struct aob_piece *other, uint32_t *random)
{
    size_t at = random_below(random, size), from = random_below(random, other->size), count;
    switch (random_below(random, 6)) {
    case 0:
        bytes[at] ^= (uint8_t)(1 << random_below(random, 8));
        return size;
    case 1:
        bytes[at] = (uint8_t)random_below(random, 256);
        return size;
    case 2: /* a number's digit, or where another one begins */
        bytes[at] = (uint8_t) "0123456789-+.e#\n\""[random_below(random, 17)];
        return size;
    case 3:
        return at ? at : size;
    case 4: /* a part is taken out */
        count = random_below(random, size - at < 64 ? size - at : 64);
        memmove(bytes + at, bytes + at + count, size - at - count);
        return size - count;
    default: /* a part of another file lies over it */
        count = random_below(random, 64);
        count = count < size - at ? count : size - at;
        count = count < other->size - from ? count : other->size - from;
        memcpy(bytes + at, (const char *)other->bytes + from, count);
        return size;
    }
}

static void run(const struct target *target, const char *last, const void *bytes, size_t size)
{
    uint8_t *exact = memcpy(malloc(size), bytes, size); /* so that a byte beyond is noticed */
    FILE *file = fopen(last, "wb");
    fuzz_require(file && fwrite(bytes, 1, size, file) == size && fclose(file) == 0, "the input can be kept");
    target->run(exact, size);
    free(exact);
}

static void replay(const struct target *target, const struct corpus *corpus, const char *last)
{
    size_t before = fuzz_count_loaded();
    for (size_t i = 0; i < corpus->count; i++)
        run(target, last, corpus->pieces[i].bytes, corpus->pieces[i].size);
    fuzz_require(fuzz_count_loaded() > before, "a target has inputs that load");
}

static void replay_damaged(const struct target *target, const struct corpus *corpus, const char *last)
{
    uint32_t random = 1;
    for (int v = 0; v < VARIANTS; v++) {
        const struct aob_piece *piece = &corpus->pieces[random_below(&random, corpus->count)],
                               *other = &corpus->pieces[random_below(&random, corpus->count)];
        size_t size = piece->size, changes = 1 + random_below(&random, 4);
        uint8_t *copy = memcpy(aob_alloc(size + 1, 1), piece->bytes, size);
        for (size_t c = 0; c < changes && size && other->size; c++)
            size = change(copy, size, other, &random);
        run(target, last, copy, size);
        free(copy);
    }
}

int main(int argc, char **argv)
{
    if (argc != 3)
        return 2;
    for (size_t t = 0; t < AOB_COUNT(targets); t++) {
        struct corpus corpus = {0};
        char *folder = aob_path_join(argv[1], targets[t].name);
        printf("%s; each input lies in %s while it is read\n", targets[t].name, argv[2]);
        fflush(stdout);
        load(&corpus, folder);
        replay(&targets[t], &corpus, argv[2]);
        replay_damaged(&targets[t], &corpus, argv[2]);
        for (size_t i = 0; i < corpus.count; i++)
            free((void *)corpus.pieces[i].bytes);
        free(corpus.pieces);
        free(folder);
    }
    unlink(argv[2]);
    return 0;
}

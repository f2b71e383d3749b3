/* Profiles of devices. What stands behind a line "..." of the input is the file device.yaml beside it, which a profile
 * may be like. */
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"
#include "profile/profile.h"

static bool is_power(uint64_t value)
{
    return value && (value & (value - 1)) == 0;
}

static void check_level(const struct aob_profile_level *level)
{
    fuzz_require(*level->name && memchr(level->name, 0, sizeof level->name), "a level has a name");
    fuzz_require(is_power(level->line) && is_power(level->sector) && level->sector <= level->line,
                 "lines and sectors are powers of two");
    fuzz_require(level->sets && level->ways &&
                     (uint64_t)level->sets * level->ways * level->line == level->size,
                 "a level is its sets, ways and lines");
    fuzz_require(level->index != AOB_INDEX_XOR || is_power(level->sets), "xor has a power of two of sets");
    fuzz_require(level->units >= 0 && level->units <= 256, "the units of a level are within their bounds");
}

static void check_size(struct aob_size2 size, struct aob_size2 whole)
{
    fuzz_require(is_power((uint64_t)size.width) && is_power((uint64_t)size.height),
                 "sides are powers of two");
    fuzz_require(size.width <= whole.width && size.height <= whole.height, "a part is no larger than all");
}

static void check_profile(const struct aob_profile *profile)
{
    fuzz_require(profile->title && *profile->title, "a profile has a title");
    fuzz_require(profile->units >= 1 && profile->units <= 256, "units are within their bounds");
    fuzz_require(profile->in_flight >= 1 && profile->in_flight <= 128, "warps are within their bounds");
    check_size(profile->tile, (struct aob_size2){64, 64});
    check_size(profile->block, profile->tile);
    check_size(profile->warp, profile->block);
    fuzz_require(profile->layout < AOB_LAYOUT_COUNT, "the layout is one of those there are");
    fuzz_require(is_power((uint64_t)profile->block_height) && profile->block_height <= 16,
                 "a block is 16 high");
    fuzz_require(!profile->depth_bytes || is_power((uint64_t)profile->depth_bytes),
                 "bytes are a power of two");
    fuzz_require(!profile->normal_bytes || is_power((uint64_t)profile->normal_bytes),
                 "bytes are a power of two");
    fuzz_require(profile->level_count >= 1 && profile->level_count <= AOB_PROFILE_MAX_LEVEL,
                 "levels are 1 .. 4");
    for (int l = 0; l < profile->level_count; l++) {
        const struct aob_profile_level *level = &profile->levels[l];
        check_level(level);
        fuzz_require(l == 0 || level[-1].sector <= level->sector,
                     "a level brings what the one before asks for");
        for (int other = 0; other < l; other++)
            fuzz_require(strcmp(level->name, profile->levels[other].name) != 0,
                         "no two levels have one name");
        if (profile->rates.clock > 0)
            fuzz_require((l + 1 < profile->level_count) == (level->fill && level->ports),
                         "beside rates each level but the last says what fills it");
    }
}

static void check_facts(const struct aob_profile *profile)
{
    fuzz_require(profile->fact_count && profile->fact_count <= AOB_PROFILE_MAX_FACT, "there are some facts");
    for (size_t i = 0; i < profile->fact_count; i++) {
        const struct aob_profile_fact *fact = &profile->facts[i];
        fuzz_require(fact->key && fact->value && fact->source && *fact->key && *fact->value && *fact->source,
                     "a number has a name, a value and a source");
        for (size_t other = 0; other < i; other++)
            fuzz_require(strcmp(fact->key, profile->facts[other].key) != 0, "no number stands there twice");
    }
}

static const uint8_t *find_end(const uint8_t *bytes, size_t size)
{
    return memmem(bytes, size, "\n...\n", 5);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct aob_profile profile;
    struct aob_error error = {{0}};
    const uint8_t *end = find_end(bytes, size);
    size_t own = end ? (size_t)(end - bytes) + 1 : size, rest = end ? size - own - 4 : 0;
    char *path = fuzz_file("input", bytes, own),
         *device = fuzz_file("device.yaml", bytes + size - rest, rest);
    if (fuzz_answer(aob_profile_read(&profile, path, &error), &error, path)) {
        char digest[AOB_KEY_SIZE];
        check_profile(&profile);
        check_facts(&profile);
        aob_profile_digest(&profile, digest);
        fuzz_require(strspn(digest, "0123456789abcdef") == AOB_KEY_SIZE - 1, "a profile has a digest");
        aob_profile_finish(&profile);
    }
    free(path);
    free(device);
    return 0;
}

#include "profile_level.h"
#include "base/machine.h"

static bool is_power(uint64_t value)
{
    return value && (value & (value - 1)) == 0;
}

static bool judge_size(const struct aob_profile_level *level, enum aob_level_part *part,
                       struct aob_error *error)
{
    size_t memory = aob_machine_memory();
    *part = AOB_LEVEL_SIZE;
    return level->size <= memory ||
           aob_fail(error, "a cache of %.0f GiB is larger than this machine's memory, %.0f GiB",
                    (double)level->size / 0x1p30, (double)memory / 0x1p30);
}

/* Lines, sectors and ways that go together. */
static bool judge_lines(const struct aob_profile_level *level, enum aob_level_part *part,
                        struct aob_error *error)
{
    *part = AOB_LEVEL_LINE;
    if (!is_power(level->line))
        return aob_fail(error, "a line of %u bytes is no power of two", level->line);
    *part = AOB_LEVEL_SECTOR;
    if (!is_power(level->sector) || level->sector > level->line || level->line / level->sector > 32)
        return aob_fail(error, "a sector of %u bytes is no power of two between the line and a 32nd of it",
                        level->sector);
    *part = AOB_LEVEL_SIZE;
    if (level->size % level->line)
        return aob_fail(error, "%llu bytes are no whole number of lines of %u",
                        (unsigned long long)level->size, level->line);
    unsigned long long lines = level->size / level->line;
    *part = AOB_LEVEL_WAYS;
    if (lines % level->ways)
        return aob_fail(error, "%u ways do not divide the cache's %llu lines", level->ways, lines);
    *part = AOB_LEVEL_SIZE;
    return lines <= INT32_MAX ||
           aob_fail(error, "a cache of %llu lines: there are %d at most", lines, INT32_MAX);
}

/* A miss asks the next level for whole numbers of what that one brings. */
static bool judge_order(const struct aob_profile *profile, enum aob_level_part *part, struct aob_error *error)
{
    const struct aob_profile_level *level = &profile->levels[profile->level_count - 1];
    *part = AOB_LEVEL_SECTOR;
    return profile->level_count == 1 || level[-1].sector <= level->sector ||
           aob_fail(error, "it brings %u bytes at a time, less than the %u of the level before",
                    level->sector, level[-1].sector);
}

bool aob_profile_judge_level(struct aob_profile *profile, enum aob_level_part *part, struct aob_error *error)
{
    struct aob_profile_level *level = &profile->levels[profile->level_count - 1];
    if (!level->sector)
        level->sector = level->line;
    if (!judge_size(level, part, error) || !judge_lines(level, part, error))
        return false;
    level->sets = (uint32_t)(level->size / level->line / level->ways);
    *part = AOB_LEVEL_INDEX;
    if (level->index == AOB_INDEX_XOR && !is_power(level->sets))
        return aob_fail(error, "xor needs a power of two of sets, and these are %u", level->sets);
    return judge_order(profile, part, error);
}

#include "profile_machine.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/text.h"
#include "profile_level.h"

enum { MAX_CACHE = 16, MAX_TEXT = 4096 };

/* One line of a file of the kernel's; false if it is not there. */
static bool read_line(const char *folder, int cache, const char *name, char *line, size_t size)
{
    struct aob_text path = {0};
    aob_text_add(&path, "%s/index%d/%s", folder, cache, name);
    char *text = aob_file_read(path.data, MAX_TEXT, NULL, NULL);
    aob_text_finish(&path);
    if (text)
        snprintf(line, size, "%.*s", (int)strcspn(text, "\n"), text);
    bool ok = text != NULL;
    free(text);
    return ok;
}

static bool read_whole(const char *folder, int cache, const char *name, uint64_t low, uint64_t high,
                       uint64_t *value)
{
    char line[64], *rest;
    if (!read_line(folder, cache, name, line, sizeof line))
        return false;
    *value = strtoull(line, &rest, 10);
    *value *= *rest == 'K' ? 1024 : *rest == 'M' ? 1024 * 1024 : 1;
    return rest != line && *value >= low && *value <= high;
}

/* "0-3,8" names five. */
static int count_processors(const char *list)
{
    int count = 0;
    for (const char *at = list; *at;) {
        char *rest;
        long first = strtol(at, &rest, 10), last = first;
        if (rest == at)
            return count;
        if (*rest == '-')
            last = strtol(rest + 1, &rest, 10);
        count += last >= first && last - first < 65536 ? (int)(last - first) + 1 : 1;
        at = *rest == ',' ? rest + 1 : rest;
    }
    return count;
}

static void note(struct aob_profile *profile, const char *folder, int cache, const char *what, uint64_t value)
{
    const struct aob_profile_level *level = &profile->levels[profile->level_count - 1];
    char key[64], text[32], source[256];
    snprintf(key, sizeof key, "levels.%s.%s", level->name, what);
    snprintf(text, sizeof text, "%llu", (unsigned long long)value);
    snprintf(source, sizeof source, "%s/index%d", folder, cache);
    aob_profile_note(profile, key, text, source, true);
}

/* What no kernel tells. */
static void note_choice(struct aob_profile *profile, const char *what, const char *value, const char *source)
{
    char key[64];
    snprintf(key, sizeof key, "levels.%s.%s", profile->levels[profile->level_count - 1].name, what);
    aob_profile_note(profile, key, value, source, false);
}

static void note_level(struct aob_profile *profile, const char *folder, int cache)
{
    const struct aob_profile_level *level = &profile->levels[profile->level_count - 1];
    note(profile, folder, cache, "size", level->size);
    note(profile, folder, cache, "line", level->line);
    note(profile, folder, cache, "ways", level->ways);
    note(profile, folder, cache, "units", (uint64_t)level->units);
    note_choice(profile, "index", aob_index_name(level->index), "default: the kernel does not tell it");
    if (profile->level_count > 1)
        note_choice(profile, "cold", "frame", "default: no pass empties it");
}

/* Appends a level of what the folder says, before it is judged. False: the folder does not tell. */
static bool append_level(struct aob_profile *profile, const char *folder, int cache, int first)
{
    char sharing[256] = "";
    uint64_t number, size, line, ways;
    if (!read_whole(folder, cache, "level", 1, 9, &number) ||
        !read_whole(folder, cache, "size", 1, (uint64_t)1 << 36, &size) ||
        !read_whole(folder, cache, "coherency_line_size", 16, 4096, &line) ||
        !read_whole(folder, cache, "ways_of_associativity", 1, 65536, &ways))
        return false;
    read_line(folder, cache, "shared_cpu_list", sharing, sizeof sharing);
    struct aob_profile_level *level = &profile->levels[profile->level_count++];
    int share = count_processors(sharing);
    *level = (struct aob_profile_level){.size = size,
                                        .line = (uint32_t)line,
                                        .ways = (uint32_t)ways,
                                        .units = share > first ? share / first : 1,
                                        .cold_at_pass = profile->level_count == 1};
    snprintf(level->name, sizeof level->name, "L%llu", (unsigned long long)number);
    return true;
}

/* Adds the cache as a level if it is one of data. */
static bool add_cache(struct aob_profile *profile, const char *folder, int cache, int first,
                      struct aob_error *error)
{
    static const char advice[] = "write a profile with levels of your own";
    struct aob_error why = {{0}};
    enum aob_level_part part;
    char type[32];
    if (!read_line(folder, cache, "type", type, sizeof type) || strcmp(type, "Instruction") == 0 ||
        profile->level_count == AOB_PROFILE_MAX_LEVEL)
        return true;
    if (!append_level(profile, folder, cache, first))
        return aob_fail(error, "%s/index%d does not tell the cache's level, size, line and ways: %s", folder,
                        cache, advice);
    if (!aob_profile_judge_level(profile, &part, &why))
        return aob_fail(error, "%s/index%d: %s: %s", folder, cache, why.text, advice);
    note_level(profile, folder, cache);
    return true;
}

/* How many processors share their first cache of data, as two threads of a core do; 1 where it is not told. */
static int first_share(const char *folder)
{
    char type[32], sharing[256] = "";
    for (int cache = 0; cache < MAX_CACHE; cache++)
        if (read_line(folder, cache, "type", type, sizeof type) && strcmp(type, "Instruction") != 0) {
            read_line(folder, cache, "shared_cpu_list", sharing, sizeof sharing);
            break;
        }
    int share = count_processors(sharing);
    return share > 0 ? share : 1;
}

int aob_profile_machine_units(const char *folder, int processors)
{
    int share = first_share(folder);
    return (processors + share - 1) / share;
}

bool aob_profile_machine(struct aob_profile *profile, const char *folder, struct aob_error *error)
{
    int first = first_share(folder);
    for (int cache = 0; cache < MAX_CACHE; cache++)
        if (!add_cache(profile, folder, cache, first, error))
            return false;
    return profile->level_count > 0 ||
           aob_fail(error, "%s names no data cache: write a profile with levels of your own", folder);
}

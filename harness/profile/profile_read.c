#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "profile_fact.h"
#include "profile_level.h"
#include "profile_machine.h"
#include "profile_rates.h"

enum { MAX_FILE = 1 << 20 };
enum { UNITS, IN_FLIGHT, TILE, BLOCK, WARP, LAYOUT, BLOCK_HEIGHT, DEPTH_BYTES, NORMAL_BYTES };
enum { SHARED = AOB_LEVEL_PART_COUNT, COLD, FILL, PORTS }; /* behind the parts of a level */

#define OF(type, name) offsetof(struct type, name)
static const struct aob_field profile_fields[] = {
    [UNITS] = {"units", AOB_FIELD_CORES, 1, 256, OF(aob_profile, units), true},
    [IN_FLIGHT] = {"in_flight", AOB_FIELD_WHOLE, 1, 128, OF(aob_profile, in_flight), true},
    [TILE] = {"tile", AOB_FIELD_SIZE2, 2, 64, OF(aob_profile, tile), true},
    [BLOCK] = {"block", AOB_FIELD_SIZE2, 2, 64, OF(aob_profile, block), false},
    [WARP] = {"warp", AOB_FIELD_SIZE2, 2, 64, OF(aob_profile, warp), true},
    [LAYOUT] = {"layout", AOB_FIELD_LAYOUT, 0, 0, OF(aob_profile, layout), true},
    [BLOCK_HEIGHT] = {"block_height", AOB_FIELD_WHOLE, 1, 16, OF(aob_profile, block_height), false},
    [DEPTH_BYTES] = {"depth_bytes", AOB_FIELD_WHOLE, 1, 16, OF(aob_profile, depth_bytes), false},
    [NORMAL_BYTES] = {"normal_bytes", AOB_FIELD_WHOLE, 1, 16, OF(aob_profile, normal_bytes), false},
    {0},
};
static const struct aob_field level_fields[] = {
    [AOB_LEVEL_SIZE] = {"size", AOB_FIELD_BYTES, 64, 0x1p50, OF(aob_profile_level, size), true},
    [AOB_LEVEL_LINE] = {"line", AOB_FIELD_WHOLE, 16, 4096, OF(aob_profile_level, line), true},
    [AOB_LEVEL_SECTOR] = {"sector", AOB_FIELD_WHOLE, 16, 4096, OF(aob_profile_level, sector), false},
    [AOB_LEVEL_WAYS] = {"ways", AOB_FIELD_WHOLE, 1, 0x1p31, OF(aob_profile_level, ways), true},
    [AOB_LEVEL_INDEX] = {"index", AOB_FIELD_INDEX, 0, 0, OF(aob_profile_level, index), true},
    [SHARED] = {"units", AOB_FIELD_UNITS, 1, 256, OF(aob_profile_level, units), false},
    [COLD] = {"cold", AOB_FIELD_COLD, 0, 0, OF(aob_profile_level, cold_at_pass), false},
    [FILL] = {"fill", AOB_FIELD_WHOLE, 1, 65536, OF(aob_profile_level, fill), false},
    [PORTS] = {"ports", AOB_FIELD_WHOLE, 1, 65536, OF(aob_profile_level, ports), false},
    {0},
};

static bool is_power(uint64_t value)
{
    return value && (value & (value - 1)) == 0;
}

/* What is wrong is shown where it is written: a sector that was left out is the line. */
static bool judge_level(struct aob_yaml *yaml, const struct aob_field_reader *reader)
{
    struct aob_error error = {{0}};
    enum aob_level_part part;
    if (aob_profile_judge_level(reader->profile, &part, &error))
        return true;
    return aob_yaml_fail(yaml, reader->nodes[reader->nodes[part] ? part : AOB_LEVEL_LINE], "%s", error.text);
}

/* What a file leaves out is a choice of ours all the same. */
static void note_level_defaults(const struct aob_field_reader *reader)
{
    const struct aob_profile_level *level = reader->target;
    char line[16];
    snprintf(line, sizeof line, "%u", level->line);
    aob_field_default(reader, AOB_LEVEL_SECTOR, line, "default: a miss brings the whole line");
    if (level == reader->profile->levels)
        return;
    aob_field_default(reader, SHARED, "all", "default: all units share it");
    aob_field_default(reader, COLD, "frame", "default: no pass empties it");
}

static bool read_level_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user)
{
    return strcmp(key, "name") == 0 || aob_field_read(yaml, key, value, user);
}

static bool read_level_name(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_profile *profile)
{
    struct aob_profile_level *level = &profile->levels[profile->level_count - 1];
    const char *name;
    const yaml_node_t *value = aob_yaml_find(yaml, node, "name");
    if (!value)
        return aob_yaml_fail(yaml, node, "a level is a mapping with a 'name', such as L1");
    if (!aob_yaml_text(yaml, value, &name))
        return false;
    if (strlen(name) >= sizeof level->name)
        return aob_yaml_fail(yaml, value, "'%s' has more than %zu letters", name, sizeof level->name - 1);
    for (const struct aob_profile_level *other = profile->levels; other < level; other++)
        if (strcmp(other->name, name) == 0)
            return aob_yaml_fail(yaml, value, "there is a level '%s' already", name);
    snprintf(level->name, sizeof level->name, "%s", name);
    return true;
}

static bool read_level(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    static const char *const first[] = {"name",  "size", "line",  "sector", "ways",
                                        "index", "fill", "ports", NULL};
    static const char *const later[] = {"name",  "size", "line", "sector", "ways", "index",
                                        "units", "cold", "fill", "ports",  NULL};
    struct aob_profile *profile = user;
    char prefix[32];
    bool is_first = profile->level_count == 0;
    if (profile->level_count == AOB_PROFILE_MAX_LEVEL)
        return aob_yaml_fail(yaml, node, "more than %d levels", AOB_PROFILE_MAX_LEVEL);
    struct aob_profile_level *level = &profile->levels[profile->level_count++];
    if (!read_level_name(yaml, node, profile))
        return false;
    snprintf(prefix, sizeof prefix, "levels.%s.", level->name);
    level->cold_at_pass = is_first;
    level->units = is_first;
    struct aob_field_reader reader = {profile, prefix, level_fields, level, {NULL}};
    if (!aob_yaml_mapping(yaml, node, is_first ? first : later, read_level_entry, &reader) ||
        !aob_field_need(yaml, node, &reader) || !judge_level(yaml, &reader))
        return false;
    note_level_defaults(&reader);
    return true;
}

static bool accept(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user)
{
    const char *text;
    (void)key;
    (void)user;
    return aob_yaml_text(yaml, value, &text);
}

/* Levels that the machine tells have a source too, as every number has. */
static bool judge_machine(struct aob_yaml *yaml, const yaml_node_t *node)
{
    static const char *const keys[] = {"value", "confirmed", "unverified", NULL};
    bool confirmed = aob_yaml_find(yaml, node, "confirmed"),
         unverified = aob_yaml_find(yaml, node, "unverified");
    return aob_yaml_mapping(yaml, node, keys, accept, NULL) &&
           (confirmed != unverified ||
            aob_yaml_fail(yaml, node, "write one source beside machine, as confirmed or as unverified"));
}

/* A list, or {value: machine, ...}: the caches of the processor that this program runs on. */
static bool read_levels(struct aob_yaml *yaml, yaml_node_t *node, struct aob_profile *profile)
{
    struct aob_error error = {{0}};
    const char *text;
    const yaml_node_t *value = aob_yaml_find(yaml, node, "value");
    if (!value)
        return aob_yaml_sequence(yaml, node, read_level, profile) &&
               (profile->level_count || aob_yaml_fail(yaml, node, "a profile has one level at least"));
    if (!aob_yaml_text(yaml, value, &text) || !judge_machine(yaml, node))
        return false;
    if (strcmp(text, "machine") != 0)
        return aob_yaml_fail(yaml, value, "'%s' is not machine: write it so, or a list of levels", text);
    return aob_profile_machine(profile, AOB_PROFILE_SYSFS, &error) ||
           aob_yaml_fail(yaml, value, "%s", error.text);
}

static bool read_profile_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user)
{
    struct aob_field_reader *reader = user;
    const char *title;
    if (strcmp(key, "levels") == 0)
        return read_levels(yaml, value, reader->profile);
    if (strcmp(key, "rates") == 0)
        return aob_profile_rates_read(yaml, value, reader->profile);
    if (strcmp(key, "title") != 0)
        return aob_field_read(yaml, key, value, user);
    if (!aob_yaml_text(yaml, value, &title))
        return false;
    reader->profile->title = aob_strdup(title);
    return true;
}

static bool divides(struct aob_size2 part, struct aob_size2 whole)
{
    return part.width <= whole.width && part.height <= whole.height; /* all are powers of two */
}

static bool judge_bytes(struct aob_yaml *yaml, const yaml_node_t *node, int bytes)
{
    return !bytes || is_power((uint64_t)bytes) ||
           aob_yaml_fail(yaml, node, "%d bytes a texel are no power of two", bytes);
}

static void note_profile_defaults(const struct aob_field_reader *reader)
{
    const struct aob_profile *profile = reader->target;
    char block[32];
    snprintf(block, sizeof block, "%dx%d", profile->block.width, profile->block.height);
    aob_field_default(reader, BLOCK, block, "default: a tile is one block");
    if (profile->layout == AOB_LAYOUT_BLOCK_LINEAR)
        aob_field_default(reader, BLOCK_HEIGHT, "16", "default: the highest block that the layout has");
}

static bool judge_profile(struct aob_yaml *yaml, const struct aob_field_reader *reader)
{
    struct aob_profile *profile = reader->target;
    if (!reader->nodes[BLOCK])
        profile->block = profile->tile;
    if (!divides(profile->block, profile->tile))
        return aob_yaml_fail(yaml, reader->nodes[BLOCK], "a block is no larger than a tile");
    if (!divides(profile->warp, profile->block))
        return aob_yaml_fail(yaml, reader->nodes[WARP],
                             "a warp is no larger than a tile, and than a block where there is one");
    if (!profile->block_height)
        profile->block_height = 16;
    if (!is_power((uint64_t)profile->block_height))
        return aob_yaml_fail(yaml, reader->nodes[BLOCK_HEIGHT], "a block of %d GOBs is no power of two",
                             profile->block_height);
    return judge_bytes(yaml, reader->nodes[DEPTH_BYTES], profile->depth_bytes) &&
           judge_bytes(yaml, reader->nodes[NORMAL_BYTES], profile->normal_bytes);
}

static bool read_root(struct aob_yaml *yaml, struct aob_profile *profile)
{
    static const char *const keys[] = {
        "title",        "units",       "in_flight",    "tile",   "block", "warp", "layout",
        "block_height", "depth_bytes", "normal_bytes", "levels", "rates", NULL};
    const yaml_node_t *root = yaml_document_get_root_node(&yaml->document);
    struct aob_field_reader reader = {profile, "", profile_fields, profile, {NULL}};
    if (!aob_yaml_mapping(yaml, root, keys, read_profile_entry, &reader) ||
        !aob_field_need(yaml, root, &reader))
        return false;
    if (!profile->title || !profile->level_count)
        return aob_yaml_fail(yaml, root, "'%s' is missing", profile->title ? "levels" : "title");
    if (!judge_profile(yaml, &reader) || !aob_profile_rates_judge(yaml, root, profile))
        return false;
    note_profile_defaults(&reader);
    return true;
}

/* The file's name without folder and ending. */
static char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    char *name = aob_strdup(slash ? slash + 1 : path), *dot = strrchr(name, '.');
    if (dot && dot != name)
        *dot = '\0';
    return name;
}

bool aob_profile_read(struct aob_profile *profile, const char *path, struct aob_error *error)
{
    struct aob_yaml yaml;
    size_t size;
    *profile = (struct aob_profile){0};
    char *text = aob_file_read(path, MAX_FILE, &size, error);
    if (!text)
        return false;
    bool ok = aob_yaml_load(&yaml, path, text, size, error);
    if (ok) {
        profile->path = aob_strdup(path);
        profile->name = name_of(path);
        ok = read_root(&yaml, profile);
        aob_yaml_finish(&yaml);
    }
    free(text);
    if (!ok)
        aob_profile_finish(profile);
    return ok;
}

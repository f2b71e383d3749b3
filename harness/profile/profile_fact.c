#include "profile_fact.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/machine.h"
#include "base/memory.h"
#include "base/text.h"
#include "profile_machine.h"

/* A number, or a word in place of one, with how it is known. */
struct fact {
    const yaml_node_t *value; /* NULL: not in the file */
    const char *text, *source;
    bool confirmed, unverified;
};

void aob_profile_note(struct aob_profile *profile, const char *key, const char *value, const char *source,
                      bool confirmed)
{
    if (profile->fact_count == AOB_PROFILE_MAX_FACT)
        return;
    profile->facts[profile->fact_count++] =
        (struct aob_profile_fact){aob_strdup(key), aob_strdup(value), aob_strdup(source), confirmed};
}

static bool read_fact_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user)
{
    struct fact *fact = user;
    if (strcmp(key, "value") == 0) {
        fact->value = value;
        return aob_yaml_text(yaml, value, &fact->text);
    }
    fact->confirmed |= strcmp(key, "confirmed") == 0;
    fact->unverified |= strcmp(key, "unverified") == 0;
    return aob_yaml_text(yaml, value, &fact->source);
}

static bool read_fact(struct aob_yaml *yaml, const yaml_node_t *node, struct fact *fact)
{
    static const char *const keys[] = {"value", "confirmed", "unverified", NULL};
    *fact = (struct fact){0};
    if (node->type != YAML_MAPPING_NODE)
        return aob_yaml_fail(
            yaml, node,
            "a number has a source here: {value: ..., confirmed: where} or {value: ..., unverified: why}");
    if (!aob_yaml_mapping(yaml, node, keys, read_fact_entry, fact))
        return false;
    if (!fact->value)
        return aob_yaml_fail(yaml, node, "'value' is missing");
    return fact->confirmed != fact->unverified ||
           aob_yaml_fail(yaml, node, "say where the value is from, in one of 'confirmed' and 'unverified'");
}

static bool read_number(struct aob_yaml *yaml, const struct fact *fact, const struct aob_field *field,
                        double *number)
{
    if (!aob_yaml_number(yaml, fact->value, field->low, field->high, number))
        return false;
    return *number == floor(*number) || aob_yaml_fail(yaml, fact->value, "%s is no whole number", fact->text);
}

/* "16 KiB" or "16384". */
static bool read_bytes(struct aob_yaml *yaml, const struct fact *fact, const struct aob_field *field,
                       uint64_t *bytes)
{
    static const struct {
        const char *name;
        double scale;
    } units[] = {{" KiB", 0x1p10}, {" MiB", 0x1p20}, {" GiB", 0x1p30}, {" TiB", 0x1p40}, {"", 1}};
    char text[64];
    double number;
    snprintf(text, sizeof text, "%s", fact->text);
    for (size_t u = 0; u < AOB_COUNT(units); u++) {
        size_t size = strlen(text), end = strlen(units[u].name);
        if (size < end || strcmp(text + size - end, units[u].name) != 0)
            continue;
        text[size - end] = '\0';
        if (!aob_parse_double(text, &number))
            break;
        number *= units[u].scale;
        if (!(number >= field->low && number <= field->high) || number != floor(number))
            return aob_yaml_fail(yaml, fact->value, "%s is not a whole number of bytes within %g B .. %g TiB",
                                 fact->text, field->low, field->high / 0x1p40);
        *bytes = (uint64_t)number;
        return true;
    }
    return aob_yaml_fail(yaml, fact->value, "'%s' is no size: write bytes, or 16 KiB, 4 MiB", fact->text);
}

static bool read_size2(struct aob_yaml *yaml, const struct fact *fact, const struct aob_field *field,
                       struct aob_size2 *size)
{
    if (!aob_parse_size(fact->text, &size->width, &size->height))
        return aob_yaml_fail(yaml, fact->value, "'%s' is no size in pixels, such as 8x4", fact->text);
    bool powers = !(size->width & (size->width - 1)) && !(size->height & (size->height - 1));
    return (powers && size->width >= field->low && size->width <= field->high && size->height >= field->low &&
            size->height <= field->high) ||
           aob_yaml_fail(yaml, fact->value, "%s: each side is a power of two within %g .. %g", fact->text,
                         field->low, field->high);
}

static bool read_layout(struct aob_yaml *yaml, const struct fact *fact, enum aob_layout *layout)
{
    for (int i = 0; i < AOB_LAYOUT_COUNT; i++)
        if (strcmp(fact->text, aob_layout_name((enum aob_layout)i)) == 0) {
            *layout = (enum aob_layout)i;
            return true;
        }
    return aob_yaml_fail(yaml, fact->value, "'%s' is not one of linear, morton, block_linear", fact->text);
}

/* A whole number, or "all": 0. */
static bool read_units(struct aob_yaml *yaml, const struct fact *fact, const struct aob_field *field,
                       int *units)
{
    double number = 0;
    if (strcmp(fact->text, "all") != 0 && !read_number(yaml, fact, field, &number))
        return false;
    *units = (int)number;
    return true;
}

static bool read_cold(struct aob_yaml *yaml, const struct fact *fact, bool *at_pass)
{
    *at_pass = strcmp(fact->text, "pass") == 0;
    return *at_pass || strcmp(fact->text, "frame") == 0 ||
           aob_yaml_fail(yaml, fact->value, "'%s' is neither pass nor frame", fact->text);
}

/* A whole number, or "machine": the first caches of data of the processors that this process may use. */
static bool read_cores(struct aob_yaml *yaml, const struct fact *fact, const struct aob_field *field,
                       int *units)
{
    double number = aob_profile_machine_units(AOB_PROFILE_SYSFS, aob_machine_cores());
    if (strcmp(fact->text, "machine") != 0 && !read_number(yaml, fact, field, &number))
        return false;
    *units = (int)number;
    return true;
}

static bool read_value(struct aob_yaml *yaml, const struct fact *fact, const struct aob_field *field,
                       void *at)
{
    double number;
    switch (field->kind) {
    case AOB_FIELD_WHOLE:
        if (!read_number(yaml, fact, field, &number))
            return false;
        *(uint32_t *)at = (uint32_t)number; /* int fields are within its lower half */
        return true;
    case AOB_FIELD_BYTES:
        return read_bytes(yaml, fact, field, at);
    case AOB_FIELD_SIZE2:
        return read_size2(yaml, fact, field, at);
    case AOB_FIELD_LAYOUT:
        return read_layout(yaml, fact, at);
    case AOB_FIELD_INDEX:
        return aob_index_find(fact->text, at) ||
               aob_yaml_fail(yaml, fact->value, "'%s' is neither modulo nor xor", fact->text);
    case AOB_FIELD_CORES:
        return read_cores(yaml, fact, field, at);
    case AOB_FIELD_UNITS:
        return read_units(yaml, fact, field, at);
    case AOB_FIELD_REAL:
        return aob_yaml_number(yaml, fact->value, field->low, field->high, at);
    case AOB_FIELD_BOOL:
        return aob_yaml_bool(yaml, fact->value, at);
    default:
        return read_cold(yaml, fact, at);
    }
}

static const struct aob_field *find_field(const struct aob_field_reader *reader, const char *key)
{
    const struct aob_field *field = reader->fields;
    while (field->key && strcmp(field->key, key) != 0)
        field++;
    return field->key ? field : NULL;
}

static void note(const struct aob_field_reader *reader, const struct aob_field *field,
                 const struct fact *fact)
{
    char key[64], value[64];
    snprintf(key, sizeof key, "%s%s", reader->prefix, field->key);
    snprintf(value, sizeof value, "%s", fact->text);
    if (field->kind == AOB_FIELD_CORES)
        snprintf(value, sizeof value, "%d", *(int *)(void *)((char *)reader->target + field->offset));
    aob_profile_note(reader->profile, key, value, fact->source, fact->confirmed);
}

bool aob_field_read(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user)
{
    struct aob_field_reader *reader = user;
    const struct aob_field *field = find_field(reader, key);
    struct fact fact;
    if (!read_fact(yaml, value, &fact) ||
        !read_value(yaml, &fact, field, (char *)reader->target + field->offset))
        return false;
    reader->nodes[field - reader->fields] = fact.value;
    note(reader, field, &fact);
    return true;
}

void aob_field_default(const struct aob_field_reader *reader, size_t field, const char *value,
                       const char *source)
{
    char key[64];
    if (reader->nodes[field])
        return;
    snprintf(key, sizeof key, "%s%s", reader->prefix, reader->fields[field].key);
    aob_profile_note(reader->profile, key, value, source, false);
}

bool aob_field_need(struct aob_yaml *yaml, const yaml_node_t *node, const struct aob_field_reader *reader)
{
    for (const struct aob_field *field = reader->fields; field->key; field++)
        if (field->needed && !reader->nodes[field - reader->fields])
            return aob_yaml_fail(yaml, node, "'%s' is missing", field->key);
    return true;
}

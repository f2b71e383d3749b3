#include "yaml.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"

bool aob_yaml_load(struct aob_yaml *yaml, const char *path, const char *text, size_t size,
                   struct aob_error *error)
{
    yaml_parser_t parser;
    *yaml = (struct aob_yaml){.path = path, .error = error};
    if (!yaml_parser_initialize(&parser))
        return aob_fail(error, "%s: out of memory", path);
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, size);
    bool ok = yaml_parser_load(&parser, &yaml->document);
    if (!ok)
        aob_fail(error, "%s:%zu:%zu: not YAML: %s", path, parser.problem_mark.line + 1,
                 parser.problem_mark.column + 1, parser.problem ? parser.problem : "unreadable");
    else if (!yaml_document_get_root_node(&yaml->document)) {
        yaml_document_delete(&yaml->document);
        ok = aob_fail(error, "%s: the file is empty", path);
    }
    yaml_parser_delete(&parser);
    return ok;
}

void aob_yaml_finish(struct aob_yaml *yaml)
{
    yaml_document_delete(&yaml->document);
}

bool aob_yaml_fail(const struct aob_yaml *yaml, const yaml_node_t *node, const char *format, ...)
{
    char text[512];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return aob_fail(yaml->error, "%s:%zu:%zu: %s", yaml->path, node->start_mark.line + 1,
                    node->start_mark.column + 1, text);
}

yaml_node_t *aob_yaml_node(struct aob_yaml *yaml, int id)
{
    return yaml_document_get_node(&yaml->document, id);
}

bool aob_yaml_text(struct aob_yaml *yaml, const yaml_node_t *node, const char **text)
{
    if (node->type != YAML_SCALAR_NODE)
        return aob_yaml_fail(yaml, node, "a single value is expected here, not a list or mapping");
    *text = (const char *)node->data.scalar.value;
    if (strlen(*text) != node->data.scalar.length || !**text)
        return aob_yaml_fail(yaml, node, "a value is missing here");
    return true;
}

bool aob_yaml_bool(struct aob_yaml *yaml, const yaml_node_t *node, bool *value)
{
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    *value = strcmp(text, "true") == 0;
    return *value || strcmp(text, "false") == 0 ||
           aob_yaml_fail(yaml, node, "'%s' is neither true nor false", text);
}

bool aob_yaml_number(struct aob_yaml *yaml, const yaml_node_t *node, double low, double high, double *value)
{
    const char *text;
    double v;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    if (!aob_parse_double(text, &v))
        return aob_yaml_fail(yaml, node, "'%s' is not a number", text);
    if (v < low || v > high)
        return aob_yaml_fail(yaml, node, "%s is outside %g .. %g", text, low, high);
    *value = v;
    return true;
}

static bool read_vector(struct aob_yaml *yaml, const yaml_node_t *node, double *value, int count)
{
    if (node->type != YAML_SEQUENCE_NODE ||
        node->data.sequence.items.top - node->data.sequence.items.start != count)
        return aob_yaml_fail(yaml, node,
                             count == 3 ? "three numbers are expected: [x, y, z]"
                                        : "two numbers are expected: [x, y]");
    for (int i = 0; i < count; i++)
        if (!aob_yaml_number(yaml, aob_yaml_node(yaml, node->data.sequence.items.start[i]), -1e30, 1e30,
                             &value[i]))
            return false;
    return true;
}

bool aob_yaml_vec3(struct aob_yaml *yaml, const yaml_node_t *node, double value[3])
{
    return read_vector(yaml, node, value, 3);
}

bool aob_yaml_vec2(struct aob_yaml *yaml, const yaml_node_t *node, double value[2])
{
    return read_vector(yaml, node, value, 2);
}

struct aob_value aob_yaml_value(const yaml_node_t *node, const char *text)
{
    return (struct aob_value){aob_strdup(text), (int)node->start_mark.line + 1,
                              (int)node->start_mark.column + 1};
}

static bool known_key(struct aob_yaml *yaml, const yaml_node_t *node, const char *key,
                      const char *const *keys)
{
    struct aob_text all = {0};
    for (int i = 0; keys && keys[i]; i++) {
        if (strcmp(key, keys[i]) == 0) {
            aob_text_finish(&all);
            return true;
        }
        aob_text_add(&all, "%s%s", i ? ", " : "", keys[i]);
    }
    bool ok = !keys || aob_yaml_fail(yaml, node, "unknown key '%s'; known here: %s", key, all.data);
    aob_text_finish(&all);
    return ok;
}

bool aob_yaml_mapping(struct aob_yaml *yaml, const yaml_node_t *node, const char *const *keys,
                      aob_yaml_entry *read, void *user)
{
    if (node->type != YAML_MAPPING_NODE)
        return aob_yaml_fail(yaml, node, "a mapping (key: value) is expected here");
    const yaml_node_pair_t *start = node->data.mapping.pairs.start, *top = node->data.mapping.pairs.top;
    for (const yaml_node_pair_t *pair = start; pair < top; pair++) {
        yaml_node_t *key_node = aob_yaml_node(yaml, pair->key), *value = aob_yaml_node(yaml, pair->value);
        const char *key, *earlier;
        if (!aob_yaml_text(yaml, key_node, &key) || !known_key(yaml, key_node, key, keys))
            return false;
        for (const yaml_node_pair_t *other = start; other < pair; other++) {
            earlier = (const char *)aob_yaml_node(yaml, other->key)->data.scalar.value;
            if (strcmp(earlier, key) == 0)
                return aob_yaml_fail(yaml, key_node, "key '%s' stands here twice", key);
        }
        if (!read(yaml, key, value, user))
            return false;
    }
    return true;
}

bool aob_yaml_sequence(struct aob_yaml *yaml, yaml_node_t *node, aob_yaml_element *read, void *user)
{
    if (node->type != YAML_SEQUENCE_NODE)
        return read(yaml, node, user);
    for (yaml_node_item_t *item = node->data.sequence.items.start; item < node->data.sequence.items.top;
         item++)
        if (!read(yaml, aob_yaml_node(yaml, *item), user))
            return false;
    return true;
}

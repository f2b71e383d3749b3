#include "yaml.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"
#include "base/table.h"
#include "base/text.h"

/* Of a byte that libyaml's reader refuses it tells the offset alone. A column is a character, as in its own marks. */
static yaml_mark_t find_mark(const unsigned char *text, size_t offset)
{
    yaml_mark_t mark = {.index = offset};
    for (size_t i = 0; i < offset; i++)
        if (text[i] == '\n') {
            mark.line++;
            mark.column = 0;
        } else
            mark.column += (text[i] & 0xc0) != 0x80; /* it begins a character */
    return mark;
}

static bool fail_parser(const struct aob_yaml *yaml, const yaml_parser_t *parser)
{
    yaml_mark_t mark = parser->error == YAML_READER_ERROR
                           ? find_mark(parser->input.string.start, parser->problem_offset)
                           : parser->problem_mark;
    return aob_fail(yaml->error, "%s:%zu:%zu: not YAML: %s", yaml->path, mark.line + 1, mark.column + 1,
                    parser->problem ? parser->problem : "unreadable");
}

/* libyaml compares every %TAG line with those before it, and a config has no use for one. */
static bool judge_tags(const struct aob_yaml *yaml, const char *text)
{
    const char *tag = strstr(text, "%TAG");
    size_t line = 1;
    for (const char *at = text; tag && (at = strchr(at, '\n')) && at < tag; at++)
        line++;
    return !tag || aob_fail(yaml->error, "%s:%zu: a config has no %%TAG lines", yaml->path, line);
}

static bool has_anchor(const yaml_event_t *event)
{
    return event->type == YAML_SCALAR_EVENT           ? event->data.scalar.anchor != NULL
           : event->type == YAML_SEQUENCE_START_EVENT ? event->data.sequence_start.anchor != NULL
           : event->type == YAML_MAPPING_START_EVENT  ? event->data.mapping_start.anchor != NULL
                                                      : false;
}

/* The file as events, which takes a time in proportion to its size. Loading it as nodes does not: libyaml compares every
 * anchor and alias with all anchors, and looks at all open brackets for each token. */
static bool survey(const struct aob_yaml *yaml, yaml_parser_t *parser)
{
    int depth = 0, anchors = 0;
    for (bool done = false; !done;) {
        yaml_event_t event;
        if (!yaml_parser_parse(parser, &event))
            return fail_parser(yaml, parser);
        yaml_event_type_t type = event.type;
        yaml_mark_t at = event.start_mark;
        anchors += has_anchor(&event);
        yaml_event_delete(&event);
        depth += (type == YAML_SEQUENCE_START_EVENT || type == YAML_MAPPING_START_EVENT) -
                 (type == YAML_SEQUENCE_END_EVENT || type == YAML_MAPPING_END_EVENT);
        if (depth > AOB_YAML_MAX_DEPTH || anchors > AOB_YAML_MAX_ANCHORS)
            return aob_fail(yaml->error, "%s:%zu:%zu: more than %d %s", yaml->path, at.line + 1,
                            at.column + 1,
                            depth > AOB_YAML_MAX_DEPTH ? AOB_YAML_MAX_DEPTH : AOB_YAML_MAX_ANCHORS,
                            depth > AOB_YAML_MAX_DEPTH ? "lists and mappings within each other" : "anchors");
        done = type == YAML_DOCUMENT_END_EVENT || type == YAML_STREAM_END_EVENT;
    }
    return true;
}

bool aob_yaml_load(struct aob_yaml *yaml, const char *path, const char *text, size_t size,
                   struct aob_error *error)
{
    *yaml = (struct aob_yaml){.path = path, .error = error};
    bool ok = judge_tags(yaml, text);
    for (int pass = 0; ok && pass < 2; pass++) {
        yaml_parser_t parser;
        if (!yaml_parser_initialize(&parser))
            return aob_fail(error, "%s: out of memory", path);
        yaml_parser_set_input_string(&parser, (const unsigned char *)text, size);
        yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING); /* in another one no %TAG was looked for */
        ok = pass == 0 ? survey(yaml, &parser)
                       : yaml_parser_load(&parser, &yaml->document) || fail_parser(yaml, &parser);
        yaml_parser_delete(&parser);
    }
    if (ok && !yaml_document_get_root_node(&yaml->document)) {
        yaml_document_delete(&yaml->document);
        ok = aob_fail(error, "%s: the file is empty", path);
    }
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
    aob_line_print_list(text, sizeof text, format, args);
    va_end(args);
    return aob_fail(yaml->error, "%s:%zu:%zu: %s", yaml->path, node->start_mark.line + 1,
                    node->start_mark.column + 1, text);
}

static yaml_node_t *get_node(struct aob_yaml *yaml, int id)
{
    return yaml_document_get_node(&yaml->document, id);
}

const yaml_node_t *aob_yaml_find(struct aob_yaml *yaml, const yaml_node_t *node, const char *key)
{
    if (node->type != YAML_MAPPING_NODE)
        return NULL;
    for (const yaml_node_pair_t *p = node->data.mapping.pairs.start; p < node->data.mapping.pairs.top; p++) {
        const yaml_node_t *name = get_node(yaml, p->key);
        if (name->type == YAML_SCALAR_NODE && strcmp((const char *)name->data.scalar.value, key) == 0)
            return get_node(yaml, p->value);
    }
    return NULL;
}

bool aob_yaml_text(struct aob_yaml *yaml, const yaml_node_t *node, const char **text)
{
    if (node->type != YAML_SCALAR_NODE)
        return aob_yaml_fail(yaml, node, "a single value is expected here, not a list or mapping");
    *text = (const char *)node->data.scalar.value;
    if (strlen(*text) != node->data.scalar.length || !**text)
        return aob_yaml_fail(yaml, node, "a value is missing here");
    return strlen(*text) <= AOB_YAML_MAX_TEXT ||
           aob_yaml_fail(yaml, node, "a value of more than %d bytes", AOB_YAML_MAX_TEXT);
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
        if (!aob_yaml_number(yaml, get_node(yaml, node->data.sequence.items.start[i]), -1e30, 1e30,
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
    for (int i = 0; keys && keys[i]; i++)
        if (strcmp(key, keys[i]) == 0)
            return true;
    for (int i = 0; keys && keys[i]; i++)
        aob_text_add(&all, "%s%s", i ? ", " : "", keys[i]);
    bool ok = !keys || aob_yaml_fail(yaml, node, "unknown key '%s'; known here: %s", key, all.data);
    aob_text_finish(&all);
    return ok;
}

/* A list of aliases of lists of aliases stands for more values than any memory holds. */
static bool count_visit(struct aob_yaml *yaml, const yaml_node_t *node)
{
    return ++yaml->visits <= AOB_YAML_MAX_VISITS ||
           aob_yaml_fail(yaml, node, "the aliases stand for more than %d values", AOB_YAML_MAX_VISITS);
}

static bool read_pair(struct aob_yaml *yaml, const yaml_node_pair_t *pair, const char *const *keys,
                      struct aob_table *seen, aob_yaml_entry *read, void *user)
{
    const yaml_node_t *node = get_node(yaml, pair->key);
    const char *key;
    if (!count_visit(yaml, node) || !aob_yaml_text(yaml, node, &key) || !known_key(yaml, node, key, keys))
        return false;
    size_t number = seen->count;
    if (number == AOB_YAML_MAX_KEYS)
        return aob_yaml_fail(yaml, node, "a mapping of more than %d keys", AOB_YAML_MAX_KEYS);
    if (aob_table_put(seen, key, number) != number)
        return aob_yaml_fail(yaml, node, "key '%s' stands here twice", key);
    return read(yaml, key, get_node(yaml, pair->value), user);
}

bool aob_yaml_mapping(struct aob_yaml *yaml, const yaml_node_t *node, const char *const *keys,
                      aob_yaml_entry *read, void *user)
{
    if (node->type != YAML_MAPPING_NODE)
        return aob_yaml_fail(yaml, node, "a mapping (key: value) is expected here");
    struct aob_table seen = {0};
    bool ok = true;
    for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start;
         ok && pair < node->data.mapping.pairs.top; pair++)
        ok = read_pair(yaml, pair, keys, &seen, read, user);
    aob_table_finish(&seen);
    return ok;
}

bool aob_yaml_sequence(struct aob_yaml *yaml, yaml_node_t *node, aob_yaml_element *read, void *user)
{
    if (node->type != YAML_SEQUENCE_NODE)
        return read(yaml, node, user);
    for (yaml_node_item_t *item = node->data.sequence.items.start; item < node->data.sequence.items.top;
         item++)
        if (!count_visit(yaml, node) || !read(yaml, get_node(yaml, *item), user))
            return false;
    return true;
}

/* A YAML document as nodes with positions (libyaml), and typed reads of them. Every read that fails has
 * written FILE:LINE:COLUMN: cause. */
#ifndef AOB_CONFIG_YAML_H
#define AOB_CONFIG_YAML_H
#include <stdbool.h>
#include <yaml.h>
#include "base/error.h"
#include "config.h"

struct aob_yaml {
    const char *path;
    yaml_document_t document;
    struct aob_error *error;
    size_t
        visits; /* entries and elements read so far; through aliases they can be far more than the file has */
};
/* What no config needs and a hostile one would take minutes or all memory with is refused: besides what passes these
 * bounds, %TAG lines, and texts that are not UTF-8. */
enum {
    AOB_YAML_MAX_DEPTH = 32,       /* lists and mappings within each other */
    AOB_YAML_MAX_KEYS = 1000,      /* in a mapping */
    AOB_YAML_MAX_ANCHORS = 256,    /* in a file */
    AOB_YAML_MAX_VISITS = 1000000, /* values that its aliases stand for */
    AOB_YAML_MAX_TEXT = 4096       /* bytes of a value */
};
bool aob_yaml_load(struct aob_yaml *yaml, const char *path, const char *text, size_t size,
                   struct aob_error *error);
void aob_yaml_finish(struct aob_yaml *yaml);

bool aob_yaml_fail(const struct aob_yaml *yaml, const yaml_node_t *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The value of a key, or NULL: the key is not there, or the node is no mapping. */
const yaml_node_t *aob_yaml_find(struct aob_yaml *yaml, const yaml_node_t *node, const char *key);

bool aob_yaml_text(struct aob_yaml *yaml, const yaml_node_t *node, const char **text); /* a scalar */
bool aob_yaml_bool(struct aob_yaml *yaml, const yaml_node_t *node, bool *value);       /* true or false */
bool aob_yaml_number(struct aob_yaml *yaml, const yaml_node_t *node, double low, double high, double *value);
bool aob_yaml_vec3(struct aob_yaml *yaml, const yaml_node_t *node, double value[3]);
bool aob_yaml_vec2(struct aob_yaml *yaml, const yaml_node_t *node, double value[2]);
struct aob_value aob_yaml_value(const yaml_node_t *node, const char *text); /* copies the text */

/* Call `read` for each entry of a mapping whose key is one of `keys` (NULL-ended); unknown and double keys
 * fail. */
typedef bool aob_yaml_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user);
bool aob_yaml_mapping(struct aob_yaml *yaml, const yaml_node_t *node, const char *const *keys,
                      aob_yaml_entry *read, void *user);
/* Call `read` for each element; a single scalar or mapping counts as a sequence of one. */
typedef bool aob_yaml_element(struct aob_yaml *yaml, yaml_node_t *value, void *user);
bool aob_yaml_sequence(struct aob_yaml *yaml, yaml_node_t *node, aob_yaml_element *read, void *user);
#endif

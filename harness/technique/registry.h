/* Techniques: the built-in ones, and modules loaded from .so files after an ABI check.
 * aob_technique_info is the plain-data shadow of a technique (no code) that the program's main process works
 * with; only workers open modules and call into techniques. */
#ifndef AOB_TECHNIQUE_REGISTRY_H
#define AOB_TECHNIQUE_REGISTRY_H
#include <aobudget/technique.h>
#include <jansson.h>
#include <stddef.h>
#include "base/error.h"
#include "base/hash.h"

/* NULL-ended, sorted by name; written by the build from the folders in techniques/. */
extern const struct aob_technique *const aob_builtin_techniques[];

struct aob_registry {
    struct aob_registry_entry {
        const struct aob_technique *technique;
        const char *module;        /* path of its .so; NULL: built in */
        char digest[AOB_KEY_SIZE]; /* of its texts, tables and revision; of the .so's bytes for a module */
    } * entries;
    size_t count, capacity;
    void **handles;
    size_t handle_count, handle_capacity;
};

/* The built-ins, then each module in turn; a module's technique takes the place of one of the same name. */
void aob_registry_init(struct aob_registry *registry);
bool aob_registry_load(struct aob_registry *registry, const char *path, struct aob_error *error);
const struct aob_registry_entry *aob_registry_find(const struct aob_registry *registry, const char *name);
void aob_registry_finish(struct aob_registry *registry);

/* The number of a module interface as people know it: up to 3 it stood in the upper half. */
uint32_t aob_abi_number(uint32_t abi);

/* A table that no harness code could trust is refused: size, names, bounds, offsets, shaders, build. */
bool aob_technique_judge(const struct aob_technique *technique, struct aob_error *error);

struct aob_technique_info {
    char *name, *title, *citation, *summary, *notes,
        *module;    /* the last three may be NULL; module: a built-in's */
    char *sampling; /* the parameter that counts its samples, or NULL */
    enum aob_sequence sequence;
    uint32_t revision;
    char digest[AOB_KEY_SIZE];
    struct aob_param *params; /* strings owned */
    size_t param_count;
};
struct aob_technique_list {
    struct aob_technique_info *items;
    size_t count;
};

json_t *aob_technique_to_json(const struct aob_registry_entry *entry); /* with parameters, units, bounds */
json_t *aob_technique_info_to_json(const struct aob_technique_info *info); /* the same */
json_t *aob_param_to_json(const struct aob_param *param); /* unit, scale, stage and rule as words */
bool aob_technique_list_add(struct aob_technique_list *list,
                            const json_t *described); /* false: not of that shape */
const struct aob_technique_info *aob_technique_list_find(const struct aob_technique_list *list,
                                                         const char *name);
void aob_technique_list_finish(struct aob_technique_list *list);
#endif

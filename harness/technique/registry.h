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

/* Where a technique is, and which build of it is meant. A name is not enough: a process may hold several builds of one
 * technique. Texts are borrowed. */
struct aob_address {
    const char *technique;
    const char *module; /* path of its .so, NULL: built in */
    const char *digest; /* as in struct aob_registry_entry */
};

/* The built-ins, then the techniques of each module that is loaded; all stay, whatever their names. A file that is loaded
 * by one path twice is loaded once. By two paths it has its entries twice, of one digest, though the system maps it
 * once. `path` is borrowed until aob_registry_finish. */
void aob_registry_init(struct aob_registry *registry);
bool aob_registry_load(struct aob_registry *registry, const char *path, struct aob_error *error);

/* The technique of that name in the module of that path, as it was loaded; module NULL: the built-in one. */
const struct aob_registry_entry *aob_registry_find(const struct aob_registry *registry, const char *module,
                                                   const char *name);

/* The same after its module is loaded. NULL after a line if that fails, or if what is there now is another build than the
 * one that is meant. */
const struct aob_technique *aob_registry_open(struct aob_registry *registry,
                                              const struct aob_address *address, struct aob_error *error);
void aob_registry_finish(struct aob_registry *registry);

/* The number of a module interface as people know it: up to 3 it stood in the upper half. */
uint32_t aob_abi_number(uint32_t abi);

/* A table that no harness code could trust is refused: size, names, bounds, offsets, shaders, build. */
bool aob_technique_judge(const struct aob_technique *technique, struct aob_error *error);

struct aob_technique_info {
    char *name, *title, *citation, *summary, *notes; /* the last two may be NULL */
    char *module;   /* its file as the user wrote it, which records call it by; NULL: built in */
    char *file;     /* the same for workers, absolute; NULL: built in */
    bool offered;   /* it is built in or of a --module: who names no module may mean it */
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

/* The technique of that name in a module as the user wrote it. Module NULL: that of an offered module, else the built-in
 * one. NULL after a line if there is none, or if offered modules have different builds of it. */
const struct aob_technique_info *aob_technique_list_find(const struct aob_technique_list *list,
                                                         const char *module, const char *name,
                                                         struct aob_error *error);
struct aob_address aob_technique_address(const struct aob_technique_info *info); /* borrows its texts */
void aob_technique_list_finish(struct aob_technique_list *list);
#endif

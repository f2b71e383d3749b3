#include "gltf_type.h"
#include <string.h>
#include "base/memory.h"

/* Component types as bits: 5120 is the first. */
enum { FIRST = 5120, I8 = 1, U8 = 2, I16 = 4, U16 = 8, U32 = 32, F32 = 64 };

static const struct rule {
    const char *name; /* one that ends in _ is followed by a number */
    unsigned plain, quantised;
    bool
        shares; /* whole numbers must be normalised; elsewhere only their ratios count, or they are what they are */
} rules[] = {
    {"POSITION", F32, I8 | U8 | I16 | U16, false}, {"NORMAL", F32, I8 | I16, false},
    {"COLOR_", U8 | U16 | F32, 0, true},           {"JOINTS_", U8 | U16, 0, false},
    {"WEIGHTS_", U8 | U16 | F32, 0, false},        {"TRANSLATION", F32, 0, false},
    {"ROTATION", I8 | I16 | F32, 0, true},         {"SCALE", F32, 0, false},
    {"indices", U8 | U16 | U32, 0, false},         {"inverseBindMatrices", F32, 0, false},
};

static const struct rule *find_rule(const char *name)
{
    for (size_t i = 0; i < AOB_COUNT(rules); i++) {
        size_t size = strlen(rules[i].name);
        bool open = rules[i].name[size - 1] == '_';
        if (strncmp(name, rules[i].name, size) == 0 && (open || !name[size]))
            return &rules[i];
    }
    return NULL;
}

static bool declares(const struct aob_gltf *gltf, const char *list, const char *extension)
{
    const json_t *names = json_object_get(gltf->file->root, list);
    for (size_t i = 0; i < json_array_size(names); i++)
        if (strcmp(json_string_value(json_array_get(names, i)), extension) == 0)
            return true;
    return false;
}

/* It must be in both lists, but either says what the numbers are. */
static bool is_quantised(const struct aob_gltf *gltf)
{
    return declares(gltf, "extensionsUsed", "KHR_mesh_quantization") ||
           declares(gltf, "extensionsRequired", "KHR_mesh_quantization");
}

static unsigned bit_of(size_t type)
{
    return type >= FIRST && type < FIRST + 7 ? 1u << (type - FIRST) : 0;
}

bool aob_gltf_type_check(const struct aob_gltf *gltf, size_t accessor, const char *name,
                         struct aob_error *error)
{
    const struct rule *rule = find_rule(name);
    const json_t *element = aob_gltf_element(gltf, "accessors", accessor, error);
    struct aob_gltf_label label = aob_gltf_label("accessor", accessor);
    size_t type;
    if (!element || !aob_gltf_whole(gltf, element, label.text, "componentType", 0, &type, error))
        return false;
    unsigned bit = bit_of(type);
    if (!rule)
        return true;
    if (rule->quantised & bit && !is_quantised(gltf))
        return aob_fail(error,
                        "%s: %s: %s of componentType %zu need KHR_mesh_quantization, which the file does not "
                        "declare: declare it, or export floats",
                        gltf->file->path, label.text, name, type);
    if (!((rule->plain | rule->quantised) & bit))
        return aob_fail(error, "%s: %s: %s are of componentType %zu: the file is damaged", gltf->file->path,
                        label.text, name, type);
    return !rule->shares || bit == F32 || json_is_true(json_object_get(element, "normalized")) ||
           aob_fail(error, "%s: %s: %s of componentType %zu are not normalized: the file is damaged",
                    gltf->file->path, label.text, name, type);
}

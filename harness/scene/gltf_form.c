#include "gltf_form.h"
#include "base/memory.h"
#include "base/text.h"

enum kind { ANY, FLAG, NUMBER, TEXT, OBJECT };

/* A member of an object; a table of them ends with one that has no name. */
struct member {
    const char *name;
    enum kind kind;               /* of its elements, if it is a list */
    bool list, needed;            /* an array of such; the format demands it */
    const struct member *members; /* of an object, or of each object of a list; NULL: none is looked at */
};

static const struct member attributes[] = {{"attributes", .kind = OBJECT, .needed = true}, {0}};
static const struct member visibility[] = {{"visible", .kind = FLAG}, {0}};
static const struct member node_extensions[] = {
    {"EXT_mesh_gpu_instancing", .kind = OBJECT, .members = attributes},
    {"KHR_node_visibility", .kind = OBJECT, .members = visibility},
    {0},
};
static const struct member node[] = {
    {"children", .kind = ANY, .list = true},
    {"weights", .kind = NUMBER, .list = true},
    {"extensions", .kind = OBJECT, .members = node_extensions},
    {0},
};
static const struct member primitive_extensions[] = {
    {"KHR_draco_mesh_compression", .kind = OBJECT, .members = attributes},
    {0},
};
static const struct member primitive[] = {
    {"attributes", .kind = OBJECT, .needed = true},
    {"targets", .kind = OBJECT, .list = true},
    {"extensions", .kind = OBJECT, .members = primitive_extensions},
    {0},
};
static const struct member mesh[] = {
    {"primitives", .kind = OBJECT, .list = true, .needed = true, .members = primitive},
    {"weights", .kind = NUMBER, .list = true},
    {"extensions", .kind = OBJECT},
    {0},
};
static const struct member sparse[] = {
    {"count", .kind = ANY, .needed = true},
    {"indices", .kind = OBJECT, .needed = true},
    {"values", .kind = OBJECT, .needed = true},
    {0},
};
static const struct member accessor[] = {
    {"count", .kind = ANY, .needed = true},
    {"type", .kind = TEXT, .needed = true},
    {"normalized", .kind = FLAG},
    {"sparse", .kind = OBJECT, .members = sparse},
    {0},
};
static const struct member meshopt[] = {
    {"mode", .kind = TEXT, .needed = true}, {"filter", .kind = TEXT}, {0}};
static const struct member view_extensions[] = {
    {"EXT_meshopt_compression", .kind = OBJECT, .members = meshopt},
    {0},
};
static const struct member view[] = {{"extensions", .kind = OBJECT, .members = view_extensions}, {0}};
static const struct member buffer[] = {{"uri", .kind = TEXT}, {0}};
static const struct member skin[] = {{"joints", .kind = ANY, .list = true, .needed = true}, {0}};
static const struct member scene[] = {{"nodes", .kind = ANY, .list = true}, {0}};
static const struct member metal[] = {
    {"roughnessFactor", .kind = NUMBER}, {"metallicFactor", .kind = NUMBER}, {0}};
static const struct member gloss[] = {{"glossinessFactor", .kind = NUMBER}, {0}};
static const struct member material_extensions[] = {
    {"KHR_materials_pbrSpecularGlossiness", .kind = OBJECT, .members = gloss},
    {0},
};
static const struct member material[] = {
    {"pbrMetallicRoughness", .kind = OBJECT, .members = metal},
    {"extensions", .kind = OBJECT, .members = material_extensions},
    {0},
};
static const struct member document[] = {
    {"extensionsUsed", .kind = TEXT, .list = true},
    {"extensionsRequired", .kind = TEXT, .list = true},
    {"accessors", .kind = OBJECT, .list = true, .members = accessor},
    {"bufferViews", .kind = OBJECT, .list = true, .members = view},
    {"buffers", .kind = OBJECT, .list = true, .members = buffer},
    {"materials", .kind = OBJECT, .list = true, .members = material},
    {"meshes", .kind = OBJECT, .list = true, .members = mesh},
    {"nodes", .kind = OBJECT, .list = true, .members = node},
    {"scenes", .kind = OBJECT, .list = true, .members = scene},
    {"skins", .kind = OBJECT, .list = true, .members = skin},
    {0},
};

/* Where a value stands: a member of what is above it, or an element of that. */
struct place {
    const struct place *above;
    const char *name; /* NULL: an element */
    size_t index;
};

static void add_place(const struct place *place, struct aob_text *text)
{
    if (place->above)
        add_place(place->above, text);
    if (place->name)
        aob_text_add(text, "%s%s", place->above ? "." : "", place->name);
    else
        aob_text_add(text, "[%zu]", place->index);
}

static bool fail_at(const struct aob_gltf_file *file, const struct place *place, const char *what,
                    struct aob_error *error)
{
    struct aob_text text = {0};
    add_place(place, &text);
    aob_fail(error, "%s: %s is %s: the file is damaged", file->path, text.data, what);
    aob_text_finish(&text);
    return false;
}

static bool is_of_kind(const json_t *value, enum kind kind)
{
    switch (kind) {
    case FLAG:
        return json_is_boolean(value);
    case NUMBER:
        return json_is_number(value);
    case TEXT:
        return json_is_string(value);
    case OBJECT:
        return json_is_object(value);
    case ANY:
        break;
    }
    return true;
}

static bool check_members(const struct aob_gltf_file *file, const json_t *object,
                          const struct member *members, const struct place *above, struct aob_error *error);

static bool check_value(const struct aob_gltf_file *file, const json_t *value, const struct member *member,
                        const struct place *place, struct aob_error *error)
{
    static const char *const wrong[] = {[FLAG] = "neither true nor false",
                                        [NUMBER] = "no number",
                                        [TEXT] = "no text",
                                        [OBJECT] = "no object"};
    if (!is_of_kind(value, member->kind))
        return fail_at(file, place, wrong[member->kind], error);
    return !member->members || check_members(file, value, member->members, place, error);
}

static bool check_list(const struct aob_gltf_file *file, const json_t *list, const struct member *member,
                       const struct place *above, struct aob_error *error)
{
    if (!json_is_array(list))
        return fail_at(file, above, "no array", error);
    for (size_t i = 0; i < json_array_size(list); i++) {
        const struct place place = {.above = above, .index = i};
        if (!check_value(file, json_array_get(list, i), member, &place, error))
            return false;
    }
    return true;
}

static bool check_members(const struct aob_gltf_file *file, const json_t *object,
                          const struct member *members, const struct place *above, struct aob_error *error)
{
    for (const struct member *member = members; member->name; member++) {
        const struct place place = {.above = above, .name = member->name};
        const json_t *value = json_object_get(object, member->name);
        bool ok = value            ? member->list ? check_list(file, value, member, &place, error)
                                                  : check_value(file, value, member, &place, error)
                             : member->needed ? fail_at(file, &place, "missing", error)
                                   : true;
        if (!ok)
            return false;
    }
    return true;
}

bool aob_gltf_form_check(const struct aob_gltf_file *file, struct aob_error *error)
{
    return check_members(file, file->root, document, NULL, error);
}

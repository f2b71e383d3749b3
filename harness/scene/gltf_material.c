#include "gltf_material.h"
#include "base/json.h"

static double number_or(const json_t *object, const char *key, double fallback)
{
    const json_t *member = json_object_get(object, key);
    return json_is_number(member) ? json_number_value(member) : fallback;
}

static bool read_colour(const struct aob_gltf *gltf, const json_t *object, const char *key, float colour[3],
                        struct aob_error *error)
{
    double rgba[4] = {(double)colour[0], (double)colour[1], (double)colour[2], 1};
    if (!aob_gltf_vector(gltf, object, "a material", key, rgba, 4, error))
        return false;
    for (int c = 0; c < 3; c++)
        colour[c] = (float)rgba[c];
    return true;
}

bool aob_gltf_material(const struct aob_gltf *gltf, const json_t *primitive, struct aob_material *material,
                       bool *said, struct aob_error *error)
{
    size_t index;
    *material = (struct aob_material){.base_colour = {1, 1, 1}, .roughness = 1, .metalness = 1};
    *said = false;
    if (!aob_gltf_whole(gltf, primitive, "a primitive", "material", aob_gltf_none, &index, error))
        return false;
    if (index == aob_gltf_none)
        return true;
    const json_t *element = aob_gltf_element(gltf, "materials", index, error);
    const json_t *metal = json_object_get(element, "pbrMetallicRoughness");
    const json_t *gloss = aob_gltf_extension(element, "KHR_materials_pbrSpecularGlossiness");
    if (!read_colour(gltf, metal, "baseColorFactor", material->base_colour, error))
        return false;
    material->roughness = (float)number_or(metal, "roughnessFactor", 1);
    material->metalness = (float)number_or(metal, "metallicFactor", gloss && !metal ? 0 : 1);
    if (gloss && !metal) {
        if (!read_colour(gltf, gloss, "diffuseFactor", material->base_colour, error))
            return false;
        material->roughness = 1 - (float)number_or(gloss, "glossinessFactor", 1);
    }
    *said = true;
    return element;
}

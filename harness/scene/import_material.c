#include "import_material.h"
#include <assimp/material.h>
#include <string.h>

static void read_number(const struct aiMaterial *material, const char *key, float *into)
{
    ai_real value;
    if (aiGetMaterialFloatArray(material, key, 0, 0, &value, NULL) == aiReturn_SUCCESS)
        *into = value;
}

static bool read_colour(const struct aiMaterial *material, const char *key, float into[3])
{
    struct aiColor4D colour;
    if (aiGetMaterialColor(material, key, 0, 0, &colour) != aiReturn_SUCCESS)
        return false;
    into[0] = colour.r;
    into[1] = colour.g;
    into[2] = colour.b;
    return true;
}

static void read_material(const struct aiMaterial *material, struct aob_material *into)
{
    if (!read_colour(material, "$clr.base", into->base_colour))
        read_colour(material, "$clr.diffuse", into->base_colour);
    read_number(material, "$mat.roughnessFactor", &into->roughness);
    read_number(material, "$mat.metallicFactor", &into->metalness);
}

/* If a file has no material, assimp makes one up: a grey one with a name of its own for most formats, a nameless
 * white one for PLY. */
static bool is_made_up(const struct aiMaterial *material)
{
    struct aiString name = {.data = ""};
    struct aob_material values = {.base_colour = {1, 1, 1}, .roughness = 1, .metalness = 1};
    const struct aob_material white = values;
    aiGetMaterialString(material, AI_MATKEY_NAME, &name);
    read_material(material, &values);
    return strcmp(name.data, AI_DEFAULT_MATERIAL_NAME) == 0 ||
           (!*name.data && aob_material_equal(&values, &white));
}

bool aob_import_material(const struct aiMaterial *material, struct aob_material *into)
{
    *into = aob_material_default;
    if (is_made_up(material))
        return false;
    read_material(material, into);
    return true;
}

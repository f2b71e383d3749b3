#include "import_material.h"
#include <assimp/material.h>
#include <math.h>
#include <string.h>

/* NAN stays, so that aob_mesh_check refuses the mesh. */
static float clamped(double value)
{
    return (float)(value < 0 ? 0 : value > 1 ? 1 : value);
}

static void read_number(const struct aiMaterial *material, const char *key, float *into)
{
    ai_real value;
    if (aiGetMaterialFloatArray(material, key, 0, 0, &value, NULL) == aiReturn_SUCCESS)
        *into = clamped((double)value);
}

static bool read_colour(const struct aiMaterial *material, const char *key, float into[3])
{
    struct aiColor4D colour;
    if (aiGetMaterialColor(material, key, 0, 0, &colour) != aiReturn_SUCCESS)
        return false;
    into[0] = clamped((double)colour.r);
    into[1] = clamped((double)colour.g);
    into[2] = clamped((double)colour.b);
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
 * white one for PLY, and a nameless one of glTF's defaults (white, all metal, rough) for glTF. */
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

static void multiply_by_colours(const struct aiColor4D *colours, const struct aiFace *face, float colour[3])
{
    double sum[3] = {0};
    for (int k = 0; k < 3; k++) {
        const struct aiColor4D *c = &colours[face->mIndices[k]];
        sum[0] += (double)c->r;
        sum[1] += (double)c->g;
        sum[2] += (double)c->b;
    }
    for (int c = 0; c < 3; c++)
        colour[c] = clamped((double)colour[c] * sum[c] / 3);
}

struct aob_material aob_import_material(const struct aiMaterial *material, const struct aiMesh *mesh,
                                        const struct aiFace *face)
{
    struct aob_material result = aob_material_default;
    bool said = material && !is_made_up(material);
    if (said)
        read_material(material, &result);
    if (!face || !mesh->mColors[0])
        return result;
    for (int c = 0; c < 3 && !said; c++)
        result.base_colour[c] = 1;
    multiply_by_colours(mesh->mColors[0], face, result.base_colour);
    return result;
}

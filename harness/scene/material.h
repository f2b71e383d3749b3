/* What a surface is made of, in the metallic-roughness model of glTF 2.0, without textures. */
#ifndef AOB_SCENE_MATERIAL_H
#define AOB_SCENE_MATERIAL_H
#include <stdbool.h>

struct aob_material {
    float base_colour[3];       /* linear R, G, B; 0..1 like the rest */
    float roughness, metalness; /* metalness 1: no diffuse reflection */
};

/* The material where a scene names none: base colour 0.8 (a light wall or plaster, so that bounces show without being
 * endless), roughness 1 and metalness 0 (nothing shines unless the scene says so). */
extern const struct aob_material aob_material_default;

bool aob_material_equal(const struct aob_material *a, const struct aob_material *b);
bool aob_material_valid(const struct aob_material *material); /* all finite, within 0..1 */
#endif

#include "pictures.h"
#include <stdio.h>
#include <stdlib.h>
#include "base/file.h"
#include "small.h"

struct pictures {
    const struct aob_effects *effects;
    const char *folder;
    bool drawn[AOB_EFFECT_ALL + 1]; /* by set */
};

static bool write_set(struct pictures *p, unsigned set, const char *name, struct aob_error *error)
{
    const struct aob_effects *e = p->effects;
    struct aob_small small;
    char *path = aob_path_join(p->folder, name);
    aob_small_init(&small, &e->seen, &e->drawn[aob_effect_image_of(set)], set, e->answer.shrink);
    bool ok = aob_small_write(&small, path, error);
    aob_small_finish(&small);
    free(path);
    return ok;
}

/* A set that was not looked at has no picture. */
static bool add_set(struct pictures *p, unsigned set, json_t *member, struct aob_error *error)
{
    char name[32];
    if (!json_is_object(member))
        return true;
    snprintf(name, sizeof name, "images/set-%u.exr", set);
    json_object_set_new(member, "image", json_string(name));
    if (p->drawn[set])
        return true;
    p->drawn[set] = true;
    return write_set(p, set, name, error);
}

bool aob_effects_draw(const struct aob_effects *e, const char *folder, json_t *document,
                      struct aob_error *error)
{
    struct pictures p = {.effects = e, .folder = folder};
    char *images = aob_path_join(folder, "images");
    bool ok = aob_folder_create(images, error);
    free(images);
    json_object_set_new(document, "exposure", json_real(aob_light_exposure(&e->seen.light)));
    if (e->answer.chosen < 0)
        return ok;
    unsigned taken = e->answer.candidates[e->answer.chosen].set;
    ok = ok && add_set(&p, taken, json_object_get(document, "chosen"), error);
    for (int id = 0; id < AOB_EFFECT_COUNT && ok; id++) {
        json_t *row = json_array_get(json_object_get(document, "effects"), (size_t)id);
        ok = add_set(&p, aob_effect_turned(taken, (enum aob_effect_id)id), json_object_get(row, "otherwise"),
                     error);
    }
    return ok;
}

#include "key.h"
#include <stdlib.h>
#include "base/memory.h"
#include "base/table.h"
#include "technique/clearance.h"
#include "technique/composite.h"

/* The camera, whatever the view is called. One that frames a mesh is known only once the mesh is loaded, and follows from
 * it. */
static void add_view(const struct aob_plan_scene *scene, struct aob_text *text)
{
    if (scene->framed)
        aob_text_add(text, " framed");
    else
        aob_camera_print(&scene->camera, true, text);
    if (scene->motion.frames)
        aob_motion_print(&scene->motion, text);
}

/* What all cases of a scene share: where they look, at what, and what they are compared with. */
static void describe_scene(const struct aob_plan *plan, const struct aob_plan_scene *scene,
                           struct aob_text *text)
{
    aob_text_add(text, "\n%s ", scene->digest);
    add_view(scene, text);
    aob_text_add(text, "\n%d %.9g", plan->config->spp, plan->config->thickness);
    for (size_t i = 0; i < scene->target_count; i++)
        aob_text_add(text, " %.9g%s", scene->targets[i].radius, scene->targets[i].uniform ? "u" : "");
}

/* Only an output that depends on the light makes it a part of the question. */
static void add_light(const struct aob_case *c, struct aob_text *text)
{
    if (aob_case_is_lit(c))
        aob_text_add(text, " light=%s", c->scene->light_digest);
}

static void make_key(struct aob_case *c, const char *scene)
{
    struct aob_text text = {0};
    aob_case_settings(c, &text);
    add_light(c, &text);
    if (aob_case_options(c).thrift) {
        aob_text_add(&text, " clearance=");
        aob_clearance_identify(&text);
    }
    if (aob_case_options(c).lit) {
        aob_text_add(&text, " composite=");
        aob_composite_identify(&text);
    }
    aob_text_add(&text, "\n%s %u%s", c->technique->digest, c->technique->revision, scene);
    aob_hash_text(text.data, c->key);
    aob_text_finish(&text);
}

void aob_plan_make_keys(struct aob_plan *plan)
{
    struct aob_text *scenes = AOB_NEW_ARRAY(struct aob_text, plan->scene_count);
    struct aob_table keys = {0};
    size_t kept = 0;
    for (size_t i = 0; i < plan->scene_count; i++)
        describe_scene(plan, &plan->scenes[i], &scenes[i]);
    for (size_t i = 0; i < plan->case_count; i++) {
        struct aob_case *c = &plan->cases[i];
        make_key(c, scenes[c->scene - plan->scenes].data);
        if (aob_table_put(&keys, c->key, kept) == kept)
            plan->cases[kept++] = *c;
        else
            free(c->params);
    }
    plan->case_count = kept;
    for (size_t i = 0; i < plan->scene_count; i++)
        aob_text_finish(&scenes[i]);
    free(scenes);
    aob_table_finish(&keys);
}

void aob_case_series(const struct aob_case *c, const char *device_class, char key[AOB_KEY_SIZE])
{
    struct aob_text text = {0};
    aob_case_settings(c, &text);
    add_light(c, &text);
    aob_text_add(&text, "\n%s %s ", device_class, c->scene->geometry);
    add_view(c->scene, &text);
    aob_hash_text(text.data, key);
    aob_text_finish(&text);
}

#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "gbuffer/gbuffer.h"
#include "reference/bound.h"
#include "reference/incident.h"
#include "reference/lit.h"
#include "reference/specular.h"
#include "reference/tracer.h"
#include "view.h"

struct aob_view_moment aob_view_moment_last(const struct aob_plan_scene *scene)
{
    int frames = scene->motion.frames;
    return (struct aob_view_moment){.camera = scene->camera,
                                    .frame = frames ? aob_plan_scene_frame(scene, frames - 1) : 0};
}

/* Rays of several seeds, in turn: the noise of a truth and of the one before are independent, and so is that of most pairs of frames, so
 * that longer sequences have less of it. Where nothing moves, all frames are one. */
enum { SEEDS = 8 };

struct aob_view_moment aob_view_moment_of(const struct aob_plan_scene *scene, int frame)
{
    const struct aob_motion *motion = &scene->motion;
    bool changes = aob_motion_has_camera(motion) || aob_plan_scene_frame(scene, 1);
    return (struct aob_view_moment){.camera = aob_motion_camera(motion, &scene->camera, frame),
                                    .frame = aob_plan_scene_frame(scene, frame),
                                    .seed = changes ? (unsigned)(motion->frames - 1 - frame) % SEEDS : 0};
}

static void describe_view(const struct aob_case *c, const struct aob_view_moment *moment, int guard,
                          bool motion, struct aob_text *text)
{
    aob_text_add(text, "%s ", c->scene->digest);
    aob_camera_print(&moment->camera, motion, text);
    if (moment->frame)
        aob_text_add(text, " in frame %d", moment->frame);
    aob_text_add(text, " %dx%d+%d %s", c->width, c->height, guard, aob_tracer_version);
}

/* Of what computes a term besides the tracer. */
static void add_versions(const json_t *term, struct aob_text *text)
{
    const char *output = json_string_value(json_object_get(term, "output"));
    bool specular = output && strcmp(output, aob_output_name(AOB_OUT_SPECULAR)) == 0,
         lit = output && strcmp(output, aob_output_name(AOB_OUT_LIT)) == 0;
    if (lit)
        aob_text_add(text, "%s,%s,%s", aob_lit_version, aob_incident_version, aob_specular_version);
    else if (output)
        aob_text_add(text, "%s", specular ? aob_specular_version : aob_incident_version);
    else if (json_object_get(term, "screen"))
        aob_text_add(text, "%s", aob_bound_version);
}

char *aob_view_term_path(const struct aob_measurement *m, const struct aob_case *c,
                         const struct aob_view_moment *moment, json_t *term)
{
    struct aob_text text = {0};
    char *line = aob_json_line(term, 17);
    bool screen = json_object_get(term, "screen");
    /* Neither guard band nor motion changes the truth; the screen-space bound ends with the guard band. */
    describe_view(c, moment, screen ? aob_case_options(c).guard_band : 0, false, &text);
    aob_text_add(&text, " %d ", m->plan->config->spp);
    if (moment->seed)
        aob_text_add(&text, "seed %u ", moment->seed);
    add_versions(term, &text);
    aob_text_add(&text, " %s", line);
    char *path = aob_cache_path(&m->cache, "visibility", text.data, ".exr");
    free(line);
    aob_text_finish(&text);
    return path;
}

char *aob_view_gbuffer_path(const struct aob_measurement *m, const struct aob_case *c,
                            const struct aob_view_moment *moment)
{
    struct aob_text text = {0};
    if (c->scene->gbuffer)
        return aob_strdup(c->scene->gbuffer);
    describe_view(c, moment, aob_case_options(c).guard_band, true, &text);
    aob_text_add(&text, " %s", aob_gbuffer_version);
    char *path = aob_cache_path(&m->cache, "gbuffer", text.data, ".exr");
    aob_text_finish(&text);
    return path;
}

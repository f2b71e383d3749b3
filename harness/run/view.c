#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "measurement.h"
#include "reference/bound.h"
#include "reference/tracer.h"

static json_t *pose_to_json(struct aob_vec3 eye, struct aob_vec3 target)
{
    return json_pack("{s:[fff], s:[fff]}", "eye", eye.x, eye.y, eye.z, "target", target.x, target.y,
                     target.z);
}

json_t *aob_camera_to_json(const struct aob_camera *camera)
{
    json_t *json = pose_to_json(camera->eye, camera->target);
    json_object_set_new(json, "fov_deg", json_real(camera->fov_deg));
    json_object_set_new(json, "ortho_height", json_real(camera->ortho_height));
    json_object_set_new(json, "shift", aob_json_vector(camera->shift, 2));
    json_object_set_new(json, "previous",
                        camera->moves ? pose_to_json(camera->previous_eye, camera->previous_target)
                                      : json_null());
    return json;
}

static char *cache_path(const struct aob_measurement *m, const char *kind, const char *what,
                        const char *suffix)
{
    char key[AOB_KEY_SIZE], name[AOB_KEY_SIZE + 32];
    aob_hash_text(what, key);
    snprintf(name, sizeof name, "%s-%s%s", kind, key, suffix);
    return aob_path_join(m->cache, name);
}

static void take_box(void *user, json_t *answer)
{
    json_t *warning;
    size_t at;
    json_array_foreach(json_object_get(answer, "warnings"), at, warning)
        aob_warn("%s", json_string_value(warning));
    struct aob_vec3 *box = user;
    double low[3], high[3];
    if (aob_json_to_vector(json_object_get(answer, "low"), low, 3) &&
        aob_json_to_vector(json_object_get(answer, "high"), high, 3)) {
        box[0] = aob_vec(low[0], low[1], low[2]);
        box[1] = aob_vec(high[0], high[1], high[2]);
    }
}

/* Once a run. Time and memory in proportion to the file: a small hostile one would loop or allocate without end.
 * Real meshes take about 0.04 s a megabyte and 20 bytes of memory a byte. */
static bool import_mesh(struct aob_measurement *m, struct aob_plan_scene *scene, const char *path,
                        struct aob_error *error)
{
    struct aob_vec3 box[2] = {{0}};
    size_t size = aob_file_size(scene->file);
    struct aob_job_desc desc = {
        .job = json_pack("{s:s, s:s, s:s}", "job", "mesh", "file", scene->file, "out", path),
        .timeout_s = 10 + 2e-6 * (double)size,
        .memory_limit = ((size_t)1 << 30) + 64 * size,
        .on_answer = take_box,
        .user = box};
    if (!aob_dispatch_job(m->dispatch, &desc, error))
        return strstr(error->text, scene->file) ? false
                                                : aob_fail_in(error, "%s: the mesh loader", scene->file);
    if (scene->framed)
        scene->camera = aob_scene_framing(box[0], box[1]);
    scene->loaded = true;
    return true;
}

static char *load_mesh(struct aob_measurement *m, struct aob_plan_scene *scene, struct aob_error *error)
{
    char *path = cache_path(m, "mesh", scene->digest, ".mesh");
    if (scene->loaded || import_mesh(m, scene, path, error))
        return path;
    free(path);
    return NULL;
}

static void describe_view(const struct aob_case *c, int guard, bool motion, struct aob_text *text)
{
    aob_text_add(text, "%s ", c->scene->digest);
    aob_camera_print(&c->scene->camera, motion, text);
    aob_text_add(text, " %dx%d+%d %s", c->width, c->height, guard, aob_tracer_version);
}

static char *term_path(const struct aob_measurement *m, const struct aob_case *c, json_t *term)
{
    struct aob_text text = {0};
    char *line = aob_json_line(term, 17);
    bool screen = json_object_get(term, "screen");
    /* Neither guard band nor motion changes the truth; the screen-space bound ends with the guard band. */
    describe_view(c, screen ? aob_case_options(c).guard_band : 0, false, &text);
    aob_text_add(&text, " %d %s %s", m->plan->config->spp, screen ? aob_bound_version : "", line);
    char *path = cache_path(m, "visibility", text.data, ".exr");
    free(line);
    aob_text_finish(&text);
    return path;
}

/* What a case is compared with: the truth, its definition, and the definition within the screen-space bound. A capture
 * has no geometry, so its truth and definition are those of the bound. A technique that draws the scene's triangles is
 * not bound to the screen: it knows all that its definition asks for. NULL: the case has no such term. */
enum term_kind { TERM_TRUTH, TERM_DEFINITION, TERM_SCREEN, TERM_COUNT };

static json_t *make_term(const struct aob_measurement *m, size_t index, enum term_kind kind)
{
    const struct aob_case *c = &m->plan->cases[index];
    const json_t *definition = m->states[index].definition;
    bool captured = c->scene->gbuffer != NULL;
    if (kind != TERM_TRUTH && !definition)
        return NULL;
    json_t *term = kind == TERM_TRUTH
                       ? json_pack("{s:o, s:b, s:n, s:b}", "radius", aob_json_number(c->reference_radius),
                                   "uniform", 0, "falloff", "of_triangle", 0)
                       : json_deep_copy(definition);
    if (captured || (kind == TERM_SCREEN && !m->states[index].triangles))
        json_object_set_new(term, "screen",
                            m->plan->config->thickness < 0 ? json_incref(json_object_get(term, "radius"))
                                                           : aob_json_number(m->plan->config->thickness));
    return term;
}

/* Adds the term to the view's job unless its file is there already; returns that file. */
static char *want_term(struct aob_measurement *m, size_t index, enum term_kind kind, json_t *missing)
{
    const struct aob_case *c = &m->plan->cases[index];
    json_t *term = make_term(m, index, kind);
    if (!term)
        return NULL;
    char *path = term_path(m, c, term);
    bool wanted = aob_file_exists(path);
    for (size_t i = 0; i < json_array_size(missing) && !wanted; i++)
        wanted = strcmp(json_string_value(json_object_get(json_array_get(missing, i), "out")), path) == 0;
    if (!wanted) {
        json_object_set_new(term, "out", json_string(path));
        json_array_append(missing, term);
    }
    json_decref(term);
    return path;
}

static bool same_view(const struct aob_case *a, const struct aob_case *b)
{
    return a->scene == b->scene && a->width == b->width && a->height == b->height;
}

static bool trace_view(struct aob_measurement *m, const struct aob_case *c, const char *mesh,
                       const char *gbuffer, json_t *missing, struct aob_error *error)
{
    int guard = aob_case_options(c).guard_band;
    double rays = (double)c->width * c->height * m->plan->config->spp;
    json_t *job = json_pack("{s:s, s:s, s:b, s:o, s:i, s:i, s:i, s:i, s:s, s:O}", "job", "view",
                            mesh ? "mesh" : "scene", mesh ? mesh : c->scene->name, "captured",
                            c->scene->gbuffer != NULL, "camera", aob_camera_to_json(&c->scene->camera),
                            "width", c->width, "height", c->height, "guard", guard, "spp",
                            m->plan->config->spp, "gbuffer", gbuffer, "terms", missing);
    struct aob_job_desc desc = {.job = job, .timeout_s = 300 + rays / 1e5 * (double)json_array_size(missing)};
    return aob_dispatch_job(m->dispatch, &desc, error) || aob_fail_in(error, "scene '%s'", c->scene->name);
}

/* All terms of the view that the plan still needs are traced at once: one set of rays serves them all. The bound of
 * another guard band is rebuilt from another G-buffer than this job's. */
static void want_whole_view(struct aob_measurement *m, const struct aob_case *c, json_t *missing)
{
    int guard = aob_case_options(c).guard_band;
    for (size_t i = 0; i < m->plan->case_count; i++) {
        const struct aob_case *other = &m->plan->cases[i];
        if (m->states[i].stage != AOB_PENDING || !same_view(c, other))
            continue;
        for (int kind = 0; kind < TERM_COUNT; kind++)
            if (kind != TERM_SCREEN || aob_case_options(other).guard_band == guard)
                free(want_term(m, i, (enum term_kind)kind, missing));
    }
}

bool aob_view_prepare(struct aob_measurement *m, const size_t *indices, size_t count,
                      struct aob_view_files *files, struct aob_error *error)
{
    const struct aob_case *c = &m->plan->cases[indices[0]];
    struct aob_plan_scene *scene = &m->plan->scenes[c->scene - m->plan->scenes];
    int64_t start = aob_clock_wall_ns();
    char *mesh = scene->file ? load_mesh(m, scene, error) : NULL;
    if (scene->file && !mesh)
        return false;
    struct aob_text text = {0};
    json_t *missing = json_array();
    *files = (struct aob_view_files){.count = count, .mesh = mesh};
    files->reference = AOB_NEW_ARRAY(char *, count);
    files->definition = AOB_NEW_ARRAY(char *, count);
    files->screen = AOB_NEW_ARRAY(char *, count);
    describe_view(c, aob_case_options(c).guard_band, true, &text);
    files->gbuffer =
        scene->gbuffer ? aob_strdup(scene->gbuffer) : cache_path(m, "gbuffer", text.data, ".exr");
    for (size_t i = 0; i < count && m->plan->config->measure_error; i++) {
        files->reference[i] = want_term(m, indices[i], TERM_TRUTH, missing);
        files->definition[i] = want_term(m, indices[i], TERM_DEFINITION, missing);
        files->screen[i] = want_term(m, indices[i], TERM_SCREEN, missing);
    }
    bool ok = true;
    if (json_array_size(missing))
        want_whole_view(m, c, missing);
    if (json_array_size(missing) || !aob_file_exists(files->gbuffer))
        ok = trace_view(m, c, mesh, files->gbuffer, missing, error);
    m->shares.reference += (double)(aob_clock_wall_ns() - start) * 1e-9;
    json_decref(missing);
    aob_text_finish(&text);
    if (!ok)
        aob_view_files_finish(files);
    return ok;
}

void aob_view_files_finish(struct aob_view_files *files)
{
    for (size_t i = 0; i < files->count; i++) {
        free(files->reference[i]);
        free(files->definition[i]);
        free(files->screen[i]);
    }
    free(files->reference);
    free(files->definition);
    free(files->screen);
    free(files->gbuffer);
    free(files->mesh);
    *files = (struct aob_view_files){0};
}

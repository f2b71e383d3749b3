#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "check.h"
#include "gbuffer/gbuffer.h"
#include "job/mesh_job.h"
#include "job/view_job.h"
#include "measurement.h"
#include "reference/bound.h"
#include "reference/incident.h"
#include "view.h"

/* Metres. A mesh beyond these is of another unit, or one that a radius of half a metre swallows or hardly touches. */
static const double SHORTEST_MESH = 0.5, LONGEST_MESH = 100;

struct box {
    struct aob_vec3 low, high;
};

static void take_box(void *user, const json_t *object)
{
    struct box *box = user;
    struct aob_mesh_answer answer;
    json_t *warning;
    size_t at;
    if (!aob_mesh_answer_from_json(object, &answer))
        return;
    *box = (struct box){answer.low, answer.high};
    json_array_foreach(answer.warnings, at, warning) aob_warn("%s", json_string_value(warning));
}

/* Nobody sees from a file how long its unit is, and default lengths are metres. */
static void warn_of_unit(const struct aob_plan_scene *scene, const struct box *box)
{
    struct aob_vec3 side = aob_vec_sub(box->high, box->low);
    double longest = fmax(side.x, fmax(side.y, side.z));
    if (!scene->unit_stated && longest > 0 && (longest < SHORTEST_MESH || longest > LONGEST_MESH))
        aob_warn("%s: its unit is taken as a metre, so it is %.3g m across, and default lengths (a radius of "
                 "0.5 m) may not suit it: state metres_per_unit (0.01: centimetres)",
                 scene->name, longest);
}

/* Each mesh is imported once a run, and again if its flat file is removed meanwhile. Limits grow with the file, so a
 * small hostile file cannot loop or allocate for ever. Real meshes take about 0.04 s a megabyte and 20 bytes of memory
 * a byte. */
static bool import_mesh(struct aob_measurement *m, struct aob_plan_scene *scene, const char *path,
                        struct aob_error *error)
{
    struct aob_mesh_job job = {.file = scene->file, .out = path};
    struct box box = {aob_vec(0, 0, 0), aob_vec(0, 0, 0)};
    size_t size = aob_file_size(scene->file);
    if (!aob_cache_has(path, &job.cached, error))
        return false;
    struct aob_job_desc desc = {.job = aob_mesh_job_to_json(&job),
                                .timeout_s = 10 + 2e-6 * (double)size,
                                .memory_limit = ((size_t)1 << 30) + 64 * size,
                                .on_answer = take_box,
                                .user = &box,
                                .file = scene->file};
    if (!aob_dispatch_job(m->dispatch, &desc, error))
        return false;
    warn_of_unit(scene, &box);
    if (scene->framed)
        scene->camera = aob_scene_framing(box.low, box.high);
    scene->loaded = true;
    return true;
}

static char *load_mesh(struct aob_measurement *m, struct aob_plan_scene *scene, struct aob_error *error)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s %s", scene->digest, aob_mesh_flat_version);
    char *path = aob_cache_path(&m->cache, "mesh", text.data, ".mesh");
    aob_text_finish(&text);
    if ((scene->loaded && aob_file_exists(path)) || import_mesh(m, scene, path, error))
        return path;
    free(path);
    return NULL;
}

/* What a capture shows has no geometry, so all of its references are those of the screen-space bound. */
static void bind_to_screen(const struct aob_measurement *m, json_t *term)
{
    double thickness = m->plan->config->thickness;
    aob_term_set_bound(term, thickness < 0 ? aob_json_to_number(json_object_get(term, "radius")) : thickness);
}

/* Adds the term to the view's job unless its file is there already; returns that file. Takes the term. */
static char *want_term(struct aob_measurement *m, const struct aob_case *c,
                       const struct aob_view_moment *moment, json_t *term, struct aob_view_missing *missing)
{
    char *path = aob_view_term_path(m, c, moment, term);
    bool known = json_object_get(missing->known, path), has;
    json_object_set_new(missing->known, path, json_true());
    if (!known && aob_cache_has(path, &has, &missing->shut) && !has) {
        json_object_set_new(term, "out", aob_json_path(path));
        json_array_append(missing->terms, term);
    }
    json_decref(term);
    return path;
}

char *aob_view_want_truth(struct aob_measurement *m, const struct aob_case *c,
                          const struct aob_view_moment *moment, const struct aob_view_truth *truth,
                          struct aob_view_missing *missing)
{
    json_t *term = aob_term_to_json(&(struct aob_term){
        .radius = truth->target->radius, .uniform = truth->target->uniform, .bent = truth->bent});
    if (c->scene->gbuffer)
        bind_to_screen(m, term);
    return want_term(m, c, moment, term, missing);
}

/* Of what is scored. */
static char *want_truth(struct aob_measurement *m, const struct aob_case *c, const struct aob_target *target,
                        bool bent, struct aob_view_missing *missing)
{
    const struct aob_view_moment last = aob_view_moment_last(c->scene);
    return aob_view_want_truth(m, c, &last, &(struct aob_view_truth){target, bent}, missing);
}

/* What a case claims to compute, traced freely, or within the screen-space bound. A technique that draws the scene's
 * triangles is not limited to the depth buffer, so its bound is the scene itself. NULL: it claims nothing. */
static char *want_claim(struct aob_measurement *m, size_t index, bool bound, struct aob_view_missing *missing)
{
    const struct aob_state *state = &m->states[index];
    const struct aob_case *c = &m->plan->cases[index];
    const struct aob_view_moment last = aob_view_moment_last(c->scene);
    if (!state->definition)
        return NULL;
    json_t *term = json_deep_copy(state->definition);
    if (c->scene->gbuffer || (bound && !state->triangles))
        bind_to_screen(m, term);
    return want_term(m, c, &last, term, missing);
}

static bool gives_bent_normal(const struct aob_state *state)
{
    return state->outputs >> AOB_OUT_BENT_NORMAL & 1;
}

/* The truths of the outputs that have files of their own. A capture has no surfaces to trace them. */
static void want_effects(struct aob_measurement *m, const struct aob_case *c, const struct aob_target *target,
                         unsigned outputs, char *truth[AOB_OUTPUT_COUNT], struct aob_view_missing *missing)
{
    const struct aob_view_moment last = aob_view_moment_last(c->scene);
    for (int which = AOB_OUT_VISIBILITY_RGB; which < AOB_OUTPUT_COUNT; which++)
        if (outputs >> which & 1 && !c->scene->gbuffer)
            truth[which] = want_term(m, c, &last,
                                     aob_term_to_json(&(struct aob_term){.radius = target->radius,
                                                                         .output = (enum aob_output)which,
                                                                         .bounces = AOB_TRUTH_BOUNCES,
                                                                         .light = c->scene->light}),
                                     missing);
}

struct aob_job_view aob_job_view_of(const struct aob_case *c, const struct aob_view_files *files)
{
    return (struct aob_job_view){.mesh = files->mesh,
                                 .scene = c->scene->name,
                                 .captured = c->scene->gbuffer != NULL,
                                 .camera = c->scene->camera,
                                 .frame = aob_view_moment_last(c->scene).frame,
                                 .width = c->width,
                                 .height = c->height,
                                 .guard = aob_case_options(c).guard_band,
                                 .gbuffer = files->gbuffer,
                                 .light = c->scene->light};
}

/* The worker judges what it needs. This is for what it did not foresee, and adds what a process takes in addresses
 * alone: 0.4 GB were measured, and each thread has a stack and an arena. */
size_t aob_view_memory_limit(void)
{
    size_t memory = aob_machine_memory(), more = ((size_t)1 << 30) + ((size_t)aob_machine_cores() << 27);
    return memory < SIZE_MAX - more ? memory + more : 0;
}

bool aob_view_trace(struct aob_measurement *m, const struct aob_case *c, const struct aob_job_view *view,
                    bool cast, json_t *terms, struct aob_error *error)
{
    int spp = m->plan->config->spp;
    if (m->on_work)
        m->on_work(m->user, (size_t)(c - m->plan->cases), "tracing");
    double rays = (double)c->width * c->height * spp;
    struct aob_job_desc desc = {.job = aob_view_job_to_json(view, spp, cast, json_incref(terms)),
                                .timeout_s = 300 + rays / 1e5 * (double)json_array_size(terms),
                                .memory_limit = aob_view_memory_limit()};
    return aob_dispatch_job(m->dispatch, &desc, error) || aob_fail_in(error, "scene '%s'", c->scene->name);
}

/* A view is what one job serves: the screen-space bound ends with the guard band. */
static bool same_view(const struct aob_case *a, const struct aob_case *b)
{
    return a->scene == b->scene && a->width == b->width && a->height == b->height &&
           aob_case_options(a).guard_band == aob_case_options(b).guard_band;
}

/* Its first place in by_view. */
size_t aob_view_number(const struct aob_measurement *m, size_t index)
{
    const struct aob_case *cases = m->plan->cases;
    size_t first = m->place[index];
    while (first > 0 && same_view(&cases[index], &cases[m->by_view[first - 1]]))
        first--;
    return first;
}

/* All terms of the view that the plan still needs are traced at once: one set of rays serves them all. */
static void want_whole_view(struct aob_measurement *m, size_t index, struct aob_view_missing *missing)
{
    const struct aob_case *cases = m->plan->cases, *c = &cases[index];
    bool wanted[2] = {false, false}; /* truths without and with their mean open directions */
    unsigned outputs = 0;
    for (size_t i = aob_view_number(m, index); i < m->plan->case_count; i++) {
        size_t at = m->by_view[i];
        if (!same_view(c, &cases[at]))
            break;
        if (m->states[at].stage != AOB_PENDING)
            continue;
        wanted[gives_bent_normal(&m->states[at])] = true;
        outputs |= m->states[at].outputs;
        free(want_claim(m, at, false, missing));
        free(want_claim(m, at, true, missing));
    }
    for (int bent = 0; bent < 2; bent++)
        for (size_t t = 0; wanted[bent] && t < c->scene->target_count; t++)
            free(want_truth(m, c, &c->scene->targets[t], bent, missing));
    for (size_t t = 0; t < c->scene->target_count; t++) {
        char *truth[AOB_OUTPUT_COUNT] = {NULL};
        want_effects(m, c, &c->scene->targets[t], outputs, truth, missing);
        for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
            free(truth[which]);
    }
}

static bool make_files(struct aob_measurement *m, const size_t *indices, struct aob_view_files *files,
                       struct aob_view_missing *missing, struct aob_error *error)
{
    const struct aob_case *c = &m->plan->cases[indices[0]];
    bool has;
    if (!aob_cache_has(files->gbuffer, &has, error))
        return false;
    if (!has && c->scene->gbuffer)
        return aob_fail(error, "%s: what was read of the capture is lost: run again", files->gbuffer);
    for (size_t t = 0; t < files->target_count; t++) {
        const struct aob_target *target = &c->scene->targets[t];
        files->truth[t][AOB_OUT_VISIBILITY] = want_truth(m, c, target, files->bent, missing);
        want_effects(m, c, target, files->outputs, files->truth[t], missing);
    }
    for (size_t i = 0; i < files->count && files->target_count; i++) {
        files->definition[i] = want_claim(m, indices[i], false, missing);
        files->screen[i] = want_claim(m, indices[i], true, missing);
    }
    if (json_array_size(missing->terms))
        want_whole_view(m, indices[0], missing);
    if (*missing->shut.text)
        return aob_fail(error, "%s", missing->shut.text);
    const struct aob_job_view view = aob_job_view_of(c, files);
    return (has && !json_array_size(missing->terms)) ||
           aob_view_trace(m, c, &view, !has, missing->terms, error);
}

static bool prepare(struct aob_measurement *m, const size_t *indices, size_t count,
                    struct aob_view_files *files, struct aob_error *error)
{
    const struct aob_case *c = &m->plan->cases[indices[0]];
    struct aob_plan_scene *scene = &m->plan->scenes[c->scene - m->plan->scenes];
    char *mesh = scene->file ? load_mesh(m, scene, error) : NULL;
    if (scene->file && !mesh)
        return false;
    struct aob_view_missing missing = {.terms = json_array(), .known = json_object()};
    const struct aob_view_moment last = aob_view_moment_last(scene);
    *files = (struct aob_view_files){.mesh = mesh,
                                     .gbuffer = aob_view_gbuffer_path(m, c, &last),
                                     .truth = aob_alloc(scene->target_count, sizeof *files->truth),
                                     .target_count = scene->target_count,
                                     .definition = AOB_NEW_ARRAY(char *, count),
                                     .screen = AOB_NEW_ARRAY(char *, count),
                                     .count = count};
    for (size_t i = 0; i < count; i++)
        files->outputs |= m->states[indices[i]].outputs;
    files->bent = files->outputs >> AOB_OUT_BENT_NORMAL & 1;
    bool ok = make_files(m, indices, files, &missing, error) && aob_view_prepare_poses(m, c, files, error);
    json_decref(missing.terms);
    json_decref(missing.known);
    if (ok)
        aob_check_view(m, indices[0], files);
    else
        aob_view_files_finish(files);
    return ok;
}

/* A view that failed once would fail again for each of its blocks, and may take minutes each time. */
bool aob_view_prepare(struct aob_measurement *m, const size_t *indices, size_t count,
                      struct aob_view_files *files, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    char view[24];
    snprintf(view, sizeof view, "%zu", aob_view_number(m, indices[0]));
    const char *failed = json_string_value(json_object_get(m->failed_views, view));
    if (failed)
        return aob_fail(error, "%s", failed);
    bool ok = aob_cache_keep(&m->cache, error) && prepare(m, indices, count, files, error);
    if (!ok)
        json_object_set_new(m->failed_views, view, json_string(error->text));
    m->shares.reference += (double)(aob_clock_wall_ns() - start) * 1e-9;
    return ok;
}

void aob_view_files_finish(struct aob_view_files *files)
{
    for (size_t t = 0; t < files->target_count; t++)
        for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
            free(files->truth[t][which]);
    for (size_t i = 0; i < files->count; i++) {
        free(files->definition[i]);
        free(files->screen[i]);
    }
    aob_view_poses_finish(files);
    free(files->truth);
    free(files->definition);
    free(files->screen);
    free(files->gbuffer);
    free(files->mesh);
    *files = (struct aob_view_files){0};
}

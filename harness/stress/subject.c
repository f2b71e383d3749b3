#include "subject.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "frame/frame.h"
#include "technique/graph.h"
#include "technique/param.h"

void aob_subject_init(struct aob_subject *subject, const struct aob_technique *technique, struct aob_gpu *gpu)
{
    *subject = (struct aob_subject){.technique = technique, .gpu = gpu};
    aob_programs_init(&subject->programs, gpu);
}

void aob_subject_finish(struct aob_subject *subject)
{
    aob_programs_finish(&subject->programs);
}

bool aob_subject_has(const struct aob_subject *subject, const char *param)
{
    return aob_param_find(subject->technique->params, subject->technique->param_count, param);
}

struct aob_pass_graph *aob_subject_lay(const struct aob_subject *subject, uint32_t wanted)
{
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    if (aob_subject_values(subject, &(struct aob_shot){0}, values, &options, NULL) &&
        aob_graph_build(graph, subject->technique, values, wanted, NULL))
        return graph;
    free(graph);
    return NULL;
}

bool aob_subject_gives(const struct aob_subject *subject, enum aob_output which)
{
    struct aob_pass_graph *graph = aob_subject_lay(subject, 1u << which);
    bool gives = graph && aob_graph_gives(graph, which);
    free(graph);
    return gives;
}

bool aob_subject_draws_triangles(const struct aob_subject *subject)
{
    struct aob_pass_graph *graph = aob_subject_lay(subject, 0);
    bool draws = graph && aob_graph_needs_triangles(graph);
    free(graph);
    return draws;
}

/* One word of `set` into the number that it is for. */
static bool set_number(const struct aob_param *param, const char *text, double *value,
                       struct aob_error *error)
{
    double number;
    if (param->choices || !aob_parse_double(text, &number))
        return aob_param_parse(param, text, value, error) || aob_fail_in(error, "%s", param->name);
    *value = fmin(fmax(number, param->min), param->max);
    return aob_param_obeys(param, *value) ||
           aob_fail(error, "%s: %s is not %s", param->name, text, aob_param_rule(param));
}

struct numbers {
    double params[AOB_MAX_PARAM], options[AOB_OPTION_COUNT];
};

/* Properties set a parameter of whoever has it, so a word that some technique of ours has is no mistake. */
static bool is_shared_word(const char *word)
{
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (aob_param_find((*t)->params, (*t)->param_count, word))
            return true;
    return false;
}

static bool set_word(const struct aob_subject *subject, char *word, struct numbers *numbers,
                     struct aob_error *error)
{
    const struct aob_technique *t = subject->technique;
    char *text = strchr(word, '=');
    if (!text)
        return aob_fail(error, "'%s' is not NAME=VALUE", word);
    *text++ = '\0';
    const struct aob_param *param = aob_param_find(t->params, t->param_count, word);
    if (param)
        return set_number(param, text, &numbers->params[param - t->params], error);
    const struct aob_param *option = aob_param_find(aob_option_params, AOB_OPTION_COUNT, word);
    if (option)
        return set_number(option, text, &numbers->options[option - aob_option_params], error);
    return is_shared_word(word) ||
           aob_fail(error, "'%s' is no run option and no technique's parameter", word);
}

static bool set_words(const struct aob_subject *subject, const char *set, struct numbers *numbers,
                      struct aob_error *error)
{
    char *copy = aob_strdup(set), *rest = copy;
    bool ok = true;
    for (char *word; ok && (word = strsep(&rest, " "));)
        ok = !*word || set_word(subject, word, numbers, error);
    free(copy);
    return ok;
}

static void set_lengths(const struct aob_technique *technique, double radius, double *numbers)
{
    const struct aob_param *params = technique->params,
                           *param = aob_param_find(params, technique->param_count, "radius");
    double metre = radius > 0 && param && param->initial > 0 ? radius / param->initial : 1;
    aob_param_defaults(params, technique->param_count, metre, numbers);
}

bool aob_subject_values(const struct aob_subject *subject, const struct aob_shot *shot, void *values,
                        struct aob_options *options, struct aob_error *error)
{
    const struct aob_technique *technique = subject->technique;
    struct numbers numbers;
    set_lengths(technique, shot->radius, numbers.params);
    aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, 1, numbers.options);
    if (shot->set && !set_words(subject, shot->set, &numbers, error))
        return false;
    aob_param_pack(technique->params, technique->param_count, numbers.params, values, 4 * AOB_MAX_PARAM);
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, numbers.options, options, sizeof *options);
    return true;
}

static bool read_frame(struct aob_frame *frame, struct aob_reading *reading, struct aob_error *error)
{
    bool ok = true;
    reading->bytes = frame->memory_bytes;
    for (int which = 0; ok && which < AOB_OUTPUT_COUNT; which++) {
        enum aob_output output = (enum aob_output)which;
        ok = !reading->of[which] ||
             aob_frame_read(frame, output, aob_output_components(output), reading->of[which], error);
    }
    return ok;
}

/* The triangles are uploaded for techniques that draw them only. */
static bool draw_frame(struct aob_subject *subject, const struct aob_shot *shot,
                       const struct aob_frame_desc *desc, struct aob_screen *screen,
                       struct aob_reading *reading, bool *unfit, struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_geometry geometry = shot->exhibit->geometry;
    bool triangles = aob_subject_draws_triangles(subject);
    bool ok = !triangles || aob_geometry_upload(&geometry, subject->gpu, error);
    screen->geometry = triangles ? &geometry : NULL;
    if (shot->light) {
        const struct aob_frame_axes axes = aob_camera_axes(&shot->exhibit->camera);
        aob_light_turn(shot->light, &axes, &screen->light);
    }
    ok = ok && aob_frame_init_desc(frame, screen, desc, error);
    *unfit = frame->unfit;
    ok = ok && aob_frame_run(frame, shot->runs > 0 ? shot->runs : 1, NULL, error) &&
         read_frame(frame, reading, error);
    aob_frame_finish(frame);
    aob_gpu_texture_destroy(subject->gpu, geometry.texture);
    free(frame);
    return ok;
}

bool aob_subject_draw(struct aob_subject *subject, const struct aob_shot *shot, struct aob_reading *reading,
                      bool *unfit, struct aob_error *error)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_screen screen;
    const char *why = NULL;
    *unfit = false;
    if (!aob_subject_values(subject, shot, values, &options, error))
        return false;
    if (subject->technique->check && !subject->technique->check(values, &why)) {
        *unfit = true;
        return aob_fail(error, "%s: %s", subject->technique->name, why ? why : "its check() refuses");
    }
    bool ok = aob_screen_init(&screen, subject->gpu, &shot->exhibit->gbuffer, &options, error);
    *unfit = screen.unfit;
    const struct aob_frame_desc desc = {.technique = subject->technique,
                                        .values = values,
                                        .fetch = (enum aob_fetch)options.fetch,
                                        .wanted = aob_options_wanted(&options),
                                        .programs = &subject->programs};
    ok = ok && draw_frame(subject, shot, &desc, &screen, reading, unfit, error);
    aob_screen_finish(&screen);
    return ok;
}

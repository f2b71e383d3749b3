#include "canvas.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "scene/scene.h"
#include "technique/param.h"
#include "technique/registry.h"

static bool load_triangles(struct aob_canvas *canvas, struct aob_error *error)
{
    const struct aob_scene_info *scene = aob_scene_find(canvas->view->scene);
    struct aob_mesh mesh = {0};
    if (!scene || !scene->build)
        return aob_fail(error, "'%s' is no procedural scene", canvas->view->scene);
    scene->build(&mesh);
    aob_geometry_init(&canvas->geometry, &mesh, &canvas->view->camera);
    aob_mesh_finish(&mesh);
    return aob_geometry_upload(&canvas->geometry, canvas->gpu, error);
}

bool aob_canvas_init(struct aob_canvas *canvas, struct aob_gpu *gpu, const struct aob_check_view *view,
                     struct aob_error *error)
{
    const struct aob_gbuffer_desc desc = {&view->camera, view->width, view->height, 0, false};
    *canvas = (struct aob_canvas){.gpu = gpu, .view = view};
    if (aob_gbuffer_load(&canvas->gbuffer, view->file, &desc, error) && load_triangles(canvas, error))
        return true;
    aob_canvas_finish(canvas);
    return false;
}

void aob_canvas_finish(struct aob_canvas *canvas)
{
    aob_screen_finish(&canvas->screen);
    aob_geometry_finish(&canvas->geometry);
    aob_gbuffer_finish(&canvas->gbuffer);
    *canvas = (struct aob_canvas){0};
}

static bool read_value(const struct aob_param *param, const json_t *json, double *value,
                       struct aob_error *error)
{
    struct aob_text text = {0};
    if (json_is_string(json))
        aob_text_add(&text, "%s", json_string_value(json));
    else
        aob_text_add(&text, "%.17g", json_number_value(json));
    bool ok = aob_param_parse(param, text.data, value, error);
    aob_text_finish(&text);
    return ok;
}

static bool read_values(const struct aob_param *params, size_t count, double metre, const json_t *object,
                        double *values, struct aob_error *error)
{
    aob_param_defaults(params, count, metre, values);
    for (size_t i = 0; i < count; i++) {
        const json_t *json = json_object_get(object, params[i].name);
        if (json && !read_value(&params[i], json, &values[i], error))
            return false;
    }
    return true;
}

static bool use_screen(struct aob_canvas *canvas, const json_t *options, struct aob_error *error)
{
    double values[AOB_OPTION_COUNT];
    struct aob_options wanted;
    if (!read_values(aob_option_params, AOB_OPTION_COUNT, canvas->view->metre, options, values, error))
        return false;
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, values, &wanted, sizeof wanted);
    if (canvas->screen.gpu && memcmp(&wanted, &canvas->options, sizeof wanted) == 0)
        return true;
    aob_screen_finish(&canvas->screen);
    if (!aob_screen_init(&canvas->screen, canvas->gpu, &canvas->gbuffer, &wanted, error))
        return false;
    canvas->screen.geometry = &canvas->geometry;
    canvas->options = wanted;
    return true;
}

static const struct aob_technique *find_technique(const char *name, struct aob_error *error)
{
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (strcmp((*t)->name, name) == 0)
            return *t;
    aob_fail(error, "there is no technique '%s'", name);
    return NULL;
}

bool aob_canvas_show(struct aob_canvas *canvas, const struct aob_check_drawing *drawing,
                     struct aob_frame *frame, struct aob_error *error)
{
    const struct aob_technique *technique = find_technique(drawing->technique, error);
    double numbers[AOB_MAX_PARAM];
    unsigned char values[4 * AOB_MAX_PARAM];
    *frame = (struct aob_frame){0};
    if (!technique ||
        !read_values(technique->params, technique->param_count, canvas->view->metre, drawing->params, numbers,
                     error) ||
        !use_screen(canvas, drawing->options, error))
        return false;
    canvas->screen.light = drawing->light;
    aob_param_pack(technique->params, technique->param_count, numbers, values, sizeof values);
    const struct aob_frame_desc desc = {.technique = technique,
                                        .values = values,
                                        .fetch = (enum aob_fetch)canvas->options.fetch,
                                        .wanted = aob_options_wanted(&canvas->options)};
    return aob_frame_init_desc(frame, &canvas->screen, &desc, error);
}

bool aob_canvas_draw(struct aob_frame *frame, int frames, struct aob_error *error)
{
    unsigned char values[sizeof frame->values];
    bool ok = true;
    memcpy(values, frame->values, sizeof values);
    for (int i = 0; ok && i < frames; i++)
        ok = aob_frame_set(frame, i, values, error) && aob_frame_run(frame, 1, NULL, error);
    return ok;
}

#include "gallery.h"
#include "base/child.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include <stdlib.h>
#include <string.h>

struct drawing {
    struct aob_gallery *gallery;
    const char *out;
    size_t *order; /* of the figures in the job */
    size_t reported;
};

/* What needs OpenGL comes last, so that a driver that crashes takes nothing else with it. */
static bool needs_opengl(const struct aob_figure *figure)
{
    return figure->kind == AOB_FIGURE_HEIGHT ||
           ((figure->kind == AOB_FIGURE_CHART || figure->kind == AOB_FIGURE_CACHE ||
             figure->kind == AOB_FIGURE_OVER_TIME) &&
            strstr(figure->file, ".png") != NULL);
}

static void order_figures(struct drawing *d)
{
    size_t used = 0;
    for (int last = 0; last < 2; last++)
        for (size_t i = 0; i < d->gallery->count; i++)
            if (needs_opengl(&d->gallery->figures[i]) == last)
                d->order[used++] = i;
}

static char *job_text(const struct drawing *d)
{
    json_t *list = json_array();
    for (size_t i = 0; i < d->gallery->count; i++) {
        struct aob_figure *figure = &d->gallery->figures[d->order[i]];
        char *path = aob_path_join(d->out, figure->file);
        json_object_set_new(figure->job, "out", json_string(path));
        json_array_append(list, figure->job);
        free(path);
    }
    json_t *job = json_pack("{s:o}", "figures", list);
    char *text = json_dumps(job, JSON_COMPACT);
    json_decref(job);
    return text;
}

static void take_report(void *user, const char *line)
{
    struct drawing *d = user;
    json_t *report = json_loads(line, 0, NULL);
    if (json_is_object(report) && d->reported < d->gallery->count) {
        struct aob_figure *figure = &d->gallery->figures[d->order[d->reported++]];
        const char *failure = json_string_value(json_object_get(report, "error"));
        free(figure->failure);
        figure->failure = aob_strdup(failure);
    }
    json_decref(report);
}

static void fail_all(struct aob_gallery *g, const char *why)
{
    for (size_t i = 0; i < g->count; i++) {
        free(g->figures[i].failure);
        g->figures[i].failure = aob_strdup(why);
    }
}

static void run_plotter(struct drawing *d, const char *plotter, const char *job)
{
    const char *const argv[] = {plotter, NULL};
    struct aob_child_desc desc = {
        .argv = argv,
        .input = job,
        .input_size = strlen(job),
        .timeout_s = 60 + 10 * (double)d->gallery->count,
        .on_line = take_report,
        .user = d,
    };
    struct aob_child_result result = {0};
    struct aob_error error = {0};
    char why[600] = "";
    if (!aob_child_run(&desc, &result, &error)) {
        fail_all(d->gallery, error.text);
        return;
    }
    if (d->reported == d->gallery->count)
        return;
    aob_child_explain(&desc, &result, why, sizeof why);
    for (size_t i = d->reported; i < d->gallery->count; i++) {
        free(d->gallery->figures[d->order[i]].failure);
        d->gallery->figures[d->order[i]].failure = aob_strdup(why);
    }
}

char *aob_gallery_plotter(const char *program)
{
    if (!program)
        return NULL;
    const char *slash = strrchr(program, '/');
    struct aob_text path = {0};
    aob_text_add(&path, "%.*saobudget-plot", slash ? (int)(slash - program + 1) : 0, program);
    if (!aob_file_exists(path.data))
        aob_text_finish(&path);
    return path.data;
}

void aob_gallery_draw(struct aob_gallery *g, const char *plotter, const char *out)
{
    struct drawing d = {.gallery = g, .out = out, .order = AOB_NEW_ARRAY(size_t, g->count)};
    struct aob_error error = {0};
    char *folder = aob_path_join(out, g->folder);
    if (!plotter)
        fail_all(g, "aobudget-plot is not there (built without VTK?)");
    else if (!aob_folder_create(folder, &error))
        fail_all(g, error.text);
    else if (g->count) {
        order_figures(&d);
        char *job = job_text(&d);
        if (job)
            run_plotter(&d, plotter, job);
        else
            fail_all(g, "the figures could not be described as JSON");
        free(job);
    }
    free(folder);
    free(d.order);
}

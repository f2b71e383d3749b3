#include "gallery.h"
#include <ctype.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"

void aob_gallery_plain_name(char *name)
{
    for (char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_')
            *c = '-';
}

static char *file_name(const struct aob_gallery *g, size_t section, const char *name, const char *end)
{
    struct aob_text text = {0};
    const struct aob_section *s = &g->rows->sections[section];
    aob_text_add(&text, "%.40s-%.40s-%.60s", s->scene, s->view, name);
    aob_gallery_plain_name(text.data);
    struct aob_text file = {0};
    aob_text_add(&file, "%s/%04zu-%s%s", g->folder, g->count, text.data, end);
    aob_text_finish(&text);
    return file.data;
}

struct aob_figure *aob_gallery_add(struct aob_gallery *g, const struct aob_panel *panel,
                                   enum aob_figure_kind kind, const char *name, const char *end, json_t *job)
{
    static const char *const kinds[] = {"triptych", "map", "split", "height", "vti",
                                        "triptych", "map", "chart", "chart",  "chart"};
    char *file = file_name(g, panel->section, name, end);
    struct aob_figure *figure = AOB_PUSH(g->figures, g->count, g->capacity);
    if (!job) /* a path that is no UTF-8; the figure will say that it has no image */
        job = json_object();
    json_object_set_new(job, "kind", json_string(kinds[kind]));
    *figure = (struct aob_figure){
        .kind = kind, .section = panel->section, .target = panel->target, .file = file, .job = job};
    figure->title = aob_member_text(job, "title");
    return figure;
}

void aob_gallery_finish(struct aob_gallery *g)
{
    for (size_t i = 0; i < g->count; i++) {
        free(g->figures[i].file);
        free(g->figures[i].failure);
        free(g->figures[i].front);
        free(g->figures[i].note);
        json_decref(g->figures[i].job);
    }
    free(g->figures);
    free(g->panels);
    *g = (struct aob_gallery){0};
}

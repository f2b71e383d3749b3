#include "cache_map.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "reports/page/gallery.h"

static char *path_of(const struct aob_cache_map_desc *desc, const char *ending)
{
    const char *dot = strrchr(desc->image, '.'), *slash = strrchr(desc->image, '/');
    size_t stem = dot && (!slash || dot > slash) ? (size_t)(dot - desc->image) : strlen(desc->image);
    struct aob_text path = {0};
    aob_text_add(&path, "%.*s-%s%s", (int)stem, desc->image, desc->profile, ending);
    return path.data;
}

static json_t *describe(const struct aob_cache_map_desc *desc, const char *kind)
{
    struct aob_text channel = {0}, subtitle = {0};
    aob_text_add(&channel, "%s.misses", desc->profile);
    aob_text_add(&subtitle, "%s, first level, as many warps in flight as there may be", desc->profile);
    json_t *job = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "kind", kind, "title", desc->title,
                            "subtitle", subtitle.data, "image", desc->image, "error", channel.data, "amount",
                            "misses a pixel", "limit_group", desc->profile);
    aob_text_finish(&channel);
    aob_text_finish(&subtitle);
    return job ? job : json_object();
}

static void add_figure(struct aob_gallery *gallery, const struct aob_cache_map_desc *desc,
                       enum aob_figure_kind figure, const char *kind, const char *ending)
{
    *AOB_PUSH(gallery->figures, gallery->count, gallery->capacity) =
        (struct aob_figure){.kind = figure, .file = path_of(desc, ending), .job = describe(desc, kind)};
}

static void tell(const struct aob_gallery *gallery, const struct aob_cache_map_desc *desc,
                 struct aob_text *out)
{
    struct aob_text files = {0};
    for (size_t i = 0; i < gallery->count; i++)
        if (!gallery->figures[i].failure)
            aob_text_add(&files, ", %s", gallery->figures[i].file);
    aob_text_add_line(out, "%s: misses by pixel are in %s%s", desc->profile, desc->image,
                      files.data ? files.data : "");
    aob_text_finish(&files);
}

static void warn(const struct aob_gallery *gallery, const struct aob_cache_map_desc *desc)
{
    size_t i = 0;
    while (i < gallery->count && !gallery->figures[i].failure)
        i++;
    if (i < gallery->count)
        aob_warn("%s: %s; the numbers are in %s", gallery->figures[i].file, gallery->figures[i].failure,
                 desc->image);
}

void aob_cache_map_draw(const struct aob_cache_map_desc *desc, struct aob_text *out)
{
    struct aob_gallery gallery = {.folder = ""};
    char *plotter = aob_gallery_plotter(desc->program);
    add_figure(&gallery, desc, AOB_FIGURE_MAP, "map", ".png");
    add_figure(&gallery, desc, AOB_FIGURE_VTI, "vti", ".vti");
    aob_gallery_draw(&gallery, plotter, desc->image[0] == '/' ? "/" : ".");
    warn(&gallery, desc);
    if (out)
        tell(&gallery, desc, out);
    free(plotter);
    aob_gallery_finish(&gallery);
}

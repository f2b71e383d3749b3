#include "cache_map.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "reports/page/gallery.h"

static char *picture_path(const struct aob_cache_map_desc *desc)
{
    const char *dot = strrchr(desc->image, '.'), *slash = strrchr(desc->image, '/');
    size_t stem = dot && (!slash || dot > slash) ? (size_t)(dot - desc->image) : strlen(desc->image);
    struct aob_text path = {0};
    aob_text_add(&path, "%.*s-%s.png", (int)stem, desc->image, desc->profile);
    return path.data;
}

static json_t *describe(const struct aob_cache_map_desc *desc)
{
    struct aob_text channel = {0}, subtitle = {0};
    aob_text_add(&channel, "%s.misses", desc->profile);
    aob_text_add(&subtitle, "%s, first level, as many warps in flight as there may be", desc->profile);
    json_t *job = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "kind", "map", "title", desc->title,
                            "subtitle", subtitle.data, "image", desc->image, "error", channel.data, "amount",
                            "misses a pixel", "limit_group", desc->profile);
    aob_text_finish(&channel);
    aob_text_finish(&subtitle);
    return job ? job : json_object();
}

void aob_cache_map_draw(const struct aob_cache_map_desc *desc)
{
    struct aob_gallery gallery = {.folder = ""};
    char *plotter = aob_gallery_plotter(desc->program);
    struct aob_figure *figure = AOB_PUSH(gallery.figures, gallery.count, gallery.capacity);
    *figure = (struct aob_figure){.kind = AOB_FIGURE_MAP, .file = picture_path(desc), .job = describe(desc)};
    aob_gallery_draw(&gallery, plotter, desc->image[0] == '/' ? "/" : ".");
    if (figure->failure)
        aob_warn("%s: %s; the numbers are in %s", figure->file, figure->failure, desc->image);
    free(plotter);
    aob_gallery_finish(&gallery);
}

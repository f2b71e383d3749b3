#include <math.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "frame/raster.h"
#include "scene/mesh.h"
#include "store/image.h"
#include "drawing.h"

/* The canonical G-buffer with its primitives, which techniques and scores do not read. */
static bool load_canonical(const char *path, struct aob_hits *hits, struct aob_error *error)
{
    struct aob_image image = {0};
    if (!aob_image_read(&image, path, error))
        return false;
    static const char *const names[3] = {"N.X", "N.Y", "N.Z"};
    const float *z = aob_image_channel(&image, "Z"), *primitive = aob_image_channel(&image, "primitive"),
                *normal[3];
    size_t count = (size_t)image.width * (size_t)image.height;
    bool ok = z && primitive;
    for (int c = 0; c < 3; c++)
        ok = (normal[c] = aob_image_channel(&image, names[c])) && ok;
    *hits = (struct aob_hits){.width = image.width, .height = image.height};
    hits->primitive = aob_alloc(count, sizeof *hits->primitive);
    hits->depth = aob_alloc(count, sizeof *hits->depth);
    hits->normal = aob_alloc(count, sizeof *hits->normal);
    for (size_t i = 0; ok && i < count; i++) {
        hits->primitive[i] = primitive[i] < 0 ? AOB_NO_PRIMITIVE : (uint32_t)primitive[i];
        hits->depth[i] = z[i];
        for (int c = 0; c < 3; c++)
            hits->normal[i][c] = normal[c][i];
    }
    aob_image_finish(&image);
    return ok || aob_fail(error, "%s: not a G-buffer", path);
}

static json_t *to_json(const struct aob_raster_difference *d)
{
    double edge = d->other ? 1 - (double)d->off_edge / (double)d->other : NAN;
    return json_pack("{s:f, s:o, s:f, s:f, s:f, s:f}", "primitive_share",
                     (double)d->other / (double)d->pixels, "edge_share", aob_json_number(edge), "depth_rmse",
                     d->depth_rmse, "depth_max", d->depth_max, "depth_relative_max", d->depth_relative_max,
                     "normal_max", d->normal_max);
}

bool aob_drawing_draw(struct aob_drawing *drawing, struct aob_error *error)
{
    const struct aob_job_view *view = &drawing->job->view;
    struct aob_hits canonical = {0}, drawn = {0};
    struct aob_raster_difference difference;
    if (!drawing->job->raster)
        return true;
    bool ok = aob_raster_draw(drawing->gpu, &drawing->mesh, &view->camera, &drawing->gbuffer.projection,
                              &drawn, error) &&
              load_canonical(view->gbuffer, &canonical, error);
    if (ok) {
        aob_raster_compare(&canonical, &drawn, &difference);
        aob_gbuffer_init(&drawing->drawn, &drawn, &drawing->gbuffer.projection, view->guard);
        aob_gbuffer_paint(&drawing->drawn, &drawn, &drawing->mesh);
        drawing->difference = to_json(&difference);
    }
    aob_hits_finish(&canonical);
    aob_hits_finish(&drawn);
    return ok;
}

#include "geometry.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

enum { MOST_ROWS = 16384 };

static void set_triangle(const struct aob_mesh *mesh, size_t number, const struct aob_camera *camera,
                         const struct aob_frame_axes *axes, float (*texels)[4])
{
    struct aob_vec3 p[3];
    for (int k = 0; k < 3; k++) {
        struct aob_vec3 v = aob_vec_sub(mesh->positions[mesh->triangles[number][k]], camera->eye);
        p[k] = aob_vec(aob_vec_dot(v, axes->right), aob_vec_dot(v, axes->up), aob_vec_dot(v, axes->back));
    }
    struct aob_vec3 n = aob_vec_normalize(aob_vec_cross(aob_vec_sub(p[1], p[0]), aob_vec_sub(p[2], p[0])));
    bool flat = aob_vec_length(n) > 0.5; /* no area: no direction either */
    double normal[3] = {flat ? n.x : 0, flat ? n.y : 0, flat ? n.z : 0};
    for (int k = 0; k < 3; k++) {
        texels[k][0] = (float)p[k].x;
        texels[k][1] = (float)p[k].y;
        texels[k][2] = (float)p[k].z;
        texels[k][3] = (float)normal[k];
    }
}

static size_t rows_of(size_t count)
{
    return (count + AOB_GEOMETRY_ROW - 1) / AOB_GEOMETRY_ROW;
}

void aob_geometry_init(struct aob_geometry *geometry, const struct aob_mesh *mesh,
                       const struct aob_camera *camera)
{
    struct aob_frame_axes axes = aob_camera_axes(camera);
    *geometry = (struct aob_geometry){.count = mesh->triangle_count};
    geometry->texels = aob_alloc(rows_of(geometry->count) * AOB_GEOMETRY_ROW * AOB_GEOMETRY_TEXELS,
                                 sizeof *geometry->texels);
    for (size_t i = 0; i < geometry->count; i++)
        set_triangle(mesh, i, camera, &axes, geometry->texels + i * AOB_GEOMETRY_TEXELS);
}

/* The size of the texture. */
static size_t bytes_of(const struct aob_geometry *geometry)
{
    return rows_of(geometry->count) * AOB_GEOMETRY_ROW * AOB_GEOMETRY_TEXELS * sizeof *geometry->texels;
}

bool aob_geometry_upload(struct aob_geometry *geometry, struct aob_gpu *gpu, struct aob_error *error)
{
    size_t rows = rows_of(geometry->count);
    if (rows > MOST_ROWS)
        return true; /* aob_geometry_serves refuses what needs it */
    geometry->gpu = gpu;
    const struct aob_gpu_texture_desc desc = {.format = AOB_RGBA32F,
                                              .width = AOB_GEOMETRY_ROW * AOB_GEOMETRY_TEXELS,
                                              .height = (int)rows,
                                              .uses = AOB_GPU_USE_SAMPLED,
                                              .texels = geometry->texels};
    geometry->texture = aob_gpu_texture_create(gpu, &desc, error);
    return geometry->texture || aob_fail_in(error, "the scene's triangles");
}

void aob_geometry_finish(struct aob_geometry *geometry)
{
    if (geometry->gpu)
        aob_gpu_texture_destroy(geometry->gpu, geometry->texture);
    free(geometry->texels);
    *geometry = (struct aob_geometry){0};
}

struct range {
    double low, high;
};

/* The range of the places a/s for a in `a` and s in `s` (s.high > 0), in scene units at distance 1; unbounded where s
 * reaches 0. */
static struct range over(struct range a, struct range s)
{
    double near = s.low > 0 ? s.low : 0;
    return (struct range){a.low < 0 ? a.low / near : a.low / s.high,
                          a.high > 0 ? a.high / near : a.high / s.high};
}

static double pixels_between(struct range q, double size, int divisor)
{
    return fmax(0, ceil(fmin(q.high, size) / divisor) - floor(fmax(q.low, 0) / divisor));
}

static double fragments_of(const float (*corners)[4], const struct aob_projection *view, double reach,
                           int divisor)
{
    struct range box[3];
    for (int c = 0; c < 3; c++) {
        box[c].low = fmin((double)corners[0][c], fmin((double)corners[1][c], (double)corners[2][c])) - reach;
        box[c].high = fmax((double)corners[0][c], fmax((double)corners[1][c], (double)corners[2][c])) + reach;
    }
    struct range distance = {-box[2].high, -box[2].low}, down = {-box[1].high, -box[1].low};
    if (view->perspective && !(distance.high > 0))
        return 0;
    struct range x = view->perspective ? over(box[0], distance) : box[0];
    struct range y = view->perspective ? over(down, distance) : down;
    x = (struct range){x.low / view->sx + view->cx, x.high / view->sx + view->cx};
    y = (struct range){y.low / view->sy + view->cy, y.high / view->sy + view->cy};
    return pixels_between(x, view->width, divisor) * pixels_between(y, view->height, divisor);
}

double aob_geometry_fragments(const struct aob_geometry *geometry, const struct aob_projection *projection,
                              float reach, int divisor)
{
    double sum = 0;
    for (size_t i = 0; i < geometry->count; i++)
        sum += fragments_of((const float(*)[4])(geometry->texels + i * AOB_GEOMETRY_TEXELS), projection,
                            (double)reach, divisor);
    return sum;
}

static bool serves_pass(const struct aob_geometry *geometry, const struct aob_pass_graph *graph,
                        const struct aob_graph_pass *pass, const struct aob_projection *projection,
                        struct aob_error *error)
{
    size_t most = INT32_MAX / pass->per_triangle;
    if (rows_of(geometry->count) > MOST_ROWS || geometry->count > most)
        return aob_fail(error,
                        "pass '%s': the scene's %zu triangles would take %zu MiB and %.3g vertices; at most "
                        "%d triangles and %.3g vertices fit: use a smaller mesh",
                        pass->name, geometry->count, bytes_of(geometry) >> 20,
                        (double)geometry->count * pass->per_triangle, MOST_ROWS * AOB_GEOMETRY_ROW,
                        (double)INT32_MAX);
    double fragments =
        aob_geometry_fragments(geometry, projection, pass->reach, aob_graph_target_divisor(graph, pass));
    return fragments <= AOB_GEOMETRY_FRAGMENTS ||
           aob_fail(error,
                    "pass '%s': %zu triangles with a reach of %g would draw about %.2g fragments a frame "
                    "(some %.0f s on a processor); the limit is %.2g: use a smaller radius, image or mesh, "
                    "or a larger divisor",
                    pass->name, geometry->count, (double)pass->reach, fragments, fragments * 57e-9,
                    AOB_GEOMETRY_FRAGMENTS);
}

bool aob_geometry_serves(const struct aob_geometry *geometry, const struct aob_pass_graph *graph,
                         const struct aob_projection *projection, struct aob_error *error)
{
    for (int p = 0; p < graph->pass_count; p++) {
        const struct aob_graph_pass *pass = &graph->passes[p];
        if (!pass->live || pass->draw != AOB_TRIANGLES)
            continue;
        if (!geometry)
            return aob_fail(error, "pass '%s' needs the scene's triangles, and a capture has none",
                            pass->name);
        if (!serves_pass(geometry, graph, pass, projection, error))
            return false;
    }
    return true;
}

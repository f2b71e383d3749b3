#include "raster.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "frame/texts.h"

/* A triangle's texels, in this order; ROW triangles a row of the texture. */
enum { CORNER, PLANE = 3, SHADING, TEXELS = SHADING + 3, ROW = 2048 };

struct view_block {  /* std140 */
    float scale[4];  /* x, y of clip space a unit of view space (over w) */
    float centre[4]; /* clip-space place of the view axis */
    float ray[4];    /* cx, cy, then view space a pixel, y up */
    float range[4];  /* x: near, or 1/far of an orthographic view; z: whether perspective */
};

struct raster {
    struct aob_gpu *gpu;
    const struct aob_mesh *mesh;
    struct aob_vec3 eye;
    struct aob_frame_axes axes;
    double farthest; /* of the mesh along the view axis, or beside it */
    struct aob_gpu_texture *triangles, *surface, *shaded;
    struct aob_gpu_program *program;
    struct aob_gpu_pass *pass;
};

static struct aob_vec3 turn(const struct raster *raster, struct aob_vec3 v)
{
    return aob_vec(aob_vec_dot(v, raster->axes.right), aob_vec_dot(v, raster->axes.up),
                   aob_vec_dot(v, raster->axes.back));
}

static void set_texel(float texel[4], struct aob_vec3 v, double w)
{
    texel[0] = (float)v.x;
    texel[1] = (float)v.y;
    texel[2] = (float)v.z;
    texel[3] = (float)w;
}

static void set_triangle(struct raster *raster, size_t number, float (*texels)[4])
{
    const struct aob_mesh *mesh = raster->mesh;
    const uint32_t *index = mesh->triangles[number];
    struct aob_vec3 p[3];
    for (int k = 0; k < 3; k++)
        p[k] = turn(raster, aob_vec_sub(mesh->positions[index[k]], raster->eye));
    struct aob_vec3 n = aob_vec_normalize(aob_vec_cross(aob_vec_sub(p[1], p[0]), aob_vec_sub(p[2], p[0])));
    if (!(aob_vec_length(n) > 0.5))
        p[1] = p[2] = p[0]; /* rounding must not give it an area */
    double bounds[3] = {-fmax(p[0].z, fmax(p[1].z, p[2].z)), -fmin(p[0].z, fmin(p[1].z, p[2].z)), 0};
    for (int k = 0; k < 3; k++) {
        set_texel(texels[CORNER + k], p[k], bounds[k]);
        set_texel(texels[SHADING + k], mesh->normals ? turn(raster, mesh->normals[index[k]]) : n, 0);
        raster->farthest = fmax(raster->farthest, aob_vec_length(p[k]));
    }
    set_texel(texels[PLANE], n, aob_vec_dot(n, p[0]));
}

static bool upload(struct raster *raster, struct aob_error *error)
{
    size_t count = raster->mesh->triangle_count, rows = (count + ROW - 1) / ROW;
    float(*texels)[4] = aob_alloc(rows * ROW * TEXELS, sizeof *texels);
    for (size_t i = 0; i < count; i++)
        set_triangle(raster, i, texels + i * TEXELS);
    const struct aob_gpu_texture_desc desc = {.format = AOB_RGBA32F,
                                              .width = ROW * TEXELS,
                                              .height = (int)rows,
                                              .uses = AOB_GPU_USE_SAMPLED,
                                              .texels = texels};
    raster->triangles = aob_gpu_texture_create(raster->gpu, &desc, error);
    free(texels);
    return raster->triangles;
}

static struct view_block describe_view(const struct raster *raster, const struct aob_projection *view)
{
    double range = raster->farthest > 0 ? raster->farthest : 1;
    range = view->perspective ? 0x1p-20 * range : 1 / (1.001 * range);
    return (struct view_block){
        .scale = {(float)(2 / (view->sx * view->width)), (float)(-2 / (view->sy * view->height))},
        .centre = {(float)(2 * view->cx / view->width - 1), (float)(2 * view->cy / view->height - 1)},
        .ray = {(float)view->cx, (float)view->cy, (float)view->sx, (float)-view->sy},
        .range = {(float)range, 0, view->perspective},
    };
}

static bool draw(struct raster *raster, const struct aob_projection *view, struct aob_error *error)
{
    struct view_block block = describe_view(raster, view);
    const struct aob_gpu_bind bind = {.binding = 1, .texture = raster->triangles};
    const struct aob_gpu_texture_desc image = {.format = AOB_RGBA32F,
                                               .width = view->width,
                                               .height = view->height,
                                               .uses = AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK};
    raster->surface = aob_gpu_texture_create(raster->gpu, &image, error);
    raster->shaded = raster->surface ? aob_gpu_texture_create(raster->gpu, &image, error) : NULL;
    if (!raster->shaded)
        return false;
    const struct aob_gpu_target targets[] = {{raster->surface, 0}, {raster->shaded, 0}};
    raster->program = aob_gpu_program_create_geometry(raster->gpu, aob_text_frame_raster_vertex,
                                                      aob_text_frame_raster_fragment, error);
    if (!raster->program)
        return false;
    struct aob_gpu_pass_desc desc = {.program = raster->program,
                                     .binds = &bind,
                                     .bind_count = 1,
                                     .targets = targets,
                                     .target_count = AOB_COUNT(targets),
                                     .uniforms = &block,
                                     .uniform_size = sizeof block,
                                     .vertex_count = (uint32_t)(3 * raster->mesh->triangle_count),
                                     .depth_test = true};
    raster->pass = aob_gpu_pass_create(raster->gpu, &desc, error);
    return raster->pass &&
           aob_gpu_run(raster->gpu, &(struct aob_gpu_run_desc){&raster->pass, 1, 1}, NULL, NULL, error);
}

static bool read_back(struct raster *raster, struct aob_hits *hits, struct aob_error *error)
{
    int width = raster->surface->width, height = raster->surface->height;
    size_t pixels = (size_t)width * (size_t)height;
    float(*surface)[4] = aob_alloc(pixels, sizeof *surface), (*shaded)[4] = aob_alloc(pixels, sizeof *shaded);
    bool ok = aob_gpu_texture_read(raster->gpu, raster->surface, 0, surface, error) &&
              aob_gpu_texture_read(raster->gpu, raster->shaded, 0, shaded, error);
    if (ok) {
        *hits = (struct aob_hits){.width = width, .height = height};
        hits->primitive = aob_alloc(pixels, sizeof *hits->primitive);
        hits->depth = aob_alloc(pixels, sizeof *hits->depth);
        hits->normal = aob_alloc(pixels, sizeof *hits->normal);
        hits->shading = aob_alloc(pixels, sizeof *hits->shading);
    }
    for (size_t i = 0; ok && i < pixels; i++) {
        hits->primitive[i] = shaded[i][3] > 0 ? (uint32_t)shaded[i][3] - 1 : AOB_NO_PRIMITIVE;
        hits->depth[i] = surface[i][3];
        memcpy(hits->normal[i], surface[i], sizeof hits->normal[i]);
        memcpy(hits->shading[i], shaded[i], sizeof hits->shading[i]);
    }
    free(surface);
    free(shaded);
    return ok;
}

bool aob_raster_draw(struct aob_gpu *gpu, const struct aob_mesh *mesh, const struct aob_camera *camera,
                     const struct aob_projection *projection, struct aob_hits *hits, struct aob_error *error)
{
    if (gpu->info.draws_nothing)
        return aob_fail(error,
                        "gbuffer=raster: backend '%s' draws nothing: use another, or gbuffer=canonical",
                        gpu->info.backend);
    if (mesh->triangle_count < 1 || mesh->triangle_count > AOB_RASTER_MAX_TRIANGLES)
        return aob_fail(error,
                        "gbuffer=raster: the mesh has %zu triangles: it must have 1..%d: use canonical",
                        mesh->triangle_count, AOB_RASTER_MAX_TRIANGLES);
    struct raster raster = {.gpu = gpu, .mesh = mesh, .eye = camera->eye, .axes = aob_camera_axes(camera)};
    bool ok = upload(&raster, error) && draw(&raster, projection, error) && read_back(&raster, hits, error);
    aob_gpu_pass_destroy(gpu, raster.pass);
    aob_gpu_program_destroy(gpu, raster.program);
    aob_gpu_texture_destroy(gpu, raster.shaded);
    aob_gpu_texture_destroy(gpu, raster.surface);
    aob_gpu_texture_destroy(gpu, raster.triangles);
    return ok || aob_fail_in(error, "raster G-buffer");
}

static bool at_edge(const struct aob_hits *hits, int x, int y)
{
    uint32_t own = hits->primitive[(size_t)y * (size_t)hits->width + (size_t)x];
    for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < hits->height; v++)
        for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < hits->width; u++)
            if (hits->primitive[(size_t)v * (size_t)hits->width + (size_t)u] != own)
                return true;
    return false;
}

void aob_raster_compare(const struct aob_hits *canonical, const struct aob_hits *drawn,
                        struct aob_raster_difference *difference)
{
    struct aob_raster_difference d = {.pixels = (size_t)canonical->width * (size_t)canonical->height};
    double squares = 0;
    size_t common = 0;
    for (size_t i = 0; i < d.pixels; i++) {
        int x = (int)(i % (size_t)canonical->width), y = (int)(i / (size_t)canonical->width);
        if (canonical->primitive[i] != drawn->primitive[i]) {
            d.other++;
            d.off_edge += !at_edge(canonical, x, y);
        } else if (canonical->primitive[i] != AOB_NO_PRIMITIVE) {
            double e = fabs((double)drawn->depth[i] - (double)canonical->depth[i]);
            squares += e * e;
            common++;
            d.depth_max = fmax(d.depth_max, e);
            d.depth_relative_max = fmax(d.depth_relative_max, e / (double)canonical->depth[i]);
            for (int c = 0; c < 3; c++)
                d.normal_max =
                    fmax(d.normal_max, fabs((double)drawn->normal[i][c] - (double)canonical->normal[i][c]));
        }
    }
    d.depth_rmse = common ? sqrt(squares / (double)common) : 0;
    *difference = d;
}

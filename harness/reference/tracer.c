#include "tracer.h"
#include <stdlib.h>
#include <string.h>
#include <xmmintrin.h>
#include "base/memory.h"
#include "embree_mesh.h"

const char aob_tracer_version[] = "4";

enum { FLUSH_BITS = 0x8040 }; /* flush to zero, denormals are zero */

unsigned aob_float_mode_begin(void)
{
    unsigned mode = _mm_getcsr();
    _mm_setcsr(mode | FLUSH_BITS);
    return mode;
}

void aob_float_mode_end(unsigned mode)
{
    _mm_setcsr(mode);
}

struct aob_vec3 aob_tracer_corners(const struct aob_tracer *tracer, uint32_t triangle,
                                   struct aob_vec3 corner[3])
{
    for (int k = 0; k < 3; k++)
        corner[k] = tracer->points[tracer->triangles[triangle][k]];
    return aob_vec_cross(aob_vec_sub(corner[1], corner[0]), aob_vec_sub(corner[2], corner[0]));
}

const struct aob_material *aob_tracer_material(const struct aob_tracer *tracer, uint32_t triangle)
{
    return &tracer->materials[tracer->material_of ? tracer->material_of[triangle] : 0];
}

static void measure_box(struct aob_tracer *tracer, const struct aob_mesh *mesh)
{
    struct aob_vec3 low, high;
    aob_mesh_bounds(mesh, &low, &high);
    tracer->centre = aob_vec_add(aob_vec_scale(low, 0.5), aob_vec_scale(high, 0.5));
    tracer->half = aob_vec_sub(aob_vec_scale(high, 0.5), aob_vec_scale(low, 0.5));
    double longest = 2 * fmax(tracer->half.x, fmax(tracer->half.y, tracer->half.z));
    tracer->to_unit = 1 / longest;
}

static void copy_mesh(struct aob_tracer *tracer, const struct aob_mesh *mesh)
{
    tracer->vertex_count = mesh->vertex_count;
    tracer->triangle_count = mesh->triangle_count;
    tracer->points = aob_alloc(mesh->vertex_count, sizeof *tracer->points);
    tracer->unit_points = aob_alloc(mesh->vertex_count + 2, sizeof *tracer->unit_points);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        struct aob_vec3 p = aob_vec_sub(mesh->positions[i], tracer->centre);
        tracer->points[i] = p;
        tracer->unit_points[i][0] = (float)(p.x * tracer->to_unit);
        tracer->unit_points[i][1] = (float)(p.y * tracer->to_unit);
        tracer->unit_points[i][2] = (float)(p.z * tracer->to_unit);
    }
    if (mesh->frame > 0) {
        tracer->moving_first = mesh->moving_first;
        tracer->moving_count = mesh->moving_count;
        tracer->step = mesh->step;
    }
    if (mesh->normals) {
        tracer->normals = aob_alloc(mesh->vertex_count, sizeof *tracer->normals);
        memcpy(tracer->normals, mesh->normals, mesh->vertex_count * sizeof *tracer->normals);
    }
    tracer->triangles = aob_alloc(mesh->triangle_count, sizeof *tracer->triangles);
    memcpy(tracer->triangles, mesh->triangles, mesh->triangle_count * sizeof *tracer->triangles);
}

static void copy_materials(struct aob_tracer *tracer, const struct aob_mesh *mesh)
{
    size_t count = mesh->materials ? mesh->material_count : 1;
    tracer->materials = aob_alloc(count, sizeof *tracer->materials);
    memcpy(tracer->materials, mesh->materials ? mesh->materials : &aob_material_default,
           count * sizeof *tracer->materials);
    if (!mesh->materials)
        return;
    tracer->material_of = aob_alloc(mesh->triangle_count, sizeof *tracer->material_of);
    memcpy(tracer->material_of, mesh->material_of, mesh->triangle_count * sizeof *tracer->material_of);
}

static struct aob_vec3 unit_point(const struct aob_tracer *tracer, uint32_t vertex)
{
    const float *p = tracer->unit_points[vertex];
    return aob_vec(p[0], p[1], p[2]);
}

/* Whether the triangle still has an area in Embree's floats and a normal in double precision. */
static bool has_area(const struct aob_tracer *tracer, uint32_t triangle)
{
    const uint32_t *t = tracer->triangles[triangle];
    struct aob_vec3 a = unit_point(tracer, t[0]);
    struct aob_vec3 u = aob_vec_sub(unit_point(tracer, t[1]), a),
                    v = aob_vec_sub(unit_point(tracer, t[2]), a);
    struct aob_vec3 corner[3];
    return aob_vec_length(aob_vec_cross(u, v)) > 0 &&
           aob_vec_length(aob_tracer_corners(tracer, triangle, corner)) > 0;
}

static void keep_solid_triangles(struct aob_tracer *tracer)
{
    tracer->unit_triangles = aob_alloc(tracer->triangle_count + 2, sizeof *tracer->unit_triangles);
    tracer->triangle_of = aob_alloc(tracer->triangle_count, sizeof *tracer->triangle_of);
    for (uint32_t i = 0; i < tracer->triangle_count; i++) {
        if (!has_area(tracer, i))
            continue;
        memcpy(tracer->unit_triangles[tracer->unit_count], tracer->triangles[i], sizeof *tracer->triangles);
        tracer->triangle_of[tracer->unit_count++] = i;
    }
}

static bool build_scene(struct aob_tracer *tracer, struct aob_error *error)
{
    tracer->device = rtcNewDevice(NULL);
    if (!tracer->device)
        return aob_fail(error, "Embree: no device (error %d): is the processor older than SSE2?",
                        (int)rtcGetDeviceError(NULL));
    tracer->scene = rtcNewScene(tracer->device);
    rtcSetSceneFlags(tracer->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(tracer->scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(tracer->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, tracer->unit_points, 0,
                               sizeof *tracer->unit_points, tracer->vertex_count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, tracer->unit_triangles,
                               0, sizeof *tracer->unit_triangles, tracer->unit_count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tracer->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(tracer->scene);
    enum RTCError code = rtcGetDeviceError(tracer->device);
    return code == RTC_ERROR_NONE ||
           aob_fail(error, "Embree: cannot build the scene of %zu triangles (error %d%s)", tracer->unit_count,
                    (int)code, code == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory" : "");
}

struct aob_tracer *aob_tracer_create(const struct aob_mesh *mesh, struct aob_error *error)
{
    if (!aob_mesh_check(mesh, "mesh", error))
        return NULL;
    struct aob_tracer *tracer = AOB_NEW(struct aob_tracer);
    measure_box(tracer, mesh);
    if (!isfinite(tracer->to_unit) || !(tracer->to_unit > 0)) {
        aob_fail(error, "mesh: its extent is zero or beyond double precision: nothing can be traced");
        goto fail;
    }
    copy_mesh(tracer, mesh);
    copy_materials(tracer, mesh);
    keep_solid_triangles(tracer);
    if (!tracer->unit_count) {
        aob_fail(error, "mesh: none of its %zu triangles has an area", tracer->triangle_count);
        goto fail;
    }
    if (build_scene(tracer, error))
        return tracer;
fail:
    aob_tracer_destroy(tracer);
    return NULL;
}

void aob_tracer_destroy(struct aob_tracer *tracer)
{
    if (!tracer)
        return;
    if (tracer->scene)
        rtcReleaseScene(tracer->scene);
    if (tracer->device)
        rtcReleaseDevice(tracer->device);
    free(tracer->unit_points);
    free(tracer->unit_triangles);
    free(tracer->triangle_of);
    free(tracer->points);
    free(tracer->normals);
    free(tracer->triangles);
    free(tracer->materials);
    free(tracer->material_of);
    free(tracer);
}

#include <math.h>
#include "base/memory.h"
#include "groups.h"
#include "sets.h"

/* --- Where a surface faces ------------------------------------------------------------------------------------- */

enum { AZIMUTHS = 8 };

static void ask_planes_alike(struct aob_trial *trial)
{
    struct aob_shot shots[AZIMUTHS];
    const float *images[AZIMUTHS];
    double means[AZIMUTHS], all = 0;
    for (int i = 0; i < AZIMUTHS; i++) {
        const struct aob_plane_desc plane = {
            .tilt_deg = 40, .azimuth_deg = 45 * i, .width = 64, .height = 64};
        shots[i] = (struct aob_shot){.exhibit = aob_set_plane(trial, &plane), .radius = 0.5};
        images[i] = aob_trial_draw(trial, &shots[i]);
        if (!images[i])
            return;
        means[i] = aob_mean_of(shots[i].exhibit, images[i], NULL);
        all += means[i] / AZIMUTHS;
    }
    for (int i = 0; i < AZIMUTHS; i++)
        aob_trial_take(trial, fabs(means[i] - all), &(struct aob_seen){&shots[i], images[i], NULL},
                       "plane tilted by 40 degrees towards azimuth %d: mean %.4f, of all azimuths %.4f",
                       45 * i, means[i], all);
}

/* The pixels of a ball, in sectors about its middle, which is the image's. */
static void ask_caps_alike(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 128);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = {.eye = {0, 0, 4}, .fov_deg = 40}, .width = 128, .height = 128};
    struct aob_shot shot = {.exhibit = aob_trial_exhibit(trial, &desc), .radius = 0.5};
    const float *image = aob_trial_draw(trial, &shot);
    if (!image)
        return;
    double all = aob_mean_of(shot.exhibit, image, NULL);
    for (int s = 0; s < AZIMUTHS; s++) {
        bool *mask = aob_trial_mask(trial, shot.exhibit);
        for (int i = 0; i < 128 * 128; i++)
            mask[i] = (int)floor((atan2(63.5 - i / 128, i % 128 - 63.5) + M_PI) * AZIMUTHS / (2 * M_PI)) == s;
        double mean = aob_mean_of(shot.exhibit, image, mask);
        aob_trial_take(trial, fabs(mean - all), &(struct aob_seen){&shot, image, NULL},
                       "a ball's sector from azimuth %d: mean %.4f, of all %.4f", s * 45 - 180, mean, all);
    }
}

/* Turned away from the camera, towards one azimuth. */
static void ask_tilts_alike(struct aob_trial *trial)
{
    static const double tilts[] = {0, 20, 40, 60};
    double facing = NAN;
    for (size_t i = 0; i < AOB_COUNT(tilts); i++) {
        const struct aob_plane_desc plane = {
            .tilt_deg = tilts[i], .azimuth_deg = 20, .width = 64, .height = 64};
        const struct aob_shot shot = {.exhibit = aob_set_plane(trial, &plane), .radius = 0.5};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL);
        facing = i == 0 ? mean : facing;
        aob_trial_take(trial, fabs(mean - facing), &(struct aob_seen){&shot, image, NULL},
                       "plane tilted by %g degrees: mean %.4f, %.4f facing the camera", tilts[i], mean,
                       facing);
    }
}

static void ask_alike(struct aob_trial *trial)
{
    ask_planes_alike(trial);
    ask_tilts_alike(trial);
    ask_caps_alike(trial);
}

/* --- The same surfaces, made of other triangles -------------------------------------------------------------- */

typedef void change_fn(struct aob_mesh *mesh);

static const struct aob_vec3 origin = {0, 0, 0};

/* The still life, changed: the difference of its images. */
static void take_changed(struct aob_trial *trial, change_fn *change, bool rmse, const char *what)
{
    struct aob_mesh mesh = {0};
    aob_set_still_life(&mesh, 1, origin);
    change(&mesh);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = aob_still_life_camera(1, origin), .width = 96, .height = 64};
    struct aob_shot plain = {.exhibit = aob_set_default(trial), .radius = 0.5, .set = "falloff=0"},
                    changed = {.exhibit = aob_trial_exhibit(trial, &desc), .radius = 0.5, .set = "falloff=0"};
    const float *wanted = aob_trial_draw(trial, &plain), *image = aob_trial_draw(trial, &changed);
    if (!wanted || !image)
        return;
    struct aob_difference d = aob_difference_of(plain.exhibit, image, wanted, NULL);
    aob_trial_take(trial, rmse ? d.rmse : d.most, &(struct aob_seen){&changed, image, wanted},
                   "%s: pixel (%d, %d) is off by %.4f, the mean by %.4f", what, (int)d.at % 96,
                   (int)d.at / 96, d.most, d.mean);
}

/* Corners that coincide, and corners on a line: in space, on a face, and along an edge of one. */
static void add_degenerate(struct aob_mesh *mesh)
{
    uint32_t a = aob_mesh_add_vertex(mesh, aob_vec(-0.5, 0.5, 0.6));
    uint32_t b = aob_mesh_add_vertex(mesh, aob_vec(0.5, 0.5, 0.6));
    uint32_t c = aob_mesh_add_vertex(mesh, aob_vec(0, 0.5, 0.6));
    const uint32_t *first = mesh->triangles[0];
    uint32_t p = first[0], q = first[1];
    aob_mesh_add_triangle(mesh, a, b, c);
    aob_mesh_add_triangle(mesh, a, a, b);
    aob_mesh_add_triangle(mesh, a, a, a);
    aob_mesh_add_triangle(mesh, p, q, q);
    aob_mesh_add_triangle(mesh, p, q, p);
}

static void ask_degenerate(struct aob_trial *trial)
{
    take_changed(trial, add_degenerate, false, "with triangles without area");
}

static void double_faces(struct aob_mesh *mesh)
{
    size_t count = mesh->triangle_count;
    for (size_t i = 0; i < count; i++)
        aob_mesh_add_triangle(mesh, mesh->triangles[i][0], mesh->triangles[i][1], mesh->triangles[i][2]);
}

static void ask_coincident(struct aob_trial *trial)
{
    take_changed(trial, double_faces, false, "with every triangle twice");
}

static void ask_inverted(struct aob_trial *trial)
{
    take_changed(trial, aob_set_turn_faces, true, "with fronts inwards");
}

static uint32_t add_middle(struct aob_mesh *mesh, uint32_t a, uint32_t b)
{
    struct aob_vec3 sum = aob_vec_add(mesh->positions[a], mesh->positions[b]);
    return aob_mesh_add_vertex(mesh, aob_vec_scale(sum, 0.5));
}

/* Each triangle in four. */
static void cut_faces(struct aob_mesh *mesh)
{
    size_t count = mesh->triangle_count;
    for (size_t i = 0; i < count; i++) {
        uint32_t a = mesh->triangles[i][0], b = mesh->triangles[i][1], c = mesh->triangles[i][2];
        uint32_t ab = add_middle(mesh, a, b), bc = add_middle(mesh, b, c), ca = add_middle(mesh, c, a);
        aob_mesh_add_triangle(mesh, ab, b, bc);
        aob_mesh_add_triangle(mesh, ca, bc, c);
        aob_mesh_add_triangle(mesh, ab, bc, ca);
        mesh->triangles[i][1] = ab;
        mesh->triangles[i][2] = ca;
    }
}

static void cut_faces_twice(struct aob_mesh *mesh)
{
    cut_faces(mesh);
    cut_faces(mesh);
}

static void ask_tessellated(struct aob_trial *trial)
{
    take_changed(trial, cut_faces_twice, true, "with every triangle in 16");
}

const struct aob_property aob_properties_faces[] = {
    {.name = "faces_alike",
     .sentence =
         "A surface is not darkened by where it faces: planes and the sides of a ball are alike at every "
         "azimuth, and planes at every tilt up to 60 degrees.",
     .measure = "largest distance of an azimuth's mean from the mean of all, or of a tilt's from none's",
     .source = "https://github.com/mrdoob/three.js/issues/8576",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_alike},
    {.name = "degenerate_faces",
     .sentence = "Triangles without area change nothing.",
     .measure = "largest difference of a pixel",
     .source = "technique.h: the front of a triangle without area is 0",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_degenerate},
    {.name = "coincident_faces",
     .sentence = "A face that lies in the mesh twice has the image of one that lies there once.",
     .measure = "largest difference of a pixel",
     .source = "McGuire: Ambient Occlusion Volumes (2010), Algorithm",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .excuse = aob_excuse_no_triangles,
     .ask = ask_coincident},
    {.name = "inverted_faces",
     .sentence = "A mesh whose fronts are turned inwards has the same image.",
     .measure = "root mean square difference",
     .source = "https://github.com/Unity-Technologies/Graphics/pull/1043",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .excuse = aob_excuse_no_triangles,
     .ask = ask_inverted},
    {.name = "tessellated_faces",
     .sentence = "Faces cut into many triangles have the image of whole ones.",
     .measure = "root mean square difference",
     .source = "technique.h: AOB_DISTANCE_TRIANGLE",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_tessellated},
    {0},
};

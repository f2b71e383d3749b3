#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "reference/incident.h"
#include "rig.h"
#include "score/score.h"
#include "true_inputs.h"

/* gtao's irradiance of a directional light: its zonal functions against quadrature, open surfaces against the closed form, and
 * occluded ones against the traced irradiance. */

enum { ANGLES = 91 };

static bool build_zonal(struct aob_graph *graph, const void *values)
{
    aob_tex open = aob_texture(graph, .name = "open", .format = AOB_RGBA32F);
    aob_tex zonal = aob_texture(graph, .name = "zonal", .format = AOB_R32F);
    int band;
    memcpy(&band, values, sizeof band);
    return aob_pass(graph, .name = "open", .shader = "open", .out = {{.name = "open", .tex = open}}) &&
           aob_pass(graph, .name = "zonal", .shader = "zonal", .reads = AOB_DEPTH | AOB_NORMAL | AOB_LIGHT,
                    .defines = {{"IRRADIANCE_BY", 0}, {"BAND", band}}, .in = {{.name = "open", .tex = open}},
                    .out = {{.name = "zonal", .tex = zonal}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, zonal);
}

/* Integral over the cone of cosine times the zonal harmonic of a band, by Simpson's rule. */
static double zonal_by_quadrature(int band, double alpha)
{
    const int steps = 2000;
    double sum = 0;
    for (int i = 0; i <= steps; i++) {
        double theta = alpha * i / steps, c = cos(theta);
        double y = sqrt((2 * band + 1) / (4 * M_PI)) * (band == 0 ? 1 : band == 1 ? c : 1.5 * c * c - 0.5);
        sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * 2 * M_PI * c * sin(theta) * y;
    }
    return sum * alpha / steps / 3;
}

/* The pass's own functions in front of a main() that writes a coefficient for each degree. */
static void test_zonal_coefficients(void **state)
{
    (void)state;
    struct aob_text text = {0};
    struct aob_rig rig;
    float pixels[ANGLES];
    aob_text_add(
        &text,
        "#define main other\n%s\n#undef main\nvoid main() {\n    zonal = cut_cosine(cos(AOB_PI / 180.0 * "
        "float(aob_pixel.x)))[BAND] + 0.0 * irradiance.x;\n}\n",
        aob_rig_text("gtao", "irradiance"));
    char *start = strstr(text.data, "irradiance = ");
    assert_non_null(start);
    struct aob_text declared = {0};
    aob_text_add(&declared, "vec4 irradiance = vec4(0.0);\n%s", text.data);
    const struct aob_shader shaders[] = {{"open", "void main() { open = vec4(0.0, 0.0, 0.0, 1.0); }\n"},
                                         {"zonal", declared.data},
                                         {NULL, NULL}};
    const struct aob_technique technique = {
        .name = "zonal", .shaders = shaders, .values_size = sizeof(int), .build = build_zonal};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = ANGLES, .height = 1});
    for (int band = 0; band < 3; band++) {
        aob_rig_probe(&rig, gpu, &technique, &band, &(struct aob_options){0}, pixels);
        for (int degree = 0; degree < ANGLES; degree++)
            assert_near(pixels[degree], zonal_by_quadrature(band, degree * M_PI / 180), 1e-6);
    }
    aob_rig_finish(&rig);
    aob_text_finish(&text);
    aob_text_finish(&declared);
    aob_gpu_close(gpu);
}

static const char *const ways[] = {"moments", "zonal", "bent_normal", "visibility", "triple_product"};

static void make_light(const char *name, struct aob_light *light)
{
    struct aob_light_projection projection;
    aob_light_make(aob_light_find(name), &projection);
    *light = projection.light;
}

/* Each way but the triple product, whose cone is cut to nine harmonics, gives an open surface the closed form: at any tilt and
 * in a turned view, at full and half size. */
static void test_open_surfaces(void **state)
{
    (void)state;
    enum { W = 32, H = 18 };
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float ao[W * H], light[W * H][3];
    for (int tilt = 0; tilt < 80; tilt += 26)
        for (size_t way = 0; way < 4; way++) {
            struct aob_rig rig;
            char params[80];
            aob_rig_plane(&rig, &(struct aob_rig_plane){
                                    .width = W, .height = H, .tilt_deg = tilt, .azimuth_deg = 40 + 3 * tilt});
            make_light("sky", &rig.light);
            snprintf(params, sizeof params, "radius=0.5 divisor=%d irradiance_by=%s", tilt % 4 ? 2 : 1,
                     ways[way]);
            aob_rig_run_outputs(&rig, gpu, "gtao", params, AOB_FETCH_SAMPLED,
                                (float *[AOB_OUTPUT_COUNT]){ao, [AOB_OUT_IRRADIANCE] = light[0]});
            struct aob_frame_axes axes = aob_camera_axes(&rig.camera);
            for (int i = 0; i < W * H; i++) {
                if (rig.hits.primitive[i] == AOB_NO_PRIMITIVE)
                    continue;
                const float *n = &rig.gbuffer.normal[4 * i];
                double open[3];
                struct aob_vec3 world =
                    aob_vec_add(aob_vec_scale(axes.right, n[0]),
                                aob_vec_add(aob_vec_scale(axes.up, n[1]), aob_vec_scale(axes.back, n[2])));
                aob_light_irradiance(&rig.light, world, open);
                for (int c = 0; c < 3; c++)
                    assert_near(light[i][c], open[c], 3e-3 * open[c]);
            }
            aob_rig_finish(&rig);
        }
    aob_gpu_close(gpu);
}

enum { W = 320, H = 180, SPP = 128 };

/* The room with the bright window, with its truths of one radius. */
struct room {
    struct aob_rig rig;
    struct aob_visibility visible;
    struct aob_incident truth;
    double radius;
};

static void room_init(struct room *room, double radius)
{
    struct aob_error error = {{0}};
    struct aob_rig *rig = &room->rig;
    aob_rig_scene(rig, "window_room", NULL, W, H, 0);
    make_light("window", &rig->light);
    room->radius = radius;
    const struct aob_visibility_term term = {.radius = radius, .bent = true};
    const struct aob_visibility_desc desc = {.terms = &term, .term_count = 1, .spp = SPP};
    const struct aob_incident_desc incident = {.radius = radius, .light = &rig->light, .spp = SPP};
    if (!aob_tracer_visibility(rig->tracer, &rig->camera, &rig->hits, &desc, &room->visible, &error) ||
        !aob_tracer_incident(rig->tracer, &rig->camera, &rig->hits, &incident, &room->truth, &error))
        fail_msg("%s", error.text);
}

static void room_finish(struct room *room)
{
    aob_visibility_finish(&room->visible);
    aob_incident_finish(&room->truth);
    aob_rig_finish(&room->rig);
}

/* Relative RMSE in band of an irradiance. */
static double error_of(const struct room *room, float (*light)[3])
{
    double square = 0, all = 0;
    for (int i = 0; i < W * H; i++)
        for (int c = 0; c < 3; c++) {
            if (room->rig.hits.primitive[i] == AOB_NO_PRIMITIVE ||
                room->visible.ao[i] >= (float)AOB_BAND_LIMIT)
                continue;
            square += pow((double)light[i][c] - (double)room->truth.rgb[i][c], 2);
            all += pow((double)room->truth.rgb[i][c], 2);
        }
    return sqrt(square / all);
}

static void run_gtao(const struct room *room, struct aob_gpu *gpu, const char *way, float (*light)[3])
{
    float *ao = AOB_NEW_ARRAY(float, W *H);
    char params[120];
    snprintf(params, sizeof params, "radius=%g slices=9 steps=12 irradiance_by=%s", room->radius, way);
    aob_rig_run_outputs(&room->rig, gpu, "gtao", params, AOB_FETCH_SAMPLED,
                        (float *[AOB_OUTPUT_COUNT]){ao, [AOB_OUT_IRRADIANCE] = light[0]});
    free(ao);
}

/* With the traced visibility and bent normal the moments are the best way at every radius. With gtao's own they are better than
 * the text's cone, plain visibility and the triple product; where its visibility is too dark, the look-up may be nearer, whose
 * light is too bright (./dev bench effects has that figure). */
static void test_window_room(void **state)
{
    (void)state;
    static const double radii[] = {0.25, 0.5, 1};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float(*light)[3] = aob_alloc(W * H, sizeof *light);
    for (size_t r = 0; r < AOB_COUNT(radii); r++) {
        struct room room;
        double given[AOB_COUNT(ways)], own[AOB_COUNT(ways)];
        room_init(&room, radii[r]);
        for (size_t way = 0; way < AOB_COUNT(ways); way++) {
            run_true_inputs(&room.rig, gpu, &room.visible, AOB_OUT_IRRADIANCE, (int)way, light[0]);
            given[way] = error_of(&room, light);
            run_gtao(&room, gpu, ways[way], light);
            own[way] = error_of(&room, light);
            printf("window_room R=%g, %s: %.4f given the truth, %.4f by gtao\n", radii[r], ways[way],
                   given[way], own[way]);
            assert_true(way == 0 || given[0] < given[way]);
            assert_true(way == 0 || way == 2 || own[0] < own[way]);
        }
        room_finish(&room);
    }
    free(light);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_zonal_coefficients),
                                       cmocka_unit_test(test_open_surfaces),
                                       cmocka_unit_test(test_window_room)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

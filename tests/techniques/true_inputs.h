/* A pass of gtao's that makes an output of visibility and bent normal, given the traced ones: what is left is the error of the
 * formula itself. */
#ifndef AOB_TESTS_TRUE_INPUTS_H
#define AOB_TESTS_TRUE_INPUTS_H
#include <string.h>
#include "rig.h"
#include "techniques/gtao/lobe.h"

/* What the tables of the technique below are filled with; one at a time. */
static struct {
    int width, height;
    const struct aob_visibility *traced;
    enum aob_output output; /* AOB_OUT_SPECULAR or AOB_OUT_IRRADIANCE */
    int way;                /* of specular_by or irradiance_by */
} true_inputs;

static void fill_open(const void *values, void *texels)
{
    float(*into)[4] = texels;
    (void)values;
    for (int i = 0; i < true_inputs.width * true_inputs.height; i++) {
        memcpy(into[i], true_inputs.traced->bent[i], sizeof true_inputs.traced->bent[i]);
        into[i][3] = true_inputs.traced->ao[i];
    }
}

static bool build_true_inputs(struct aob_graph *graph, const void *values)
{
    bool lobe = true_inputs.output == AOB_OUT_SPECULAR;
    const char *name = lobe ? "specular" : "irradiance";
    (void)values;
    aob_tex open =
        aob_texture(graph, .name = "open", .format = AOB_RGBA32F, .width = (uint32_t)true_inputs.width,
                    .height = (uint32_t)true_inputs.height, .fill = fill_open);
    aob_tex lobes = aob_texture(graph, .name = "lobes", .format = AOB_R16, .width = GTAO_LOBE_EDGES,
                                .height = GTAO_LOBE_CONES * GTAO_LOBE_SHAPES, .fill = gtao_lobe_fill);
    aob_tex out = aob_texture(graph, .name = name, .format = lobe ? AOB_R32F : AOB_RGBA32F);
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "visibility", .shader = "visibility",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_pass(
               graph, .name = name, .shader = name,
               .reads = AOB_DEPTH | AOB_NORMAL | AOB_MATERIAL | AOB_LIGHT,
               .defines = {{"EDGES", GTAO_LOBE_EDGES},
                           {"CONES", GTAO_LOBE_CONES},
                           {"SHAPES", GTAO_LOBE_SHAPES},
                           {"LEAST_PERCENT", 5},
                           {lobe ? "SPECULAR_BY" : "IRRADIANCE_BY", true_inputs.way}},
               .in = {{.name = "open", .tex = open}, {.name = "lobes", .tex = lobes, .filter = AOB_BILINEAR}},
               .out = {{.name = name, .tex = out}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility) && aob_output(graph, true_inputs.output, out);
}

/* Draws that output, given what was traced, by the way of that number; `pixels` holds 1 float a pixel, or 3 of irradiance. */
static void run_true_inputs(const struct aob_rig *rig, struct aob_gpu *gpu,
                            const struct aob_visibility *traced, enum aob_output output, int way,
                            float *pixels)
{
    const char *name = output == AOB_OUT_SPECULAR ? "specular" : "irradiance";
    const struct aob_shader shaders[] = {{"visibility", "void main() { visibility = 1.0; }\n"},
                                         {name, aob_rig_text("gtao", name)},
                                         {NULL, NULL}};
    const struct aob_technique technique = {
        .name = "true_inputs", .shaders = shaders, .build = build_true_inputs};
    float *images[AOB_OUTPUT_COUNT] = {NULL};
    images[output] = pixels;
    true_inputs.width = rig->width;
    true_inputs.height = rig->height;
    true_inputs.traced = traced;
    true_inputs.output = output;
    true_inputs.way = way;
    aob_rig_draw(rig, gpu, &technique, "", &(struct aob_options){0}, images);
}
#endif

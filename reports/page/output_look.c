#include "output_look.h"

const struct aob_output_look aob_output_looks[AOB_OUTPUT_LOOKS] = {
    {.output = AOB_OUT_BENT_NORMAL,
     .metric = "bent_band",
     .error = "error.bent",
     .amount = "degrees",
     .map_end = "-bent.png",
     .map_title = "bent normals, degrees off",
     .heading = "Angle between bent normals and what is open"},
    {.output = AOB_OUT_VISIBILITY_RGB,
     .metric = "bounce_band",
     .error = "error.visibility_rgb",
     .quantity = "visibility after bounces",
     .technique = "technique.visibility_rgb",
     .reference = "reference.visibility_rgb",
     .truth = "Reference: path-traced",
     .colour = true,
     .exposure = 1,
     .end = "-bounces.png",
     .map_end = "-bounces-map.png",
     .title = "visibility after bounces",
     .map_title = "error of visibility after bounces",
     .heading = "Visibility after bounces",
     .sentence =
         "The light that arrives under a uniform white sky, with what the surfaces around reflect of it. "
         "The pictures are linear colours, shown as sRGB at exposure 1, the sky grey; the error is the mean "
         "of the three "
         "channels\u2019 differences."},
    {.output = AOB_OUT_SPECULAR,
     .metric = "specular_band",
     .error = "error.specular",
     .quantity = "specular occlusion",
     .technique = "technique.specular",
     .reference = "reference.specular",
     .truth = "Reference: ray-traced",
     .end = "-specular.png",
     .map_end = "-specular-map.png",
     .title = "specular occlusion",
     .map_title = "error of specular occlusion",
     .heading = "Specular occlusion",
     .sentence =
         "The open share of each surface\u2019s own GGX lobe, 0 black to 1 white. The error is absolute; the "
         "scores are relative to the truth."},
    {.output = AOB_OUT_IRRADIANCE,
     .metric = "irradiance_band",
     .error = "error.irradiance",
     .quantity = "irradiance",
     .technique = "technique.irradiance",
     .reference = "reference.irradiance",
     .truth = "Reference: ray-traced",
     .colour = true,
     .end = "-irradiance.png",
     .map_end = "-irradiance-map.png",
     .title = "irradiance over \u03c0",
     .map_title = "error of irradiance over \u03c0",
     .heading = "Irradiance of the scene\u2019s light",
     .sentence =
         "The light that reaches each surface past what blocks it, over \u03c0. The pictures are linear "
         "colours, shown as sRGB, the sky grey; technique and reference have one exposure, which their "
         "headings say. The "
         "error is the mean of the three channels\u2019 differences, without the exposure; the scores are "
         "relative to the truth."},
    {.output = AOB_OUT_LIT,
     .metric = "lit_band",
     .error = "error.lit",
     .quantity = "the lit image",
     .technique = "technique.lit",
     .reference = "reference.lit",
     .truth = "Reference: path-traced",
     .colour = true,
     .exposed = "lit_exposure",
     .end = "-lit.png",
     .map_end = "-lit-map.png",
     .title = "lit image",
     .map_title = "error of the lit image",
     .heading = "The lit image",
     .sentence = "What each surface shows of the scene\u2019s light: diffuse and mirrored, composed of the "
                 "outputs that the "
                 "case wants; visibility stands in for those that it does not. The reference is path-traced "
                 "with eight "
                 "reflections. The pictures are linear colours, shown as sRGB, the sky grey; technique and "
                 "reference have "
                 "one exposure, which their headings say. The error is the mean of the three channels\u2019 "
                 "differences, "
                 "without the exposure; the scores are relative to the truth."},
};

#include <math.h>
#include <string.h>
#include "effects.h"
#include "fuzz_frame.h"

/* All of it comes from about one direction: (1 + x)^2, x the cosine to it, is the sharpest square of two bands. */
static struct aob_light draw_sun(struct aob_chance *chance)
{
    /* 4/3 + 2 P1 + 2/3 P2, each times 4 pi / (2 l + 1) */
    const double bands[3] = {4.0 / 3 * 4 * M_PI, 2.0 * 4 * M_PI / 3, 2.0 / 3 * 4 * M_PI / 5};
    struct aob_light sun;
    double basis[9];
    aob_light_basis(aob_chance_direction(chance), basis);
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            sun.sh[i][c] = bands[i == 0 ? 0 : i < 4 ? 1 : 2] * basis[i];
    return sun;
}

/* From a night to more than half floats hold; a channel in eight is dark. */
static void scale_light(struct aob_light *light, struct aob_chance *chance)
{
    double scale = aob_chance_once_in(chance, 2) ? 1 : aob_chance_log(chance, 1e-6, 1e6);
    for (int c = 0; c < 3; c++) {
        double factor = aob_chance_once_in(chance, 8) ? 0 : scale;
        for (int i = 0; i < 9; i++)
            light->sh[i][c] *= factor;
    }
}

void aob_fuzz_light_fill(struct aob_fuzz_frame *frame, struct aob_chance *chance)
{
    size_t count = aob_fuzz_frame_pixels(frame);
    aob_effects_paint(&frame->gbuffer, chance);
    switch (aob_chance_below(chance, 3)) {
    case 0:
        frame->light = aob_light_uniform;
        break;
    case 1:
        frame->light = aob_effects_light(chance);
        break;
    default:
        frame->light = draw_sun(chance);
    }
    scale_light(&frame->light, chance);
    for (size_t i = 0; i < count; i++)
        if (frame->pixels[i] == AOB_FUZZ_SKY) {
            memset(&frame->gbuffer.albedo[3 * i], 0, 3 * sizeof(float));
            memset(&frame->gbuffer.shine[2 * i], 0, 2 * sizeof(float));
        }
}

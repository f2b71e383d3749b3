#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"
#include "effects.h"
#include "sets.h"
#include "technique/graph.h"

/* The options that want those outputs of these bits which the subject gives. */
static void want(const struct aob_subject *subject, uint32_t outputs, char *set, size_t size)
{
    struct aob_text text = {0};
    for (int which = AOB_OUT_VISIBILITY + 1; which < AOB_OUTPUT_COUNT; which++)
        if (outputs >> which & 1 && aob_subject_gives(subject, (enum aob_output)which))
            aob_text_add(&text, "%s%s=on", text.data ? " " : "", aob_output_name((enum aob_output)which));
    aob_line_print(set, size, "%s", text.data ? text.data : "");
    aob_text_finish(&text);
}

enum { ALL = ~0, LIGHT = 1 << AOB_OUT_VISIBILITY_RGB | 1 << AOB_OUT_SPECULAR | 1 << AOB_OUT_IRRADIANCE };

struct frames {
    struct aob_shot shot;
    char set[160];
};

static struct aob_reading draw(struct aob_trial *trial, struct frames *frames, uint32_t outputs)
{
    want(trial->subject, outputs, frames->set, sizeof frames->set);
    frames->shot.set = frames->set;
    return aob_trial_read(trial, &frames->shot);
}

static void start(struct aob_trial *trial, struct frames *frames, const struct aob_light *light,
                  struct aob_chance *chance)
{
    struct aob_exhibit *exhibit = aob_set_default(trial);
    if (exhibit)
        aob_effects_paint(&exhibit->gbuffer, chance);
    *frames = (struct frames){.shot = {.exhibit = exhibit, .radius = 0.5, .light = light}};
}

void aob_ask_effects_apart(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("effects_apart");
    const struct aob_light light = aob_effects_light(&chance);
    struct frames frames;
    start(trial, &frames, &light, &chance);
    struct aob_reading all = draw(trial, &frames, (uint32_t)ALL);
    for (int which = 0; which < AOB_OUT_LIT; which++) { /* the lit image is made of the others */
        if (!all.of[which])
            continue;
        struct aob_reading alone = draw(trial, &frames, 1u << which);
        int stride = aob_output_components((enum aob_output)which);
        for (int c = 0; alone.of[which] && c < stride; c++) {
            const struct aob_exhibit *exhibit = frames.shot.exhibit;
            const float *image = alone.of[which], *wanted = all.of[which];
            if (stride > 1) {
                image = aob_effects_channel(trial, exhibit, image, c, 1);
                wanted = aob_effects_channel(trial, exhibit, wanted, c, 1);
            }
            aob_effects_take(trial, &frames.shot, image, wanted, aob_output_name((enum aob_output)which));
        }
    }
}

/* Nobody needs light or materials for a visibility. */
static void take_reads(struct aob_trial *trial)
{
    struct aob_pass_graph *graph = aob_subject_lay(trial->subject, 0);
    uint32_t reads = graph ? aob_graph_reads(graph) & (AOB_MATERIAL | AOB_LIGHT) : 0;
    aob_trial_take(trial, graph && !reads ? 0 : 1, NULL, "visibility alone reads %s",
                   reads & AOB_LIGHT ? "the light"
                   : reads           ? "materials"
                                     : "no more than it needs");
    free(graph);
}

/* Each of these outputs has a texture of its own, so that a frame which does not want it is smaller. */
void aob_ask_effects_unwanted(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("effects_unwanted");
    struct frames frames;
    start(trial, &frames, NULL, &chance);
    take_reads(trial);
    struct aob_reading none = draw(trial, &frames, 0), all = draw(trial, &frames, LIGHT);
    for (int which = AOB_OUT_VISIBILITY_RGB; which < AOB_OUTPUT_COUNT; which++) {
        if (!all.of[which] || !none.of[AOB_OUT_VISIBILITY])
            continue;
        struct aob_reading alone = draw(trial, &frames, 1u << which),
                           others = draw(trial, &frames, LIGHT & ~(1u << which));
        double bytes =
            fmin((double)alone.bytes - (double)none.bytes, (double)all.bytes - (double)others.bytes);
        aob_trial_take(trial, aob_over(1 - bytes / (double)aob_exhibit_pixels(frames.shot.exhibit)),
                       &(struct aob_seen){&frames.shot, NULL, NULL},
                       "%s adds %.0f bytes to a frame where it is wanted",
                       aob_output_name((enum aob_output)which), bytes);
    }
}

/* What is no surface, and normals that are none, among good ones, in materials at the ends. */
void aob_ask_effects_finite(struct aob_trial *trial)
{
    static const float values[] = {NAN, INFINITY, 0, -1, 1e-42f};
    struct aob_chance chance = aob_chance_of("effects_finite");
    const struct aob_light light = aob_effects_light(&chance);
    for (size_t v = 0; v < 2 * AOB_COUNT(values); v++) {
        struct frames frames;
        start(trial, &frames, &light, &chance);
        const struct aob_exhibit *exhibit = frames.shot.exhibit;
        for (size_t i = 0; exhibit && i < aob_exhibit_pixels(exhibit); i += 7) {
            size_t at = aob_exhibit_place(exhibit, i);
            if (v % 2)
                exhibit->gbuffer.depth[at] = values[v / 2];
            for (size_t c = 0; v % 2 == 0 && c < 3; c++)
                exhibit->gbuffer.normal[4 * at + c] = values[v / 2];
        }
        if (!draw(trial, &frames, LIGHT).of[AOB_OUT_VISIBILITY])
            return;
        aob_trial_take(trial, 0, &(struct aob_seen){&frames.shot, NULL, NULL}, "every seventh %s is %g",
                       v % 2 ? "depth" : "normal", (double)values[v / 2]);
    }
}

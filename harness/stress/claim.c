#include "claim.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "reference/bound.h"
#include "technique/definition.h"

static bool trace_scene(const struct aob_exhibit *exhibit, const struct aob_visibility_desc *desc,
                        struct aob_visibility *traced, struct aob_error *error)
{
    return aob_tracer_visibility(exhibit->tracer, &exhibit->camera, &exhibit->hits, desc, traced, error);
}

static bool trace_image(const struct aob_exhibit *exhibit, const struct aob_visibility_desc *desc,
                        struct aob_visibility *traced, struct aob_error *error)
{
    const struct aob_bound_desc thin = {.kind = AOB_BOUND_THIN};
    struct aob_bound *bound =
        aob_bound_create(&exhibit->camera, &exhibit->gbuffer.projection, &exhibit->hits, &thin, error);
    bool ok = bound && aob_bound_visibility(bound, desc, traced, error);
    aob_bound_destroy(bound);
    return ok;
}

static bool trace(const struct aob_exhibit *exhibit, const struct aob_visibility_term *term,
                  enum aob_claim_of of, int spp, struct aob_visibility *traced, struct aob_error *error)
{
    const struct aob_visibility_desc desc = aob_exhibit_rays(exhibit, term, spp);
    return of == AOB_CLAIM_OF_SCENE ? trace_scene(exhibit, &desc, traced, error)
                                    : trace_image(exhibit, &desc, traced, error);
}

/* Traces the claim of a shot's values; false after an error or an excuse of the trial. */
static bool trace_claim(struct aob_trial *trial, const struct aob_shot *shot, const void *values,
                        enum aob_claim_of of, int spp, bool bent, struct aob_visibility *traced)
{
    struct aob_definition_table *table = AOB_NEW(struct aob_definition_table);
    bool ok = aob_definition_tabulate(trial->subject->technique, values, table, &trial->error);
    if (ok && !table->claims)
        aob_trial_excuse(trial, "it claims nothing that can be traced");
    const struct aob_visibility_term term = {.radius = (double)table->radius,
                                             .uniform = table->uniform,
                                             .of_triangle = table->of_triangle,
                                             .falloff = table->fades ? table->falloff : NULL,
                                             .falloff_count = AOB_FALLOFF_ROWS,
                                             .bent = bent};
    ok = ok && table->claims && trace(shot->exhibit, &term, of, spp, traced, &trial->error);
    free(table);
    return ok;
}

static struct aob_open claim(struct aob_trial *trial, const struct aob_shot *shot, enum aob_claim_of of,
                             int spp, bool bent)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_visibility traced;
    struct aob_open open = {NULL, NULL};
    const struct aob_definition *definition = &trial->subject->technique->definition;
    if (!shot->exhibit || *trial->error.text || *trial->excuse.text ||
        !aob_subject_values(trial->subject, shot, values, &options, &trial->error) ||
        !trace_claim(trial, shot, values, of, spp, bent, &traced))
        return open;
    open.visibility = aob_trial_image(trial, shot->exhibit);
    open.bent = bent ? aob_trial_vectors(trial, shot->exhibit) : NULL;
    for (size_t i = 0; i < aob_exhibit_pixels(shot->exhibit); i++) {
        open.visibility[i] = definition->map ? definition->map(values, traced.ao[i]) : traced.ao[i];
        for (int c = 0; bent && c < 3; c++)
            open.bent[i][c] = traced.bent[i][c];
    }
    aob_visibility_finish(&traced);
    return open;
}

float *aob_claim_trace(struct aob_trial *trial, const struct aob_shot *shot, enum aob_claim_of of, int spp)
{
    return claim(trial, shot, of, spp, false).visibility;
}

struct aob_open aob_claim_trace_open(struct aob_trial *trial, const struct aob_shot *shot,
                                     enum aob_claim_of of, int spp)
{
    return claim(trial, shot, of, spp, true);
}

double aob_claim_open(struct aob_trial *trial, const struct aob_shot *shot)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    const struct aob_definition *definition = &trial->subject->technique->definition;
    if (!aob_subject_values(trial->subject, shot, values, &options, &trial->error))
        return NAN;
    return definition->map ? (double)definition->map(values, 1) : 1;
}

#include "effects.h"
#include <math.h>
#include <string.h>
#include "base/clock.h"
#include "planner.h"
#include "run/captures.h"

/* So many rays tell a relative error of .02 from its noise. */
static const double enough_rays = 1.8e6;
enum { MOST_RAYS = 64 };

/* Even, since a truth has two halves. */
static int choose_spp(const struct aob_config *config)
{
    double pixels = (double)config->sizes[0].width * config->sizes[0].height,
           spp = 2 * ceil(enough_rays / pixels / 2);
    return (int)fmin(fmax(spp, 2), MOST_RAYS);
}

/* The lit image is composed here of the geometric normals that an image keeps. */
static bool judge_options(const struct aob_config *config, struct aob_error *error)
{
    for (size_t i = 0; i < config->option_count; i++)
        if (strcmp(config->options[i].name, "normals") == 0 &&
            strcmp(config->options[i].values[0].text, "geometric") != 0)
            return aob_fail(error, "a plan of effects is of geometric normals: leave normals=%s out",
                            config->options[i].values[0].text);
    return aob_effect_frames_judge(config, 0, error);
}

/* What the view is of: how many rays its size needs, and whether it has surfaces to trace. */
static bool look(struct aob_effect_planner *p, bool *captured, unsigned *materials, struct aob_error *error)
{
    struct aob_config config = {0};
    bool ok = p->desc->maker.make(p->desc->maker.user, &config, error) && judge_options(&config, error);
    *captured = ok && config.scenes[0].capture;
    if (*captured && p->desc->spp)
        ok = aob_fail(error, "a capture has no surfaces to trace: leave --reference-spp out");
    ok = ok && (!*captured || aob_captures_load(&config, p->desc->dispatch, error));
    *materials = ok ? config.scenes[0].materials : 0;
    if (ok && !*captured)
        p->effects->spp = p->desc->spp ? p->desc->spp : choose_spp(&config);
    aob_config_finish(&config);
    return ok;
}

static bool trace_truth(struct aob_effect_planner *p, struct aob_error *error)
{
    static const unsigned nothing = 0;
    struct aob_effects *e = p->effects;
    struct aob_effect_frames_desc desc = aob_effect_planner_frames(p, &nothing, 1);
    int64_t start = aob_clock_wall_ns();
    desc.spp = e->spp;
    aob_effect_planner_say(p, "tracing the lit truth");
    e->truth_records = aob_effect_frames_measure(&desc, &e->truth, error);
    e->truth_s = (double)(aob_clock_wall_ns() - start) * 1e-9;
    return e->truth_records && aob_effect_planner_see(p, e->truth_records, &e->truth, error) &&
           (e->seen.mean_light > 0 ||
            aob_fail(error, "the view is black: its lit image has no error to speak of"));
}

/* Why a view without a motion of its own has no frames before it; NULL: it could stand still. */
static const char *find_no_sequence(const struct aob_effect_planner *p, const struct aob_case *c)
{
    if (p->desc->picture)
        return "the view is one picture; give it a motion";
    if (aob_plan_scene_frame(c->scene, 1))
        return "the scene moves, and this is one picture of it; --frames makes it a sequence";
    if (c->scene->framed)
        return "a sequence needs a camera; give --eye and --target";
    return aob_case_options(c).gbuffer ? "a sequence is of ray-cast G-buffers; leave gbuffer out" : NULL;
}

/* Whether frames before this one are to be thought of. One in which nothing moves is as good as a picture. */
static void look_at_sequence(struct aob_effect_planner *p)
{
    const struct aob_case *c = &p->effects->truth.plan.cases[0];
    const struct aob_motion *motion = &c->scene->motion;
    struct aob_effect_answer *a = &p->effects->answer;
    if (aob_motion_has_camera(motion) || aob_plan_scene_frame(c->scene, 1))
        a->frames = motion->frames;
    if (!motion->frames)
        a->no_sequence = find_no_sequence(p, c);
}

/* Where nothing is off without any occlusion no other frame is needed: no set is cheaper than nothing. */
static void apply_rules(struct aob_effect_planner *p)
{
    struct aob_effect_answer *a = &p->effects->answer;
    double tolerance = aob_effect_ask_tolerance(&a->ask);
    struct aob_lit_error none = aob_drawn_error(&p->effects->seen, NULL, 0);
    bool flickers = aob_effect_planner_flicker(p, 0) > tolerance;
    aob_effect_bounds_find(&p->effects->seen, &a->bounds);
    a->open = none.rmse + 2 * none.rmse_se <= tolerance && !flickers
                  ? 0
                  : aob_effect_bounds_open(&a->bounds, tolerance);
    if (a->no_sequence)
        a->open &= ~AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL);
}

static bool time_frames(struct aob_effect_planner *p, struct aob_error *error)
{
    unsigned sets[AOB_EFFECT_FRAMES];
    size_t count = aob_effect_frames_choose(p->effects->answer.open, sets);
    return aob_effect_planner_time(p, 0, sets, count, error);
}

/* Frames of full size are dear, so one is timed only where it is taken. */
static bool confirm(struct aob_effect_planner *p, struct aob_error *error)
{
    const struct aob_effect_answer *a = &p->effects->answer;
    const struct aob_effect_candidate *chosen = a->chosen < 0 ? NULL : &a->candidates[a->chosen];
    if (!chosen || !chosen->set || aob_effect_has(chosen->set, AOB_EFFECT_HALF_SIZE))
        return true;
    const unsigned set = chosen->set;
    return aob_effect_planner_time(p, 1, &set, 1, error) && aob_effect_planner_judge(p, error);
}

static bool draw_scene(struct aob_effect_planner *p, struct aob_error *error)
{
    if (!trace_truth(p, error))
        return false;
    look_at_sequence(p);
    apply_rules(p);
    return aob_effect_planner_look(p, error);
}

bool aob_effects_plan(const struct aob_effects_desc *desc, struct aob_effects *effects,
                      struct aob_error *error)
{
    struct aob_effect_planner p = {.desc = desc, .effects = effects};
    bool captured;
    unsigned materials;
    effects->answer.ask = desc->ask;
    if (!look(&p, &captured, &materials, error) ||
        !(captured ? aob_effect_planner_capture(&p, materials, error) : draw_scene(&p, error)))
        return false;
    return time_frames(&p, error) && aob_effect_planner_judge(&p, error) && confirm(&p, error);
}

const struct aob_sweep *aob_effects_sweep(const struct aob_effects *effects)
{
    return effects->truth.plan.case_count ? &effects->truth : &effects->images[0];
}

void aob_effects_finish(struct aob_effects *e)
{
    json_decref(e->truth_records);
    json_decref(e->flicker_records);
    aob_seen_finish(&e->seen);
    for (int i = 0; i < 2; i++) {
        json_decref(e->image_records[i]);
        aob_sweep_finish(&e->images[i]);
        json_decref(e->time_records[i]);
        aob_sweep_finish(&e->times[i]);
    }
    for (size_t i = 0; i < AOB_EFFECT_IMAGES; i++)
        aob_drawn_finish(&e->drawn[i]);
    aob_sweep_finish(&e->truth);
    aob_sweep_finish(&e->flickers);
    *e = (struct aob_effects){0};
}

#include "effects.h"
#include <math.h>
#include <stdlib.h>
#include "base/clock.h"
#include "base/memory.h"
#include "cost.h"

/* So many rays tell a relative error of .02 from its noise; FLIP looks at pixels of so many. */
static const double enough_rays = 1.8e6;
enum { MOST_RAYS = 64, PIXEL_RAYS = 128 };

/* Wall time of timing a frame: three processes of a tenth of a second. */
static const double timing_s = 0.3;

struct planner {
    const struct aob_effects_desc *desc;
    struct aob_effects *effects;
    struct aob_effect_costs costs;
};

static void say(const struct planner *p, const char *work)
{
    if (p->desc->on_work)
        p->desc->on_work(p->desc->user, work);
}

static const struct aob_case *first_case(const struct aob_sweep *sweep)
{
    return &sweep->plan.cases[0];
}

static struct aob_effect_frames_desc frames_desc(const struct planner *p, const unsigned *sets, size_t count)
{
    return (struct aob_effect_frames_desc){.dispatch = p->desc->dispatch,
                                           .maker = p->desc->maker,
                                           .folder = p->desc->folder,
                                           .sets = sets,
                                           .count = count};
}

/* Even, since a truth has two halves. */
static int choose_spp(const struct aob_config *config)
{
    double pixels = (double)config->sizes[0].width * config->sizes[0].height,
           spp = 2 * ceil(enough_rays / pixels / 2);
    return (int)fmin(fmax(spp, 2), MOST_RAYS);
}

static bool find_spp(struct planner *p, struct aob_error *error)
{
    struct aob_config config = {0};
    bool ok = p->desc->maker.make(p->desc->maker.user, &config, error);
    if (ok)
        p->effects->spp = p->desc->spp ? p->desc->spp : choose_spp(&config);
    aob_config_finish(&config);
    return ok;
}

static bool read_image(const struct planner *p, const json_t *record,
                       bool (*read)(void *, const char *, struct aob_error *), void *user,
                       struct aob_error *error)
{
    struct aob_effect_frames_desc frames = frames_desc(p, NULL, 0);
    char *image = aob_effect_frames_image(&frames, record);
    bool ok =
        image ? read(user, image, error) : aob_fail(error, "a frame left no image in %s", p->desc->folder);
    free(image);
    return ok;
}

static bool read_seen(void *user, const char *image, struct aob_error *error)
{
    struct aob_effects *e = user;
    const struct aob_plan_scene *scene = first_case(&e->truth)->scene;
    const struct aob_seen_desc desc = {image, &scene->camera, &scene->light};
    return aob_seen_read(&e->seen, &desc, error);
}

static bool trace_truth(struct planner *p, struct aob_error *error)
{
    static const unsigned nothing = 0;
    struct aob_effects *e = p->effects;
    struct aob_effect_frames_desc desc = frames_desc(p, &nothing, 1);
    int64_t start = aob_clock_wall_ns();
    desc.spp = e->spp;
    say(p, "tracing the lit truth");
    e->truth_records = aob_effect_frames_measure(&desc, &e->truth, error);
    e->truth_s = (double)(aob_clock_wall_ns() - start) * 1e-9;
    return e->truth_records && read_image(p, json_array_get(e->truth_records, 0), read_seen, e, error) &&
           (e->seen.mean_light > 0 ||
            aob_fail(error, "the view is black: its lit image has no error to speak of"));
}

/* Where nothing is off without any occlusion no other frame is needed: no set is cheaper than nothing. */
static void apply_rules(struct planner *p)
{
    struct aob_effect_answer *a = &p->effects->answer;
    double tolerance = aob_effect_ask_tolerance(&a->ask);
    struct aob_lit_error none = aob_drawn_error(&p->effects->seen, NULL, 0);
    aob_effect_bounds_find(&p->effects->seen, &a->bounds);
    a->open = none.rmse + 2 * none.rmse_se <= tolerance ? 0 : aob_effect_bounds_open(&a->bounds, tolerance);
}

struct drawn_reader {
    const struct aob_seen *seen;
    struct aob_drawn *drawn;
};
static bool read_drawn(void *user, const char *image, struct aob_error *error)
{
    struct drawn_reader *reader = user;
    return aob_drawn_read(reader->drawn, reader->seen, image, error);
}

/* Everything that is open, at each size of occlusion. */
static bool draw_images(struct planner *p, struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    const unsigned half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE),
                   sets[2] = {e->answer.open & ~half, e->answer.open};
    struct aob_effect_frames_desc desc = frames_desc(p, sets, 2);
    int64_t start = aob_clock_wall_ns();
    bool ok = true;
    if (!e->answer.open)
        return true;
    say(p, "drawing frames");
    e->image_records = aob_effect_frames_measure(&desc, &e->images, error);
    e->images_s = (double)(aob_clock_wall_ns() - start) * 1e-9;
    for (size_t i = 0; i < 2 && ok; i++) {
        struct drawn_reader reader = {.seen = &e->seen, .drawn = &e->drawn[i]};
        ok = e->image_records &&
             read_image(p, json_array_get(e->image_records, i), read_drawn, &reader, error);
    }
    return ok;
}

static bool time_sets(struct planner *p, int turn, const unsigned *sets, size_t count,
                      struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    struct aob_effect_frames_desc desc = frames_desc(p, sets, count);
    int64_t start = aob_clock_wall_ns();
    desc.profile = p->desc->ask.profile;
    desc.seconds = desc.profile ? 0 : timing_s;
    say(p, "timing frames");
    e->time_records[turn] = aob_effect_frames_measure(&desc, &e->times[turn], error);
    e->times_s += (double)(aob_clock_wall_ns() - start) * 1e-9;
    p->costs.profile = desc.profile;
    for (size_t i = 0; i < count; i++)
        p->costs.frames[p->costs.count++] =
            (struct aob_effect_frame){sets[i], json_array_get(e->time_records[turn], i)};
    return e->time_records[turn];
}

static bool time_frames(struct planner *p, struct aob_error *error)
{
    unsigned sets[AOB_EFFECT_FRAMES];
    size_t count = aob_effect_frames_choose(p->effects->answer.open, sets);
    return time_sets(p, 0, sets, count, error);
}

static const struct aob_drawn *drawn_of(const struct aob_effects *e, unsigned set)
{
    return &e->drawn[aob_effect_has(set, AOB_EFFECT_HALF_SIZE)];
}

static bool is_timed(const struct planner *p, unsigned set)
{
    for (size_t i = 0; i < p->costs.count; i++)
        if (p->costs.frames[i].set == set)
            return true;
    return false;
}

static bool judge_sets(struct planner *p, struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    struct aob_effect_answer *a = &e->answer;
    unsigned sets[AOB_EFFECT_SETS];
    a->count = aob_effect_sets(a->open, sets);
    a->shrink = (int)ceil(sqrt((double)PIXEL_RAYS / e->spp));
    for (size_t i = 0; i < a->count; i++) {
        struct aob_effect_candidate *c = &a->candidates[i];
        *c = (struct aob_effect_candidate){.set = sets[i],
                                           .error = aob_drawn_error(&e->seen, drawn_of(e, sets[i]), sets[i]),
                                           .ms = aob_effect_cost(&p->costs, sets[i]),
                                           .drawn = is_timed(p, sets[i])};
        c->error.flip = aob_drawn_flip(&e->seen, drawn_of(e, sets[i]), sets[i], a->shrink);
        if (!isfinite(c->ms))
            return aob_fail(error, "a frame has no time%s%s", a->ask.profile ? " modelled on " : "",
                            a->ask.profile ? a->ask.profile : "");
    }
    aob_effect_answer_choose(a);
    return true;
}

/* Frames of full size are dear, so one is timed only where it is taken. */
static bool confirm(struct planner *p, struct aob_error *error)
{
    const struct aob_effect_answer *a = &p->effects->answer;
    const struct aob_effect_candidate *chosen = a->chosen < 0 ? NULL : &a->candidates[a->chosen];
    if (!chosen || !chosen->set || aob_effect_has(chosen->set, AOB_EFFECT_HALF_SIZE))
        return true;
    const unsigned set = chosen->set;
    return time_sets(p, 1, &set, 1, error) && judge_sets(p, error);
}

bool aob_effects_plan(const struct aob_effects_desc *desc, struct aob_effects *effects,
                      struct aob_error *error)
{
    struct planner p = {.desc = desc, .effects = effects};
    effects->answer.ask = desc->ask;
    if (!find_spp(&p, error) || !trace_truth(&p, error))
        return false;
    apply_rules(&p);
    return draw_images(&p, error) && time_frames(&p, error) && judge_sets(&p, error) && confirm(&p, error);
}

void aob_effects_finish(struct aob_effects *e)
{
    json_decref(e->truth_records);
    json_decref(e->image_records);
    aob_seen_finish(&e->seen);
    for (int i = 0; i < 2; i++) {
        aob_drawn_finish(&e->drawn[i]);
        json_decref(e->time_records[i]);
        aob_sweep_finish(&e->times[i]);
    }
    aob_sweep_finish(&e->truth);
    aob_sweep_finish(&e->images);
    *e = (struct aob_effects){0};
}

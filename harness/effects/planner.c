#include "planner.h"
#include <math.h>
#include <stdlib.h>
#include "base/clock.h"
#include "small.h"

/* Wall time of timing a frame: three processes of a tenth of a second. */
static const double timing_s = 0.3;

/* FLIP looks at pixels of so many rays, or without rays at about so many pixels. */
enum { PIXEL_RAYS = 128, PIXELS = 60000 };

void aob_effect_planner_say(const struct aob_effect_planner *p, const char *work)
{
    if (p->desc->on_work)
        p->desc->on_work(p->desc->user, work);
}

struct aob_effect_frames_desc aob_effect_planner_frames(const struct aob_effect_planner *p,
                                                        const unsigned *sets, size_t count)
{
    return (struct aob_effect_frames_desc){.dispatch = p->desc->dispatch,
                                           .maker = p->desc->maker,
                                           .folder = p->desc->folder,
                                           .sets = sets,
                                           .count = count,
                                           .unlit = p->effects->answer.unlit,
                                           .unsupported = &p->effects->unsupported};
}

/* The image of a measurement's record; free() it. NULL after a line. */
static char *find_image(const struct aob_effect_planner *p, const json_t *records, size_t at,
                        struct aob_error *error)
{
    struct aob_effect_frames_desc frames = aob_effect_planner_frames(p, NULL, 0);
    char *image = aob_effect_frames_image(&frames, json_array_get(records, at));
    if (!image)
        aob_fail(error, "a frame left no image in %s", p->desc->folder);
    return image;
}

bool aob_effect_planner_see(struct aob_effect_planner *p, const json_t *records,
                            const struct aob_sweep *sweep, struct aob_error *error)
{
    const struct aob_plan_scene *scene = sweep->plan.cases[0].scene;
    char *image = find_image(p, records, 0, error);
    const struct aob_seen_desc desc = {image, &scene->camera, &scene->light};
    bool ok = image && aob_seen_read(&p->effects->seen, &desc, error);
    p->effects->seen.spp = p->effects->spp;
    free(image);
    return ok;
}

static bool read_images(struct aob_effect_planner *p, const struct aob_effect_turn *turn,
                        struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    bool ok = true;
    for (size_t i = 0; i < turn->count && ok; i++) {
        struct aob_drawn *drawn = &e->drawn[aob_effect_image_of(turn->sets[i])];
        char *image = find_image(p, e->image_records[turn->turn], i, error);
        aob_drawn_finish(drawn);
        ok = image && aob_drawn_read(drawn, &e->seen, image, error);
        free(image);
    }
    return ok;
}

bool aob_effect_planner_draw(struct aob_effect_planner *p, const struct aob_effect_turn *turn,
                             struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    struct aob_effect_frames_desc desc = aob_effect_planner_frames(p, turn->sets, turn->count);
    struct aob_sweep *sweep = &e->images[turn->turn];
    json_t **records = &e->image_records[turn->turn];
    int64_t start = aob_clock_wall_ns();
    desc.still_frames = turn->still_frames;
    aob_effect_planner_say(p, "drawing frames");
    *records = aob_effect_frames_measure(&desc, sweep, error);
    e->images_s += (double)(aob_clock_wall_ns() - start) * 1e-9;
    return *records && (e->seen.count || aob_effect_planner_see(p, *records, sweep, error)) &&
           read_images(p, turn, error);
}

bool aob_effect_planner_time(struct aob_effect_planner *p, int turn, const unsigned *sets, size_t count,
                             struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    struct aob_effect_frames_desc desc = aob_effect_planner_frames(p, sets, count);
    int64_t start = aob_clock_wall_ns();
    desc.profile = p->desc->ask.profile;
    desc.seconds = desc.profile ? 0 : timing_s;
    aob_effect_planner_say(p, "timing frames");
    e->time_records[turn] = aob_effect_frames_measure(&desc, &e->times[turn], error);
    e->times_s += (double)(aob_clock_wall_ns() - start) * 1e-9;
    p->costs.profile = desc.profile;
    p->costs.unlit = desc.unlit;
    for (size_t i = 0; i < count; i++)
        p->costs.frames[p->costs.count++] =
            (struct aob_effect_frame){sets[i], json_array_get(e->time_records[turn], i)};
    return e->time_records[turn];
}

static bool is_timed(const struct aob_effect_planner *p, unsigned set)
{
    for (size_t i = 0; i < p->costs.count; i++)
        if (p->costs.frames[i].set == set)
            return true;
    return false;
}

static struct aob_effect_candidate judge_set(const struct aob_effect_planner *p, unsigned set)
{
    const struct aob_effects *e = p->effects;
    const struct aob_drawn *drawn = &e->drawn[aob_effect_image_of(set)];
    struct aob_effect_candidate c = {.set = set,
                                     .error = aob_drawn_error(&e->seen, drawn, set),
                                     .flicker = aob_effect_planner_flicker(p, set),
                                     .ms = aob_effect_cost(&p->costs, set),
                                     .drawn = is_timed(p, set)};
    struct aob_small small;
    aob_small_init(&small, &e->seen, drawn, set, e->answer.shrink);
    c.error.flip = aob_small_flip(&small, aob_light_exposure(&e->seen.light));
    aob_small_finish(&small);
    return c;
}

/* Without noise only so far that a large image does not take long. */
static int choose_shrink(const struct aob_effects *e)
{
    double pixels = (double)e->seen.width * e->seen.height;
    return (int)ceil(sqrt(e->spp ? (double)PIXEL_RAYS / e->spp : fmax(pixels / PIXELS, 1)));
}

bool aob_effect_planner_judge(struct aob_effect_planner *p, struct aob_error *error)
{
    struct aob_effect_answer *a = &p->effects->answer;
    unsigned sets[AOB_EFFECT_SETS];
    a->count = aob_effect_sets(a->open, sets);
    a->shrink = choose_shrink(p->effects);
    for (size_t i = 0; i < a->count; i++) {
        a->candidates[i] = judge_set(p, sets[i]);
        if (!isfinite(a->candidates[i].ms))
            return aob_fail(error, "a frame has no time%s%s", a->ask.profile ? " modelled on " : "",
                            a->ask.profile ? a->ask.profile : "");
    }
    aob_effect_answer_choose(a);
    return true;
}

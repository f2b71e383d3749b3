#include "check.h"
#include "job/check_job.h"

enum { CHECK_SIDE = 96 }; /* pixels of the longer side; with 16 rays each they are some ten thousand rays */

/* A mean visibility that is wrong by less is not worth a line. */
static const double least_share = 1e-3;

/* The farthest that the pending cases of this view look which draw triangles; 0: there is none. */
static double farthest_radius(const struct aob_measurement *m, const struct aob_plan_scene *scene)
{
    double radius = 0;
    for (size_t i = 0; i < m->plan->case_count; i++) {
        const struct aob_case *c = &m->plan->cases[i];
        if (c->scene == scene && m->states[i].triangles && m->states[i].stage == AOB_PENDING)
            radius = fmax(radius, isnan(aob_case_radius(c)) ? INFINITY : aob_case_radius(c));
    }
    return radius;
}

static void warn(const struct aob_plan_scene *scene, const struct aob_check_answer *answer)
{
    struct aob_text text = {0};
    if (answer->doubled)
        aob_text_add(&text, "%zu of its %zu triangles repeat another one", answer->doubled,
                     answer->triangles);
    if (answer->backs >= least_share)
        aob_text_add(
            &text,
            "%s%.1f %% of the directions from what is seen meet backs of triangles within the radius (open "
            "sheets, or solids turned inside out)",
            text.data ? ", and " : "", 100 * answer->backs);
    if (text.data)
        aob_warn(
            "%s/%s: %s; techniques that draw triangles are right only for closed solids that face outwards, "
            "each face once",
            scene->name, scene->view, text.data);
    aob_text_finish(&text);
}

static void take_answer(void *user, const json_t *object)
{
    struct aob_check_answer answer;
    if (aob_check_answer_from_json(object, &answer))
        warn(user, &answer);
}

static void shrink(struct aob_job_view *view)
{
    int side = view->width > view->height ? view->width : view->height;
    view->guard = 0;
    view->width = (view->width * CHECK_SIDE + side - 1) / side;
    view->height = (view->height * CHECK_SIDE + side - 1) / side;
}

void aob_check_view(struct aob_measurement *m, size_t index, const struct aob_view_files *files)
{
    const struct aob_case *c = &m->plan->cases[index];
    struct aob_plan_scene *scene = &m->plan->scenes[c->scene - m->plan->scenes];
    if (scene->checked || scene->gbuffer)
        return;
    scene->checked = true; /* at once: to look through all cases again for every block would take too long */
    struct aob_check_job job = {.view = aob_job_view_of(c, files), .radius = farthest_radius(m, scene)};
    if (job.radius == 0)
        return;
    shrink(&job.view);
    struct aob_error error = {{0}};
    struct aob_job_desc desc = {.job = aob_check_job_to_json(&job),
                                .timeout_s = 300,
                                .memory_limit = aob_view_memory_limit(),
                                .on_answer = take_answer,
                                .user = scene};
    if (!aob_dispatch_job(m->dispatch, &desc, &error))
        aob_warn("%s/%s: its triangles could not be checked: %s", scene->name, scene->view, error.text);
}

#include "auto.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/output.h"
#include "effects.h"
#include "work_folder.h"

static const char technique[] = "gtao";
static const unsigned no_set = ~0U; /* of a view that nobody asks about */

static int find_entry(const struct aob_config *config, const char *name)
{
    for (size_t i = 0; i < config->technique_count; i++)
        if (strcmp(config->techniques[i].name.text, name) == 0)
            return (int)i;
    return -1;
}

static bool has_one_value(const struct aob_axis *axes, size_t count, struct aob_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (axes[i].count > 1)
            return aob_fail(error, "effects: auto takes one value of '%s'", axes[i].name);
    return true;
}

static bool judge(const struct aob_config *config, struct aob_error *error)
{
    int entry = find_entry(config, technique), entries = 0;
    for (size_t i = 0; i < config->technique_count; i++)
        entries += strcmp(config->techniques[i].name.text, technique) == 0;
    if (entries != 1)
        return aob_fail(error, "effects: auto needs one entry of %s, and there are %d", technique, entries);
    return aob_effect_frames_judge(config, (size_t)entry, error) &&
           has_one_value(config->options, config->option_count, error) &&
           has_one_value(config->techniques[entry].axes, config->techniques[entry].axis_count, error);
}

/* `none` where gtao is, whether or not the config has it somewhere; what is then there twice is one case. */
static void add_none(struct aob_config *config)
{
    struct aob_technique_choice none = {.name.text = aob_strdup("none")};
    const struct aob_backend_choice *own = &config->techniques[find_entry(config, technique)].backends;
    for (size_t i = 0; i < own->count; i++) {
        struct aob_value *name = AOB_PUSH(none.backends.names, none.backends.count, none.backends.capacity);
        *name = own->names[i];
        name->text = aob_strdup(own->names[i].text);
    }
    *AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity) = none;
}

/* All sets of gtao, and nothing. */
static bool widen(void *user, struct aob_config *config, struct aob_error *error)
{
    struct aob_effects_auto *chooser = user;
    if (!judge(config, error))
        return false;
    aob_effect_frames_widen(config, (size_t)find_entry(config, technique), AOB_EFFECT_ALL, false);
    add_none(config);
    chooser->config_of = config;
    return true;
}

/* Whether the config itself wants `none` on a backend. */
static bool names_none(const struct aob_config *config, const char *backend)
{
    for (size_t i = 0; i + 1 < config->technique_count; i++) {
        const struct aob_backend_choice *there = aob_config_backends(config, &config->techniques[i]);
        if (strcmp(config->techniques[i].name.text, "none") != 0)
            continue;
        for (size_t b = 0; b < there->count; b++)
            if (strcmp(there->names[b].text, backend) == 0)
                return true;
    }
    return false;
}

/* Which view of the config is planned. */
struct one {
    const struct aob_effects_auto *chooser;
    size_t scene; /* of the plan's and the config's */
    const struct aob_case *c;
};

static void keep_scene(struct aob_config *config, size_t at)
{
    for (size_t i = 0; i < config->scene_count; i++)
        if (i != at)
            aob_scene_choice_finish(&config->scenes[i]);
    config->scenes[0] = config->scenes[at];
    config->scene_count = 1;
}

static void keep_entry(struct aob_config *config, size_t at)
{
    for (size_t i = 0; i < config->technique_count; i++)
        if (i != at)
            aob_technique_choice_finish(&config->techniques[i]);
    config->techniques[0] = config->techniques[at];
    config->technique_count = 1;
}

static void keep_backend(struct aob_backend_choice *backends, const char *name)
{
    for (size_t i = 0; i < backends->count; i++) {
        free(backends->names[i].text);
        backends->names[i].text = i ? NULL : aob_strdup(name);
    }
    backends->count = backends->count ? 1 : 0;
}

/* A config of captures alone may have none. */
static void keep_size(struct aob_config *config, const struct aob_case *c)
{
    if (!config->size_count)
        AOB_PUSH(config->sizes, config->size_count, config->size_capacity);
    config->sizes[0] = (struct aob_size){.width = c->width, .height = c->height};
    config->size_count = 1;
}

/* The lit truth has the radius that the case is compared at; a weighting is of visibility alone. */
static void keep_target(struct aob_config *config, const struct aob_case *c)
{
    if (!config->target_count)
        return;
    config->targets[0] = (struct aob_target){.radius = config->targets[aob_case_own_target(c)].radius};
    config->target_count = 1;
}

/* The config once more, of that view alone; without a target its radius is that, and what it measures is the planner's. */
static bool make(void *user, struct aob_config *config, struct aob_error *error)
{
    const struct one *one = user;
    if (!aob_config_read(config, one->chooser->config, error))
        return false;
    free(config->effects.text);
    config->effects.text = NULL;
    aob_config_leave_unshown(config);
    keep_scene(config, one->scene);
    keep_entry(config, (size_t)find_entry(config, technique));
    if (!config->backends.count)
        AOB_PUSH(config->backends.names, config->backends.count, config->backends.capacity);
    keep_backend(&config->backends, one->c->backend);
    keep_backend(&config->techniques[0].backends, one->c->backend);
    keep_size(config, one->c);
    keep_target(config, one->c);
    config->scenes[0].told = true;
    return true;
}

static void tell(const struct one *one, unsigned set)
{
    struct aob_text name = {0};
    aob_effect_set_print(set, &name);
    if (!one->chooser->quiet)
        aob_note("%s/%s %dx%d %s calls for %s", one->c->scene->name, one->c->scene->view, one->c->width,
                 one->c->height, one->c->backend, name.data);
    aob_text_finish(&name);
}

/* What has no device has no effects to choose: visibility stands for the view, and the run says of it why it could not be drawn. */
static bool give_up(const struct one *one, struct aob_error *error)
{
    if (!one->chooser->quiet)
        aob_note("%s/%s on %s is not planned: %s", one->c->scene->name, one->c->scene->view, one->c->backend,
                 error->text);
    *error = (struct aob_error){0};
    return true;
}

static bool plan_view(struct one *one, unsigned *set, struct aob_error *error)
{
    struct aob_work_folder folder;
    struct aob_effects effects = {0};
    struct aob_effects_desc desc = {.dispatch = one->chooser->dispatch,
                                    .maker = {make, one},
                                    .ask = {NAN, INFINITY, NULL},
                                    .picture = true};
    if (!aob_work_folder_create(&folder, error))
        return false;
    desc.folder = folder.path;
    bool ok = aob_effects_plan(&desc, &effects, error);
    *set = ok ? effects.answer.candidates[effects.answer.chosen].set : AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);
    if (ok)
        tell(one, *set);
    else
        ok = effects.unsupported ? give_up(one, error)
                                 : aob_fail_in(error, "%s/%s", one->c->scene->name, one->c->scene->view);
    aob_effects_finish(&effects);
    aob_work_folder_remove(&folder);
    return ok;
}

static bool is_view(const struct aob_case *a, const struct aob_case *b)
{
    return a->scene == b->scene && a->width == b->width && a->height == b->height &&
           strcmp(a->backend, b->backend) == 0;
}

static bool is_planned(const struct aob_case *c)
{
    return strcmp(c->technique->name, technique) == 0;
}

/* Of other techniques what stands in the config stays: the lit image with nothing besides visibility. `none` draws the empty set, and where the
 * config itself names it, it stays too. */
static bool is_kept(const struct aob_effects_auto *chooser, const struct aob_case *c, unsigned set)
{
    const unsigned own = aob_effect_set_of(c), visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);
    if (is_planned(c))
        return own == set;
    if (strcmp(c->technique->name, "none") == 0)
        return own == 0 && (set == 0 || names_none(chooser->config_of, c->backend));
    return (own & ~(AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE) | AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL))) == visible;
}

/* The first case of gtao that has the view of case i; NULL: gtao is not wanted there. */
static const struct aob_case *first_planned(const struct aob_plan *plan, size_t i)
{
    for (size_t k = 0; k < plan->case_count; k++)
        if (is_planned(&plan->cases[k]) && is_view(&plan->cases[k], &plan->cases[i]))
            return &plan->cases[k];
    return NULL;
}

/* Of these the plan of a view decides. */
static bool is_chosen(const struct aob_case *c)
{
    return is_planned(c) || strcmp(c->technique->name, "none") == 0;
}

/* Whether the filter leaves anything of the view of case i that the plan decides. */
static bool is_asked(const struct aob_plan *plan, size_t i, const char *filter)
{
    for (size_t k = 0; k < plan->case_count; k++)
        if (is_chosen(&plan->cases[k]) && is_view(&plan->cases[k], &plan->cases[i]) &&
            (!filter || aob_plan_matches(plan, &plan->cases[k], filter)))
            return true;
    return false;
}

/* The set of each case's view; each view with gtao is planned once, where it is asked for. */
static bool plan_views(struct aob_effects_auto *chooser, const struct aob_plan *plan, const char *filter,
                       unsigned *sets, struct aob_error *error)
{
    bool ok = true;
    for (size_t i = 0; i < plan->case_count && ok; i++) {
        const struct aob_case *c = &plan->cases[i];
        struct one one = {chooser, (size_t)(c->scene - plan->scenes), c};
        if (first_planned(plan, i) == c && is_asked(plan, i, filter))
            ok = plan_view(&one, &sets[i], error);
        else
            sets[i] = no_set;
    }
    for (size_t i = 0; i < plan->case_count; i++) {
        const struct aob_case *first = first_planned(plan, i);
        sets[i] = first ? sets[first - plan->cases] : no_set;
    }
    return ok;
}

/* Whether the filter keeps views from being planned, whose cases are not known then. */
static bool is_part(const struct aob_plan *plan, const char *filter)
{
    for (size_t i = 0; i < plan->case_count; i++)
        if (first_planned(plan, i) && !is_asked(plan, i, filter))
            return true;
    return false;
}

static bool choose(void *user, struct aob_plan *plan, const char *filter, struct aob_error *error)
{
    struct aob_effects_auto *chooser = user;
    unsigned *sets = AOB_NEW_ARRAY(unsigned, plan->case_count + 1);
    bool ok = plan_views(chooser, plan, filter, sets, error);
    size_t kept = 0;
    plan->part = is_part(plan, filter);
    for (size_t i = 0; i < plan->case_count; i++)
        if (is_kept(chooser, &plan->cases[i], sets[i]))
            plan->cases[kept++] = plan->cases[i];
        else
            free(plan->cases[i].params);
    plan->case_count = kept;
    free(sets);
    return ok;
}

struct aob_sweep_choice aob_effects_auto_choice(struct aob_effects_auto *chooser)
{
    return (struct aob_sweep_choice){widen, choose, chooser};
}

#include "sweep.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/shelf.h"
#include "captures.h"
#include "lights.h"

/* Where a path leads to nothing, loading it will say so. */
static bool same_file(const char *a, const char *b)
{
    char *p = realpath(a, NULL), *q = realpath(b, NULL);
    bool same = !p || !q || strcmp(p, q) == 0;
    free(p);
    free(q);
    return same;
}

/* The --module files and those of the config's entries, each name once. A name that stands for two files would not say
 * which of them a record is of. */
struct gathered {
    const char **paths, **names; /* borrowed */
    size_t count, offered;       /* offered: of the --module files, which come first */
};

static bool gather(struct gathered *all, const char *name, const char *path, struct aob_error *error)
{
    for (size_t i = 0; i < all->count; i++) {
        if (strcmp(all->names[i], name) != 0)
            continue;
        return same_file(all->paths[i], path) ||
               aob_fail(error,
                        "%s names two modules, %s and %s: write one of them by another path, such as ./%s",
                        name, all->paths[i], path, name);
    }
    all->paths[all->count] = path;
    all->names[all->count++] = name;
    return true;
}

static bool gather_all(struct gathered *all, const struct aob_sweep *sweep, const struct aob_modules *offered,
                       struct aob_error *error)
{
    const struct aob_config *config = &sweep->config;
    all->paths = AOB_NEW_ARRAY(const char *, offered->count + config->technique_count + 1);
    all->names = AOB_NEW_ARRAY(const char *, offered->count + config->technique_count + 1);
    for (size_t i = 0; i < offered->count; i++) {
        gather(all, offered->names[i], offered->paths[i], NULL); /* in one folder equal names are one file */
        all->offered = i < offered->offered ? all->count : all->offered;
    }
    for (size_t i = 0; i < config->technique_count; i++) {
        const struct aob_technique_choice *choice = &config->techniques[i];
        if (choice->file && !gather(all, choice->module.text, choice->file, error))
            return aob_config_fail_at(config, choice->module.line, choice->module.column, error);
    }
    return true;
}

/* The line names the module by its whole path; the config's place goes before it. */
static bool names(const struct aob_error *error, const char *file)
{
    char *path = aob_path_absolute(file);
    bool found = strstr(error->text, path);
    free(path);
    return found;
}

static bool fail_at_module(const struct aob_config *config, struct aob_error *error)
{
    for (size_t i = 0; i < config->technique_count; i++) {
        const struct aob_technique_choice *choice = &config->techniques[i];
        if (choice->file && names(error, choice->file))
            return aob_config_fail_at(config, choice->module.line, choice->module.column, error);
    }
    return false;
}

static bool describe(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error)
{
    struct gathered all = {0};
    bool ok = gather_all(&all, sweep, &dispatch->modules, error);
    const struct aob_modules modules = {all.paths, all.names, all.count, all.offered};
    ok = ok && (aob_dispatch_describe(dispatch, &modules, &sweep->techniques, error) ||
                fail_at_module(&sweep->config, error));
    free(all.paths);
    free(all.names);
    return ok;
}

/* One line a scene: what is said of it holds for its other cases too. */
static void warn_of_units(const struct aob_sweep *sweep)
{
    const char *told = NULL;
    for (size_t i = 0; i < sweep->plan.case_count; i++) {
        const struct aob_case *c = &sweep->plan.cases[i];
        struct aob_error line;
        if ((told && strcmp(told, c->scene->name) == 0) || !aob_case_mixes_units(c, &sweep->config, &line))
            continue;
        aob_warn("%s", line.text);
        told = c->scene->name;
    }
}

/* A path in the config is seen from its folder. */
static bool read_budget(struct aob_sweep *sweep, struct aob_error *error)
{
    const struct aob_value *value = &sweep->config.budget;
    if (!value->text)
        return true;
    char *name = aob_shelf_is_path(value->text) ? aob_path_beside(sweep->config.place, value->text)
                                                : aob_strdup(value->text);
    bool ok = aob_budget_find(&sweep->budget, name, error) ||
              aob_config_fail_at(&sweep->config, value->line, value->column, error);
    free(name);
    return ok;
}

static bool has_rates(const struct aob_plan *plan, const char *device)
{
    bool rates = false;
    for (size_t i = 0; i < plan->profile_count; i++)
        rates = rates || (plan->profiles[i].rates && strcmp(plan->profiles[i].name, device) == 0);
    return rates;
}

static bool has_size(const struct aob_plan *plan, int width, int height)
{
    bool size = false;
    for (size_t i = 0; i < plan->case_count && !size; i++)
        size = plan->cases[i].width == width && plan->cases[i].height == height;
    return size;
}

/* What no case of the plan can have is known before the first one is measured. It is no error: the cases are worth as much
 * without the budget. */
static void warn_of_budget(const struct aob_sweep *sweep)
{
    const struct aob_budget *budget = &sweep->budget;
    const struct aob_value *value = &sweep->config.budget;
    struct aob_error line = {{0}};
    if (budget->device && !has_rates(&sweep->plan, budget->device))
        aob_fail(
            &line,
            "the budget is of '%s', and no time will be modelled on that: name a profile of it with rates, "
            "as measure: {cache: [%s]}, or give the budget another device",
            budget->device, budget->device);
    else if (budget->width && !has_size(&sweep->plan, budget->width, budget->height))
        aob_fail(&line, "the budget is of %dx%d, and no case has that size: add it to the resolutions",
                 budget->width, budget->height);
    else
        return;
    aob_config_fail_at(&sweep->config, value->line, value->column, &line);
    aob_warn("%s", line.text);
}

static bool widen(struct aob_sweep *sweep, struct aob_error *error)
{
    const struct aob_value *effects = &sweep->config.effects;
    if (!effects->text)
        return true;
    bool ok =
        sweep->choice
            ? sweep->choice->widen(sweep->choice->user, &sweep->config, error)
            : aob_fail(
                  error,
                  "effects: auto is for `aobudget run` alone, which plans each view first: write a view's "
                  "config with `aobudget effects SCENE --out FILE.yaml`, and give that");
    return ok || aob_config_fail_at(&sweep->config, effects->line, effects->column, error);
}

bool aob_sweep_choose(struct aob_sweep *sweep, const char *filter, struct aob_error *error)
{
    return !sweep->config.effects.text ||
           sweep->choice->choose(sweep->choice->user, &sweep->plan, filter, error);
}

bool aob_sweep_expand(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error)
{
    bool ok = widen(sweep, error) && read_budget(sweep, error) && describe(sweep, dispatch, error) &&
              aob_captures_load(&sweep->config, dispatch, error) &&
              aob_lights_load(&sweep->config, dispatch, error) &&
              aob_plan_create(&sweep->plan, &sweep->config, &sweep->techniques, error);
    if (ok) {
        warn_of_units(sweep);
        warn_of_budget(sweep);
    }
    return ok;
}

void aob_sweep_finish(struct aob_sweep *sweep)
{
    aob_budget_finish(&sweep->budget);
    aob_plan_finish(&sweep->plan);
    aob_technique_list_finish(&sweep->techniques);
    aob_config_finish(&sweep->config);
}

#include "budget_reason.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/shelf.h"
#include "base/table.h"
#include "base/text.h"
#include "profile/profile.h"

/* The rows that every stage before has kept. */
struct kept {
    const struct aob_rows *rows;
    const struct aob_ask *ask;
    const char *folder;
    const struct aob_row **list;
    size_t count;
};

/* A list of texts without twice the same one: "a, b". */
struct names {
    struct aob_table seen;
    struct aob_text text;
};

static void add_name(struct names *names, const char *name)
{
    if (aob_table_find(&names->seen, name, NULL))
        return;
    aob_table_put(&names->seen, name, 0);
    aob_text_add(&names->text, "%s%s", names->text.size ? ", " : "", name);
}

static void finish_names(struct names *names)
{
    aob_table_finish(&names->seen);
    aob_text_finish(&names->text);
}

static bool is_good(const struct aob_ask *ask, const struct aob_row *row)
{
    (void)ask;
    return aob_row_is_ok(row);
}

static void say_good(const struct kept *kept, struct aob_error *error)
{
    if (!kept->count)
        aob_fail(error, "%s: its journal holds no case", kept->folder);
    else
        aob_fail(error, "%s: none of its %zu cases is good: the journal has the reasons", kept->folder,
                 kept->count);
}

static bool has_scene(const struct aob_ask *ask, const struct aob_row *row)
{
    return !ask->scene || strcmp(ask->scene, row->scene) == 0;
}

static void say_scene(const struct kept *kept, struct aob_error *error)
{
    struct names scenes = {0};
    for (size_t i = 0; i < kept->count; i++)
        add_name(&scenes, kept->list[i]->scene);
    aob_fail(error, "%s: no good case of the scene %s; the good ones are of %s", kept->folder,
             kept->ask->scene, scenes.text.data);
    finish_names(&scenes);
}

static bool has_size(const struct aob_ask *ask, const struct aob_row *row)
{
    return !ask->width || (ask->width == row->width && ask->height == row->height);
}

static void say_size(const struct kept *kept, struct aob_error *error)
{
    struct names sizes = {0};
    const struct aob_ask *ask = kept->ask;
    for (size_t i = 0; i < kept->count; i++) {
        struct aob_text size = {0};
        aob_text_add(&size, "%dx%d", kept->list[i]->width, kept->list[i]->height);
        add_name(&sizes, size.data);
        aob_text_finish(&size);
    }
    aob_fail(error, "%s: no good case%s%s of %dx%d, the budget's resolution; there are %s", kept->folder,
             ask->scene ? " of " : "", ask->scene ? ask->scene : "", ask->width, ask->height,
             sizes.text.data);
    finish_names(&sizes);
}

static bool may_choose(const struct aob_ask *ask, const struct aob_row *row)
{
    (void)ask;
    return aob_ask_may_choose(row->json);
}

static void say_choice(const struct kept *kept, struct aob_error *error)
{
    struct names techniques = {0};
    for (size_t i = 0; i < kept->count; i++)
        add_name(&techniques, kept->list[i]->name);
    aob_fail(error,
             "%s: no case of these that may be chosen is good; the good ones are of %s: the journal has the "
             "reasons of the others",
             kept->folder, techniques.text.data);
    finish_names(&techniques);
}

static bool has_cost(const struct aob_ask *ask, const struct aob_row *row)
{
    return isfinite(aob_ask_cost(ask, row->json).at);
}

static void add_profiles(struct names *names, const struct aob_row *row)
{
    const char *name;
    json_t *figures;
    json_object_foreach(json_object_get(row->json, "cache"), name, figures)
    {
        if (isfinite(aob_costs_modelled(row->json, name).at))
            add_name(names, name);
    }
}

static bool is_profile(const char *name)
{
    char *path = aob_shelf_find(AOB_PROFILE_SHELF, "profile", name, NULL);
    bool found = path != NULL;
    free(path);
    return found;
}

static void say_cost(const struct kept *kept, struct aob_error *error)
{
    const char *profile = kept->ask->profile;
    struct names has = {0};
    if (!profile) {
        aob_fail(error, "%s: no case was timed: run it with measure: {time: true}, or give --profile",
                 kept->folder);
        return;
    }
    for (size_t i = 0; i < kept->count; i++)
        add_profiles(&has, kept->list[i]);
    if (has.text.size && !is_profile(profile))
        aob_fail(error, "%s: no case has a time modelled on '%s', and no profile has that name; it has %s",
                 kept->folder, profile, has.text.data);
    else
        aob_fail(
            error,
            "%s: no case has a time modelled on '%s': put measure: {cache: [%s]} into its config and run "
            "it again; the profile needs rates%s%s",
            kept->folder, profile, profile, has.text.size ? "; it has " : "",
            has.text.size ? has.text.data : "");
    finish_names(&has);
}

static bool has_error(const struct aob_ask *ask, const struct aob_row *row)
{
    bool has = false;
    for (size_t i = 0; i < row->score_count && !has; i++) {
        double radius = aob_target_of(row->scores[i].json, row->json).radius;
        has = isfinite(aob_costs_error(row->scores[i].json)) &&
              (isnan(ask->radius) || (float)ask->radius == (float)radius);
    }
    return has;
}

static void say_error(const struct kept *kept, struct aob_error *error)
{
    struct names radii = {0};
    for (size_t i = 0; i < kept->count; i++)
        for (size_t k = 0; k < kept->list[i]->score_count; k++) {
            struct aob_text radius = {0};
            aob_text_add(&radius, "%g", kept->rows->targets[kept->list[i]->scores[k].target].radius);
            add_name(&radii, radius.data);
            aob_text_finish(&radius);
        }
    if (!radii.text.size || isnan(kept->ask->radius))
        aob_fail(error, "%s: no case of these has an error: run it with measure: {error: true}",
                 kept->folder);
    else
        aob_fail(error, "%s: no case of these has an error against the target %g; the radii are %s",
                 kept->folder, kept->ask->radius, radii.text.data);
    finish_names(&radii);
}

static const struct stage {
    bool (*keeps)(const struct aob_ask *ask, const struct aob_row *row);
    void (*say)(const struct kept *kept,
                struct aob_error *error); /* of those before, none of which is kept */
} stages[] = {{is_good, say_good},      {has_scene, say_scene}, {has_size, say_size},
              {may_choose, say_choice}, {has_cost, say_cost},   {has_error, say_error}};

/* Behind those that are kept lie the others, so that the line can speak of all. */
static size_t keep(const struct kept *kept, const struct stage *stage)
{
    size_t count = 0;
    for (size_t i = 0; i < kept->count; i++)
        if (stage->keeps(kept->ask, kept->list[i])) {
            const struct aob_row *row = kept->list[i];
            kept->list[i] = kept->list[count];
            kept->list[count++] = row;
        }
    return count;
}

bool aob_budget_judge(const struct aob_rows *rows, const struct aob_ask *ask, struct aob_error *error)
{
    struct kept kept = {rows, ask, rows->runs[0].folder,
                        AOB_NEW_ARRAY(const struct aob_row *, rows->count + 1), rows->count};
    bool ok = true;
    for (size_t i = 0; i < rows->count; i++)
        kept.list[i] = &rows->list[i];
    for (size_t i = 0; i < AOB_COUNT(stages) && ok; i++) {
        size_t count = keep(&kept, &stages[i]);
        if (!count)
            stages[i].say(&kept, error);
        ok = count > 0;
        kept.count = count;
    }
    free(kept.list);
    return ok;
}

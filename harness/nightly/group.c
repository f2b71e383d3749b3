#include "group.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/member.h"
#include "base/memory.h"
#include "compare/builds.h"

/* What tells groups apart, as in struct aob_group. */
struct group_of {
    bool beside;
    const char *module, *old, *old_module;
};

static struct aob_group *find(struct aob_groups *groups, const char *night_folder, const struct group_of *of)
{
    for (size_t i = 0; i < groups->count; i++) {
        struct aob_group *group = groups->list[i];
        if (group->beside == of->beside && strcmp(group->module, of->module) == 0 &&
            strcmp(group->old, of->old) == 0 && strcmp(group->old_module, of->old_module) == 0)
            return group;
    }
    struct aob_group *group = AOB_NEW(struct aob_group);
    *AOB_PUSH(groups->list, groups->count, groups->capacity) = group;
    struct aob_text name = {0};
    aob_text_add(&name, "%s/%zu", of->beside ? "beside" : "images", groups->count);
    *group = (struct aob_group){.name = name.data,
                                .folder = aob_path_join(night_folder, name.data),
                                .beside = of->beside,
                                .module = aob_strdup(of->module),
                                .old = aob_strdup(of->old),
                                .old_module = aob_strdup(of->old_module)};
    return group;
}

struct aob_group *aob_groups_beside(struct aob_groups *groups, const char *night_folder,
                                    const struct aob_point *now, const char *old)
{
    return find(groups, night_folder, &(struct group_of){true, now->module, old, old});
}

struct aob_group *aob_groups_stored(struct aob_groups *groups, const char *night_folder,
                                    const struct aob_point *now, const struct aob_point *before,
                                    const char *old)
{
    return find(groups, night_folder, &(struct group_of){false, now->module, old, before->module});
}

void aob_group_add(struct aob_group *group, struct aob_suspect *suspect)
{
    *AOB_PUSH(group->items, group->count, group->capacity) = suspect;
    aob_table_put(&group->keys, suspect->now->key, group->count);
}

/* To compare, the new build is the stored one, since its records are there. Those that nobody suspects are left out. */
static void leave_suspects(const struct aob_group *group, struct aob_old_module *stored)
{
    for (size_t i = json_array_size(stored->records); i-- > 0;)
        if (!aob_table_find(&group->keys, aob_member_text(json_array_get(stored->records, i), "key"), NULL))
            json_array_remove(stored->records, i);
}

/* A night that times nothing asks for the images alone, so the timing that comes with them is as short as can be. */
static double seconds_of(const struct aob_group *group, const struct aob_nightly_desc *desc)
{
    for (size_t i = 0; i < group->count; i++)
        if (isfinite(group->items[i]->now->ratio))
            return desc->seconds;
    return 0.05;
}

static bool measure(const struct aob_group *group, const struct aob_nightly_desc *desc, const char *run,
                    struct aob_error *error)
{
    const struct aob_compare_desc compare = {.dispatch = desc->dispatch,
                                             .sides = {run, group->old},
                                             .precision = desc->precision,
                                             .seconds = seconds_of(group, desc),
                                             .quiet = true};
    struct aob_old_module stored = {0};
    bool ok = aob_old_module_find(&stored, &compare, group->module, error);
    if (ok) {
        leave_suspects(group, &stored);
        ok = aob_builds_measure_again(&compare, &stored, group->folder, error);
    }
    aob_old_module_finish(&stored);
    return ok;
}

bool aob_group_measure(struct aob_group *group, const struct aob_nightly_desc *desc, const char *run,
                       struct aob_error *error)
{
    bool beside = group->beside;
    struct aob_contest *contest = &group->contest;
    *contest = (struct aob_contest){.names = {group->old, beside ? group->module : run},
                                    .folders = {beside ? group->folder : group->old, beside ? NULL : run},
                                    .modules = {group->old_module, group->module},
                                    .keys = beside ? NULL : &group->keys,
                                    .maps = group->folder,
                                    .precision = desc->precision};
    group->tried = true;
    group->ready = aob_folder_create(group->folder, error) && (!beside || measure(group, desc, run, error)) &&
                   aob_contest_read(contest, error);
    return group->ready;
}

const struct aob_compared *aob_group_item(const struct aob_group *group, const struct aob_suspect *suspect)
{
    const struct aob_couples *couples = &group->contest.couples;
    for (size_t i = 0; group->ready && i < couples->count; i++)
        if (strcmp(couples->items[i].b->key, suspect->now->key) == 0)
            return &group->contest.table.items[i];
    return NULL;
}

void aob_groups_finish(struct aob_groups *groups)
{
    for (size_t i = 0; i < groups->count; i++) {
        struct aob_group *group = groups->list[i];
        aob_contest_finish(&group->contest);
        aob_table_finish(&group->keys);
        free(group->items);
        free(group->name);
        free(group->folder);
        free(group->module);
        free(group->old);
        free(group->old_module);
        free(group);
    }
    free(groups->list);
    *groups = (struct aob_groups){0};
}

#include "property.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "groups.h"

const struct aob_property *const aob_property_tables[] = {
    aob_properties_projection, aob_properties_numbers,     aob_properties_near,
    aob_properties_normals,    aob_properties_resolution,  aob_properties_edges,
    aob_properties_halos,      aob_properties_faces,       aob_properties_relations,
    aob_properties_thrift,     aob_properties_directions,  aob_properties_light,
    aob_properties_time,       aob_properties_instruments, NULL,
};

static const char *const group_names[AOB_GROUP_COUNT] = {
    [AOB_GROUP_PROJECTION] = "projection",
    [AOB_GROUP_NUMBERS] = "numbers",
    [AOB_GROUP_NEAR] = "near",
    [AOB_GROUP_NORMALS] = "normals",
    [AOB_GROUP_RESOLUTION] = "resolution",
    [AOB_GROUP_EDGES] = "edges",
    [AOB_GROUP_RELATIONS] = "relations",
    [AOB_GROUP_DIRECTIONS] = "directions",
    [AOB_GROUP_LIGHT] = "light",
    [AOB_GROUP_TIME] = "time",
    [AOB_GROUP_INSTRUMENTS] = "instruments",
};

const char *aob_property_group_name(enum aob_property_group group)
{
    return group_names[group];
}

const struct aob_property *aob_property_find(const char *name)
{
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++)
            if (strcmp(p->name, name) == 0)
                return p;
    return NULL;
}

size_t aob_property_count(void)
{
    size_t count = 0;
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++)
            count++;
    return count;
}

const struct aob_bound *aob_bound_find(const char *property)
{
    for (const struct aob_bound *bound = aob_bounds; bound->property; bound++)
        if (strcmp(bound->property, property) == 0)
            return bound;
    return NULL;
}

const char *aob_outcome_word(enum aob_outcome outcome)
{
    static const char *const words[] = {"pass", "fail", "by definition", "n/a"};
    return words[outcome];
}

static void answer_not_applicable(struct aob_answer *answer, const char *why)
{
    *answer = (struct aob_answer){.outcome = AOB_NOT_APPLICABLE, .worst = NAN, .bound = NAN};
    aob_line_print(answer->reason, sizeof answer->reason, "%s", why);
}

/* What the technique says of this property; NULL: nothing. */
static const char *declaration(const struct aob_trial *trial, const char *property)
{
    const struct aob_by_definition *d = trial->subject ? trial->subject->technique->by_definition : NULL;
    for (; d && d->property; d++)
        if (strcmp(d->property, property) == 0)
            return d->because;
    return NULL;
}

static void judge(const struct aob_property *property, const struct aob_trial *trial,
                  struct aob_answer *answer)
{
    const struct aob_bound *bound = aob_bound_find(property->name);
    const char *because = declaration(trial, property->name);
    bool software = !trial->subject || trial->subject->gpu->info.software;
    answer->bound = !bound ? NAN : software ? bound->software : bound->gpu;
    answer->worst = trial->asked ? trial->worst : NAN;
    answer->declared = because;
    aob_line_print(answer->where, sizeof answer->where, "%s", trial->asked ? trial->sight.where : "");
    bool told = trial->asked && !*trial->error.text && !trial->broken; /* no definition wants anything else */
    bool passes = told && trial->worst <= answer->bound;
    answer->outcome = passes ? AOB_PASSES : told && because ? AOB_BY_DEFINITION : AOB_FAILS;
    if (answer->outcome == AOB_BY_DEFINITION)
        aob_line_print(answer->reason, sizeof answer->reason, "%s", because);
    else if (*trial->error.text)
        aob_line_print(answer->reason, sizeof answer->reason, "%s", trial->error.text);
    else
        aob_line_print(answer->reason, sizeof answer->reason, "%s",
                       trial->asked ? trial->sight.where : "the property took no answer");
}

void aob_property_ask(const struct aob_property *property, struct aob_trial *trial, struct aob_answer *answer)
{
    *answer = (struct aob_answer){0};
    const char *excuse = trial->subject && property->excuse ? property->excuse(trial->subject) : NULL;
    if (excuse) {
        answer_not_applicable(answer, excuse);
        return;
    }
    property->ask(trial);
    judge(property, trial, answer);
    /* An excuse that comes late takes back no failure. */
    if (*trial->excuse.text && (!trial->asked || (trial->worst <= answer->bound && !trial->broken)))
        answer_not_applicable(answer, trial->excuse.text);
}

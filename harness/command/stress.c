#include "stress/stress.h"
#include "command.h"

struct options {
    struct aob_common common;
    const char *technique, *backend, *out;
    struct aob_words properties;
    bool quick, list;
};

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct options, field)                                    \
    }
static const struct aob_flag flags[] = {
    TEXT("technique", "NAME", technique, "only this one (all; with --module, all of the modules)"),
    {"property", "NAME", "only this one; may be repeated; see --list", AOB_FLAG_MANY,
     offsetof(struct options, properties)},
    TEXT("backend", "NAME", backend, "only this one; see: aobudget list backends (all that draw)"),
    TEXT("out", "DIR", out, "stress.json, its page, and a picture of each place where a property fails"),
    {"quick", NULL, "the properties that need few programs, at fewer places", AOB_FLAG_SWITCH,
     offsetof(struct options, quick)},
    {"list", NULL, "print the properties with their bounds, and ask nothing", AOB_FLAG_SWITCH,
     offsetof(struct options, list)},
    {0},
};

static enum aob_exit stress(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_text table = {0};
    if (o->list) {
        aob_stress_list(&o->common.out);
        return AOB_EXIT_OK;
    }
    enum aob_exit code = aob_stress(&(struct aob_stress_desc){.dispatch = o->common.dispatch,
                                                              .technique = o->technique,
                                                              .properties = o->properties.items,
                                                              .property_count = o->properties.count,
                                                              .backend = o->backend,
                                                              .quick = o->quick,
                                                              .out = o->out,
                                                              .json = o->common.json,
                                                              .quiet = o->common.quiet},
                                    &table, error);
    if (aob_common_speaks(&o->common) && table.size)
        aob_text_add_bytes(&o->common.out, table.data, table.size);
    aob_text_finish(&table);
    aob_words_finish(&o->properties);
    return code;
}

const struct aob_command aob_command_stress = {
    .name = "stress",
    .help = "hard cases: whether each technique stays stable where renderers went wrong",
    .usage = "[--technique T] [--property P] [--backend B] [--quick] [--out DIR] [--module FILE.so]",
    .summary = "Puts every technique on every backend to properties that real renderers broke.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .size = sizeof(struct options),
    .run = stress,
};

#include "stress/stress.h"
#include <math.h>
#include "command.h"
#include "stress/fuzz.h"

struct options {
    struct aob_common common;
    const char *technique, *backend, *out, *fuzz, *seed, *from;
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
    TEXT("fuzz", "N", fuzz, "instead of the properties, N small frames drawn by lot, shared among the rows"),
    TEXT("seed", "S", seed, "of these frames, a whole number (1)"),
    TEXT("from", "I", from, "each row's first frame (0), as a line that reports one says it"),
    {"quick", NULL, "the properties that need few programs, at fewer places", AOB_FLAG_SWITCH,
     offsetof(struct options, quick)},
    {"list", NULL, "print the properties with their bounds, and ask nothing", AOB_FLAG_SWITCH,
     offsetof(struct options, list)},
    {0},
};

/* A whole number that a double holds exactly. */
static bool read_number(const char *flag, const char *text, uint64_t least, uint64_t *number,
                        struct aob_error *error)
{
    double value;
    if (!text)
        return true;
    if (!aob_parse_double(text, &value) || value != floor(value) || value < (double)least || value > 0x1p53)
        return aob_fail(error, "%s: '%s' is not a whole number from %llu to 2^53", flag, text,
                        (unsigned long long)least);
    *number = (uint64_t)value;
    return true;
}

static enum aob_exit fuzz(const struct options *o, struct aob_text *table, struct aob_error *error)
{
    struct aob_fuzz_desc desc = {.dispatch = o->common.dispatch,
                                 .technique = o->technique,
                                 .backend = o->backend,
                                 .seed = 1,
                                 .out = o->out,
                                 .json = o->common.json,
                                 .quiet = o->common.quiet};
    if (o->properties.count || o->quick) {
        aob_fail(error, "--fuzz draws frames and asks no property: leave out --property and --quick");
        return AOB_EXIT_USAGE;
    }
    if (!read_number("--fuzz", o->fuzz, 1, &desc.frames, error) ||
        !read_number("--seed", o->seed, 0, &desc.seed, error) ||
        !read_number("--from", o->from, 0, &desc.from, error))
        return AOB_EXIT_USAGE;
    return aob_fuzz(&desc, table, error);
}

static enum aob_exit ask(const struct options *o, struct aob_text *table, struct aob_error *error)
{
    if (o->seed || o->from) {
        aob_fail(error, "--seed and --from choose frames of --fuzz N: give that as well");
        return AOB_EXIT_USAGE;
    }
    return aob_stress(&(struct aob_stress_desc){.dispatch = o->common.dispatch,
                                                .technique = o->technique,
                                                .properties = o->properties.items,
                                                .property_count = o->properties.count,
                                                .backend = o->backend,
                                                .quick = o->quick,
                                                .out = o->out,
                                                .json = o->common.json,
                                                .quiet = o->common.quiet},
                      table, error);
}

static enum aob_exit stress(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_text table = {0};
    if (o->list) {
        aob_stress_list(&o->common.out);
        return AOB_EXIT_OK;
    }
    enum aob_exit code = o->fuzz ? fuzz(o, &table, error) : ask(o, &table, error);
    if (aob_common_speaks(&o->common) && table.size)
        aob_text_add_bytes(&o->common.out, table.data, table.size);
    aob_text_finish(&table);
    aob_words_finish(&o->properties);
    return code;
}

const struct aob_command aob_command_stress = {
    .name = "stress",
    .help = "hard cases: whether each technique stays stable where renderers went wrong",
    .usage = "[--technique T] [--property P] [--backend B] [--quick] [--fuzz N [--seed S]] [--out DIR] "
             "[--module FILE.so]",
    .summary = "Puts every technique on every backend to properties that real renderers broke.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .size = sizeof(struct options),
    .run = stress,
};

#include <stdint.h>
#include "base/json.h"
#include "base/text.h"
#include "cache_frame.h"
#include "command.h"
#include "profile/lines.h"

struct options {
    struct aob_common common;
    struct aob_single_flags frame;
    const char *profile, *out;
    const char *lines, *sets, *ways, *index;
};

static const struct aob_flag flags[] = {
    AOB_FLAG_OF(struct options, profile, "profile", "P[,P...]",
                "whose caches: a name (see: aobudget list profiles) or a file"),
    AOB_FLAG_OF(struct options, out, "out", "FILE.exr",
                "misses by pixel; for each profile also a picture and a .vti file for ParaView"),
    AOB_SINGLE_FLAGS(struct options, frame),
    AOB_FLAG_OF(struct options, lines, "lines", "FILE",
                "no frame, but a stream of 32-bit line numbers, little-endian"),
    AOB_FLAG_OF(struct options, sets, "sets", "N", "of the cache that the stream goes through"),
    AOB_FLAG_OF(struct options, ways, "ways", "N", "of a set"),
    AOB_FLAG_OF(struct options, index, "index", "modulo|xor",
                "which set a line is in: line, or line ^ line >> b ^ line >> 2b of 2^b sets"),
    {0},
};

static bool read_count(const char *flag, const char *text, uint32_t *count, struct aob_error *error)
{
    double number;
    if (!text)
        return aob_fail(error, "cache: --lines needs --sets, --ways and --index as well: --%s is missing",
                        flag);
    if (!aob_parse_double(text, &number) || !(number >= 1 && number <= INT32_MAX) ||
        number != (double)(uint32_t)number)
        return aob_fail(error, "--%s: '%s' is not a whole number within 1 .. %d", flag, text, INT32_MAX);
    *count = (uint32_t)number;
    return true;
}

static bool read_cache(const struct options *o, struct aob_lines_desc *desc, struct aob_error *error)
{
    desc->path = o->lines;
    if (!read_count("sets", o->sets, &desc->sets, error) || !read_count("ways", o->ways, &desc->ways, error))
        return false;
    if (!o->index)
        return aob_fail(error, "cache: --lines needs --sets, --ways and --index as well: --index is missing");
    return aob_index_find(o->index, &desc->index) ||
           aob_fail(error, "--index: '%s' is neither modulo nor xor", o->index);
}

static json_t *to_json(const struct aob_lines_desc *desc, const struct aob_misses *misses)
{
    return json_pack("{s:s, s:I, s:I, s:s, s:I, s:I, s:I, s:I, s:I}", "lines", desc->path, "sets",
                     (json_int_t)desc->sets, "ways", (json_int_t)desc->ways, "index",
                     aob_index_name(desc->index), "accesses", (json_int_t)misses->accesses, "misses",
                     (json_int_t)misses->misses, "compulsory", (json_int_t)misses->compulsory, "capacity",
                     (json_int_t)misses->capacity, "conflict", (json_int_t)misses->conflict);
}

static void print(const struct aob_misses *misses, struct aob_text *out)
{
    aob_text_add_line(
        out, "%llu accesses, %llu misses (%.2f %%): %llu compulsory, %lld capacity, %lld conflict",
        (unsigned long long)misses->accesses, (unsigned long long)misses->misses,
        misses->accesses ? 100.0 * (double)misses->misses / (double)misses->accesses : 0.0,
        (unsigned long long)misses->compulsory, (long long)misses->capacity, (long long)misses->conflict);
}

static enum aob_exit cache_lines(struct options *o, struct aob_error *error)
{
    struct aob_lines_desc desc;
    struct aob_misses misses;
    if (!aob_json_check(o->common.json, error) || !read_cache(o, &desc, error) ||
        !aob_lines_simulate(&desc, &misses, error))
        return AOB_EXIT_USAGE;
    if (aob_common_speaks(&o->common))
        print(&misses, &o->common.out);
    if (!o->common.json)
        return AOB_EXIT_OK;
    json_t *document = to_json(&desc, &misses);
    bool ok = aob_json_write(document, o->common.json, error);
    json_decref(document);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

static enum aob_exit cache(void *from, struct aob_error *error)
{
    struct options *o = from;
    const struct aob_cache_frame_desc desc = {&o->common, &o->frame, o->profile, o->out};
    bool frame = o->frame.technique || o->frame.scene || o->profile;
    if (frame && o->lines)
        aob_fail(error, "cache: give a frame or --lines, not both");
    else if (!frame && !o->lines)
        aob_fail(error,
                 "cache: say of what: --technique T --scene S --profile P, or --lines FILE; see: aobudget "
                 "cache --help");
    enum aob_exit code = *error->text ? AOB_EXIT_USAGE
                         : frame      ? aob_cache_frame(&desc, error)
                                      : cache_lines(o, error);
    aob_words_finish(&o->frame.params);
    return code;
}

const struct aob_command aob_command_cache = {
    .name = "cache",
    .help = "what caches miss",
    .usage = "--technique T --scene S --profile P[,P...] [flags], or --lines FILE --sets N --ways N --index "
             "modulo|xor",
    .summary = "What the caches of a profile miss of the fetches of one frame, or one cache of a stream.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .size = sizeof(struct options),
    .run = cache,
};

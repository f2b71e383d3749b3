#include <stdlib.h>
#include "ask.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "fuzz_shrink.h"
#include "job/fuzz_job.h"
#include "store/image.h"

/* Programs that are kept: those of more constants than that are seldom met again. */
enum { MOST_PROGRAMS = 64 };

struct fuzzing {
    struct aob_worker *worker;
    struct aob_fuzz_job job;
    struct aob_registry registry;
    struct aob_gpu *gpu;
    struct aob_fuzz_artist artist;
    bool has_artist;
    uint32_t known; /* bits of faults that were told with their frames */
};

static void reply(struct fuzzing *fuzzing, const struct aob_fuzz_answer *answer)
{
    aob_worker_reply(fuzzing->worker, aob_fuzz_answer_to_json(answer));
}

static bool open_artist(struct fuzzing *fuzzing, struct aob_error *error)
{
    const struct aob_fuzz_job *job = &fuzzing->job;
    const struct aob_technique *technique = aob_registry_open(&fuzzing->registry, &job->technique, error);
    const struct aob_gpu_desc desc = {.validate = job->validate, .robust = true, .device = job->device};
    fuzzing->gpu = technique ? aob_gpu_open(job->backend, &desc, error) : NULL;
    if (!fuzzing->gpu)
        return false;
    aob_subject_init(&fuzzing->artist.subject, technique, fuzzing->gpu);
    fuzzing->has_artist = true;
    reply(fuzzing, &(struct aob_fuzz_answer){.message = AOB_FUZZ_OPENED,
                                             .device = fuzzing->gpu->info.device,
                                             .driver = fuzzing->gpu->info.driver});
    return true;
}

static void add_channels(struct aob_image *image, const float *pixels, size_t stride,
                         const char *const *names)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t c = 0; names[c]; c++) {
        float *into = aob_image_add(image, names[c]);
        for (size_t i = 0; i < count; i++)
            into[i] = pixels[stride * i + c];
    }
}

static void write_image(struct aob_image *image, const char *stem, const char *end)
{
    struct aob_text path = {0};
    struct aob_error error = {{0}};
    aob_text_add(&path, "%s%s", stem, end);
    if (!aob_image_write(image, path.data, &error))
        aob_warn("%s", error.text);
    aob_image_finish(image);
    aob_text_finish(&path);
}

static void write_images(const struct aob_fuzz_frame *frame, const struct aob_fuzz_sight *sight,
                         const char *stem)
{
    static const char *const normal[] = {"N.X", "N.Y", "N.Z", NULL},
                             *const shading[] = {"S.X", "S.Y", "S.Z", NULL}, *const depth[] = {"Z", NULL},
                             *const ao[] = {"technique.AO", NULL}, *const again[] = {"again.AO", NULL},
                             *const albedo[] = {"albedo.R", "albedo.G", "albedo.B", NULL},
                             *const shine[] = {"roughness", "metalness", NULL};
    struct aob_image seen = {.width = frame->gbuffer.projection.width,
                             .height = frame->gbuffer.projection.height};
    struct aob_image drawn = {.width = aob_fuzz_frame_width(frame), .height = aob_fuzz_frame_height(frame)};
    add_channels(&seen, frame->gbuffer.depth, 1, depth);
    add_channels(&seen, frame->gbuffer.normal, 4, normal);
    add_channels(&seen, frame->gbuffer.shading, 4, shading);
    add_channels(&seen, frame->gbuffer.albedo, 3, albedo);
    add_channels(&seen, frame->gbuffer.shine, 2, shine);
    write_image(&seen, stem, "-gbuffer.exr");
    add_channels(&drawn, sight->drawn[0].of[AOB_OUT_VISIBILITY], 1, ao);
    add_channels(&drawn, sight->drawn[1].of[AOB_OUT_VISIBILITY], 1, again);
    write_image(&drawn, stem, "-image.exr");
}

/* The frame as JSON, with its images beside it. */
static json_t *write_frame(const struct fuzzing *fuzzing, const struct aob_fuzz_frame *frame,
                           const struct aob_fuzz_sight *sight, uint64_t index)
{
    json_t *document = aob_fuzz_frame_to_json(frame);
    struct aob_text name = {0}, file = {0};
    struct aob_error error = {{0}};
    if (!fuzzing->artist.triangles)
        json_object_del(document, "triangles");
    json_object_set_new(document, "sentence", aob_json_text(sight->sentence));
    if (fuzzing->job.images) {
        aob_text_add(&name, "%s-%s-%llu", fuzzing->job.technique.technique, fuzzing->job.backend,
                     (unsigned long long)index);
        char *stem = aob_path_join(fuzzing->job.images, name.data);
        write_images(frame, sight, stem);
        aob_text_add(&file, "%s.json", stem);
        if (!aob_json_write(document, file.data, &error))
            aob_warn("%s", error.text);
        free(stem);
        aob_text_finish(&file);
        aob_text_finish(&name);
    }
    return document;
}

static void tell(struct fuzzing *fuzzing, struct aob_fuzz_frame *frame, struct aob_fuzz_sight *sight,
                 uint64_t index)
{
    struct aob_fuzz_answer answer = {.message = AOB_FUZZ_FOUND,
                                     .index = index,
                                     .fault = aob_fuzz_fault_word(sight->fault),
                                     .hostile = aob_fuzz_frame_hostile(frame) > 0};
    uint32_t bit = 1u << (2 * (int)sight->fault + answer.hostile);
    char sentence[sizeof sight->sentence];
    aob_line_print(sentence, sizeof sentence, "%s", sight->sentence);
    answer.sentence = sentence;
    if (!(fuzzing->known & bit)) {
        fuzzing->known |= bit;
        aob_fuzz_shrink(&fuzzing->artist, frame, sight);
        answer.smallest = write_frame(fuzzing, frame, sight, index);
    }
    reply(fuzzing, &answer);
}

static void draw(struct fuzzing *fuzzing, uint64_t index)
{
    struct aob_subject *subject = &fuzzing->artist.subject;
    struct aob_fuzz_frame frame;
    struct aob_fuzz_sight sight;
    const struct aob_fuzz_name name = {subject->technique, fuzzing->job.backend, fuzzing->job.seed, index};
    if (subject->programs.count > MOST_PROGRAMS) {
        aob_programs_finish(&subject->programs);
        aob_programs_init(&subject->programs, fuzzing->gpu);
    }
    reply(fuzzing, &(struct aob_fuzz_answer){.message = AOB_FUZZ_BEGUN, .index = index});
    aob_fuzz_frame_init(&frame, &name);
    aob_fuzz_draw(&fuzzing->artist, &frame, &sight);
    if (sight.fault == AOB_FUZZ_REFUSED)
        reply(fuzzing, &(struct aob_fuzz_answer){.message = AOB_FUZZ_REFUSES, .index = index});
    else if (sight.fault != AOB_FUZZ_FINE)
        tell(fuzzing, &frame, &sight, index);
    aob_fuzz_sight_finish(&sight);
    aob_fuzz_frame_finish(&frame);
}

static bool run(struct aob_worker *worker, struct aob_error *error)
{
    struct fuzzing *fuzzing = AOB_NEW(struct fuzzing);
    fuzzing->worker = worker;
    aob_registry_init(&fuzzing->registry);
    bool ok = aob_fuzz_job_from_json(worker->job, &fuzzing->job, error) && open_artist(fuzzing, error);
    if (ok) {
        fuzzing->known = fuzzing->job.known;
        fuzzing->artist.triangles = aob_subject_draws_triangles(&fuzzing->artist.subject);
        for (uint64_t i = 0; i < fuzzing->job.count; i++)
            draw(fuzzing, fuzzing->job.from + i);
    }
    if (fuzzing->has_artist)
        aob_subject_finish(&fuzzing->artist.subject);
    aob_gpu_close(fuzzing->gpu);
    aob_registry_finish(&fuzzing->registry);
    free(fuzzing);
    return ok;
}

const struct aob_worker_job aob_worker_fuzz = {"fuzz", run};

#include "fuzz.h"
#include <pthread.h>
#include <stdlib.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "chosen.h"
#include "crew.h"
#include "fuzz_row.h"

/* A worker's share: a few groups of frames that compile together, so that a lost worker takes little with it. A frame takes
 * milliseconds, and compiling for a group of them seconds; a row whose frames end so many workers is not gone on with. */
enum { SHARE = 2 * AOB_FUZZ_SHARED, MOST_CRASHES = 8 };
static const double job_s = 120, frame_s = 0.25;

struct share {
    struct aob_fuzz_row *row;
    uint64_t from, count;
};

/* What the threads share; the lock is for all of it, the rows, and what is printed. */
struct fuzz {
    const struct aob_fuzz_desc *desc;
    struct aob_technique_list techniques;
    struct aob_fuzz_row *rows;
    size_t row_count, row_capacity;
    struct share *shares;
    size_t share_count, share_capacity, next; /* next: that nobody has begun */
    struct aob_progress progress;
    pthread_mutex_t lock;
};

/* One share while a worker draws it. */
struct drawing {
    struct fuzz *fuzz;
    struct share *share;
    uint64_t at; /* frame that it began last */
    bool begun;
};

static bool choose_rows(struct fuzz *fuzz, struct aob_error *error)
{
    const struct aob_fuzz_desc *desc = fuzz->desc;
    const struct aob_chosen chosen = {&fuzz->techniques, &desc->dispatch.modules, desc->technique,
                                      desc->backend};
    if (!aob_chosen_check(&chosen, error))
        return false;
    for (size_t t = 0; t < fuzz->techniques.count; t++)
        for (const struct aob_gpu_fns *const *b = aob_gpu_backends; *b; b++)
            if (aob_chosen_backend(&chosen, (*b)->name) &&
                aob_chosen_technique(&chosen, &fuzz->techniques.items[t]))
                *AOB_PUSH(fuzz->rows, fuzz->row_count, fuzz->row_capacity) =
                    (struct aob_fuzz_row){.technique = &fuzz->techniques.items[t], .backend = (*b)->name};
    return fuzz->row_count || aob_fail(error, "nothing is to be drawn: no technique fits these flags");
}

static void share_out(struct fuzz *fuzz)
{
    const struct aob_fuzz_desc *desc = fuzz->desc;
    for (size_t r = 0; r < fuzz->row_count; r++) {
        uint64_t frames = desc->frames / fuzz->row_count + (r < desc->frames % fuzz->row_count);
        for (uint64_t at = 0; at < frames; at += SHARE)
            *AOB_PUSH(fuzz->shares, fuzz->share_count, fuzz->share_capacity) =
                (struct share){&fuzz->rows[r], desc->from + at, frames - at < SHARE ? frames - at : SHARE};
    }
}

static bool prepare(struct fuzz *fuzz, struct aob_error *error)
{
    const struct aob_fuzz_desc *desc = fuzz->desc;
    if (!aob_json_check(desc->json, error) || (desc->out && !aob_folder_create(desc->out, error)) ||
        !aob_dispatch_describe(&desc->dispatch, &desc->dispatch.modules, &fuzz->techniques, error) ||
        !choose_rows(fuzz, error))
        return false;
    share_out(fuzz);
    return true;
}

static void take(void *user, const json_t *object)
{
    struct drawing *drawing = user;
    struct fuzz *fuzz = drawing->fuzz;
    struct aob_fuzz_answer answer;
    const struct share *share = drawing->share;
    bool ours = aob_fuzz_answer_from_json(object, &answer) &&
                (answer.message == AOB_FUZZ_OPENED ||
                 (answer.index >= share->from && answer.index - share->from < share->count));
    if (!ours) /* a module may write what it likes */
        return;
    pthread_mutex_lock(&fuzz->lock);
    aob_fuzz_row_take(drawing->share->row, &answer);
    if (answer.message == AOB_FUZZ_BEGUN) {
        drawing->begun = true;
        drawing->at = answer.index;
        fuzz->progress.done++;
        if (answer.index % 64 == 0)
            aob_progress_say(&fuzz->progress, drawing->share->row->technique->name);
    }
    pthread_mutex_unlock(&fuzz->lock);
}

static bool send(struct drawing *drawing, uint32_t known, struct aob_error *error)
{
    const struct aob_fuzz_desc *desc = drawing->fuzz->desc;
    const struct aob_fuzz_row *row = drawing->share->row;
    const char *env[AOB_CREW_ENVIRONMENT];
    const struct aob_fuzz_job job = {.technique = aob_technique_address(row->technique),
                                     .backend = row->backend,
                                     .device = desc->dispatch.device,
                                     .validate = desc->dispatch.validate,
                                     .seed = desc->seed,
                                     .from = drawing->share->from,
                                     .count = drawing->share->count,
                                     .known = known,
                                     .images = desc->out};
    aob_crew_environment(row->backend, env);
    const struct aob_job_desc job_desc = {.job = aob_fuzz_job_to_json(&job),
                                          .env = env,
                                          .timeout_s = job_s + frame_s * (double)job.count,
                                          .on_answer = take,
                                          .user = drawing};
    if (!aob_dispatch_job(&desc->dispatch, &job_desc, error))
        return false;
    bool whole = drawing->begun && drawing->at + 1 == job.from + job.count; /* a module may end the process */
    return whole || aob_fail(error, "the worker ended without an answer");
}

/* What a worker leaves that ended: the frame that it was at is a finding, and the share goes on behind it. */
static void take_crash(struct drawing *drawing, const char *why)
{
    struct share *share = drawing->share;
    if (!drawing->begun) {
        free(share->row->missing);
        share->row->missing = aob_strdup(why);
        share->count = 0;
        return;
    }
    aob_fuzz_row_take(share->row, &(struct aob_fuzz_answer){.message = AOB_FUZZ_FOUND,
                                                            .index = drawing->at,
                                                            .fault = aob_fuzz_fault_word(AOB_FUZZ_CRASH),
                                                            .sentence = why});
    share->row->crashes++;
    share->count -= drawing->at + 1 - share->from;
    share->from = drawing->at + 1;
}

static void draw_share(struct fuzz *fuzz, struct share *share)
{
    for (bool done = false; !done;) {
        struct drawing drawing = {.fuzz = fuzz, .share = share};
        struct aob_error error = {{0}};
        pthread_mutex_lock(&fuzz->lock);
        bool skip = !share->count || share->row->missing || share->row->crashes >= MOST_CRASHES;
        uint32_t known = aob_fuzz_row_known(share->row);
        pthread_mutex_unlock(&fuzz->lock);
        done = skip || send(&drawing, known, &error);
        pthread_mutex_lock(&fuzz->lock);
        if (!done)
            take_crash(&drawing, error.text);
        pthread_mutex_unlock(&fuzz->lock);
    }
}

static void *work(void *user)
{
    struct fuzz *fuzz = user;
    for (;;) {
        pthread_mutex_lock(&fuzz->lock);
        size_t at = fuzz->next++;
        pthread_mutex_unlock(&fuzz->lock);
        if (at >= fuzz->share_count)
            return NULL;
        draw_share(fuzz, &fuzz->shares[at]);
    }
}

static void draw_all(struct fuzz *fuzz, struct aob_fuzz_sums *sums)
{
    int64_t start = aob_clock_wall_ns();
    aob_progress_init(&fuzz->progress, fuzz->desc->frames, fuzz->desc->quiet);
    pthread_mutex_init(&fuzz->lock, NULL);
    aob_crew_share(work, fuzz, fuzz->share_count);
    pthread_mutex_destroy(&fuzz->lock);
    aob_progress_finish(&fuzz->progress);
    for (size_t r = 0; r < fuzz->row_count; r++) {
        sums->begun += fuzz->rows[r].begun;
        sums->refused += fuzz->rows[r].refused;
        for (size_t i = 0; i < fuzz->rows[r].finding_count; i++)
            sums->failed += fuzz->rows[r].findings[i].count;
    }
    sums->seconds = (double)(aob_clock_wall_ns() - start) * 1e-9;
}

static bool write_documents(const struct fuzz *fuzz, const struct aob_fuzz_sums *sums,
                            struct aob_error *error)
{
    const struct aob_fuzz_desc *desc = fuzz->desc;
    json_t *document = aob_fuzz_to_json(desc, fuzz->rows, fuzz->row_count, sums);
    char *path = desc->out ? aob_path_join(desc->out, "fuzz.json") : NULL;
    bool ok = (!path || aob_json_write(document, path, error)) &&
              (!desc->json || aob_json_write(document, desc->json, error));
    free(path);
    json_decref(document);
    return ok;
}

static enum aob_exit judge(const struct fuzz *fuzz, const struct aob_fuzz_sums *sums)
{
    if (sums->failed)
        return AOB_EXIT_BAD;
    return sums->begun < fuzz->desc->frames ? AOB_EXIT_PART : AOB_EXIT_OK;
}

enum aob_exit aob_fuzz(const struct aob_fuzz_desc *desc, struct aob_text *table, struct aob_error *error)
{
    struct fuzz fuzz = {.desc = desc};
    struct aob_fuzz_sums sums = {0};
    enum aob_exit code = AOB_EXIT_USAGE;
    if (prepare(&fuzz, error)) {
        draw_all(&fuzz, &sums);
        aob_fuzz_print(desc, fuzz.rows, fuzz.row_count, &sums, table);
        if (write_documents(&fuzz, &sums, error))
            code = judge(&fuzz, &sums);
    }
    for (size_t r = 0; r < fuzz.row_count; r++)
        aob_fuzz_row_finish(&fuzz.rows[r]);
    free(fuzz.rows);
    free(fuzz.shares);
    aob_technique_list_finish(&fuzz.techniques);
    return code;
}

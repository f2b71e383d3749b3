/* Damaged files, through the worker that loads them: the harness stays up, a refusal is one line that leaves no file,
 * and what is loaded is what a second reader reads. */
#ifndef AOB_TESTS_DAMAGED_H
#define AOB_TESTS_DAMAGED_H
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "run/dispatch.h"

struct damaged {
    const char *what;       /* in the line that is printed */
    const char *file, *out; /* the worker loads the one and writes the other; neither is left in the end */
    json_t *(*job)(const struct damaged *damaged);
    const char *answer; /* a whole number that the answer to the job holds */
    double timeout_s;
    size_t memory_limit;                                     /* bytes */
    size_t (*damage)(char *bytes, size_t size, int variant); /* gives how many bytes are left */
    int variants;
    bool may_crash; /* the reader may: its worker alone dies of it */
    /* Of a file that was loaded into `out`: what is wrong with it; "" where a second reader agrees; NULL where none has
     * an opinion. NULL: there is no second reader. */
    const char *(*judge)(const struct damaged *damaged);
};

struct damaged_counts {
    int loaded, refused, agreed; /* agreed: of the loaded ones, with a second reader */
    int late, crashed;           /* of the refused ones: their workers ran out of time, or died */
    int faults;                  /* each is printed */
};

struct damaged_answers {
    const char *member;
    int count;
};

static inline void damaged_count(void *user, const json_t *answer)
{
    struct damaged_answers *answers = user;
    answers->count += json_is_integer(json_object_get(answer, answers->member));
}

/* What is wrong with how the worker ended; NULL: nothing. */
static inline const char *damaged_fault(const struct damaged *d, bool ok, int answers, const char *line)
{
    if (answers != ok)
        return ok ? "no answer" : "an answer of a refused file";
    if (!ok && !*line)
        return "a refusal without a line";
    if (strchr(line, '\n'))
        return "a refusal of more than one line";
    if (!d->may_crash && strstr(line, "crashed"))
        return "the reader crashed";
    return aob_file_exists(d->out) == ok ? NULL : ok ? "nothing is written" : "a refused file is written";
}

/* Loads the file once. A file with which something is wrong is kept beside, as FILE.fault-0 and so on. */
static inline bool damaged_load(const struct damaged *d, const struct aob_dispatch *dispatch,
                                struct damaged_counts *counts)
{
    struct aob_error error = {{0}};
    struct damaged_answers answers = {d->answer, 0};
    struct aob_job_desc desc = {.job = d->job(d),
                                .timeout_s = d->timeout_s,
                                .memory_limit = d->memory_limit,
                                .on_answer = damaged_count,
                                .user = &answers};
    unlink(d->out);
    bool ok = aob_dispatch_job(dispatch, &desc, &error);
    const char *fault = damaged_fault(d, ok, answers.count, error.text);
    const char *opinion = ok && !fault && d->judge ? d->judge(d) : NULL;
    if (opinion && *opinion)
        fault = opinion;
    counts->loaded += ok;
    counts->refused += !ok;
    counts->agreed += opinion && !*opinion;
    counts->late += strstr(error.text, "took longer") || strstr(error.text, "nothing for");
    counts->crashed += strstr(error.text, "crashed") != NULL;
    if (fault) {
        struct aob_text kept = {0};
        aob_text_add(&kept, "%s.fault-%d", d->file, counts->faults++);
        rename(d->file, kept.data);
        printf("FAULT: %s: %s; the file is %s\n", fault, error.text, kept.data);
        aob_text_finish(&kept);
    }
    return ok;
}

/* Loads the bytes as they are, without a judge, and each variant of them, and adds up what became of the variants. */
static inline void damaged_run(const struct damaged *d, const char *bytes, size_t size,
                               struct damaged_counts *counts)
{
    char *program = aob_path_join(getenv("AOBUDGET_BUILD"), "aobudget"), *copy = aob_alloc(size, 1);
    struct aob_dispatch dispatch = {.program = program};
    struct damaged_counts whole = {0};
    struct damaged undamaged = *d;
    undamaged.judge = NULL;
    assert_true(aob_file_write(d->file, bytes, size, NULL));
    assert_true(damaged_load(&undamaged, &dispatch, &whole));
    counts->faults += whole.faults;
    for (int v = 0; v < d->variants; v++) {
        memcpy(copy, bytes, size);
        size_t left = d->damage(copy, size, v);
        assert_true(aob_file_write(d->file, copy, left, NULL));
        damaged_load(d, &dispatch, counts);
    }
    unlink(d->file);
    unlink(d->out);
    free(copy);
    free(program);
}

static inline void damaged_print(const char *what, const struct damaged_counts *c)
{
    printf("%s: of %d damaged files %d load (%d as a second reader reads them), %d are refused in one line\n",
           what, c->loaded + c->refused, c->loaded, c->agreed, c->refused);
}

#endif

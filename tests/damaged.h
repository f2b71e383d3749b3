/* Damaged files, through the worker that loads them: the harness stays up, and a refusal is one line that leaves no
 * file. */
#ifndef AOB_TESTS_DAMAGED_H
#define AOB_TESTS_DAMAGED_H
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
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
    void (*loaded)(
        const struct damaged *damaged); /* a damaged file that was loaded lies there; NULL: nobody asks */
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

/* 1: loaded; 0: refused in one line. */
static inline int damaged_load(const struct damaged *d, const struct aob_dispatch *dispatch)
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
    assert_int_equal(answers.count, ok);
    assert_true(ok || *error.text);
    assert_null(strchr(error.text, '\n'));
    assert_true(d->may_crash || !strstr(error.text, "crashed"));
    assert_int_equal(aob_file_exists(d->out), ok);
    return ok;
}

/* Loads the bytes as they are, and each variant of them. */
static inline void damaged_check(const struct damaged *d, const char *bytes, size_t size)
{
    char *program = aob_path_join(getenv("AOBUDGET_BUILD"), "aobudget"), *copy = aob_alloc(size, 1);
    struct aob_dispatch dispatch = {.program = program};
    int loaded = 0;
    assert_true(aob_file_write(d->file, bytes, size, NULL));
    assert_int_equal(damaged_load(d, &dispatch), 1);
    for (int v = 0; v < d->variants; v++) {
        memcpy(copy, bytes, size);
        size_t left = d->damage(copy, size, v);
        assert_true(aob_file_write(d->file, copy, left, NULL));
        bool ok = damaged_load(d, &dispatch);
        loaded += ok;
        if (ok && d->loaded)
            d->loaded(d);
    }
    printf("%s: of %d damaged files %d load, %d are refused in one line\n", d->what, d->variants, loaded,
           d->variants - loaded);
    unlink(d->file);
    unlink(d->out);
    free(copy);
    free(program);
}
#endif

/* How a job ends that reads a file of the user: the line names the file and what to do, whatever became of the worker. */
#include <jansson.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "run/dispatch.h"

#define DAMAGED                                                                                              \
    "sub/box.ply: cannot load: the file is damaged, or of a form or size that is not read: save it again, "  \
    "or "                                                                                                    \
    "in another format "

static void test_lines_name_the_file(void **state)
{
    static const char *const cases[][2] = {
        {"kill -SEGV $$", DAMAGED "(crashed (signal 11, segmentation fault))"},
        {"echo ai_assert failure >&2; kill -ABRT $$",
         DAMAGED "(crashed (signal 6, aborted): ai_assert failure)"},
        {"echo std::bad_alloc >&2; kill -ABRT $$",
         DAMAGED "(not enough memory (its limit is 512 MiB): std::bad_alloc)"},
        {"exit 3", DAMAGED "(exit code 3)"},
        {"echo 'aobudget: error: the cache is full' >&2; exit 2", "sub/box.ply: the cache is full"},
        {"echo 'aobudget: error: sub/box.ply: line 3: no' >&2; exit 2", "sub/box.ply: line 3: no"},
    };
    char program[64];
    (void)state;
    snprintf(program, sizeof program, "/tmp/aobudget-dispatch-%ld", (long)getpid());
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_text script = {0};
        struct aob_error error = {""};
        const struct aob_dispatch dispatch = {.program = program};
        aob_text_add(&script, "#!/bin/sh\n%s\n", cases[i][0]);
        assert_true(aob_file_write(program, script.data, script.size, &error));
        assert_int_equal(chmod(program, 0700), 0);
        assert_false(aob_dispatch_job(&dispatch,
                                      &(struct aob_job_desc){.job = json_object(),
                                                             .timeout_s = 60,
                                                             .memory_limit = (size_t)512 << 20,
                                                             .file = "sub/box.ply"},
                                      &error));
        assert_string_equal(error.text, cases[i][1]);
        aob_text_finish(&script);
    }
    unlink(program);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_lines_name_the_file)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

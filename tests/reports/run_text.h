/* The folder of a run whose journal a test writes, and its page. For tests of one program. */
#ifndef AOB_TESTS_REPORTS_RUN_TEXT_H
#define AOB_TESTS_REPORTS_RUN_TEXT_H
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "reports/page/page.h"
#include "reports/page/rows.h"

static char folder[64];

static inline void put(const char *name, const char *text)
{
    char *path = aob_path_join(folder, name);
    assert_true(aob_file_write(path, text, strlen(text), NULL));
    free(path);
}

static inline char *get(const char *name)
{
    char *path = aob_path_join(folder, name), *text = aob_file_read(path, 1 << 24, NULL, NULL);
    assert_non_null(text);
    free(path);
    return text;
}

static inline char *make_page(void)
{
    const char *const folders[] = {folder, NULL};
    char *out = aob_path_join(folder, "report");
    struct aob_error error = {""};
    if (!aob_page_write(&(struct aob_page_desc){.folders = folders, .out = out}, &error))
        fail_msg("%s", error.text);
    free(out);
    return get("report/index.html");
}

/* Against 0.25 and 1, by the cases' own radius. */
static inline void add_case(struct aob_text *journal, const char *key, const char *technique, double radius,
                            double cost, double small, double large)
{
    char near[128], far[128];
    snprintf(near, sizeof near,
             "\"target\":{\"radius\":0.25,\"weighting\":\"cosine\"},\"rmse\":%g,\"band_rmse\":%g", small / 2,
             small);
    snprintf(far, sizeof far,
             "\"target\":{\"radius\":1,\"weighting\":\"cosine\"},\"rmse\":%g,\"band_rmse\":%g", large / 2,
             large);
    aob_text_add(
        journal,
        "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"front\",\"technique\":\"%s\","
        "\"params\":{\"radius\":%g,\"steps\":6,\"blur\":0},\"options\":{\"fetch\":\"sampled\",\"guard_band\":"
        "64},"
        "\"backend\":\"vulkan\",\"width\":64,\"height\":32,\"status\":\"ok\",\"image\":\"images/%s.exr\","
        "\"time\":{\"clock\":\"cpu\",\"cpu_ms\":%g},\"error\":{%s},"
        "\"errors\":[{%s,\"truth\":\"truths/near.exr\"},{%s,\"truth\":\"truths/far.exr\"}]}\n",
        key, technique, radius, key, cost, radius == 1 ? far : near, near, far);
}

/* a: the best against 0.25; b: against 1; c: another technique, the cheapest, made for 0.25. */
static inline void write_run(void)
{
    struct aob_text journal = {0};
    add_case(&journal, "a", "gtao", 0.25, 2, 0.01, 0.3);
    add_case(&journal, "b", "gtao", 1, 4, 0.2, 0.02);
    add_case(&journal, "c", "hbao", 0.25, 1, 0.05, 0.4);
    put("journal.jsonl", journal.data);
    put("run.json", "{\"name\":\"two\",\"cases\":3,\"techniques\":[{\"name\":\"gtao\",\"params\":["
                    "{\"name\":\"radius\",\"initial\":0.25},{\"name\":\"steps\",\"initial\":6},{\"name\":"
                    "\"blur\",\"initial\":5}]}]}");
    aob_text_finish(&journal);
}

static inline void read_rows(struct aob_rows *rows)
{
    const char *const folders[] = {folder};
    struct aob_error error = {""};
    if (!aob_rows_read(rows, folders, 1, &error))
        fail_msg("%s", error.text);
}

static inline size_t count_text(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

static inline int set_up(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/aob-test-report-%ld", (long)getpid());
    return aob_folder_create(folder, NULL) ? 0 : -1;
}

static inline int tear_down(void **state)
{
    char command[128];
    (void)state;
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    return system(command);
}
#endif

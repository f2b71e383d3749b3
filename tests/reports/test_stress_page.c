/* The page of a run of `stress`, from a document that is written here. */
#include "reports/page/stress_page.h"
#include "check.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"

static json_t *cell(const char *property, const char *outcome, double worst, const char *reason)
{
    return json_pack("{s:s, s:s, s:f, s:f, s:b, s:s, s:n, s:s}", "property", property, "outcome", outcome,
                     "worst", worst, "bound", 0.25, "declared", 0, "reason", reason, "image", "command",
                     "aobudget stress --property it");
}

static json_t *row(const char *technique, const char *backend, const char *outcome, const char *reason)
{
    return json_pack("{s:s, s:n, s:s, s:s, s:s, s:[o]}", "technique", technique, "module", "backend", backend,
                     "device", "llvmpipe", "driver", "Mesa", "cells",
                     cell("sky_is_open", outcome, 0.5, reason));
}

static json_t *document(void)
{
    json_t *property =
        json_pack("{s:s, s:s, s:s, s:s, s:s, s:f, s:f, s:s}", "name", "sky_is_open", "group", "edges",
                  "sentence", "The sky is 1.", "measure", "distance from 1", "source", "a text",
                  "bound_software", 0.25, "bound_gpu", 0.5, "bound_reason", "It is so.");
    return json_pack("{s:b, s:{s:i, s:i, s:i, s:i}, s:[o], s:[o, o, o]}", "quick", 0, "counts", "pass", 2,
                     "fail", 1, "by definition", 0, "n/a", 0, "properties", property, "rows",
                     row("gtao", "vulkan", "fail", "<b>there</b>"), row("gtao", "gl-egl", "pass", "here"),
                     row("none", "vulkan", "pass", "nowhere"));
}

static size_t count_text(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

static void expect(const char *text, const char *part, size_t count)
{
    if (count_text(text, part) != count)
        fail_msg("'%s' stands there %zu times, not %zu", part, count_text(text, part), count);
}

static void the_table_shows_the_gravest_of_all_backends(void **state)
{
    (void)state;
    char folder[] = "/tmp/aobudget-stress-XXXXXX";
    struct aob_error error = {{0}};
    assert_non_null(mkdtemp(folder));
    json_t *made = document();
    if (!aob_stress_page_write(&(struct aob_stress_page_desc){made, folder, NULL}, &error))
        fail_msg("%s", error.text);
    char *path = aob_path_join(folder, "index.html");
    char *text = aob_file_read(path, 1 << 20, NULL, &error);
    assert_non_null(text);
    /* One column for gtao, whose failure on one backend is what it shows and leads to. */
    expect(text,
           "<a class=\"chip failed\" href=\"#sky_is_open-0\" title=\"&lt;b&gt;there&lt;/b&gt;\">fail</a>", 1);
    expect(text, "<a class=\"chip ok\" href=\"#sky_is_open-2\" title=\"nowhere\">pass</a>", 1);
    expect(text, "<tr id=\"sky_is_open-0\">", 1);
    expect(text, "<tr id=\"sky_is_open-2\">", 1);
    expect(text, "<code>aobudget stress --property it</code>", 3);
    expect(text, "<b>there</b>", 0);
    expect(text, ">1 fail<", 1);
    expect(text, "0.25 in software, 0.5 on a GPU. It is so.", 1);
    expect(text, "<td class=\"n\">0.5</td><td class=\"n\">0.25</td>", 3);
    unlink(path);
    rmdir(folder);
    free(path);
    free(text);
    json_decref(made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_table_shows_the_gravest_of_all_backends)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

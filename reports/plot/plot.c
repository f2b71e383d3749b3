/* aobudget-plot: draws the figures of one JSON document from standard input (its format: figure.h).
 * For each figure one line of JSON on standard output, {"out": PATH, "error": TEXT or null}, and one line on
 * standard error for each failure. Exit code 0: all drawn; 3: some failed; 2: the document is no use. */
#include "figure.h"
#include "base/error.h"
#include <stdio.h>
#include <string.h>

static void report(const char *out, const char *failure)
{
    json_t *line = json_pack("{s:s, s:s?}", "out", out, "error", failure);
    if (line) {
        json_dumpf(line, stdout, JSON_COMPACT);
        puts("");
        fflush(stdout);
    }
    json_decref(line);
    if (failure)
        fprintf(stderr, "aobudget-plot: error: %s: %s\n", out, failure);
}

/* The number of figures that failed. */
static size_t draw_all(json_t *figures)
{
    struct aob_figure_cache cache = {0};
    size_t i, failed = 0;
    json_t *figure;
    json_array_foreach(figures, i, figure)
    {
        struct aob_error error = {0};
        const char *out = json_string_value(json_object_get(figure, "out"));
        bool ok = aob_figure_draw(figure, &cache, &error);
        report(out ? out : "?", ok ? NULL : error.text);
        failed += !ok;
    }
    aob_figure_cache_finish(&cache);
    return failed;
}

static int run(void)
{
    json_error_t where;
    json_t *job = json_loadf(stdin, JSON_REJECT_DUPLICATES, &where);
    json_t *figures = json_object_get(job, "figures");
    if (!json_is_array(figures)) {
        fprintf(stderr, "aobudget-plot: error: standard input:%d: %s\n", job ? 1 : where.line,
                job ? "the document needs an array \"figures\"" : where.text);
        json_decref(job);
        return AOB_EXIT_USAGE;
    }
    aob_figure_limits(figures);
    size_t failed = draw_all(figures);
    json_decref(job);
    return failed ? AOB_EXIT_PART : AOB_EXIT_OK;
}

int main(int argc, char **argv)
{
    if (argc > 1) {
        bool help = strcmp(argv[1], "--help") == 0;
        fprintf(help ? stdout : stderr,
                "usage: aobudget-plot < JOB.json (aobudget starts it; see reports/figure.h)\n");
        return help ? AOB_EXIT_OK : AOB_EXIT_USAGE;
    }
    return run();
}

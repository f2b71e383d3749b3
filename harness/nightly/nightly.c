#include "nightly.h"
#include <stdlib.h>
#include "base/file.h"
#include "base/json.h"
#include "compare/compare.h"
#include "run/run.h"
#include "settle.h"
#include "tell.h"

/* One night, from its config to its page. */
struct nightly {
    const struct aob_nightly_desc *desc;
    struct aob_history *history;
    struct aob_night_start start;
    struct aob_lines lines;
    struct aob_suspects suspects;
    bool partial; /* the run lacks cases */
};

static bool has_journal(const char *run)
{
    char *path = aob_path_join(run, "journal.jsonl");
    bool has = aob_file_size(path) > 0;
    free(path);
    return has;
}

/* A night in which no case runs any more has a journal too, and that is what it has to tell. */
static bool measure(struct nightly *n, struct aob_error *error)
{
    const struct aob_run_desc run = {.dispatch = n->desc->dispatch,
                                     .config = n->desc->config,
                                     .out = n->start.run,
                                     .quiet = n->desc->quiet};
    if (n->start.measured)
        return true;
    if (aob_run(&run, error) != AOB_EXIT_USAGE)
        return true;
    if (!has_journal(n->start.run))
        return false;
    aob_warn("%s", error->text);
    *error = (struct aob_error){{0}};
    n->partial = true;
    return true;
}

static bool read_lines(struct nightly *n, struct aob_error *error)
{
    const struct aob_lines_ask ask = {.config = n->start.name, .night = n->start.id, .figures = true};
    return aob_night_take(n->history, n->start.id, NULL, error) &&
           aob_lines_read(n->history, &ask, &n->lines, error) &&
           (n->lines.count || aob_fail(error, "%s has no case to judge", n->start.run));
}

static bool judge(struct nightly *n, struct aob_error *error)
{
    double precision = n->desc->precision > 0 ? n->desc->precision : AOB_COMPARE_PRECISION;
    aob_suspects_choose(&n->suspects, &n->lines, precision);
    return aob_suspects_settle(&n->suspects, n->history, n->desc, &n->start, error);
}

/* Later nights begin from what this one says. */
static bool keep(struct nightly *n, const struct aob_night_told *told, struct aob_error *error)
{
    bool ok = true;
    for (size_t i = 0; ok && i < n->suspects.count; i++) {
        const struct aob_suspect *s = &n->suspects.items[i];
        ok = aob_line_judge(n->history, s->line->id, n->start.id, s->verdict,
                            s->watch.suspect || s->moved ? aob_suspect_since(s) : 0, s->said, error);
    }
    json_t *summary = aob_night_summary(told);
    char *text = json_dumps(summary, 0);
    ok = ok && aob_night_end(n->history, n->start.id, text, error);
    free(text);
    json_decref(summary);
    return ok;
}

static bool check(const struct aob_nightly_desc *desc, struct aob_error *error)
{
    return (!desc->old || aob_file_exists(desc->old) ||
            aob_fail(error, "--old %s: not found; it is a module, or a folder of modules", desc->old)) &&
           (!desc->markdown || aob_file_check(desc->markdown, error)) && aob_json_check(desc->json, error);
}

enum aob_exit aob_nightly(const struct aob_nightly_desc *desc, struct aob_text *out, struct aob_error *error)
{
    struct nightly n = {.desc = desc};
    if (!check(desc, error) || !(n.history = aob_history_open(desc->history, AOB_HISTORY_WRITE, error)))
        return AOB_EXIT_USAGE;
    bool ok = aob_night_start(n.history, desc, &n.start, error) && measure(&n, error) &&
              read_lines(&n, error) && judge(&n, error);
    const struct aob_night_told told = {desc, &n.start, &n.suspects, n.history, n.partial};
    ok = ok && keep(&n, &told, error) && aob_night_tell(&told, out, error);
    enum aob_exit code = ok ? aob_night_code(&told) : AOB_EXIT_USAGE;
    aob_suspects_finish(&n.suspects);
    aob_lines_finish(&n.lines);
    aob_night_start_finish(&n.start);
    aob_history_close(n.history);
    return code;
}

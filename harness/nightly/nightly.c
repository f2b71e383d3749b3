#include "nightly.h"
#include <stdlib.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "compare/compare.h"
#include "run/run.h"
#include "lacks.h"
#include "settle.h"
#include "store/journal.h"
#include "tell.h"

/* One night, from its config to its page. */
struct nightly {
    const struct aob_nightly_desc *desc;
    struct aob_history *history;
    struct aob_night_start start;
    struct aob_nights nights; /* of the config, this one too */
    struct aob_lines lines;
    struct aob_suspects suspects;
    size_t asked, missing, gone; /* cases (tell.h) */
};

/* A night in which no case runs any more has a record of each, and that is what it has to tell. */
static bool measure(struct nightly *n, struct aob_error *error)
{
    const struct aob_run_desc run = {.dispatch = n->desc->dispatch,
                                     .config = n->desc->config,
                                     .out = n->start.run,
                                     .quiet = n->desc->quiet};
    struct aob_error cause = {{0}};
    if (n->start.measured)
        return true;
    enum aob_exit code = aob_run(&run, &cause);
    struct aob_error unread = {{0}};
    bool whole = aob_run_lacks(n->start.run, &n->asked, &n->missing, &unread) && n->asked && !n->missing;
    if (code == AOB_EXIT_USAGE && !whole) {
        *error = cause;
        return false;
    }
    if (code == AOB_EXIT_USAGE)
        aob_warn("%s", cause.text);
    return aob_night_start_stands(&n->start, n->desc, error);
}

/* Nothing is written to the folder meanwhile, by a merge or by a run that goes on there: it would be taken in half. */
static bool take(struct nightly *n, struct aob_error *error)
{
    struct aob_journal journal;
    char *path = aob_path_join(n->start.run, "journal.jsonl");
    bool ok = aob_journal_hold(&journal, path, error);
    free(path);
    if (!ok)
        return false;
    ok = aob_run_lacks(n->start.run, &n->asked, &n->missing, error) &&
         aob_night_take(n->history, n->start.id, NULL, error);
    aob_journal_close(&journal);
    return ok;
}

/* Figures are read of the latest nights only, since reading those of all takes longer than all the rest: cache figures are
 * compared with a night that is no older. */
enum { FIGURES_OF = 10 };

static bool read_lines(struct nightly *n, struct aob_error *error)
{
    struct aob_lines_ask ask = {.config = n->start.name, .night = n->start.id};
    if (!take(n, error) || !aob_nights_read(n->history, n->start.name, &n->nights, error))
        return false;
    ask.figures = n->nights.items[n->nights.count > FIGURES_OF ? n->nights.count - FIGURES_OF : 0].id;
    return aob_lines_read(n->history, &ask, &n->lines, error) &&
           (n->lines.count || aob_fail(error, "%s has no case to judge", n->start.run));
}

static bool has_line(const struct aob_lines *lines, int64_t id)
{
    for (size_t i = 0; i < lines->count; i++)
        if (lines->items[i].id == id)
            return true;
    return false;
}

/* A config that lost a case, or a driver that begins lines of its own, would be silent otherwise. */
static bool count_gone(struct nightly *n, struct aob_error *error)
{
    struct aob_lines_ask ask = {.config = n->start.name};
    struct aob_lines lines = {0};
    for (size_t i = 0; i < n->nights.count; i++)
        if (n->nights.items[i].id < n->start.id && !aob_night_is_stopped(&n->nights.items[i]))
            ask.night = n->nights.items[i].id;
    bool ok = !ask.night || aob_lines_read(n->history, &ask, &lines, error);
    for (size_t i = 0; ok && i < lines.count; i++)
        n->gone += !has_line(&n->lines, lines.items[i].id);
    aob_lines_finish(&lines);
    return ok;
}

static bool judge(struct nightly *n, struct aob_error *error)
{
    double precision = n->desc->precision > 0 ? n->desc->precision : AOB_COMPARE_PRECISION;
    aob_suspects_choose(&n->suspects, &n->lines, &n->nights, precision);
    return aob_suspects_settle(&n->suspects, n->history, &n->nights, n->desc, &n->start, error);
}

/* Later nights begin from what this one says. */
static bool keep(struct nightly *n, const struct aob_night_told *told, struct aob_error *error)
{
    struct aob_line_verdict *verdicts = AOB_NEW_ARRAY(struct aob_line_verdict, n->suspects.count + 1);
    for (size_t i = 0; i < n->suspects.count; i++) {
        const struct aob_suspect *s = &n->suspects.items[i];
        verdicts[i] =
            (struct aob_line_verdict){s->line->id, s->told.verdict, aob_suspect_restart(s), s->told.said};
    }
    json_t *summary = aob_night_summary(told);
    char *text = json_dumps(summary, 0);
    bool ok = aob_lines_judge(n->history, n->start.id, verdicts, n->suspects.count, error) &&
              aob_night_end(n->history, n->start.id, text, error);
    free(text);
    json_decref(summary);
    free(verdicts);
    return ok;
}

/* What a night found is told before it ends: one that is stopped in between is judged again. The trend shows what is kept. */
static bool tell(struct nightly *n, struct aob_text *out, enum aob_exit *code, struct aob_error *error)
{
    const struct aob_night_told told = {n->desc,  &n->start,  &n->suspects, n->history,
                                        n->asked, n->missing, n->gone};
    struct aob_error cause = {{0}};
    if (!aob_night_tell(&told, out, error) || !keep(n, &told, error))
        return false;
    if (!aob_night_trend(&told, &cause))
        aob_warn("the trend page: %s", cause.text);
    *code = aob_night_code(&told);
    return true;
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
    enum aob_exit code = AOB_EXIT_USAGE;
    if (!check(desc, error) || !(n.history = aob_history_open(desc->history, AOB_HISTORY_WRITE, error)))
        return code;
    bool ok = aob_night_start(n.history, desc, &n.start, error) && measure(&n, error) &&
              read_lines(&n, error) && count_gone(&n, error) && judge(&n, error) &&
              tell(&n, out, &code, error);
    aob_suspects_finish(&n.suspects);
    aob_lines_finish(&n.lines);
    aob_nights_finish(&n.nights);
    aob_history_close(n.history);
    aob_night_start_finish(&n.start);
    return ok ? code : AOB_EXIT_USAGE;
}

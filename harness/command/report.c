#include <jansson.h>
#include <stdlib.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "command.h"
#include "reports/page/page.h"
#include "reports/page/techniques_page.h"

struct options {
    struct aob_common common; /* its words are the folders */
    const char *out;          /* folder of the page; NULL: report/ in the first folder */
    const char *techniques;   /* file of the page of techniques, written in its place; NULL: none */
};

static const struct aob_flag flags[] = {
    {"out", "DIR", "where the page goes (the first folder's report/)", AOB_FLAG_TEXT,
     offsetof(struct options, out)},
    {"techniques", "FILE.md", "in place of it: a page of what each technique is", AOB_FLAG_TEXT,
     offsetof(struct options, techniques)},
    {0},
};

static void tell_damage(const struct aob_error *damage)
{
    if (*damage->text)
        aob_warn("%s", damage->text);
}

static bool summarise(const struct options *o, const struct aob_page_summary *summary, const char *out,
                      struct aob_error *error)
{
    tell_damage(&summary->damage);
    if (!o->common.quiet)
        aob_note("%zu of %zu cases, %zu ok; %zu of %zu figures; page: %s/index.html", summary->cases,
                 summary->planned, summary->ok, summary->drawn, summary->figures, out);
    if (!o->common.json)
        return true;
    json_t *document = json_pack("{s:s, s:i, s:i, s:i, s:i, s:i}", "page", out, "planned",
                                 (int)summary->planned, "cases", (int)summary->cases, "ok", (int)summary->ok,
                                 "figures", (int)summary->figures, "drawn", (int)summary->drawn);
    bool ok = aob_json_write(document, o->common.json, error);
    json_decref(document);
    return ok;
}

static bool summarise_techniques(const struct options *o, const struct aob_techniques_summary *summary,
                                 struct aob_error *error)
{
    tell_damage(&summary->damage);
    if (!o->common.quiet)
        aob_note("%zu techniques, %zu of %zu cases, %zu ok; %zu of %zu pictures; page: %s",
                 summary->techniques, summary->cases, summary->planned, summary->ok, summary->drawn,
                 summary->figures, o->techniques);
    if (!o->common.json)
        return true;
    json_t *document =
        json_pack("{s:s, s:i, s:i, s:i, s:i, s:i, s:i}", "page", o->techniques, "techniques",
                  (int)summary->techniques, "planned", (int)summary->planned, "cases", (int)summary->cases,
                  "ok", (int)summary->ok, "figures", (int)summary->figures, "drawn", (int)summary->drawn);
    bool ok = aob_json_write(document, o->common.json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit report_techniques(const struct options *o, struct aob_error *error)
{
    struct aob_techniques_summary summary = {0};
    if (o->common.words.count != 1 || o->out)
        return aob_fail(error, "report: --techniques takes one folder and no --out"), AOB_EXIT_USAGE;
    if (!aob_techniques_page_write(&(struct aob_techniques_desc){o->common.words.items[0], o->techniques,
                                                                 o->common.dispatch.program},
                                   &summary, error) ||
        !summarise_techniques(o, &summary, error))
        return AOB_EXIT_USAGE;
    return summary.planned && summary.ok >= summary.planned ? AOB_EXIT_OK : AOB_EXIT_PART;
}

static enum aob_exit report(void *from, struct aob_error *error)
{
    const struct options *o = from;
    if (o->techniques)
        return report_techniques(o, error);
    const char **folders = AOB_NEW_ARRAY(const char *, o->common.words.count + 1);
    struct aob_page_summary summary = {0};
    for (size_t i = 0; i < o->common.words.count; i++)
        folders[i] = o->common.words.items[i];
    char *out = o->out ? aob_strdup(o->out) : aob_path_join(o->common.words.items[0], "report");
    bool ok =
        aob_page_write(&(struct aob_page_desc){folders, out, o->common.dispatch.program, &summary}, error) &&
        summarise(o, &summary, out, error);
    free(out);
    free(folders);
    if (!ok)
        return AOB_EXIT_USAGE;
    /* A plan that is not known may be incomplete. */
    bool whole = summary.planned && summary.ok >= summary.planned;
    return whole ? AOB_EXIT_OK : AOB_EXIT_PART;
}

const struct aob_command aob_command_report = {
    .name = "report",
    .help = "page and pictures from finished runs",
    .usage = "DIR... [--out DIR] | DIR --techniques FILE.md",
    .summary = "Page and pictures from journals.",
    .flags = flags,
    .least = 1,
    .most = 64,
    .size = sizeof(struct options),
    .run = report,
};

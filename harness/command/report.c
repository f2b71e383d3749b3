#include "report.h"
#include <jansson.h>
#include <stdlib.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "reports/page/page.h"
#include "reports/page/techniques_page.h"

static bool summarise(const struct aob_report_desc *desc, const struct aob_page_summary *summary,
                      const char *out, struct aob_error *error)
{
    if (!desc->quiet)
        aob_note("%zu of %zu cases, %zu ok; %zu of %zu figures; page: %s/index.html", summary->cases,
                 summary->planned, summary->ok, summary->drawn, summary->figures, out);
    if (!desc->json)
        return true;
    json_t *document = json_pack("{s:s, s:i, s:i, s:i, s:i, s:i}", "page", out, "planned",
                                 (int)summary->planned, "cases", (int)summary->cases, "ok", (int)summary->ok,
                                 "figures", (int)summary->figures, "drawn", (int)summary->drawn);
    bool ok = aob_json_write(document, desc->json, error);
    json_decref(document);
    return ok;
}

static bool summarise_techniques(const struct aob_report_desc *desc,
                                 const struct aob_techniques_summary *summary, struct aob_error *error)
{
    if (!desc->quiet)
        aob_note("%zu techniques, %zu of %zu cases, %zu ok; %zu of %zu pictures; page: %s",
                 summary->techniques, summary->cases, summary->planned, summary->ok, summary->drawn,
                 summary->figures, desc->techniques);
    if (!desc->json)
        return true;
    json_t *document =
        json_pack("{s:s, s:i, s:i, s:i, s:i, s:i, s:i}", "page", desc->techniques, "techniques",
                  (int)summary->techniques, "planned", (int)summary->planned, "cases", (int)summary->cases,
                  "ok", (int)summary->ok, "figures", (int)summary->figures, "drawn", (int)summary->drawn);
    bool ok = aob_json_write(document, desc->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit report_techniques(const struct aob_report_desc *desc, struct aob_error *error)
{
    struct aob_techniques_summary summary = {0};
    if (desc->folder_count != 1 || desc->out)
        return aob_fail(error, "report: --techniques takes one folder and no --out"), AOB_EXIT_USAGE;
    if (!aob_techniques_page_write(
            &(struct aob_techniques_desc){desc->folders[0], desc->techniques, desc->program}, &summary,
            error) ||
        !summarise_techniques(desc, &summary, error))
        return AOB_EXIT_USAGE;
    return summary.planned && summary.ok >= summary.planned ? AOB_EXIT_OK : AOB_EXIT_PART;
}

enum aob_exit aob_report(const struct aob_report_desc *desc, struct aob_error *error)
{
    if (desc->techniques)
        return report_techniques(desc, error);
    const char **folders = AOB_NEW_ARRAY(const char *, desc->folder_count + 1);
    struct aob_page_summary summary = {0};
    for (size_t i = 0; i < desc->folder_count; i++)
        folders[i] = desc->folders[i];
    char *out = desc->out ? aob_strdup(desc->out) : aob_path_join(desc->folders[0], "report");
    bool ok = aob_page_write(&(struct aob_page_desc){folders, out, desc->program, &summary}, error) &&
              summarise(desc, &summary, out, error);
    free(out);
    free(folders);
    if (!ok)
        return AOB_EXIT_USAGE;
    /* A plan that is not known may be incomplete. */
    bool whole = summary.planned && summary.ok >= summary.planned;
    return whole ? AOB_EXIT_OK : AOB_EXIT_PART;
}

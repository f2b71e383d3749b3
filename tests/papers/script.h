/* A run that a test writes down, and a row that is judged by it. */
#ifndef AOB_TESTS_PAPERS_SCRIPT_H
#define AOB_TESTS_PAPERS_SCRIPT_H
#include <stdarg.h>
#include "base/text.h"
#include "check.h"
#include "papers/row.h"

/* A run that is written down: a case a call, each time with an interval of `share` to both sides. */
struct script {
    json_t *records;
    double share;
};

static inline json_t *ratio(const struct script *script, double value)
{
    return json_pack("{s:f, s:f, s:f}", "ratio_to_ref", value, "ci_low", value * (1 - script->share),
                     "ci_high", value * (1 + script->share));
}

/* `params` as JSON without its braces; passes: name, cost, ..., NULL. */
static inline void add(struct script *script, const char *technique, const char *params, const char *name,
                       ...)
{
    struct aob_text text = {0};
    double whole = 0;
    va_list args;
    json_t *passes = json_array();
    va_start(args, name);
    for (; name; name = va_arg(args, const char *)) {
        double cost = va_arg(args, double);
        json_t *pass = ratio(script, cost);
        json_object_set_new(pass, "name", json_string(name));
        json_array_append_new(passes, pass);
        whole += cost;
    }
    va_end(args);
    aob_text_add(&text, "{%s}", params);
    json_t *time = ratio(script, whole), *values = json_loads(text.data, 0, NULL);
    assert_non_null(values);
    json_object_set_new(time, "passes", passes);
    json_array_append_new(script->records,
                          json_pack("{s:s, s:s, s:O, s:O, s:o, s:o}", "technique", technique, "status", "ok",
                                    "params", values, "camera", values, "time", time, "error", values));
    aob_text_finish(&text);
}

static inline const struct aob_paper_row *find_row(const char *name)
{
    const struct aob_paper_row *row = aob_paper_rows;
    while (row->name && strcmp(row->name, name) != 0)
        row++;
    assert_non_null(row->name);
    return row;
}

/* Judges the row by the script, which ends here; the reason must be or hold `says`. */
static inline void expect(struct script *script, const char *name, enum aob_paper_verdict verdict,
                          const char *says)
{
    struct aob_paper_run run = {.records = script->records};
    struct aob_paper_outcome outcome = {.row = find_row(name), .run = &run};
    struct aob_error error = {{0}};
    struct aob_text reason = {0};
    if (!outcome.row->measure(&run, &outcome.result, &error))
        fail_msg("%s: %s", name, error.text);
    assert_string_equal(aob_paper_verdicts[aob_paper_judge(outcome.row, &outcome.result)],
                        aob_paper_verdicts[verdict]);
    aob_paper_explain(&outcome, &reason);
    if (*says)
        assert_contains(reason.data, says);
    else
        assert_null(reason.data);
    aob_text_finish(&reason);
    json_decref(script->records);
    *script = (struct script){json_array(), 0};
}
#endif

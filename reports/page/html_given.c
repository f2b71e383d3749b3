/* What a case gives, and the passes that are laid for it. */
#include "html.h"
#include <math.h>
#include "costs.h"

bool aob_html_gives_more(const struct aob_row *row)
{
    return json_array_size(json_object_get(row->json, "outputs")) > 1;
}

static void add_names(struct aob_text *page, const struct aob_row *row)
{
    json_t *name;
    size_t i;
    json_array_foreach(json_object_get(row->json, "outputs"), i, name)
    {
        aob_text_add(page, "%s", i ? ", " : "");
        aob_html_escape(page, json_is_string(name) ? json_string_value(name) : "?");
    }
}

void aob_html_outputs_cell(struct aob_text *page, const struct aob_row *row)
{
    aob_text_add(page, "<td class=params><span class=clip>");
    add_names(page, row);
    aob_text_add(page, "</span></td>");
}

static void add_ms(struct aob_text *page, const char *before, double value)
{
    char ms[32];
    aob_html_ms(ms, value);
    if (isfinite(value))
        aob_text_add(page, "%s%s ms", before, ms);
}

static void add_passes(struct aob_text *page, const json_t *time)
{
    const char *member = aob_costs_member(time);
    json_t *pass;
    size_t i;
    aob_text_add(page, "<ol class=front>\n");
    json_array_foreach(json_object_get(time, "passes"), i, pass)
    {
        aob_text_add(page, "<li>");
        aob_html_escape(page, aob_member_text(pass, "name"));
        add_ms(page, ": ", aob_member_number(pass, member));
        aob_text_add(page, "</li>\n");
    }
    aob_text_add(page, "</ol>");
}

void aob_html_given(struct aob_text *page, const struct aob_row *row)
{
    const json_t *time = json_object_get(row->json, "time");
    size_t passes = json_array_size(json_object_get(time, "passes"));
    if (!aob_html_gives_more(row))
        return;
    aob_text_add(page, passes ? "<details><summary>gives " : "<div>gives ");
    add_names(page, row);
    if (passes)
        aob_text_add(page, " in %zu pass%s", passes, passes == 1 ? "" : "es");
    add_ms(page, ": ", row->cost_ms);
    if (passes) {
        aob_text_add(page, "</summary>");
        add_passes(page, time);
    }
    aob_text_add(page, passes ? "</details>" : "</div>");
}

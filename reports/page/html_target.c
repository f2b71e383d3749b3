#include <stdlib.h>
#include "html.h"

static void add_slug(struct aob_text *page, const struct aob_target *target)
{
    char *slug = aob_target_slug(target);
    aob_html_escape(page, slug);
    free(slug);
}

static void add_name(struct aob_text *page, const struct aob_target *target)
{
    char *name = aob_target_say(target);
    aob_html_escape(page, name);
    free(name);
}

void aob_html_target_control(struct aob_text *page, const struct aob_rows *rows)
{
    if (rows->target_count < 2)
        return;
    aob_text_add(page, "<fieldset id=targets hidden><legend>Compare with</legend>\n");
    for (size_t i = 0; i < rows->target_count; i++) {
        aob_text_add(page, "<label><input type=radio name=target value=\"");
        add_slug(page, &rows->targets[i]);
        aob_text_add(page, "\"> ");
        add_name(page, &rows->targets[i]);
        aob_text_add(page, "</label>\n");
    }
    aob_text_add(page, "</fieldset>\n");
}

void aob_html_target_open(struct aob_text *page, const struct aob_rows *rows, size_t target, const char *more)
{
    aob_text_add(page, "<div data-target=\"");
    add_slug(page, &rows->targets[target]);
    aob_text_add(page, "\"><h3 class=against>Against ");
    add_name(page, &rows->targets[target]);
    aob_text_add(page, "%s</h3>\n", more);
}

#include "night_page.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/file.h"
#include "night_words.h"
#include "parts.h"
#include "reports/page/html.h"

static void add_link(struct aob_text *page, const char *name, const char *path)
{
    if (!path || !*path)
        return;
    aob_trend_escaped(page, "<a href=\"", path, "\">");
    aob_text_add(page, "%s</a>\n", name);
}

static void add_head(struct aob_text *text, const struct aob_night_page *page)
{
    struct aob_text title = {0}, words = {0};
    aob_night_words_title(page, &title);
    aob_trend_open(text, title.data);
    aob_night_words_verdict(page, &words);
    aob_trend_escaped(text, "<p class=lead><b>", words.data, "</b></p>\n");
    aob_text_finish(&words);
    aob_night_words_counts(page, &words);
    aob_trend_escaped(text, "<p class=soft>", words.data, "</p>\n");
    if (page->old_note && *page->old_note)
        aob_trend_escaped(text, "<p class=banner role=status>", page->old_note, "</p>\n");
    aob_text_add(text, "<nav>");
    add_link(text, "trend", page->trend);
    add_link(text, "run", page->run_page);
    aob_text_add(text, "</nav></header>\n<main>\n");
    aob_text_finish(&title);
    aob_text_finish(&words);
}

/* A ratio, which 0 is not. */
static void add_ratio(struct aob_text *text, double ratio)
{
    char shown[32];
    snprintf(shown, sizeof shown, "%.3f", ratio);
    aob_html_number_cell(text, ratio > 0 ? ratio : NAN, shown);
}

static void add_row(struct aob_text *text, const struct aob_night_item *item)
{
    struct aob_text beside = {0}, rest = {0};
    char change[32];
    aob_night_words_change(item, change);
    aob_night_words_beside(item, &beside);
    aob_night_words_rest(item, &rest);
    aob_text_add(text, "<tr><td>");
    aob_trend_chip(text, (int64_t)item->verdict, NULL);
    aob_text_add(text, "</td><td class=n>%s</td>", change);
    aob_trend_escaped(text, "<td class=wrap>", item->line->text, "<br><small>");
    aob_trend_escaped(text, "", item->line->class_name, "</small></td>");
    add_ratio(text, item->before_ratio);
    add_ratio(text, item->after_ratio);
    aob_text_add(text, "<td class=n>%s</td>", beside.size ? beside.data : "\u2013");
    aob_trend_escaped(text, "<td class=wrap>", item->said, "");
    if (rest.size)
        aob_trend_escaped(text, "<br><small>", rest.data, "</small>");
    aob_text_add(text, "</td></tr>\n");
    aob_text_finish(&rest);
    aob_text_finish(&beside);
}

static void add_table(struct aob_text *text, const struct aob_night_page *page)
{
    aob_text_add(text, "<section id=changes><h2>What changed</h2>\n");
    if (!page->count) {
        aob_text_add(text, "<p>Nothing.</p></section>\n");
        return;
    }
    aob_text_add(text,
                 "<p class=soft>Before and after are levels of the ratio to the fixed pass. Beside the old "
                 "module: the cost of the new one over that of the old one, both timed in this night.</p>\n"
                 "<div class=\"scroll plain\" tabindex=0 role=region aria-label=changes><table "
                 "class=told><thead><tr><th>verdict</th>"
                 "<th class=n>change</th><th>series</th><th class=n>before</th><th class=n>after</th>"
                 "<th class=n>beside the old module</th><th>why</th></tr></thead><tbody>\n");
    for (size_t i = 0; i < page->count; i++)
        add_row(text, &page->items[i]);
    aob_text_add(text, "</tbody></table></div></section>\n");
}

static void add_image(struct aob_text *text, const struct aob_night_item *item)
{
    aob_trend_escaped(text, "<figure><a href=\"", item->map, ".png\">");
    aob_trend_escaped(text, "<img loading=lazy alt=\"\" src=\"", item->map, ".png\"></a>");
    aob_trend_escaped(text, "<figcaption>", item->line->text, "");
    if (item->said && *item->said)
        aob_trend_escaped(text, ": ", item->said, "");
    aob_text_add(text, "</figcaption></figure>\n");
}

static void add_images(struct aob_text *text, const struct aob_night_page *page)
{
    bool any = false;
    for (size_t i = 0; i < page->count; i++) {
        if (!page->items[i].map || !*page->items[i].map)
            continue;
        aob_text_add(text, any ? "" : "<section id=images><h2>Images that changed</h2><div class=grid>\n");
        any = true;
        add_image(text, &page->items[i]);
    }
    aob_text_add(text, any ? "</div></section>\n" : "");
}

bool aob_night_page_write(const struct aob_night_page *page, const char *folder, struct aob_error *error)
{
    struct aob_text text = {0};
    add_head(&text, page);
    add_table(&text, page);
    add_images(&text, page);
    aob_text_add(&text, "</main>\n<footer>An interval is one of 95 %%.</footer>\n</body></html>\n");
    char *path = aob_path_join(folder, "index.html");
    bool ok = aob_file_write(path, text.data, text.size, error);
    free(path);
    aob_text_finish(&text);
    return ok;
}

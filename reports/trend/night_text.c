#include "night_words.h"
#include <math.h>
#include <string.h>
#include "parts.h"
#include "reports/page/markdown.h"

/* Lines of the Markdown beside the rows: title, table's head, what is not shown, note, links, and blanks between them. */
#define MARKDOWN_FRAME 10

/* A ratio, which 0 is not. */
static double known(double ratio)
{
    return ratio > 0 ? ratio : NAN;
}

static void add_row(struct aob_text *text, const struct aob_night_item *item)
{
    struct aob_text beside = {0}, rest = {0};
    char change[32];
    aob_night_words_change(item, change);
    aob_night_words_beside(item, &beside);
    aob_night_words_rest(item, &rest);
    aob_text_add(text, "| %s | %s | ", aob_trend_word((int64_t)item->verdict)->word, change);
    aob_md_escape(text, item->line->text);
    aob_text_add(text, " |");
    aob_md_number(text, known(item->before_ratio), 3);
    aob_md_number(text, known(item->after_ratio), 3);
    aob_text_add(text, " %s | ", beside.size ? beside.data : "\u2013");
    aob_md_escape(text, item->said ? item->said : "");
    if (rest.size)
        aob_text_add(text, "%s(%s)", item->said && *item->said ? " " : "", rest.data);
    aob_text_add(text, " |\n");
    aob_text_finish(&beside);
    aob_text_finish(&rest);
}

static void add_table(const struct aob_night_page *page, struct aob_text *text)
{
    size_t most = AOB_NIGHT_MARKDOWN - MARKDOWN_FRAME;
    if (!page->count)
        return;
    aob_text_add(text, "\n| verdict | change | series | before | after | beside the old module | why |\n"
                       "|---|---:|---|---:|---:|---|---|\n");
    for (size_t i = 0; i < page->count && i < most; i++)
        add_row(text, &page->items[i]);
    if (page->count > most)
        aob_text_add(text, "\n%zu more are on the page.\n", page->count - most);
}

static void add_link(struct aob_text *text, const char *name, const char *path, bool *any)
{
    if (!path || !*path)
        return;
    aob_text_add(text, "%s[%s](", *any ? " \u00b7 " : "\n", name);
    aob_md_link(text, path);
    aob_text_add(text, ")");
    *any = true;
}

void aob_night_page_markdown(const struct aob_night_page *page, struct aob_text *text)
{
    struct aob_text title = {0}, words = {0};
    bool any = false;
    aob_night_words_title(page, &title);
    aob_night_words_verdict(page, &words);
    aob_text_add(text, "**");
    aob_md_escape(text, title.data);
    aob_text_add(text, ": %s** (", words.data);
    aob_night_words_counts(page, text);
    aob_text_add(text, ")\n");
    add_table(page, text);
    if (page->old_note && *page->old_note) {
        aob_text_add(text, "\n");
        aob_md_escape(text, page->old_note);
        aob_text_add(text, "\n");
    }
    add_link(text, "trend", page->trend, &any);
    add_link(text, "run", page->run_page, &any);
    aob_text_add(text, any ? "\n" : "");
    aob_text_finish(&title);
    aob_text_finish(&words);
}

/* --- One screen --- */

/* Where the character behind `columns` characters begins; NULL: there are no more of them. */
static const char *cut_at(const char *line, size_t columns)
{
    size_t count = 0;
    for (; *line; line++)
        if (((unsigned char)*line & 0xc0) != 0x80 && count++ == columns)
            return line;
    return NULL;
}

static void add_line(struct aob_text *text, const struct aob_text *raw)
{
    struct aob_text shown = {0};
    aob_text_add_shown(&shown, raw->data ? raw->data : "", raw->size, false);
    const char *line = shown.data ? shown.data : "";
    if (cut_at(line, AOB_NIGHT_COLUMNS))
        aob_text_add(text, "%.*s...\n", (int)(cut_at(line, AOB_NIGHT_COLUMNS - 3) - line), line);
    else
        aob_text_add(text, "%s\n", line);
    aob_text_finish(&shown);
}

static size_t columns_of(const char *text)
{
    size_t count = 0;
    while (cut_at(text, count))
        count++;
    return count;
}

static void add_item(struct aob_text *text, const struct aob_night_item *item, bool with_said)
{
    struct aob_text line = {0};
    char change[32];
    aob_night_words_change(item, change);
    aob_text_add(&line, "%-8s%*s%s  %s", aob_trend_word((int64_t)item->verdict)->word,
                 (int)(9 - columns_of(change)), "", change, item->line->text);
    add_line(text, &line);
    aob_text_finish(&line);
    if (!with_said || !item->said || !*item->said)
        return;
    aob_text_add(&line, "%19s%s", "", item->said);
    add_line(text, &line);
    aob_text_finish(&line);
}

/* Each with its sentence if all have room so, else a line each, and what still has none is counted. */
static void add_items(struct aob_text *text, const struct aob_night_page *page, size_t room)
{
    bool with_said = page->count <= room / 2;
    size_t shown = with_said || page->count <= room ? page->count : room - 1;
    for (size_t i = 0; i < shown; i++)
        add_item(text, &page->items[i], with_said);
    if (shown < page->count)
        aob_text_add(text, "%zu more, of %zu\n", page->count - shown, page->count);
}

void aob_night_page_screen(const struct aob_night_page *page, struct aob_text *text)
{
    struct aob_text line = {0};
    bool note = page->old_note && *page->old_note;
    aob_night_words_title(page, &line);
    aob_text_add(&line, ": ");
    aob_night_words_verdict(page, &line);
    add_line(text, &line);
    aob_text_finish(&line);
    aob_night_words_counts(page, &line);
    add_line(text, &line);
    aob_text_finish(&line);
    if (note) {
        aob_text_add(&line, "%s", page->old_note);
        add_line(text, &line);
        aob_text_finish(&line);
    }
    add_items(text, page, (size_t)(AOB_NIGHT_ROWS - 2 - note));
}

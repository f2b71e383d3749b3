#include "night_words.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "parts.h"

void aob_night_words_title(const struct aob_night_page *page, struct aob_text *text)
{
    char day[11];
    aob_trend_day(day, page->date);
    aob_text_add(text, "%s%s%s", page->title ? page->title : "Night", *day ? " " : "", day);
}

static size_t count_like(const struct aob_night_page *page, size_t from, size_t to)
{
    size_t count = 0;
    for (size_t i = from; i < to; i++)
        count += page->items[i].verdict == page->items[from].verdict;
    return count;
}

static bool is_first(const struct aob_night_page *page, size_t at)
{
    for (size_t i = 0; i < at; i++)
        if (page->items[i].verdict == page->items[at].verdict)
            return false;
    return true;
}

void aob_night_words_verdict(const struct aob_night_page *page, struct aob_text *text)
{
    for (size_t i = 0; i < page->count; i++)
        if (is_first(page, i))
            aob_text_add(text, "%s%zu %s", i ? ", " : "", count_like(page, i, page->count),
                         aob_trend_word((int64_t)page->items[i].verdict)->word);
    if (!page->count)
        aob_text_add(text, page->watched || !page->cases ? "nothing changed" : "nothing to compare with");
}

void aob_night_words_counts(const struct aob_night_page *page, struct aob_text *text)
{
    aob_text_add(text, "%zu of %zu cases ok, %zu series watched, %zu stood out", page->ok, page->cases,
                 page->watched, page->suspects);
}

void aob_night_words_change(const struct aob_night_item *item, char text[32])
{
    bool confirmed = item->verdict == AOB_NIGHT_SLOWER || item->verdict == AOB_NIGHT_FASTER;
    double levels = item->before_ratio > 0 ? item->after_ratio / item->before_ratio : 0;
    aob_trend_percent(text, confirmed && item->beside > 0 ? item->beside : levels);
}

void aob_night_words_beside(const struct aob_night_item *item, struct aob_text *text)
{
    char at[32], low[32], high[32];
    if (!(item->beside > 0))
        return;
    aob_trend_percent(at, item->beside);
    aob_trend_percent(low, item->low);
    aob_trend_percent(high, item->high);
    aob_text_add(text, "%s [%s, %s]", at, low, high);
}

void aob_night_words_rest(const struct aob_night_item *item, struct aob_text *text)
{
    char before[32], now[32];
    if (!item->before || !item->now)
        return;
    snprintf(before, sizeof before, "%.4f", item->before->band_rmse);
    snprintf(now, sizeof now, "%.4f", item->now->band_rmse);
    if (isfinite(item->before->band_rmse) && isfinite(item->now->band_rmse) && strcmp(before, now) != 0)
        aob_text_add(text, "error in band %s \u2192 %s", before, now);
    snprintf(before, sizeof before, "%.2f", item->before->memory_bytes / 1048576);
    snprintf(now, sizeof now, "%.2f", item->now->memory_bytes / 1048576);
    if (isfinite(item->before->memory_bytes) && isfinite(item->now->memory_bytes) && strcmp(before, now) != 0)
        aob_text_add(text, "%s%s \u2192 %s MiB", text->size ? ", " : "", before, now);
}

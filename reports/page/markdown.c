#include "markdown.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

void aob_md_escape(struct aob_text *page, const char *text)
{
    for (const char *c = text; *c; c++) {
        bool inside = *c == '_' && c > text && isalnum((unsigned char)c[-1]) && isalnum((unsigned char)c[1]);
        if ((unsigned char)*c < ' ')
            aob_text_add(page, " ");
        else if (strchr("\\`*_[]<>|#~$&", *c) && !inside)
            aob_text_add(page, "&#%d;", *c);
        else if (c == text && strchr("+-=:", *c)) /* a list, a rule, a heading's underline */
            aob_text_add(page, "&#%d;", *c);
        else
            aob_text_add_bytes(page, c, 1);
    }
}

static bool is_plain(const char *name)
{
    for (const char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && !strchr("_-./", *c))
            return false;
    return *name;
}

void aob_md_code(struct aob_text *page, const char *name)
{
    if (is_plain(name))
        aob_text_add(page, "`%s`", name);
    else
        aob_md_escape(page, name);
}

void aob_md_link(struct aob_text *page, const char *path)
{
    for (; *path; path++)
        if (isalnum((unsigned char)*path) || strchr("_-./", *path))
            aob_text_add_bytes(page, path, 1);
        else
            aob_text_add(page, "%%%02X", (unsigned)(unsigned char)*path);
}

void aob_md_number(struct aob_text *page, double value, int decimals)
{
    if (isfinite(value))
        aob_text_add(page, " %s%.*f |", value < 0 ? "\u2212" : "", decimals, fabs(value));
    else
        aob_text_add(page, " \u2013 |");
}

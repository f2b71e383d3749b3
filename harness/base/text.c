#include "text.h"
#include "memory.h"
#include <errno.h>
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The room doubles, so that a text of many small parts is not copied for each of them. */
static void make_room(struct aob_text *text, size_t more)
{
    if (text->data && more < text->room - text->size)
        return;
    text->room = text->size + more + 1 > 2 * text->room ? text->size + more + 1 : 2 * text->room;
    text->data = aob_realloc(text->data, text->room, 1);
}

void aob_text_add_bytes(struct aob_text *text, const char *bytes, size_t size)
{
    make_room(text, size);
    memcpy(text->data + text->size, bytes, size);
    text->size += size;
    text->data[text->size] = '\0';
}

static void add_list(struct aob_text *text, const char *format, va_list args)
{
    va_list again;
    va_copy(again, args);
    int size = vsnprintf(NULL, 0, format, args);
    if (size > 0) {
        make_room(text, (size_t)size);
        vsnprintf(text->data + text->size, (size_t)size + 1, format, again);
        text->size += (size_t)size;
    }
    va_end(again);
}

void aob_text_add(struct aob_text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    add_list(text, format, args);
    va_end(args);
}

/* Bytes of the character at the begin of `s`; 0 where it is not UTF-8. The second byte has narrower bounds where the
 * character could be written shorter, is a surrogate, or lies beyond the last one (RFC 3629, section 4). */
static size_t utf8_size(const unsigned char *s, size_t left)
{
    size_t size = s[0] < 0x80 ? 1 : s[0] < 0xc2 ? 0 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : s[0] < 0xf5 ? 4 : 0;
    unsigned char low = s[0] == 0xe0 ? 0xa0 : s[0] == 0xf0 ? 0x90 : 0x80;
    unsigned char high = s[0] == 0xed ? 0x9f : s[0] == 0xf4 ? 0x8f : 0xbf;
    if (size > left)
        return 0;
    for (size_t i = 1; i < size; i++)
        if (s[i] < (i == 1 ? low : 0x80) || s[i] > (i == 1 ? high : 0xbf))
            return 0;
    return size;
}

/* U+202A to U+202E and U+2066 to U+2069 turn the order of what is shown, so a name could look like another. */
static bool is_turning(const unsigned char *s)
{
    return s[0] == 0xe2 &&
           ((s[1] == 0x80 && s[2] >= 0xaa && s[2] <= 0xae) || (s[1] == 0x81 && s[2] >= 0xa6 && s[2] <= 0xa9));
}

/* The control characters are U+0000 to U+001F, U+007F, and U+0080 to U+009F, of two bytes each. 0: it is none. */
static unsigned control_of(const unsigned char *s, size_t size)
{
    bool is = size == 2 ? s[0] == 0xc2 && s[1] < 0xa0 : size == 1 && (s[0] < 0x20 || s[0] == 0x7f);
    if (size == 3 && is_turning(s))
        return 0x2000u | (unsigned)(s[1] & 0x3f) << 6 | (s[2] & 0x3f);
    return is ? s[size - 1] : 0;
}

void aob_text_add_shown(struct aob_text *text, const char *bytes, size_t size, bool lines)
{
    for (size_t at = 0, taken; at < size; at += taken) {
        const unsigned char *s = (const unsigned char *)bytes + at;
        taken = utf8_size(s, size - at);
        if (!taken) {
            aob_text_add(text, "\\x%02x", *s);
            taken = 1;
        } else if (lines && *s == '\n')
            aob_text_add_bytes(text, "\n", 1);
        else if (*s == '\n' || *s == '\r' || *s == '\t')
            aob_text_add_bytes(text, " ", 1);
        else if (control_of(s, taken) || !*s)
            aob_text_add(text, "\\u%04x", control_of(s, taken));
        else
            aob_text_add_bytes(text, (const char *)s, taken);
    }
}

void aob_text_add_line(struct aob_text *text, const char *format, ...)
{
    struct aob_text line = {0};
    va_list args;
    va_start(args, format);
    add_list(&line, format, args);
    va_end(args);
    aob_text_add_shown(text, line.data, line.size, false);
    aob_text_add_bytes(text, "\n", 1);
    aob_text_finish(&line);
}

void aob_text_finish(struct aob_text *text)
{
    free(text->data);
    *text = (struct aob_text){0};
}

static const char mark[] = "...";

static bool within_character(const struct aob_text *text, size_t at)
{
    return at < text->size && ((unsigned char)text->data[at] & 0xc0) == 0x80;
}

/* The longest stretch without a blank that has a slash: a path, or most of one. */
static size_t find_path(const struct aob_text *text, size_t *size)
{
    size_t found = 0;
    *size = 0;
    for (size_t at = 0, count; at < text->size; at += count + 1) {
        count = strcspn(text->data + at, " ");
        if (count > *size && memchr(text->data + at, '/', count)) {
            found = at;
            *size = count;
        }
    }
    return found;
}

/* Takes bytes out of the path's middle, so that about `keep` of them stay. Its begin and its end say most. */
static void cut_path(struct aob_text *text, size_t path, size_t size, size_t keep)
{
    size_t from = path + keep / 2, to = path + size - (keep - keep / 2), dots = sizeof mark - 1;
    while (within_character(text, from))
        from--;
    while (within_character(text, to))
        to++;
    memcpy(text->data + from, mark, dots);
    memmove(text->data + from + dots, text->data + to, text->size + 1 - to);
    text->size -= to - from - dots;
}

/* A message names its object first, by its path, and the cause behind it. */
static void shorten_paths(struct aob_text *text, size_t most)
{
    enum { LEAST = 64 };
    while (text->size > most) {
        size_t size, path = find_path(text, &size), more = text->size - most + sizeof mark - 1;
        if (size <= LEAST + 2 * sizeof mark)
            return;
        cut_path(text, path, size, size > more + LEAST ? size - more : LEAST);
    }
}

void aob_line_print_list(char *line, size_t size, const char *format, va_list args)
{
    struct aob_text raw = {0}, shown = {0};
    add_list(&raw, format, args);
    aob_text_add_shown(&shown, raw.data, raw.size, false);
    shorten_paths(&shown, size ? size - 1 : 0);
    size_t kept = shown.size;
    if (kept >= size && size >= sizeof mark) {
        kept = size - sizeof mark;
        while (kept && within_character(&shown, kept))
            kept--;
    }
    snprintf(line, size, "%.*s%s", (int)kept, kept ? shown.data : "", kept < shown.size ? mark : "");
    aob_text_finish(&raw);
    aob_text_finish(&shown);
}

void aob_line_print(char *line, size_t size, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    aob_line_print_list(line, size, format, args);
    va_end(args);
}

bool aob_parse_double(const char *text, double *value)
{
    if (!*text || isspace((unsigned char)*text))
        return false;
    char *end;
    errno = 0;
    double v = strtod(text, &end);
    if (*end || isnan(v) || (errno == ERANGE && fabs(v) > 1))
        return false;
    *value = v;
    return true;
}

static bool parse_int(const char *text, int64_t *value)
{
    if (!*text || isspace((unsigned char)*text))
        return false;
    char *end;
    errno = 0;
    long long v = strtoll(text, &end, 10);
    if (*end || errno)
        return false;
    *value = v;
    return true;
}

bool aob_parse_percent(const char *text, double *share)
{
    size_t size = strlen(text);
    char number[32];
    double percent;
    if (!size || size > sizeof number || text[size - 1] != '%')
        return false;
    memcpy(number, text, size - 1);
    number[size - 1] = '\0';
    if (!aob_parse_double(number, &percent))
        return false;
    *share = percent / 100;
    return true;
}

bool aob_parse_size(const char *text, int *width, int *height)
{
    const char *x = strchr(text, 'x');
    char first[16];
    int64_t w, h;
    if (!x || (size_t)(x - text) >= sizeof first)
        return false;
    memcpy(first, text, (size_t)(x - text));
    first[x - text] = '\0';
    if (!parse_int(first, &w) || !parse_int(x + 1, &h))
        return false;
    if (w < 1 || h < 1 || w > 16384 || h > 16384)
        return false;
    *width = (int)w;
    *height = (int)h;
    return true;
}

static bool parse_vector(const char *text, double *value, size_t count)
{
    char copy[256];
    double v[3];
    if (strlen(text) >= sizeof copy)
        return false;
    strcpy(copy, text);
    char *rest = copy;
    for (size_t i = 0; i < count; i++) {
        char *part = strsep(&rest, ",");
        if (!part || !aob_parse_double(part, &v[i]) || !isfinite(v[i]))
            return false;
    }
    if (rest)
        return false;
    memcpy(value, v, count * sizeof *v);
    return true;
}

bool aob_parse_vec3(const char *text, double value[3])
{
    return parse_vector(text, value, 3);
}

bool aob_parse_vec2(const char *text, double value[2])
{
    return parse_vector(text, value, 2);
}

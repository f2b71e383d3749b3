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

void aob_text_add(struct aob_text *text, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    int size = vsnprintf(NULL, 0, format, args);
    va_end(args);
    if (size > 0) {
        make_room(text, (size_t)size);
        vsnprintf(text->data + text->size, (size_t)size + 1, format, again);
        text->size += (size_t)size;
    }
    va_end(again);
}

void aob_text_finish(struct aob_text *text)
{
    free(text->data);
    *text = (struct aob_text){0};
}

void aob_line_print_list(char *line, size_t size, const char *format, va_list args)
{
    static const char mark[] = "...";
    int wanted = vsnprintf(line, size, format, args);
    if (wanted >= 0 && (size_t)wanted >= size && size >= sizeof mark)
        memcpy(line + size - sizeof mark, mark, sizeof mark);
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

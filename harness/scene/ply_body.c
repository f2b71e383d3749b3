#include "ply_body.h"
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

enum { BODY_LIMIT_BITS = 32, NAME = 64 };

static const struct type {
    const char *names[2];
    size_t size;
    bool is_signed, is_real;
} types[] = {{{"char", "int8"}, 1, true, false},    {{"uchar", "uint8"}, 1, false, false},
             {{"short", "int16"}, 2, true, false},  {{"ushort", "uint16"}, 2, false, false},
             {{"int", "int32"}, 4, true, false},    {{"uint", "uint32"}, 4, false, false},
             {{"float", "float32"}, 4, true, true}, {{"double", "float64"}, 8, true, true}};

struct property {
    char name[NAME];
    const struct type *list, *type; /* list: of its number of values; NULL: one value */
    bool corners;                   /* of a face */
};

struct element {
    char name[NAME];
    size_t count;
    struct property *properties;
    size_t property_count, property_capacity;
};

struct body {
    const char *path;
    const char *at, *end; /* what is still to be read */
    size_t line;          /* of `at`, from 1; of a text */
    bool is_text, is_big; /* big: the first byte of a number is its highest */
    bool is_old_mac;      /* lines end in carriage returns alone, so a line feed behind one is data */
    struct element *elements;
    size_t element_count, element_capacity, vertices;
};

static bool fail(const struct body *body, struct aob_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static bool fail(const struct body *body, struct aob_error *error, const char *format, ...)
{
    char text[300], place[40] = "";
    va_list args;
    va_start(args, format);
    aob_line_print_list(text, sizeof text, format, args);
    va_end(args);
    if (body->is_text)
        snprintf(place, sizeof place, "line %zu: ", body->line);
    return aob_fail(error, "%s: %s%s: the file is damaged", body->path, place, text);
}

/* --- The header -------------------------------------------------------------------------------------------- */

static const struct type *find_type(const char *name)
{
    for (size_t i = 0; i < AOB_COUNT(types); i++)
        if (strcmp(types[i].names[0], name) == 0 || strcmp(types[i].names[1], name) == 0)
            return &types[i];
    return NULL;
}

static bool add_element(struct body *body, const char *line, struct aob_error *error)
{
    char number[NAME] = "";
    struct element *element = AOB_PUSH(body->elements, body->element_count, body->element_capacity);
    *element = (struct element){.count = 0};
    bool ok = sscanf(line, "element %63s %63s", element->name, number) == 2 && strlen(number) < 16 &&
              strspn(number, "0123456789") == strlen(number);
    element->count = ok ? strtoull(number, NULL, 10) : 0;
    if (strcmp(element->name, "vertex") == 0)
        body->vertices = element->count;
    return ok || fail(body, error, "the number of its element '%s' is '%s'", element->name, number);
}

static bool add_property(struct body *body, const char *line, struct aob_error *error)
{
    char list[NAME] = "", type[NAME] = "";
    if (!body->element_count)
        return fail(body, error, "a property stands before every element");
    struct element *element = &body->elements[body->element_count - 1];
    struct property *property =
        AOB_PUSH(element->properties, element->property_count, element->property_capacity);
    *property = (struct property){.list = NULL};
    bool is_list = sscanf(line, "property list %63s %63s %63s", list, type, property->name) == 3;
    if (!is_list)
        sscanf(line, "property %63s %63s", type, property->name);
    property->list = find_type(list);
    property->type = find_type(type);
    bool counts = !is_list || (property->list && !property->list->is_real);
    property->corners =
        strcmp(element->name, "face") == 0 &&
        (strcmp(property->name, "vertex_indices") == 0 || strcmp(property->name, "vertex_index") == 0);
    return (counts && property->type) || fail(body, error, "a property of its element '%s' has the type '%s'",
                                              element->name, counts ? type : list);
}

static void next_line(struct body *body)
{
    body->at += strcspn(body->at, "\r\n");
    if (!body->is_old_mac && body->at[0] == '\r' && body->at[1] == '\n')
        body->at++;
    if (body->at < body->end)
        body->at++;
    body->line++;
}

static bool read_header_line(struct body *body, const char *line, struct aob_error *error)
{
    char word[NAME] = "", form[NAME] = "";
    sscanf(line, "%63s %63s", word, form);
    if (strcmp(word, "format") == 0) {
        body->is_big = strcmp(form, "binary_big_endian") == 0;
        bool is_binary = body->is_big || strcmp(form, "binary_little_endian") == 0;
        if (!is_binary && strcmp(form, "ascii") != 0)
            return fail(body, error, "its format is '%s'", form);
        body->is_text = !is_binary;
        return true;
    }
    return strcmp(word, "element") == 0    ? add_element(body, line, error)
           : strcmp(word, "property") == 0 ? add_property(body, line, error)
                                           : true;
}

static bool read_header(struct body *body, struct aob_error *error)
{
    bool ok = true;
    body->is_text = true; /* so is the header */
    body->is_old_mac =
        body->at[strcspn(body->at, "\r\n")] == '\r' && body->at[strcspn(body->at, "\r\n") + 1] != '\n';
    for (body->line = 1; ok && body->at < body->end && strncmp(body->at, "end_header", 10) != 0;
         next_line(body)) {
        char line[4 * NAME];
        snprintf(line, sizeof line, "%.*s", (int)fmin(strcspn(body->at, "\r\n"), sizeof line - 1), body->at);
        ok = read_header_line(body, line, error);
    }
    next_line(body);
    return ok;
}

/* --- The data ---------------------------------------------------------------------------------------------- */

static void skip_blank_lines(struct body *body)
{
    for (; strspn(body->at, " \t\r\n"); body->at++)
        body->line += *body->at == '\n' || (*body->at == '\r' && body->at[1] != '\n');
}

/* A value of the line that `at` is in. */
static bool read_word(struct body *body, const struct type *type, double *value)
{
    body->at += strspn(body->at, " \t");
    size_t size = strcspn(body->at, " \t\r\n");
    char *end;
    if (!size || (!type->is_real && strspn(body->at, "+-0123456789") != size) ||
        memchr(body->at, 'x', size) || memchr(body->at, 'X', size))
        return false;
    *value = strtod(body->at, &end);
    if (end != body->at + size)
        return false;
    body->at = end;
    return true;
}

static bool read_bytes(struct body *body, const struct type *type, double *value)
{
    uint64_t bits = 0;
    if ((size_t)(body->end - body->at) < type->size)
        return false;
    for (size_t i = 0; i < type->size; i++)
        bits |= (uint64_t)(unsigned char)body->at[body->is_big ? type->size - 1 - i : i] << (8 * i);
    body->at += type->size;
    *value = (double)bits;
    if (type->is_real && type->size == 4) {
        const uint32_t low = (uint32_t)bits;
        float real;
        memcpy(&real, &low, sizeof real);
        *value = (double)real;
    } else if (type->is_real)
        memcpy(value, &bits, sizeof bits);
    else if (type->is_signed && bits >> (8 * type->size - 1))
        *value -= ldexp(1, 8 * (int)type->size);
    return true;
}

/* Where a value is missing, in words. */
struct spot {
    const struct element *element;
    const struct property *property;
    size_t index;
};

static bool read_value(struct body *body, const struct spot *spot, const struct type *type, double *value,
                       struct aob_error *error)
{
    bool ok = body->is_text ? read_word(body, type, value) : read_bytes(body, type, value);
    if (ok)
        return true;
    const char *name = spot->property->name, *of = spot->element->name;
    if (!body->is_text || body->at == body->end)
        return fail(body, error, "it ends within %s %zu of %zu", of, spot->index, spot->element->count);
    if (strspn(body->at, "\r\n"))
        return fail(body, error, spot->property->list ? "%s %zu ends within its %s" : "%s %zu has no %s", of,
                    spot->index, name);
    return fail(body, error, "%s %zu: its %s is no %snumber", of, spot->index, name,
                type->is_real ? "" : "whole ");
}

static bool read_property(struct body *body, const struct spot *spot, struct aob_error *error)
{
    const struct property *property = spot->property;
    double count = 1, value;
    if (property->list && !read_value(body, spot, property->list, &count, error))
        return false;
    if (count < (property->corners ? 1 : 0))
        return fail(body, error, "%s %zu: its %s has %g values", spot->element->name, spot->index,
                    property->name, count);
    for (double i = 0; i < count; i++) {
        if (!read_value(body, spot, property->type, &value, error))
            return false;
        if (property->corners && !(value >= 0 && value < (double)body->vertices))
            return fail(body, error, "face %zu names vertex %g of %zu", spot->index, value, body->vertices);
    }
    return true;
}

static bool read_element(struct body *body, const struct element *element, size_t index,
                         struct aob_error *error)
{
    if (body->is_text)
        skip_blank_lines(body);
    if (body->at == body->end)
        return fail(body, error, "it ends before %s %zu of %zu", element->name, index, element->count);
    for (size_t p = 0; p < element->property_count; p++) {
        const struct spot spot = {element, &element->properties[p], index};
        if (!read_property(body, &spot, error))
            return false;
    }
    body->at += body->is_text ? strspn(body->at, " \t") : 0;
    return !body->is_text || body->at == body->end || strspn(body->at, "\r\n") ||
           fail(body, error, "%s %zu has more numbers than the header says", element->name, index);
}

static bool check(struct body *body, struct aob_error *error)
{
    if (!read_header(body, error))
        return false;
    for (size_t e = 0; e < body->element_count; e++)
        for (size_t i = 0; body->elements[e].property_count && i < body->elements[e].count; i++)
            if (!read_element(body, &body->elements[e], i, error))
                return false;
    if (body->is_text)
        skip_blank_lines(body);
    return !body->is_text || body->at == body->end ||
           fail(body, error, "it goes on behind the last element that the header counts");
}

bool aob_ply_body_check(const char *path, struct aob_error *error)
{
    size_t size;
    char *bytes = aob_file_read(path, ((size_t)1 << BODY_LIMIT_BITS) - 2, &size, NULL);
    struct body body = {.path = path, .at = bytes, .end = bytes ? bytes + size : NULL};
    bool ok = !bytes || check(&body, error);
    for (size_t i = 0; i < body.element_count; i++)
        free(body.elements[i].properties);
    free(body.elements);
    free(bytes);
    return ok;
}

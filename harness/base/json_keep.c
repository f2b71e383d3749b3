#include "json_keep.h"
#include <stdbool.h>
#include <string.h>

enum { MAX_DEPTH = 8 }; /* names of a path */

struct slice {
    const char *text;
    size_t size;
};

/* The text while it is copied. */
struct keeping {
    const char *at, *end;
    char *out;
    const char *const *paths;
    struct slice names[MAX_DEPTH]; /* of the members that are open, from the outermost object's on */
    int depth;                     /* of objects */
};

/* Behind the string that begins at `at`. */
static const char *end_of_string(const char *at, const char *end)
{
    const char *quote = at + 1 < end ? memchr(at + 1, '"', (size_t)(end - at - 1)) : NULL;
    if (quote && quote[-1] != '\\')
        return quote + 1;
    for (at++; at < end && *at != '"'; at++)
        at += *at == '\\';
    return at < end ? at + 1 : end;
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static const char *skip_blanks(const char *at, const char *end)
{
    while (at < end && is_blank(*at))
        at++;
    return at;
}

/* Behind the value that begins at `at`: at the comma or bracket that follows. */
static const char *end_of_value(const char *at, const char *end)
{
    for (int depth = 0; at < end; at++) {
        if (*at == '"') {
            at = end_of_string(at, end) - 1;
            continue;
        }
        if (depth == 0 && (*at == ',' || *at == '}' || *at == ']'))
            return at;
        depth += (*at == '{' || *at == '[') - (*at == '}' || *at == ']');
    }
    return end;
}

/* What becomes of a member. */
enum fate { LEFT_OUT, ENTERED, KEPT };

/* By one path: it leads to the innermost of the open members, past it, or elsewhere. */
static enum fate judge_by(const struct keeping *c, const char *path)
{
    for (int i = 0; i < c->depth; i++) {
        const struct slice *name = &c->names[i];
        size_t size = *path == '*' ? 1 : name->size;
        if (*path != '*' && (*path != *name->text || strncmp(path, name->text, size) != 0 ||
                             memchr(name->text, '.', size))) /* which in a path parts two names */
            return LEFT_OUT;
        path += size;
        if (*path && *path != '.')
            return LEFT_OUT;
        if (!*path)
            return i + 1 == c->depth ? KEPT : LEFT_OUT;
        path++;
    }
    return ENTERED;
}

static enum fate judge(const struct keeping *c)
{
    enum fate fate = LEFT_OUT;
    for (const char *const *path = c->paths; *path && fate != KEPT; path++) {
        enum fate next = judge_by(c, *path);
        fate = next > fate ? next : fate;
    }
    return fate;
}

static void copy_to(struct keeping *c, const char *end)
{
    size_t size = (size_t)(end - c->at);
    memmove(c->out, c->at, size);
    c->out += size;
    c->at = end;
}

/* The comma behind what is left out goes with it, or, of an object's last member, the one before. */
static void leave_out(struct keeping *c, const char *value)
{
    char *before = c->out;
    c->at = end_of_value(value, c->end);
    while (is_blank(before[-1]))
        before--;
    if (c->at < c->end && *c->at == ',')
        c->at++;
    else if (before[-1] == ',')
        c->out = before - 1;
}

/* A string is a member's name if a colon follows. */
static void take_string(struct keeping *c)
{
    const char *end = end_of_string(c->at, c->end), *colon = skip_blanks(end, c->end);
    if (c->depth < 1 || c->depth > MAX_DEPTH || colon == c->end || *colon != ':') {
        copy_to(c, end);
        return;
    }
    struct slice *name = &c->names[c->depth - 1];
    *name = (struct slice){c->at + 1, (size_t)(end - c->at) - 2};
    enum fate fate = judge(c);
    if (fate == LEFT_OUT)
        leave_out(c, colon + 1);
    else
        copy_to(c, fate == KEPT ? end_of_value(colon + 1, c->end) : end);
    if (fate == ENTERED) /* where it lay may be written over, where it lies now is not */
        name->text = c->out - name->size - 1;
}

size_t aob_json_keep(const char *text, size_t size, const char *const *paths, char *out)
{
    struct keeping c = {.at = text, .end = text + size, .out = out, .paths = paths};
    for (int i = 0; i < MAX_DEPTH; i++) /* of text that is no JSON, an object may have no name */
        c.names[i] = (struct slice){"", 0};
    while (c.at < c.end) {
        size_t plain = 0, left = (size_t)(c.end - c.at);
        while (plain < left && c.at[plain] != '"' && c.at[plain] != '{' && c.at[plain] != '}')
            plain++;
        copy_to(&c, c.at + plain);
        if (c.at == c.end)
            break;
        if (*c.at == '"') {
            take_string(&c);
            continue;
        }
        c.depth += *c.at == '{' ? 1 : -1;
        copy_to(&c, c.at + 1);
    }
    return (size_t)(c.out - out);
}

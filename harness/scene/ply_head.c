#include "ply_head.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "ply_body.h"

enum { HEAD = 1 << 20, PLY_LIMIT_BITS = 32 };
static const char header_end[] = "\nend_header\n";

/* Returns where the data of a binary file begin if they begin with a line end; else 0. */
static size_t find_data(const char *bytes, size_t size)
{
    const char *end = memmem(bytes, size < HEAD ? size : HEAD, header_end, sizeof header_end - 1);
    if (!end || strncmp(bytes, "ply\n", 4) != 0)
        return 0;
    size_t head = (size_t)(end - bytes), data = head + sizeof header_end - 1;
    return memmem(bytes, head, "\nformat binary_", 15) && data < size && bytes[data] == '\n' ? data : 0;
}

/* By its ending or, as assimp does, by its first line. */
static bool is_ply(const char *path, const char *head)
{
    const char *ending = strrchr(path, '.');
    return (ending && strcasecmp(ending, ".ply") == 0) ||
           (strncasecmp(head, "ply", 3) == 0 && head[3] && strchr("\r\n", head[3]));
}

/* The start of a PLY file, NUL-ended; free() it. NULL if it is none, or cannot be read, which the importer complains
 * of. */
static char *read_head(const char *path, size_t *size)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return NULL;
    char *head = aob_alloc(HEAD + 1, 1);
    *size = fread(head, 1, HEAD, in);
    fclose(in);
    if (is_ply(path, head))
        return head;
    free(head);
    return NULL;
}

/* Lines may end in carriage returns alone. */
static bool has_end(const char *head, size_t size)
{
    static const char word[] = "end_header";
    const char *at = head;
    while ((at = memmem(at, size - (size_t)(at - head), word, sizeof word - 1)))
        if (at > head && strchr("\r\n", at[-1]))
            return true;
        else
            at++;
    return false;
}

/* The next word of a line; *size is 0 at the line's end. */
static const char *find_word(const char *at, size_t *size)
{
    at += strspn(at, " \t");
    *size = strcspn(at, " \t\r\n");
    return at;
}

static bool is_word(const char *word, size_t size, const char *text)
{
    return strlen(text) == size && memcmp(word, text, size) == 0;
}

/* Whether "property TYPE NAME" stands below "element vertex". Also where there is no such element, which the importer
 * complains of. */
static bool has_property(const char *head, const char *name)
{
    bool below = false, found = true;
    for (const char *line = head; *line && strncmp(line, "end_header", 10) != 0;) {
        size_t sizes[3];
        const char *first = find_word(line, &sizes[0]), *second = find_word(first + sizes[0], &sizes[1]),
                   *third = find_word(second + sizes[1], &sizes[2]);
        if (is_word(first, sizes[0], "element")) {
            below = is_word(second, sizes[1], "vertex");
            found = found && !below;
        } else if (below && is_word(first, sizes[0], "property") && is_word(third, sizes[2], name))
            return true;
        line += strcspn(line, "\r\n");
        line += strspn(line, "\r\n");
    }
    return found;
}

static bool check_head(const char *path, const char *head, size_t size, struct aob_error *error)
{
    static const char *const axes[] = {"x", "y", "z"};
    if (!has_end(head, size))
        return aob_fail(error, "%s: its header has no end_header: the file is cut off or damaged", path);
    for (size_t i = 0; i < AOB_COUNT(axes); i++)
        if (!has_property(head, axes[i]))
            return aob_fail(error, "%s: its vertices have no property %s: the file is damaged", path,
                            axes[i]);
    return true;
}

bool aob_ply_check(const char *path, struct aob_error *error)
{
    size_t size;
    char *head = read_head(path, &size);
    bool ok = !head || (check_head(path, head, size, error) && aob_ply_body_check(path, error));
    free(head);
    return ok;
}

char *aob_ply_pad(const char *path, size_t *size)
{
    size_t whole;
    struct aob_text text = {0};
    char *head = read_head(path, &whole);
    bool needed = head && find_data(head, whole) > 0; /* so that only a file at fault is read into memory */
    free(head);
    char *bytes = needed ? aob_file_read(path, ((size_t)1 << PLY_LIMIT_BITS) - 2, &whole, NULL) : NULL;
    size_t data = bytes ? find_data(bytes, whole) : 0;
    if (data) {
        aob_text_add_bytes(&text, bytes, data);
        aob_text_add_bytes(&text, "\n", 1);
        aob_text_add_bytes(&text, bytes + data, whole - data);
    }
    free(bytes);
    *size = text.size;
    return text.data;
}

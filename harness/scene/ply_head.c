#include "ply_head.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

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

static bool is_ply(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending && strcasecmp(ending, ".ply") == 0;
}

/* The start of the file, NUL-ended; free() it. NULL if it cannot be read, which the importer complains of. */
static char *read_head(const char *path, size_t *size)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return NULL;
    char *head = aob_alloc(HEAD + 1, 1);
    *size = fread(head, 1, HEAD, in);
    fclose(in);
    return head;
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

bool aob_ply_check(const char *path, struct aob_error *error)
{
    size_t size;
    char *head = is_ply(path) ? read_head(path, &size) : NULL;
    bool ok = !head || has_end(head, size);
    free(head);
    return ok || aob_fail(error, "%s: its header has no end_header: the file is cut off or damaged", path);
}

char *aob_ply_pad(const char *path, size_t *size)
{
    size_t whole;
    struct aob_text text = {0};
    char *head = is_ply(path) ? read_head(path, &whole) : NULL;
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

#include "ply_pad.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

enum { HEAD = 65536, PLY_LIMIT_BITS = 32 };
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

/* The start of the file decides, so that only a file at fault is read into memory. */
static bool needs_pad(const char *path)
{
    FILE *in = fopen(path, "rb");
    if (!in)
        return false;
    char *head = aob_alloc(HEAD, 1);
    bool needed = find_data(head, fread(head, 1, HEAD, in)) > 0;
    free(head);
    fclose(in);
    return needed;
}

char *aob_ply_pad(const char *path, size_t *size)
{
    const char *ending = strrchr(path, '.');
    size_t whole;
    struct aob_text text = {0};
    if (!ending || strcasecmp(ending, ".ply") != 0 || !needs_pad(path))
        return NULL;
    char *bytes = aob_file_read(path, ((size_t)1 << PLY_LIMIT_BITS) - 2, &whole, NULL);
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

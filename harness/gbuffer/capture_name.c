#include "capture_name.h"
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "capture_channel.h"

static void add_part(struct aob_capture_name *name, size_t *used, const char *from, const char *end)
{
    name->parts[name->count++] = name->text + *used;
    for (; from < end; from++)
        if (isalnum((unsigned char)*from))
            name->text[(*used)++] = (char)tolower((unsigned char)*from);
    name->text[(*used)++] = '\0';
}

bool aob_capture_name_split(struct aob_capture_name *name, const char *text)
{
    size_t used = 0;
    name->count = 0;
    if (strlen(text) >= AOB_CAPTURE_NAME)
        return false;
    for (const char *dot; name->count < AOB_CAPTURE_PARTS - 1 && (dot = strchr(text, '.')); text = dot + 1)
        add_part(name, &used, text, dot);
    add_part(name, &used, text, text + strlen(text));
    return true;
}

bool aob_capture_name_ends(const char *part, const char *end)
{
    size_t size = strlen(part), tail = strlen(end);
    return size >= tail && strcmp(part + size - tail, end) == 0;
}

int aob_capture_name_find(const struct aob_capture_name *name, bool (*is)(const char *word))
{
    int at = name->count - 2;
    while (at >= 0 && !is(name->parts[at]))
        at--;
    return at;
}

static int compare_parts(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

void aob_capture_name_layer(const struct aob_capture_name *name, int word, char layer[AOB_CAPTURE_NAME])
{
    const char *parts[AOB_CAPTURE_PARTS];
    size_t count = 0, used = 0;
    for (int i = 0; i + 1 < name->count; i++)
        if (i != word)
            parts[count++] = name->parts[i];
    qsort(parts, count, sizeof *parts, compare_parts);
    layer[0] = '\0';
    for (size_t i = 0; i < count; i++)
        used += (size_t)snprintf(layer + used, AOB_CAPTURE_NAME - used, "%s.", parts[i]);
}

size_t aob_capture_name_stem(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot ? (size_t)(dot - name) : 0;
}

int aob_capture_name_sibling(const char *const *names, size_t count, const char *name, size_t stem,
                             const char *last)
{
    for (size_t i = 0; i < count; i++)
        if (strncmp(names[i], name, stem) == 0 && names[i][stem] == '.' &&
            strlen(names[i]) < AOB_CAPTURE_NAME && strcasecmp(names[i] + stem + 1, last) == 0)
            return (int)i;
    return AOB_CHANNEL_NONE;
}

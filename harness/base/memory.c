#include "memory.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The process ends here, so that no caller has a path for a failure that no test could reach. */
static void *checked(void *block, size_t count, size_t size)
{
    if (!block) {
        fprintf(stderr, "aobudget: error: out of memory (%zu x %zu bytes)\n", count, size);
        exit(2);
    }
    return block;
}

void *aob_alloc(size_t count, size_t size)
{
    return checked(calloc(count ? count : 1, size), count, size);
}

void *aob_realloc(void *block, size_t count, size_t size)
{
    return checked(size && count > SIZE_MAX / size ? NULL : realloc(block, count * size + !count), count,
                   size);
}

char *aob_strdup(const char *text)
{
    return text ? checked(strdup(text), strlen(text) + 1, 1) : NULL;
}

void *aob_grow(void *array, size_t count, size_t *capacity, size_t size)
{
    if (count >= *capacity) {
        *capacity = *capacity ? *capacity * 2 : 8;
        array = aob_realloc(array, *capacity, size);
    }
    memset((char *)array + count * size, 0, size);
    return array;
}

/* The number of triangles that a scene's title states. */
#ifndef AOB_TESTS_SCENE_TITLE_H
#define AOB_TESTS_SCENE_TITLE_H
#include <ctype.h>
#include <stddef.h>
#include <string.h>

/* "44,066 triangles" gives 44066; 0 without such words. */
static inline size_t title_triangles(const char *title)
{
    const char *end = strstr(title, " triangles"), *start = end;
    size_t count = 0;
    while (end && start > title && (isdigit((unsigned char)start[-1]) || start[-1] == ','))
        start--;
    for (; start < end; start++)
        if (*start != ',')
            count = 10 * count + (size_t)(*start - '0');
    return count;
}
#endif

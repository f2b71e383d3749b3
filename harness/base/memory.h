/* Memory that cannot fail: a machine out of memory ends the process with one line and exit code 2,
 * so no caller checks. Free with free(). */
#ifndef AOB_BASE_MEMORY_H
#define AOB_BASE_MEMORY_H
#include <stddef.h>

void *aob_alloc(size_t count, size_t size);                /* zeroed; count * size is checked */
void *aob_realloc(void *block, size_t count, size_t size); /* the new part is not zeroed */
char *aob_strdup(const char *text);                        /* NULL gives NULL */

#define AOB_NEW(type)          ((type *)aob_alloc(1, sizeof(type)))
#define AOB_NEW_ARRAY(type, n) ((type *)aob_alloc((n), sizeof(type)))
#define AOB_COUNT(array)       (sizeof(array) / sizeof((array)[0]))

/* Makes room for one more element at the end of a growing array, and evaluates to a pointer to that new, zeroed
 * element. `array`, `count` and `capacity` are lvalues. */
#define AOB_PUSH(array, count, capacity)                                                                     \
    ((array) = aob_grow((array), (count), &(capacity), sizeof *(array)), &(array)[(count)++])
void *aob_grow(void *array, size_t count, size_t *capacity, size_t size);
#endif

/* Memory that cannot fail: a machine out of memory ends the process with one line and exit code 2,
 * so no caller checks. Free with free(). */
#ifndef AOB_BASE_MEMORY_H
#define AOB_BASE_MEMORY_H
#include <stddef.h>

void *aob_alloc(size_t count, size_t size);                /* zeroed; count * size is checked */
void *aob_realloc(void *block, size_t count, size_t size); /* new part is not zeroed */
char *aob_strdup(const char *text);                        /* NULL gives NULL */

#define AOB_NEW(type)          ((type *)aob_alloc(1, sizeof(type)))
#define AOB_NEW_ARRAY(type, n) ((type *)aob_alloc((n), sizeof(type)))
#define AOB_COUNT(array)       (sizeof(array) / sizeof((array)[0]))

/* Room for one more element at the end of a growing array; `array`, `count` and `capacity` are lvalues.
 * Evaluates to a pointer to the new, zeroed element. */
#define AOB_PUSH(array, count, capacity)                                                                     \
    ((array) = aob_grow((array), (count), &(capacity), sizeof *(array)), &(array)[(count)++])
void *aob_grow(void *array, size_t count, size_t *capacity, size_t size);
#endif

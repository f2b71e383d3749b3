/* Misses of fully associative LRU caches of several sizes at once, in one pass over the accesses (Mattson, Gecsei, Slutz,
 * Traiger: Evaluation Techniques for Storage Hierarchies, IBM Systems Journal 9, 1970). One list holds all lines by their
 * last use; each size has a mark at its depth, and a line knows between which marks it lies. An access costs a step for
 * each mark that it passes. Sectors are as in tags.h: an access hits where its line stayed since its sector was brought.
 * Threads: one at a time for each object. */
#ifndef AOB_PROFILE_STACK_H
#define AOB_PROFILE_STACK_H
#include <stddef.h>
#include <stdint.h>

enum { AOB_STACK_MAX_SIZE = 40 };

struct aob_stack_desc {
    uint32_t numbers;      /* all are below it */
    uint32_t sectors;      /* of a line; 0 means 1 */
    const uint32_t *sizes; /* in lines, rising, from 1; at most AOB_STACK_MAX_SIZE */
    size_t size_count;
};

struct aob_stack *aob_stack_create(const struct aob_stack_desc *desc);
double aob_stack_bytes(uint32_t numbers, uint32_t sectors); /* of memory, at most */
void aob_stack_destroy(struct aob_stack *stack);
void aob_stack_access(struct aob_stack *stack, const uint32_t *numbers, size_t count);

/* Of the size with that place in `sizes`. */
uint64_t aob_stack_misses(const struct aob_stack *stack, size_t size);
#endif

/* For tags.c: the inner loops, one for each path. */
#ifndef AOB_PROFILE_TAGS_KERNEL_H
#define AOB_PROFILE_TAGS_KERNEL_H
#include "tags.h"

#define AOB_TAGS_EMPTY UINT32_MAX /* what a way holds before its first line */

struct aob_tags_accesses {
    const uint32_t *lines, *sets;
    size_t count;
    uint32_t first;   /* place of the first one, for `missed` */
    uint32_t *missed; /* room for `count` */
};

/* The ways of each set in order of their last use, the latest first, in `stride` words of which the first `ways` count.
 * Returns how many missed. */
typedef size_t aob_tags_kernel(uint32_t *tags, uint32_t ways, const struct aob_tags_accesses *accesses);

struct aob_tags_way { /* a path for a number of ways */
    aob_tags_kernel *kernel;
    uint32_t stride; /* words of a set */
};

/* What this processor has of a SIMD path; no kernel: nothing. */
struct aob_tags_way aob_tags_simd(enum aob_tags_path path, uint32_t ways);

/* The path of linked lists. */
struct aob_tags_list;
struct aob_tags_list *aob_tags_list_create(const struct aob_tags_desc *desc);
void aob_tags_list_destroy(struct aob_tags_list *list);
void aob_tags_list_clear(struct aob_tags_list *list);
double aob_tags_list_bytes(const struct aob_tags_desc *desc);
/* `lines` of the accesses are numbers of sectors. */
size_t aob_tags_list_access(struct aob_tags_list *list, const struct aob_tags_accesses *accesses);
#endif

/* What one cache holds, line by line, and in which order it was used: least recently used leaves first. It knows numbers
 * of lines and no bytes.
 *
 * A cache may fill less than a line at a time: a line of `sectors` sectors has one tag, a miss brings one sector, and a
 * hit needs both. Then the numbers below are those of sectors: sector s of line l is l * sectors + s.
 *
 * Threads: one at a time for each object. */
#ifndef AOB_PROFILE_TAGS_H
#define AOB_PROFILE_TAGS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum aob_index {                   /* which set a line lies in */
                 AOB_INDEX_MODULO, /* line modulo sets */
                 AOB_INDEX_XOR,    /* line ^ line >> b ^ line >> 2b, modulo sets, which are 2^b */
                 AOB_INDEX_COUNT
};

/* How the ways of a set are searched. All give the same answers. */
enum aob_tags_path {
    AOB_TAGS_BEST,     /* what is fastest on this processor */
    AOB_TAGS_PORTABLE, /* C: up to 16 ways */
    AOB_TAGS_SSE41,    /* up to 4 ways in one register */
    AOB_TAGS_AVX2,     /* up to 16 in one or two */
    AOB_TAGS_AVX512,   /* up to 16 in one */
    AOB_TAGS_LIST,     /* a linked list a set, and a table of all lines: any number of ways, and sectors */
    AOB_TAGS_PATH_COUNT
};

struct aob_tags_desc {
    uint32_t sets;    /* any number; a power of two with AOB_INDEX_XOR */
    uint32_t ways;    /* of a set */
    uint32_t sectors; /* of a line: a power of two up to 32; 0 means 1 */
    enum aob_index index;
    uint32_t numbers; /* all that come are below it */
    enum aob_tags_path path;
};

/* Whether that path serves such a cache on this processor. AOB_TAGS_BEST does. */
bool aob_tags_can(const struct aob_tags_desc *desc);

/* Bytes of memory at most: what a caller compares with the machine's before it creates one. */
double aob_tags_bytes(const struct aob_tags_desc *desc);

struct aob_tags *aob_tags_create(const struct aob_tags_desc *desc); /* empty */
void aob_tags_destroy(struct aob_tags *tags);
void aob_tags_clear(struct aob_tags *tags); /* empty again */

/* Uses the numbers one after the other, and returns how many missed. `missed` takes their places in `numbers`, rising; it
 * has room for `count`, or is NULL. */
size_t aob_tags_access(struct aob_tags *tags, const uint32_t *numbers, size_t count, uint32_t *missed);

/* The same with the set of each as the caller says: of numbers that only name the lines, which have others in memory. */
size_t aob_tags_access_in(struct aob_tags *tags, const uint32_t *numbers, const uint32_t *sets, size_t count,
                          uint32_t *missed);

/* The set of each line in such a cache. */
void aob_index_sets(const struct aob_tags_desc *desc, const uint32_t *lines, size_t count, uint32_t *sets);
const char *aob_index_name(enum aob_index index);             /* "modulo", "xor" */
bool aob_index_find(const char *name, enum aob_index *index); /* false: there is no such index */
#endif

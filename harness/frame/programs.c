#include "programs.h"
#include <stdlib.h>
#include <string.h>
#include "base/hash.h"
#include "base/memory.h"

void aob_programs_init(struct aob_programs *programs, struct aob_gpu *gpu)
{
    *programs = (struct aob_programs){.gpu = gpu};
}

static void key_of(const struct aob_gpu_program_desc *desc, char key[AOB_KEY_SIZE])
{
    struct aob_hash hash;
    aob_hash_begin(&hash);
    aob_hash_add(&hash, desc->fragment, strlen(desc->fragment) + 1); /* the NUL parts the two */
    if (desc->vertex)
        aob_hash_add(&hash, desc->vertex, strlen(desc->vertex));
    aob_hash_end(&hash, key);
}

struct aob_gpu_program *aob_programs_lend(struct aob_programs *programs,
                                          const struct aob_gpu_program_desc *desc, struct aob_error *error)
{
    char key[AOB_KEY_SIZE];
    size_t place;
    key_of(desc, key);
    if (aob_table_find(&programs->places, key, &place))
        return programs->items[place];
    struct aob_gpu_program *made = aob_gpu_program_create_desc(programs->gpu, desc, error);
    if (!made)
        return NULL;
    aob_table_put(&programs->places, key, programs->count);
    *AOB_PUSH(programs->items, programs->count, programs->capacity) = made;
    return made;
}

void aob_programs_finish(struct aob_programs *programs)
{
    for (size_t i = 0; i < programs->count; i++)
        aob_gpu_program_destroy(programs->gpu, programs->items[i]);
    free(programs->items);
    aob_table_finish(&programs->places);
    *programs = (struct aob_programs){0};
}

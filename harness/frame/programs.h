/* Programs that several frames share. Compiling is most of what a small frame costs, and a text that was compiled once serves
 * all sizes, views and values of uniform parameters. */
#ifndef AOB_FRAME_PROGRAMS_H
#define AOB_FRAME_PROGRAMS_H
#include "base/table.h"
#include "gpu/gpu.h"

struct aob_programs {
    struct aob_gpu *gpu; /* must outlive it */
    struct aob_table places;
    struct aob_gpu_program **items;
    size_t count, capacity;
};

void aob_programs_init(struct aob_programs *programs, struct aob_gpu *gpu);

/* The program of these texts, which is compiled if no frame had it before. It stays the cache's. NULL after one line. A
 * program with a rewrite is not for it. */
struct aob_gpu_program *aob_programs_lend(struct aob_programs *programs,
                                          const struct aob_gpu_program_desc *desc, struct aob_error *error);

void aob_programs_finish(struct aob_programs *programs); /* after the frames that borrow */
#endif

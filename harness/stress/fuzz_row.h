/* What became of the fuzzer's frames of a technique on a backend. */
#ifndef AOB_STRESS_FUZZ_ROW_H
#define AOB_STRESS_FUZZ_ROW_H
#include "fuzz.h"
#include "fuzz_draw.h"
#include "job/fuzz_job.h"

/* All frames that fail in one way. */
struct aob_fuzz_finding {
    enum aob_fuzz_fault fault;
    bool hostile;
    uint64_t count;
    uint64_t index;   /* of the frame that was made smaller, or of the first */
    char *sentence;   /* of the frame as it was drawn */
    json_t *smallest; /* NULL: it could not be made smaller */
};
struct aob_fuzz_row {
    const struct aob_technique_info *technique; /* borrowed */
    const char *backend;                        /* borrowed */
    char *device, *driver;                      /* once it was opened */
    char *missing;                              /* why the backend cannot be had; NULL: it can */
    uint64_t begun, refused, crashes;           /* frames */
    struct aob_fuzz_finding *findings;
    size_t finding_count, finding_capacity;
};
void aob_fuzz_row_finish(struct aob_fuzz_row *row);

/* Takes what a worker says. */
void aob_fuzz_row_take(struct aob_fuzz_row *row, const struct aob_fuzz_answer *answer);

/* Bits 2 * fault + hostile of what was found (job/fuzz_job.h). */
uint32_t aob_fuzz_row_known(const struct aob_fuzz_row *row);

/* How a run went: its document, a new object, and its table for people. */
struct aob_fuzz_sums {
    uint64_t begun, refused, failed;
    double seconds;
};
json_t *aob_fuzz_to_json(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *rows, size_t count,
                         const struct aob_fuzz_sums *sums);
void aob_fuzz_print(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *rows, size_t count,
                    const struct aob_fuzz_sums *sums, struct aob_text *out);
#endif

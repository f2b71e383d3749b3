/* Draws a frame of the fuzzer and says what is wrong with its image: whether there is one, all of it is finite, surfaces are
 * within 0..1, sky is 1, a bent normal is no longer than 1, light is not negative, and a second drawing is the same to the
 * bit. Threads: the one that opened the device. */
#ifndef AOB_STRESS_FUZZ_DRAW_H
#define AOB_STRESS_FUZZ_DRAW_H
#include "fuzz_frame.h"
#include "subject.h"

enum aob_fuzz_fault {
    AOB_FUZZ_FINE,
    AOB_FUZZ_REFUSED, /* check() refuses the values, or the device lacks something: no fault */
    AOB_FUZZ_ERROR,   /* no image; a message of the validation layer is one */
    AOB_FUZZ_NOT_FINITE,
    AOB_FUZZ_RANGE,
    AOB_FUZZ_NOT_OPEN, /* sky that is not 1 */
    AOB_FUZZ_AGAIN,    /* another image the second time */
    AOB_FUZZ_CRASH,    /* of the worker; nobody is left to draw again */
    AOB_FUZZ_FAULT_COUNT
};
const char *aob_fuzz_fault_word(enum aob_fuzz_fault fault); /* "not finite" */
enum aob_fuzz_fault aob_fuzz_fault_find(const char *word);  /* AOB_FUZZ_FINE: no such word */

/* Who draws. */
struct aob_fuzz_artist {
    struct aob_subject subject;
    bool triangles; /* its technique draws them */
};

struct aob_fuzz_sight {
    enum aob_fuzz_fault fault;
    char sentence[240]; /* what was seen, and where */
    /* The outputs of both drawings, width x height pixels each; zeros where one is not wanted or not given. */
    struct aob_reading drawn[2];
};
void aob_fuzz_draw(struct aob_fuzz_artist *artist, const struct aob_fuzz_frame *frame,
                   struct aob_fuzz_sight *sight);
void aob_fuzz_sight_finish(struct aob_fuzz_sight *sight);
#endif

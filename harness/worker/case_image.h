/* The images of one case, cropped to the view, and its EXR file (docs/design.md, EXR channels). */
#ifndef AOB_WORKER_CASE_IMAGE_H
#define AOB_WORKER_CASE_IMAGE_H
#include "block.h"

/* What a technique wrote of another output, and the truth of the case's own target: `components` floats a pixel. The image is
 * NULL where the case does not give it, the truth and its standard error where nothing is compared. */
struct aob_case_effect {
    int components;
    float *image, *truth, *se;
};

struct aob_case_image { /* width x height floats each, owned; NULL where the case has none */
    float *depth;       /* scene units; AOB_GBUFFER_SKY where sky */
    float *ao;          /* what the technique wrote */
    float (*bent)[3];   /* the bent normal that it wrote, view space; NULL where it gives none */
    float *truth, *se;  /* of the case's own target */
    float (*open)[3];   /* that target's mean open direction; NULL where `bent` is */
    float (*normal)[3]; /* of the surface, view space; NULL unless an output other than visibility is there */
    float *definition;  /* what the technique claims, mapped */
    float *screen;      /* the claim within the screen-space bound */
    struct aob_case_effect effects[AOB_OUTPUT_COUNT]; /* none of visibility and bent normal */
};
void aob_case_image_finish(struct aob_case_image *image);

/* Leaves the guard band out: one component, `stride` floats a pixel in `from`. */
void aob_case_image_crop(const struct aob_block *block, const float *from, int stride, float *into);

/* The surfaces' normals without the guard band: three floats a pixel, view space; the caller's to free. */
float (*aob_case_image_normals(const struct aob_block *block))[3];

/* The diffuse albedo without the guard band: three floats a pixel, 0 where sky; the caller's to free. */
float *aob_case_image_albedo(const struct aob_block *block);

bool aob_case_image_is_sky(const struct aob_case_image *image, size_t i);

/* What the technique wrote where there is a surface, all its outputs, to the bit. */
void aob_case_image_digest(const struct aob_block *block, const struct aob_case_image *image,
                           char digest[AOB_KEY_SIZE]);

/* Into the file c->image. */
bool aob_case_image_write(const struct aob_block *block, const struct aob_block_case *c,
                          const struct aob_case_image *image, struct aob_error *error);
#endif

#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "section.h"
#include "canvas.h"

/* Everything is made anew for each image: after its first message a device refuses all that follows. */
static bool draw_watched(const struct aob_section_job *job, const struct aob_check_image *image,
                         struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_canvas canvas = {0};
    size_t count = (size_t)image->view->width * (size_t)image->view->height;
    float *pixels = AOB_NEW_ARRAY(float, count);
    struct aob_gpu *gpu = aob_section_open(job, &(struct aob_gpu_desc){.validate = true}, error);
    bool ok = gpu && aob_canvas_init(&canvas, gpu, image->view, error) &&
              aob_canvas_show(&canvas, image->technique, image->params, image->options, frame, error) &&
              aob_frame_run(frame, 2, NULL, error) &&
              aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, pixels, error);
    aob_frame_finish(frame);
    aob_canvas_finish(&canvas);
    aob_gpu_close(gpu);
    free(pixels);
    free(frame);
    return ok;
}

/* Whether there is a layer: without one a device opens only unwatched. */
static bool has_layer(const struct aob_section_job *job, struct aob_error *error)
{
    struct aob_gpu *gpu = aob_section_open(job, &(struct aob_gpu_desc){.validate = true}, error);
    aob_gpu_close(gpu);
    return gpu;
}

static bool run_validation(const struct aob_section_job *job, struct aob_error *error)
{
    struct aob_error cause = {{0}};
    (void)error;
    if (!has_layer(job, &cause)) { /* or it has a message of the opening already */
        bool missing = strstr(cause.text, "no validation layer");
        aob_section_say(job, missing ? "layer" : "opening the device",
                        missing ? AOB_CHECK_SKIPPED : AOB_CHECK_DISAGREES, cause.text);
        return true;
    }
    for (size_t i = 0; i < job->data.image_count; i++) {
        const struct aob_check_image *image = &job->data.images[i];
        cause = (struct aob_error){{0}};
        if (aob_section_is_over(job, image->name))
            continue;
        bool ok = draw_watched(job, image, &cause);
        aob_section_say(job, image->name, ok ? AOB_CHECK_PASSED : AOB_CHECK_DISAGREES, cause.text);
    }
    return true;
}

const struct aob_section aob_section_validation = {"validation", run_validation};

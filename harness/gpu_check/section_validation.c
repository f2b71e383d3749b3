#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "canvas.h"
#include "section.h"

/* Reads all outputs that it gives, as each is copied from a texture of its own. */
static bool read_all(struct aob_frame *frame, const struct aob_check_view *view, struct aob_error *error)
{
    bool ok = true;
    for (int which = 0; ok && which < AOB_OUTPUT_COUNT; which++) {
        enum aob_output output = (enum aob_output)which;
        int components = aob_output_components(output);
        if (!aob_graph_gives(&frame->graph, output))
            continue;
        float *pixels = AOB_NEW_ARRAY(float, (size_t)components *(size_t)view->width *(size_t)view->height);
        ok = aob_frame_read(frame, output, components, pixels, error);
        free(pixels);
    }
    return ok;
}

/* Everything is made anew for each image: after its first message a device refuses all that follows. */
static bool draw_watched(const struct aob_section_job *job, const struct aob_check_image *image,
                         struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_canvas canvas = {0};
    struct aob_gpu *gpu = aob_section_open(job, &(struct aob_gpu_desc){.validate = true}, error);
    bool ok = gpu && aob_canvas_init(&canvas, gpu, image->view, error) &&
              aob_canvas_show(&canvas, &image->drawing, frame, error) &&
              aob_canvas_draw(frame, image->frames, error) && aob_frame_run(frame, 2, NULL, error) &&
              read_all(frame, image->view, error);
    aob_frame_finish(frame);
    aob_canvas_finish(&canvas);
    aob_gpu_close(gpu);
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

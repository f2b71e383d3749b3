#include <stdlib.h>
#include "agreement.h"
#include "base/json.h"
#include "base/memory.h"
#include "section.h"
#include "canvas.h"

/* What the images of a section share. */
struct gallery {
    const struct aob_section_job *job;
    struct aob_gpu *gpu;
    struct aob_canvas canvas; /* of the last image's view */
    float *truth;             /* of that; NULL where it was not traced */
};

static void leave_view(struct gallery *gallery)
{
    aob_canvas_finish(&gallery->canvas);
    free(gallery->truth);
    gallery->truth = NULL;
}

static bool enter_view(struct gallery *gallery, const struct aob_check_view *view, struct aob_error *error)
{
    if (gallery->canvas.view == view)
        return true;
    leave_view(gallery);
    if (!aob_canvas_init(&gallery->canvas, gallery->gpu, view, error))
        return false;
    gallery->truth = aob_check_channel(view->file, "reference.AO", view->width, view->height, error);
    return gallery->truth;
}

static bool draw(struct gallery *gallery, const struct aob_check_image *image, float *pixels,
                 struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    bool ok =
        aob_canvas_show(&gallery->canvas, image->technique, image->params, image->options, frame, error) &&
        aob_frame_run(frame, 1, NULL, error) && aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, pixels, error);
    aob_frame_finish(frame);
    free(frame);
    return ok;
}

static void reply(const struct gallery *gallery, const struct aob_check_image *image,
                  const struct aob_agreement *a)
{
    struct aob_error error = {{0}};
    bool good = aob_agreement_judge(a, gallery->gpu->info.software, &error);
    aob_section_reply(
        gallery->job,
        json_pack("{s:s, s:s, s:s, s:I, s:o, s:o, s:o, s:o, s:o, s:o}", "item", image->name, "status",
                  good ? AOB_CHECK_PASSED : AOB_CHECK_DISAGREES, "reason", error.text, "pixels",
                  (json_int_t)a->pixels, "visible_share", aob_json_number(a->visible_share), "bias",
                  aob_json_number(a->bias), "rms", aob_json_number(a->rms), "max", aob_json_number(a->max),
                  "rmse", aob_json_number(a->rmse), "expected_rmse", aob_json_number(a->expected_rmse)));
}

/* An error is of the data; what the device cannot do is an item. */
static bool check_image(struct gallery *gallery, const struct aob_check_image *image, struct aob_error *error)
{
    const struct aob_check_view *view = image->view;
    struct aob_error cause = {{0}};
    if (!enter_view(gallery, view, error))
        return false;
    float *expected = aob_check_channel(image->file, "AO", view->width, view->height, error);
    if (!expected)
        return false;
    float *pixels = AOB_NEW_ARRAY(float, (size_t)view->width *(size_t)view->height);
    if (draw(gallery, image, pixels, &cause)) {
        struct aob_agreement agreement;
        aob_agreement_measure(&(struct aob_agreement_desc){.width = view->width,
                                                           .height = view->height,
                                                           .image = pixels,
                                                           .expected = expected,
                                                           .truth = gallery->truth,
                                                           .depth = gallery->canvas.gbuffer.depth,
                                                           .sky_depth = 0.5f * AOB_GBUFFER_SKY},
                              &agreement);
        reply(gallery, image, &agreement);
    } else
        aob_section_say(gallery->job, image->name, AOB_CHECK_FAILED, cause.text);
    free(pixels);
    free(expected);
    return true;
}

static bool run_images(const struct aob_section_job *job, struct aob_error *error)
{
    struct gallery gallery = {.job = job, .gpu = aob_section_open(job, &(struct aob_gpu_desc){0}, error)};
    bool ok = gallery.gpu;
    for (size_t i = 0; ok && i < job->data.image_count; i++)
        if (!aob_section_is_over(job, job->data.images[i].name))
            ok = check_image(&gallery, &job->data.images[i], error);
    leave_view(&gallery);
    aob_gpu_close(gallery.gpu);
    return ok;
}

const struct aob_section aob_section_images = {"images", run_images};

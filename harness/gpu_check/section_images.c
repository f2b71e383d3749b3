#include <stdlib.h>
#include "agreement.h"
#include "base/json.h"
#include "base/memory.h"
#include "canvas.h"
#include "section.h"

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
    struct aob_image file = {0};
    if (!aob_check_file_read(&file, view->file, view, error))
        return false;
    gallery->truth = aob_check_output(&file, "reference.", AOB_OUT_VISIBILITY);
    aob_image_finish(&file);
    return gallery->truth || aob_fail(error, "%s: it has no channel reference.AO: pack it again", view->file);
}

static bool draw(struct gallery *gallery, const struct aob_check_image *image, struct aob_frame *frame,
                 struct aob_error *error)
{
    return aob_canvas_show(&gallery->canvas, &image->drawing, frame, error) &&
           aob_canvas_draw(frame, image->frames, error);
}

/* "gtao on cornell blocks 320x180 bent_normal", or without the last word of the visibility. free() it. */
static char *name_item(const struct aob_check_image *image, enum aob_output output)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s", image->name);
    if (output != AOB_OUT_VISIBILITY)
        aob_text_add(&name, " %s", aob_output_name(output));
    return name.data;
}

static void reply(const struct gallery *gallery, const char *name, const struct aob_agreement *a)
{
    struct aob_error error = {{0}};
    bool good = aob_agreement_judge(a, gallery->gpu->info.software, &error);
    aob_section_reply(
        gallery->job,
        json_pack("{s:s, s:s, s:s, s:s, s:o, s:I, s:o, s:o, s:o, s:o, s:o, s:o}", "item", name, "status",
                  good ? AOB_CHECK_PASSED : AOB_CHECK_DISAGREES, "reason", error.text, "output",
                  aob_output_name(a->output), "scale", aob_json_number(a->scale), "pixels",
                  (json_int_t)a->pixels, "visible_share", aob_json_number(a->visible_share), "bias",
                  aob_json_number(a->bias), "rms", aob_json_number(a->rms), "max", aob_json_number(a->max),
                  "rmse", aob_json_number(a->rmse), "expected_rmse", aob_json_number(a->expected_rmse)));
}

/* What is expected of an output, and the truth of it where that is known. */
struct model {
    float *expected, *truth;
};

static void compare(struct gallery *gallery, const struct aob_check_image *image, struct aob_frame *frame,
                    enum aob_output output, const struct model *model)
{
    const struct aob_check_view *view = image->view;
    int components = aob_output_components(output);
    char *name = name_item(image, output);
    float *pixels = AOB_NEW_ARRAY(float, (size_t)components *(size_t)view->width *(size_t)view->height);
    struct aob_error cause = {{0}};
    if (aob_frame_read(frame, output, components, pixels, &cause)) {
        struct aob_agreement agreement;
        aob_agreement_measure(&(struct aob_agreement_desc){.output = output,
                                                           .width = view->width,
                                                           .height = view->height,
                                                           .image = pixels,
                                                           .expected = model->expected,
                                                           .truth = model->truth,
                                                           .depth = gallery->canvas.gbuffer.depth,
                                                           .sky_depth = 0.5f * AOB_GBUFFER_SKY,
                                                           .normal = gallery->canvas.gbuffer.normal,
                                                           .light = &image->drawing.light},
                              &agreement);
        reply(gallery, name, &agreement);
    } else
        aob_section_say(gallery->job, name, AOB_CHECK_FAILED, cause.text);
    free(pixels);
    free(name);
}

static bool check_output(struct gallery *gallery, const struct aob_check_image *image,
                         struct aob_frame *frame, const struct aob_image *file, enum aob_output output,
                         struct aob_error *error)
{
    bool further = output != AOB_OUT_VISIBILITY;
    struct model model = {.expected = aob_check_output(file, "", output),
                          .truth = further ? aob_check_output(file, "reference.", output) : gallery->truth};
    bool ok = model.expected || aob_fail(error, "%s: it has no image of the output %s: pack it again",
                                         image->file, aob_output_name(output));
    if (ok)
        compare(gallery, image, frame, output, &model);
    free(model.expected);
    if (further)
        free(model.truth);
    return ok;
}

/* An error is of the data; what the device cannot do is an item. */
static bool check_image(struct gallery *gallery, const struct aob_check_image *image, struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_image file = {0};
    struct aob_error cause = {{0}};
    bool ok = enter_view(gallery, image->view, error) &&
              aob_check_file_read(&file, image->file, image->view, error);
    if (ok && !draw(gallery, image, frame, &cause))
        aob_section_say(gallery->job, image->name, AOB_CHECK_FAILED, cause.text);
    else
        for (int which = 0; ok && which < AOB_OUTPUT_COUNT; which++)
            if (aob_graph_gives(&frame->graph, (enum aob_output)which))
                ok = check_output(gallery, image, frame, &file, (enum aob_output)which, error);
    aob_image_finish(&file);
    aob_frame_finish(frame);
    free(frame);
    return ok;
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

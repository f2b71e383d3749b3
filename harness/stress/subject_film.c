#include <stdlib.h>
#include "base/memory.h"
#include "frame/frame.h"
#include "subject.h"

static bool draw(struct aob_frame *frame, struct aob_screen *screen, const struct aob_film *film,
                 size_t index, const void *values, float *image, struct aob_error *error)
{
    const struct aob_exhibit *exhibit = film->frames[index];
    const struct aob_screen_pose pose = {&exhibit->gbuffer, &aob_light_uniform,
                                         aob_camera_then(&exhibit->camera)};
    int number = (int)(index < film->anew ? index : index - film->anew);
    return aob_screen_show(screen, &pose, error) && aob_frame_set(frame, number, values, error) &&
           aob_frame_run(frame, 1, NULL, error) &&
           (!image || aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, image, error));
}

static bool draw_all(struct aob_frame *frame, struct aob_screen *screen, const struct aob_film *film,
                     const void *values, float *const *images, struct aob_error *error)
{
    for (size_t i = 0; i < film->count; i++)
        if (!draw(frame, screen, film, i, values, images[i], error))
            return false;
    return true;
}

bool aob_subject_film(struct aob_subject *subject, const struct aob_film *film, float *const *images,
                      bool *unfit, struct aob_error *error)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_screen screen;
    *unfit = false;
    if (!aob_subject_values(subject, film->shot, values, &options, error))
        return false;
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    const struct aob_frame_desc desc = {.technique = subject->technique,
                                        .values = values,
                                        .fetch = (enum aob_fetch)options.fetch,
                                        .wanted = aob_options_wanted(&options),
                                        .programs = &subject->programs};
    bool ok = aob_screen_init(&screen, subject->gpu, &film->frames[0]->gbuffer, &options, error);
    *unfit = screen.unfit;
    if (ok) {
        ok = aob_frame_init_desc(frame, &screen, &desc, error);
        *unfit = frame->unfit;
    }
    ok = ok && draw_all(frame, &screen, film, values, images, error);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    free(frame);
    return ok;
}

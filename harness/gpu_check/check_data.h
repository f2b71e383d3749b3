/* What gpu-check is packed with, as a folder: check.json and EXR files, all made by gpu-check-data from runs of this build on
 * the software drivers. check.json: {schema, made_on{}, techniques{NAME: digest}, views[{scene, view, camera{}, width,
 * height, metre, file, timed}], images[{name, view, technique, params{}, options{}, file}]}; `view` is a place in views[],
 * a path is seen from the folder. A view's file is a G-buffer (gbuffer/gbuffer.h) with one more channel, reference.AO,
 * where the truth was traced; an image's file has the channel AO. */
#ifndef AOB_GPU_CHECK_CHECK_DATA_H
#define AOB_GPU_CHECK_CHECK_DATA_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "scene/camera.h"

#define AOB_CHECK_DATA_SCHEMA "aobudget gpu-check data 1"

struct aob_check_view {
    const char *scene, *view; /* a procedural scene and the name of a view of it */
    struct aob_camera camera;
    int width, height;
    double metre; /* scene units, for default lengths */
    char *file;
    bool timed; /* techniques are timed on it; else it is one of the images' */
};
struct aob_check_image {
    const char
        *name; /* in results: "gtao fetch=storage on cornell blocks 320x180", with what is not the default */
    const struct aob_check_view *view;
    const char *technique;
    const json_t *params, *options; /* every one by its name; a choice as its word */
    char *file;
};
struct aob_check_data {
    json_t *document; /* borrowed texts lie here */
    struct aob_check_view *views;
    size_t view_count;
    struct aob_check_image *images; /* those of one view together */
    size_t image_count;
};

/* False after one line: no such folder, a damaged document, or one that another build has made: images of other
 * techniques say nothing. aob_check_data_finish frees. */
bool aob_check_data_load(struct aob_check_data *data, const char *folder, struct aob_error *error);
void aob_check_data_finish(struct aob_check_data *data);

/* One channel of an EXR file of ours, width x height floats; free() them. NULL after one line. */
float *aob_check_channel(const char *file, const char *channel, int width, int height,
                         struct aob_error *error);
#endif

/* What gpu-check is packed with, as a folder: check.json and EXR files, all made by gpu-check-data from runs of this build on
 * the software drivers. check.json: {schema, made_on{}, techniques{NAME: digest}, views[{scene, view, camera{}, width,
 * height, metre, file, timed}], images[{name, view, frames, technique, params{}, options{}, light[9][3], file}]}; `view` is a place in
 * views[], a path is seen from the folder. `light` is in view space, and there only where something that the image wants
 * depends on it. `frames` is 1, or how many frames of the view are drawn one after the other, of which the last is the image: then a
 * technique that keeps a history has one. A view's file is a G-buffer (gbuffer/gbuffer.h) with one more channel, reference.AO, where the truth was
 * traced. An image's file has the channels of the outputs that it wants (aob_check_channel_name) and, where it was traced,
 * the truth of those besides visibility, as reference.bent.X and so on. */
#ifndef AOB_GPU_CHECK_CHECK_DATA_H
#define AOB_GPU_CHECK_CHECK_DATA_H
#include <jansson.h>
#include <stdbool.h>
#include <aobudget/technique.h>
#include <stddef.h>
#include "base/error.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "store/image.h"

#define AOB_CHECK_DATA_SCHEMA "aobudget gpu-check data 3"

struct aob_check_view {
    const char *scene, *view; /* a procedural scene and the name of a view of it */
    struct aob_camera camera;
    int width, height;
    double metre; /* scene units, for default lengths */
    char *file;
    bool timed; /* techniques are timed on it; else it is one of the images' */
};
struct aob_check_drawing { /* a technique on a view */
    const char *technique;
    const json_t *params,
        *options; /* values by name, a choice as its word; what they lack, or NULL, is the default */
    struct aob_light light; /* view space */
};
struct aob_check_image {
    const char
        *name; /* in results: "gtao fetch=storage on cornell blocks 320x180", with what is not the default */
    const struct aob_check_view *view;
    struct aob_check_drawing drawing; /* with every value; its light is uniform where nothing depends on it */
    int frames;                       /* that are drawn; the last is the image */
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

/* "AO", "bent.X", "irradiance.R", "specular": the channel of a component of an output. */
enum { AOB_CHECK_CHANNEL_SIZE = 64 };
void aob_check_channel_name(enum aob_output output, int component, char name[AOB_CHECK_CHANNEL_SIZE]);

/* Reads a file of the size of a view; aob_image_finish frees. False after one line. */
bool aob_check_file_read(struct aob_image *file, const char *path, const struct aob_check_view *view,
                         struct aob_error *error);

/* An output in such a file, aob_output_components floats a pixel; free() them. `whose` is put before the channels' names: ""
 * or "reference.". NULL if it lacks one of them. */
float *aob_check_output(const struct aob_image *file, const char *whose, enum aob_output output);
#endif

/* A capture of an open floor, level and 0.1 below the eye, whose normals lean away from the viewer. */
#ifndef AOB_TESTS_GBUFFER_LEANING_FLOOR_H
#define AOB_TESTS_GBUFFER_LEANING_FLOOR_H
#include <math.h>
#include <unistd.h>
#include "capture_file.h"
#include "gbuffer/capture.h"

enum { FLOOR_W = 160, FLOOR_H = 90, FLOOR_COUNT = FLOOR_W * FLOOR_H };
#define FLOOR_FOV 40.0

/* Reads a capture of four planes, one after the other: Z and N.X N.Y N.Z, in view space. The caller finishes it. */
static inline struct aob_capture capture_of_planes(const float *planes, int width, int height,
                                                   exr_pixel_type_t depth)
{
    static const char *const names[4] = {"Z", "N.X", "N.Y", "N.Z"};
    char path[64];
    struct aob_error error = {{0}};
    struct aob_capture capture;
    struct sheet_file file = {.width = width, .height = height, .count = 1};
    file.sheets[0] = (struct sheet){.name = "main", .width = width, .height = height};
    for (int c = 0; c < 4; c++)
        file.sheets[0].channels[c] =
            (struct sheet_channel){names[c], planes + c * width * height, c ? EXR_PIXEL_FLOAT : depth};
    snprintf(path, sizeof path, "/tmp/aobudget-planes-%ld.exr", (long)getpid());
    sheet_write(path, &file);
    if (!aob_capture_read(&capture, &(struct aob_capture_desc){.file = path, .fov_deg = FLOOR_FOV}, &error))
        fail_msg("%s", error.text);
    unlink(path);
    return capture;
}

static inline struct aob_capture leaning_floor(double degrees)
{
    double s = 2 * tan(FLOOR_FOV * M_PI / 360) / FLOOR_H, lean = degrees * M_PI / 180;
    float *planes = AOB_NEW_ARRAY(float, 4 * FLOOR_COUNT);
    for (int i = 0; i < FLOOR_COUNT; i++) {
        double up = -(i / FLOOR_W + 0.5 - FLOOR_H / 2.0) * s;
        planes[i] = up < 0 ? (float)(0.1 / -up) : INFINITY;
        planes[2 * FLOOR_COUNT + i] = (float)cos(lean);
        planes[3 * FLOOR_COUNT + i] = (float)-sin(lean);
    }
    struct aob_capture capture = capture_of_planes(planes, FLOOR_W, FLOOR_H, EXR_PIXEL_FLOAT);
    free(planes);
    return capture;
}
#endif

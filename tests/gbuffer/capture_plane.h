/* A tilted plane n.p = -2 in view space, known in closed form in every convention; its first column is sky.
 * Files hold it, and what is read of them is compared with it. */
#ifndef AOB_TESTS_GBUFFER_CAPTURE_PLANE_H
#define AOB_TESTS_GBUFFER_CAPTURE_PLANE_H
#include "capture_file.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "gbuffer/capture.h"

enum { W = 53, H = 37, COUNT = W * H };
static const double FOV = 50, NEAR = 0.1, FAR = 200;
static const struct aob_vec3 tilted = {0.2, 0.5, 0.8};

struct plane {
    double depth[COUNT], slant[COUNT];
    float z[COUNT], normal[3][COUNT];
    struct aob_vec3 n;
};

static inline void make_plane(struct plane *p)
{
    double s = 2 * tan(FOV * M_PI / 360) / H;
    p->n = aob_vec_normalize(tilted);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            double tx = (x + 0.5 - W / 2.0) * s, ty = -(y + 0.5 - H / 2.0) * s;
            int i = y * W + x;
            p->depth[i] = 2 / (p->n.z - p->n.x * tx - p->n.y * ty);
            assert_true(p->depth[i] > 1 && p->depth[i] < 100);
            p->slant[i] = sqrt(tx * tx + ty * ty + 1);
            p->normal[0][i] = (float)p->n.x;
            p->normal[1][i] = (float)p->n.y;
            p->normal[2][i] = (float)p->n.z;
        }
}

static char path[64]; /* of the file, which is written anew each time */

static inline struct sheet_file one_part(const struct plane *p, const char *depth, exr_pixel_type_t type)
{
    struct sheet_file file = {.width = W, .height = H, .count = 1};
    file.sheets[0] =
        (struct sheet){.name = "main", .width = W, .height = H, .compression = EXR_COMPRESSION_ZIP};
    file.sheets[0].channels[0] = (struct sheet_channel){depth, p->z, type};
    return file;
}

static inline void add_normals(struct sheet *sheet, const struct plane *p, const char *const names[3])
{
    int at = 0;
    while (sheet->channels[at].name)
        at++;
    for (int c = 0; c < 3; c++)
        sheet->channels[at + c] = (struct sheet_channel){names[c], p->normal[c], EXR_PIXEL_FLOAT};
}

static inline void set_z(struct plane *p, float sky)
{
    for (int i = 0; i < COUNT; i++)
        p->z[i] = i % W ? (float)p->depth[i] : sky;
}

static inline struct aob_capture_desc plain(void)
{
    return (struct aob_capture_desc){.file = path, .fov_deg = FOV};
}

static inline struct aob_capture read_back(const struct sheet_file *file, const struct aob_capture_desc *desc)
{
    struct aob_capture capture;
    struct aob_error error = {{0}};
    sheet_write(path, file);
    if (!aob_capture_read(&capture, desc, &error))
        fail_msg("%s", error.text);
    assert_int_equal(capture.hits.width, W);
    assert_int_equal(capture.hits.height, H);
    return capture;
}

static inline void expect_refusal(const struct sheet_file *file, const struct aob_capture_desc *desc,
                                  const char *text)
{
    struct aob_capture capture;
    struct aob_error error = {{0}};
    sheet_write(path, file);
    assert_false(aob_capture_read(&capture, desc, &error));
    assert_contains(error.text, text);
    assert_contains(error.text, path);
    assert_null(strchr(error.text, '\n'));
}

/* `quantum`: relative error of a stored value; `slope`: by how much it is magnified. */
static inline void check_depth(const struct aob_capture *capture, const struct plane *p, double quantum,
                               double near)
{
    for (int i = 0; i < COUNT; i++) {
        double d = p->depth[i], got = (double)capture->hits.depth[i];
        double tolerance = d * quantum + (near > 0 ? d * d / near * 0x1p-24 : 0);
        if (i % W == 0 ? got != 0 : !(fabs(got - d) <= tolerance))
            fail_msg("pixel %d is %.9g, not %.9g within %g", i, got, d, tolerance);
    }
}

static inline double degrees_off(const struct aob_capture *capture, const struct plane *p, int i)
{
    const float *n = capture->hits.normal[i];
    struct aob_vec3 v = aob_vec((double)n[0], (double)n[1], (double)n[2]);
    return asin(fmin(aob_vec_length(aob_vec_cross(v, p->n)), 1)) * 180 / M_PI +
           (aob_vec_dot(v, p->n) > 0 ? 0 : 180);
}

static inline void check_normals(const struct aob_capture *capture, const struct plane *p, double degrees)
{
    for (int i = 0; i < COUNT; i++) {
        const float *n = capture->hits.normal[i];
        if (i % W == 0)
            assert_true(n[0] == 0 && n[1] == 0 && n[2] == 0);
        else if (!(degrees_off(capture, p, i) <= degrees))
            fail_msg("normal of pixel %d is %g degrees off", i, degrees_off(capture, p, i));
    }
}

/* The setup and the teardown of a group of tests. */
static inline int name_file(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "/tmp/aobudget-capture-%ld.exr", (long)getpid());
    return 0;
}

static inline int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}
#endif

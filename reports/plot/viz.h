/* Pictures and files drawn by VTK, behind plain C.
 *
 * Only the helper program aobudget-plot links this library: VTK brings some seventy shared libraries and its
 * own threads, which a program that measures must not load.
 *
 * Every function writes one whole file, or none: it is written beside `path` and renamed. It returns 0, or -1
 * with one line in `error`; no C++ exception leaves the library and nothing is printed. Texts are UTF-8; NULL
 * is as good as "". Text that does not fit is cut with an ellipsis. Images are width * height floats, row 0
 * at the top, and stay the caller's; a value that is not finite is drawn grey. Figures have a white
 * background and sizes of their own. Same input, same machine: same bytes.
 *
 * Maps, triptychs, splits, SVG and .vti need no OpenGL. The PNG of a chart and the height field open an EGL context
 * without a surface and fail with a line where there is none. Use one thread only. */
#ifndef AOB_REPORTS_PLOT_VIZ_H
#define AOB_REPORTS_PLOT_VIZ_H
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

enum { AOB_VIZ_ERROR_SIZE = 256 };

/* The error of ambient occlusion, or of another output: technique minus reference. Blue is too dark, red too bright; colours end at
 * +-limit, which must be positive. */
struct aob_viz_map {
    const char *title, *subtitle;
    int width, height;
    const float *error;
    double limit;
    const char *
        amount; /* NULL, or the unit of what is no error but an amount from 0 up: white to red. Flat maps only */
    const char
        *quantity; /* what the error is of, for the label of its colours; NULL: "AO". Not of a landscape */
};

/* As a flat map: every pixel becomes a square of whole pixels, as large as fits 1440 x 1080, at least 1:1. */
int aob_viz_map_png(const struct aob_viz_map *map, const char *path, char error[AOB_VIZ_ERROR_SIZE]);

/* As a landscape, averaged and smoothed, seen from the front left. */
int aob_viz_height_png(const struct aob_viz_map *map, const char *path, char error[AOB_VIZ_ERROR_SIZE]);

/* One channel is grey, 0 black to 1 white. Three are red, green and blue, linear: what a picture shows of them is their
 * product with an exposure, as sRGB. */
struct aob_viz_picture {
    const float *channels[3]; /* [1] NULL: grey */
    const float *depth; /* NULL, or where it is infinite there is no surface: drawn as what is not finite */
};

/* Technique, reference and error side by side. Images wider than 720 pixels are averaged down by a whole
 * factor, small ones drawn as squares of whole pixels. */
struct aob_viz_triptych {
    struct aob_viz_map map;
    struct aob_viz_picture technique;
    struct aob_viz_picture
        reference; /* no channel: the technique is drawn alone, and the map's error and limit are not read */
    double exposure; /* of both, where they are in colour; it must be positive then */
    const char *technique_name, *reference_name;
};
int aob_viz_triptych_png(const struct aob_viz_triptych *figure, const char *path,
                         char error[AOB_VIZ_ERROR_SIZE]);

/* Three parts of an error side by side, laid out and scaled as a triptych, all in the map's colours. The map's
 * error is not read. */
struct aob_viz_split {
    struct aob_viz_map map;
    const float *parts[3];
    const char *names[3];
};
int aob_viz_split_png(const struct aob_viz_split *figure, const char *path, char error[AOB_VIZ_ERROR_SIZE]);

enum aob_viz_style {
    AOB_VIZ_CURVE,  /* markers joined by lines, in the order of the points */
    AOB_VIZ_POINTS, /* markers only */
    AOB_VIZ_FRONT,  /* a grey staircase behind the rest: from each point level to the right, then down to the
                       next */
};

/* Points that are not finite, or not positive on a logarithmic axis, are left out. */
struct aob_viz_series {
    const char *name;
    enum aob_viz_style style;
    int colour; /* any number from 0: the same number is the same colour and marker in every chart */
    size_t count;
    const double *x, *y;
    const double *low, *high; /* error bars along y; NULL or not finite: none */
};
struct aob_viz_axis {
    const char *label;
    int logarithmic;
};
struct aob_viz_chart {
    const char *title, *subtitle;
    struct aob_viz_axis x, y;
    const struct aob_viz_series *series;
    size_t series_count;
};

/* 960 x 560; one drawing code, so both look the same. */
int aob_viz_chart_svg(const struct aob_viz_chart *chart, const char *path, char error[AOB_VIZ_ERROR_SIZE]);
int aob_viz_chart_png(const struct aob_viz_chart *chart, const char *path, char error[AOB_VIZ_ERROR_SIZE]);

/* Named float images as one VTK image file (.vti, zlib, appended raw): opens in ParaView. VTK's row 0 is at
 * the bottom, so the rows are turned over. */
struct aob_viz_field {
    const char *name;
    const float *pixels;
};
int aob_viz_vti(int width, int height, const struct aob_viz_field *fields, size_t count, const char *path,
                char error[AOB_VIZ_ERROR_SIZE]);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

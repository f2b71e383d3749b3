/* Who is put to the properties: a technique on a device, and how its frames are drawn. Programs are compiled once for all
 * frames of a subject. Threads: the one that opened the device. */
#ifndef AOB_STRESS_SUBJECT_H
#define AOB_STRESS_SUBJECT_H
#include "frame/programs.h"
#include "exhibit.h"
#include "scene/light.h"
#include "technique/option.h"
#include "technique/registry.h"

struct aob_subject {
    const struct aob_technique *technique;
    struct aob_gpu *gpu;
    struct aob_programs programs;
};
void aob_subject_init(struct aob_subject *subject, const struct aob_technique *technique,
                      struct aob_gpu *gpu);
void aob_subject_finish(struct aob_subject *subject);

/* Whether it has a parameter of that name. */
bool aob_subject_has(const struct aob_subject *subject, const char *param);

/* Its graph at its defaults, with these outputs wanted besides visibility (bits 1 << enum aob_output). NULL where it cannot be
 * built; free() it. */
struct aob_pass_graph *aob_subject_lay(const struct aob_subject *subject, uint32_t wanted);

/* Whether it gives an output besides visibility at its defaults. */
bool aob_subject_gives(const struct aob_subject *subject, enum aob_output which);

/* Whether its passes draw the scene's triangles at its defaults. */
bool aob_subject_draws_triangles(const struct aob_subject *subject);

/* What of an exhibit is drawn, and how. */
struct aob_shot {
    const struct aob_exhibit *exhibit;
    /* Scene units that the technique's parameter `radius` has, to which its other default lengths keep their proportion, so
     * that a scene of any scale is met alike. 0, or no such parameter: a metre is a scene unit. */
    double radius;
    /* "divisor=2 depth_encoding=r16f": run options and, where the technique has them, parameters in place of what they have
     * by default. A shared word for a parameter that it has not is left out, so that one text serves all techniques,
     * and any other is a mistake; a number out of its bounds is moved to the nearest bound. NULL: nothing. */
    const char *set;
    int runs;                      /* how often the frame is drawn, over itself, before it is read; 0: once */
    const struct aob_light *light; /* world space; NULL: uniform */
};

/* What a shot makes of the technique's values struct (4 * AOB_MAX_PARAM bytes) and of the options. False after a line if a
 * word of `set` is unknown, is no number or choice, or breaks its rule. */
bool aob_subject_values(const struct aob_subject *subject, const struct aob_shot *shot, void *values,
                        struct aob_options *options, struct aob_error *error);

/* Where outputs of a frame are read to, by enum aob_output: width x height pixels of aob_output_components floats; NULL: it is
 * not read. What is read the shot wants and the technique gives. */
struct aob_reading {
    float *of[AOB_OUTPUT_COUNT];
    size_t bytes; /* filled in: of the technique's own textures */
};

/* Draws one frame and reads it. False after a line; *unfit then says that it is no fault of the technique: the device lacks
 * something, or the values are refused by its check(). */
bool aob_subject_draw(struct aob_subject *subject, const struct aob_shot *shot, struct aob_reading *reading,
                      bool *unfit, struct aob_error *error);

/* Frames that follow each other, of views of one size. */
struct aob_film {
    const struct aob_shot *shot; /* how they are drawn; its exhibit is not looked at, nor is `runs` */
    const struct aob_exhibit *const *frames; /* count; their velocities are what the property made of them */
    size_t count;
    size_t
        anew; /* the frame that begins a sequence again, on what those before it left; 0: the first alone does */
};

/* Draws them in order; images[i] has width x height floats for the visibility of frame i, or is NULL. As aob_subject_draw. */
bool aob_subject_film(struct aob_subject *subject, const struct aob_film *film, float *const *images,
                      bool *unfit, struct aob_error *error);
#endif

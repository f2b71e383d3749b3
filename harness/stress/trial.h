/* One asking of one property: the exhibits and images that it makes, and the worst answer so far. Everything that it hands out
 * is its own and goes with aob_trial_clear or aob_trial_finish. What fails on the way is kept, and all later calls do
 * nothing, so that a property needs to look at NULL only. Threads: one at a time. */
#ifndef AOB_STRESS_TRIAL_H
#define AOB_STRESS_TRIAL_H
#include "subject.h"

struct aob_trial {
    struct aob_subject *subject; /* NULL: of the instruments */
    bool quick;                  /* fewer places, of the same kind */
    struct aob_error error;      /* what went wrong; empty: nothing */
    struct aob_error excuse;     /* why it cannot be asked here; empty: it can */
    bool broken;                 /* an image held what is no visibility */
    size_t asked;                /* answers that were taken */
    double worst;
    struct aob_sight { /* where it is worst; allocated */
        char where[200];
        char set[256];
        int width, height;
        float *image, *wanted; /* wanted: what it was compared with; or NULL */
    } sight;
    struct aob_trial_block { /* private */
        void *data;
        bool is_exhibit;
    } * blocks;
    size_t block_count, block_capacity;
};
void aob_trial_init(struct aob_trial *trial, struct aob_subject *subject, bool quick);
void aob_trial_clear(struct aob_trial *trial); /* what it made so far; the worst place stays */
void aob_trial_finish(struct aob_trial *trial);

/* An exhibit; NULL where that fails. The mesh is taken. */
struct aob_exhibit *aob_trial_exhibit(struct aob_trial *trial, const struct aob_exhibit_desc *desc);

/* width x height zeros, and as many zero vectors. */
float *aob_trial_image(struct aob_trial *trial, const struct aob_exhibit *exhibit);
float (*aob_trial_vectors(struct aob_trial *trial, const struct aob_exhibit *exhibit))[3];

/* Draws a shot; NULL where that fails or the device lacks what it takes. Every image is looked through: a value that is not
 * finite, or a surface outside 0..1, fails the property whatever its measure is. */
float *aob_trial_draw(struct aob_trial *trial, const struct aob_shot *shot);

/* Draws a shot that sets bent_normal=on, of a technique that gives bent normals. Their arrays are NULL where that fails.
 * What is looked through as well: a bent normal on a surface that is not finite or longer than 1 (by 1 %). */
struct aob_open {
    float *visibility; /* width * height */
    float (*bent)[3];  /* width * height, view space, as the technique wrote them */
};
struct aob_open aob_trial_draw_open(struct aob_trial *trial, const struct aob_shot *shot);

/* Draws a shot and reads all outputs that it wants, which the technique gives. All are NULL where that fails. What is looked
 * through as well: shares that are not finite and within 0..1, light that is not finite or is negative (score/effect.h). */
struct aob_reading aob_trial_read(struct aob_trial *trial, const struct aob_shot *shot);

/* Draws a film; images[i] is NULL where wanted[i] is false, and all are where it fails. They are looked through as those of
 * aob_trial_draw. `images` has room for as many as there are frames. */
bool aob_trial_film(struct aob_trial *trial, const struct aob_film *film, const bool *wanted, float **images);

/* The traced visibility of the exhibit (aob_exhibit_trace), which is looked through as well. */
float *aob_trial_trace(struct aob_trial *trial, const struct aob_exhibit *exhibit, double radius, int spp);

/* Takes an answer: how bad it is, 0 or more; NAN is the worst of all. `image` and `wanted` may be NULL; they have the
 * exhibit's size and are copied. The text says where: "radius 0.5, pixel (3, 4)". */
struct aob_seen {
    const struct aob_shot *shot;
    const float *image, *wanted;
};
void aob_trial_take(struct aob_trial *trial, double badness, const struct aob_seen *seen, const char *format,
                    ...) __attribute__((format(printf, 4, 5)));

/* The worse of two answers, where NAN is worse than all numbers; and an answer that is no less than 0, or NAN. fmax would take
 * the number, so that what could not be measured passed. */
double aob_worse(double a, double b);
double aob_over(double x);

/* It cannot be asked here, for this reason. */
void aob_trial_excuse(struct aob_trial *trial, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* How two images of an exhibit differ over its surfaces. Where `mask` is given, only pixels count that it holds true for. */
struct aob_difference {
    size_t count;      /* pixels that count; with none all else is NAN, so that nothing passes unseen */
    double most, rmse; /* largest absolute difference; root of the mean square */
    double mean;       /* of image - wanted */
    size_t at;         /* pixel of the largest */
};
struct aob_difference aob_difference_of(const struct aob_exhibit *exhibit, const float *image,
                                        const float *wanted, const bool *mask);
double aob_mean_of(const struct aob_exhibit *exhibit, const float *image, const bool *mask); /* NAN of none */
bool *aob_trial_mask(struct aob_trial *trial, const struct aob_exhibit *exhibit);            /* all false */
#endif

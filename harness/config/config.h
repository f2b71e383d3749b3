/* The config of a run, as text with positions: what the file says, in shape checked, in values not yet
 * (values of parameters are judged by the plan, which knows the tables). Lengths in the scene's units. Paths are seen from
 * the config's folder, so that a run is the same wherever it is started; of a link that is the link's folder, as with the
 * includes of C.
 *
 *   name: demo                       # letters, digits, - and _
 *   scenes:                          # a listed scene, with views (default: its first), or a mesh file
 *     - {name: corner, views: [front, far]}
 *     - {name: bunny, view: front}
 *     - {file: my.ply, eye: [0, 1, 4], target: [0, 1, 0], fov_deg: 60, shift: [0.5, 0],
 *        previous: {eye: [0.1, 1, 4], target: [0, 1, 0]}}    # a frame earlier; default: a still camera
 *     - {name: passing_box, motion: {frames: 16, eye: [0, 1, 4], target: [0, 1, 0]}}   # a sequence: the camera goes there,
 *                                    # or is still without eye and target; the last frame is scored
 *     - {name: cornell, light: sky}  # a listed light, or a probe: a lat-long picture, FILE.exr. Default: the scene's own
 *     - {capture: frame.exr, fov_deg: 60, depth: device_reversed, near: 0.1, far: inf}   # or name: capture:frame.exr
 *   resolutions: [480x270]
 *   backends: [vulkan, gl-egl]       # not needed if every technique has its own
 *   options: {guard_band: 64, fetch: [sampled, storage]}   # a list is an axis of the sweep
 *   techniques:
 *     - name: gtao
 *       module: build/gtao.so        # this file's gtao, whatever others there are
 *       backends: [gl-osmesa]        # in place of the config's
 *       params: {blur: 0}            # fixed values
 *       sweep:                       # axes, expanded as a product
 *         - {param: radius, from: 0.25, to: 2, log2: 1}    # steps of a factor 2^1; or step: 0.25
 *         - {param: slices, values: [1, 3]}
 *   measure: {time: true, error: true, images: true, seconds: 1.5, precision: 3%}   # seconds of timing a case, at most;
 *                                    # it ends early where the interval of its cost reaches so far to either side
 *     cache: [ps4, ./my.yaml]        # simulate the caches of these profiles (docs/cache.md)
 *   target: {radius: 1, weighting: cosine}   # what every image is compared with: the ray-traced visibility of this radius
 *                                    # (inf allowed) and weighting (cosine, uniform). One or a list; default: each radius
 *                                    # of the sweep, cosine
 *   budget: gtao-ps4                 # what a frame has for ambient occlusion (docs/budget.md); or ./mine.yaml
 *   effects: auto                    # `run` draws of gtao the set of effects that each view calls for (docs/design.md, Effects)
 *   reference: {spp: 256, thickness: inf}   # thickness: of the screen-space bound's surfaces; default: the radius
 */
#ifndef AOB_CONFIG_CONFIG_H
#define AOB_CONFIG_CONFIG_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/hash.h"
#include "convention.h"

struct aob_value { /* one scalar of the file */
    char *text;
    int line, column; /* from 1; 0: from the command line */
};
struct aob_axis { /* values that a parameter or option takes in turn */
    char *name;
    struct aob_value *values;
    size_t count;
    int line, column;
};
struct aob_pose {
    double eye[3], target[3]; /* scene units */
};
enum { AOB_CONFIG_MIN_FRAMES = 2, AOB_CONFIG_MAX_FRAMES = 128 };
struct aob_motion_choice {
    int frames;           /* 0: no sequence */
    bool camera;          /* it goes to `last` */
    struct aob_pose last; /* in the last frame */
};
struct aob_scene_choice {
    char *name, *file, *capture; /* one of the three; paths as the current folder sees them */
    char *given;                 /* a path as it was written, which records call the scene by; else NULL */
    char *view;                  /* listed view, or NULL */
    bool has_camera, ortho;
    double eye[3], target[3];
    double fov_deg, ortho_height; /* of a capture 0 until stated */
    double shift[2];              /* of the image, in its heights: x right, y up */
    double metres_per_unit;       /* of a mesh file or capture; 0 until stated */
    bool moves;
    struct aob_pose previous; /* if it moves: a frame earlier */
    struct aob_motion_choice motion;
    struct aob_convention convention; /* of a capture */
    char *light; /* a listed light, or a probe's path as the current folder sees it; NULL: the scene's */
    bool is_probe;
    double sh[27];      /* of a probe once it is loaded (probes.h): nine coefficients of R, G, B each */
    bool told;          /* of a capture: what there is to warn of has been said. No key of a file */
    unsigned materials; /* bits AOB_MATERIAL_BIT of what a capture has, once it is loaded (captures.h) */
    int width, height;  /* of a capture once it is loaded (captures.h), before the plan is made; */
    char *gbuffer;      /* its file in the cache, known as late, */
    char geometry[AOB_KEY_SIZE]; /* and what it was made of: the file and what is stated of it; */
    char digest[AOB_KEY_SIZE];   /* with the version of its reader */
    int line, column;
};
enum { AOB_CONFIG_MAX_VIEWS = 20000, AOB_CONFIG_MAX_CASES = 20000 };
/* Metres. Default lengths, .01 to 1 m, stay within the bounds of every parameter then. */
#define AOB_CONFIG_MIN_UNIT 1e-6
#define AOB_CONFIG_MAX_UNIT 1e4
struct aob_target { /* one question: which visibility is asked for */
    double radius;  /* scene units, a float's value; INFINITY allowed */
    bool uniform;   /* weighting of the directions; false: by the cosine */
};
enum { AOB_CONFIG_MAX_TARGETS = 64 }; /* each is a truth traced and a score of every case */
#define AOB_TARGET_MIN_RADIUS 1e-9
struct aob_backend_choice { /* names, not judged here */
    struct aob_value *names;
    size_t count, capacity;
};
struct aob_technique_choice {
    struct aob_value name;
    struct aob_value module; /* the file that it is in, as it was written; no text: by its name alone */
    char *file;              /* that path as the current folder sees it; or NULL */
    struct aob_backend_choice backends; /* none: the config's */
    struct aob_axis *axes;              /* fixed values are axes of one */
    size_t axis_count, axis_capacity;
};
struct aob_config {
    char *path;  /* as given; for messages */
    char *place; /* the file whose folder its paths are seen from: `path`, or what a copy is of */
    char *name;
    char *text; /* the file's bytes, and their hash */
    size_t size;
    char hash[AOB_KEY_SIZE];
    struct aob_scene_choice *scenes; /* one entry a view */
    size_t scene_count, scene_capacity;
    struct aob_size {
        int width, height;
        int line, column; /* as in a value */
    } * sizes;
    size_t size_count, size_capacity;
    struct aob_backend_choice backends; /* of the techniques without their own */
    struct aob_axis *options;
    size_t option_count, option_capacity;
    struct aob_technique_choice *techniques;
    size_t technique_count, technique_capacity;
    bool measure_time, measure_error, images;
    struct aob_value
        *profiles; /* of caches that are simulated, as written; not judged here. None: no cache is */
    size_t profile_count, profile_capacity;
    struct aob_value
        budget; /* of a frame, a name or path as written; not judged here. No text: there is none */
    struct aob_value effects; /* "auto"; no text: the cases are those that are written */
    double seconds;           /* of timing, a case */
    int processes;            /* to time in, at least; 0: as timing/processes.h says. No key of a file */
    double precision; /* share of a cost that its interval may reach to either side: timing ends there */
    int spp;          /* rays a pixel of the reference, even */
    double thickness; /* of what the depth shows, in the screen-space bound, scene units: 0 thin, INFINITY;
                         negative: each technique's radius */
    struct aob_target *targets; /* none: the plan takes them from the techniques' radii */
    size_t target_count, target_capacity;
};

/* A YAML file. On false the line is FILE:LINE:COLUMN: what, and what is allowed; the config is empty. */
bool aob_config_read(struct aob_config *config, const char *path, struct aob_error *error);
void aob_config_finish(struct aob_config *config);

/* A copy of the config `place`, whose paths are seen from where that lay. */
bool aob_config_read_copy(struct aob_config *config, const char *path, const char *place,
                          struct aob_error *error);

/* Takes out the profiles of caches and the budget, as if the config had none: for a comparison, which shows neither. */
void aob_config_leave_unshown(struct aob_config *config);

void aob_scene_choice_finish(struct aob_scene_choice *choice); /* of a scene that leaves its config */
void aob_technique_choice_finish(
    struct aob_technique_choice *choice); /* of an entry that leaves its config */

/* Put FILE:LINE:COLUMN before the error that is there; FILE alone for line 0, nothing for what is from the command line.
 * Always false. */
bool aob_config_fail_at(const struct aob_config *config, int line, int column, struct aob_error *error);

/* An entry's own backends, which stand in place of the config's, or those. */
const struct aob_backend_choice *aob_config_backends(const struct aob_config *config,
                                                     const struct aob_technique_choice *choice);

/* What lights a scene, as it was written: a name, or a probe's path, which has a slash or an ending. */
void aob_config_take_light(struct aob_scene_choice *choice, const char *text);

/* The defaults that a file starts from: nothing chosen, time, error and images measured, 1.5 s, 3 %, 256 spp. */
void aob_config_init(struct aob_config *config);

/* Put targets of one weighting ("cosine", "uniform") from "R" or "R,R": for the command line. */
bool aob_config_add_targets(struct aob_config *config, const char *radii, const char *weighting,
                            struct aob_error *error);

/* Reads "3%" as .03. */
#define AOB_CONFIG_MIN_PRECISION 1e-3
#define AOB_CONFIG_MAX_PRECISION 0.5
bool aob_config_parse_precision(const char *text, double *precision, struct aob_error *error);

/* Put one axis of one value; for the command line. */
void aob_axis_add(struct aob_axis **axes, size_t *count, size_t *capacity, const char *name,
                  const char *value);
#endif

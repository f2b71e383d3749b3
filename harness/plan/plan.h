/* The plan: the sweep expanded into cases, each judged against the parameter tables and given a stable key.
 * Needs no GPU, loads no scene and calls no module; files are read only for their digest. */
#ifndef AOB_PLAN_PLAN_H
#define AOB_PLAN_PLAN_H
#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "config/config.h"
#include "scene/light.h"
#include "scene/motion.h"
#include "scene/scene.h"
#include "technique/option.h"
#include "technique/registry.h"

struct aob_plan_scene {                /* one view of one scene */
    const struct aob_scene_info *info; /* NULL: a mesh file of the user's */
    char *name;                        /* "corner", one of the user's folder, or the file's path */
    char *file;                        /* mesh file to load, or NULL for a procedural scene */
    const char *gbuffer;               /* of a capture: its G-buffer in the cache, of this size; else NULL */
    unsigned materials;                /* of a capture: bits AOB_MATERIAL_BIT of what its file has */
    int width, height;
    char *
        view; /* "front", "camera", "camera-2", "capture" or "framed" (from the mesh's box, once it is loaded);
                   "front-16-frames" of a sequence */
    struct aob_camera camera; /* of what is scored: of a sequence its last frame's; unset while framed */
    struct aob_motion motion; /* of a sequence that ends with it; 0 frames: there is none */
    bool framed;
    bool loaded;                     /* by this run: its warnings are printed, its framing is known */
    bool checked;                    /* by this run: run/check.h */
    double metre;                    /* scene units that stand for a metre in default lengths (scene.h) */
    bool unit_stated;                /* how long its unit is was stated, or it is a listed scene */
    struct aob_light light;          /* that lights it, world space */
    bool light_stated;               /* by the config, in place of its own */
    const char *light_name;          /* a listed light's, or the probe's path */
    char light_digest[AOB_KEY_SIZE]; /* of the coefficients */
    char geometry[AOB_KEY_SIZE];     /* of the geometry's source, the same for every build of the program */
    char digest[AOB_KEY_SIZE];       /* of that and the version of what reads it */
    /* What the cases are compared with, at most AOB_CONFIG_MAX_TARGETS: the config's, or each radius of the scene's
     * cases in order; none if no error is measured. */
    struct aob_target *targets;
    size_t target_count, target_capacity;
};
struct aob_case {
    const struct aob_plan_scene *scene;
    int width, height;
    const char *backend; /* from aob_gpu_backends */
    const struct aob_technique_info *technique;
    double *params;                   /* one a row of the technique's table */
    double options[AOB_OPTION_COUNT]; /* one a row of aob_option_params */
    double reference_radius;          /* of its own target, scene units; 0 where there are no targets */
    size_t block;                     /* see aob_case_same_block */
    /* The hash of everything that decides the result, and of no wish (time, error, images, seconds). It is the same in
     * every run that asks the same question. */
    char key[AOB_KEY_SIZE];
};
struct aob_plan_profile { /* whose caches are simulated for each case: a wish, in no key */
    char *name;           /* of its file, without folder and ending; no two have one name */
    char *path;
    char digest[AOB_KEY_SIZE]; /* of what it says (profile/profile.h) */
    bool rates;                /* times are modelled, so operations are counted */
};
struct aob_variation { /* what has more than one value in a plan */
    bool scene, backend, size, options[AOB_OPTION_COUNT];
    bool (*params)[AOB_MAX_PARAM]; /* a row for each technique of the list */
    bool *builds; /* of each technique of the list: the plan has it and another of its name */
};
struct aob_plan {
    const struct aob_config *config; /* must outlive the plan, like the technique list */
    const struct aob_technique_list *techniques;
    struct aob_plan_scene *scenes;
    size_t scene_count;
    struct aob_case
        *cases; /* those of one block lie together, and in it builds of one; no two have the same key */
    size_t case_count, case_capacity;
    struct aob_plan_profile *profiles;
    size_t profile_count;
    struct aob_variation variation; /* of the whole plan: a filter changes no description */
    bool part; /* by `effects: auto`: views that the filter leaves out have no cases here */
};

enum { AOB_BLOCK_MAX = 6 }; /* cases of a block */

/* Captures must be loaded (captures.h). False: one line, FILE:LINE:COLUMN where the config has a position. */
bool aob_plan_create(struct aob_plan *plan, const struct aob_config *config,
                     const struct aob_technique_list *techniques, struct aob_error *error);
void aob_plan_finish(struct aob_plan *plan);

/* Keep the cases whose description holds `filter` (plain text). A space at its end matches the description's end too. */
void aob_plan_filter(struct aob_plan *plan, const char *filter);
bool aob_plan_matches(const struct aob_plan *plan, const struct aob_case *c, const char *filter);

/* A case of the plan by what tells it from the others, in a line for people: "corner/front gtao radius=0.5 slices=3
 * gl-egl". The technique always, with its module, "gtao (new.so)", where the plan has two builds of its name; scene, backend and size where they vary in the plan; parameters and options that vary,
 * then those that are not at their defaults. */
void aob_case_describe(const struct aob_plan *plan, const struct aob_case *c, struct aob_text *text);

/* Technique, all parameters, backend, size and all options, without scene and view: a part of the key. */
void aob_case_settings(const struct aob_case *c, struct aob_text *text);

/* What a history follows from one program or build to the next: technique by name, parameters, options, geometry, camera, motion, size,
 * backend and class of device (a word: "cpu", "integrated", "discrete"). Neither the program nor the question is in
 * it. */
void aob_case_series(const struct aob_case *c, const char *device_class, char key[AOB_KEY_SIZE]);

/* The technique's parameter `radius`, scene units; NAN without one. */
double aob_case_radius(const struct aob_case *c);

/* Which of its scene's targets is the case's own: the first of its radius; 0, the first, where there is none. */
size_t aob_case_own_target(const struct aob_case *c);

/* Whether a case looks as far as its technique's default says, which is a length in metres, and is compared with a target
 * that the config states, in units of the scene that are none, of another length. Then a line that says both. */
bool aob_case_mixes_units(const struct aob_case *c, const struct aob_config *config, struct aob_error *line);

/* The number of the scene's frame that a frame of its sequence shows: the same, or 0 of a scene in which nothing moves, whose
 * frames are all alike. */
int aob_plan_scene_frame(const struct aob_plan_scene *scene, int frame);

/* What options, size and scene cannot be together; one line then. */
bool aob_case_judge(const struct aob_case *c, struct aob_error *error);

/* Whether two cases may be timed in one block: same view, size, guard band, G-buffer, backend and threads. */
bool aob_case_same_block(const struct aob_case *a, const struct aob_case *b);

/* Whether two cases differ in the build of their technique only, or not at all. */
bool aob_case_same_but_build(const struct aob_case *a, const struct aob_case *b);

/* Option by its struct: packed from c->options. */
struct aob_options aob_case_options(const struct aob_case *c);

/* Whether an output is wanted that depends on the scene's light. */
bool aob_case_is_lit(const struct aob_case *c);

/* Seconds that a run of the plan takes on two cores with nothing in the cache, roughly: compiling, timing, references,
 * and for each target the score and the pictures of each case. A large image or a dear technique takes longer. */
double aob_plan_estimate_s(const struct aob_plan *plan);
#endif

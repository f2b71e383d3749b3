/* Techniques that look at all that is drawn in front of a surface, in the ways that the tests of their clearance draw them. */
#ifndef AOB_TESTS_WAYS_H
#define AOB_TESTS_WAYS_H
#include "thrifty.h"

struct way {
    const char *technique, *params;
};
enum { FEW = 3, ALL = 7 }; /* the first few are one of each technique */
static const struct way ways[ALL] = {
    {"volumetric_obscurance", "blur=0"},
    {"starcraft2_ssao", "blur=0"},
    {"crytek_ssao", "blur=0 hemisphere=on range=1000"},
    {"starcraft2_ssao", "blur=0 radii=one blocker=table no_occlusion=6 near_factor=2 depth_divisor=2"},
    {"crytek_ssao", "blur=0 hemisphere=on divisor=2 depth_divisor=2"},
    {"volumetric_obscurance", "blur=0 fine_radius=0.25 samples=12 amplification=off"},
    {"volumetric_obscurance", "blur=0 resolutions=one hemisphere=off divisor=1"},
};

static inline double share_with(const struct aob_rig *rig, struct aob_gpu *gpu, const struct way *way,
                                const char *more)
{
    char params[192];
    snprintf(params, sizeof params, "%s %s thrift=on", way->params, more);
    return share_of(rig, gpu, way->technique, params);
}

/* The largest difference that thrift makes in the first `count` ways. */
static inline double worst_of(const struct aob_rig *rig, struct aob_gpu *gpu, int count, const char *more)
{
    double worst = 0;
    char params[192];
    for (int i = 0; i < count; i++) {
        snprintf(params, sizeof params, "%s %s", ways[i].params, more);
        double found = difference(rig, gpu, ways[i].technique, params);
        if (found > 1 / 255.0)
            print_message("           %s %s: %.5f\n", ways[i].technique, params, found);
        worst = fmax(worst, found);
    }
    return worst;
}

static inline void check_worst(double worst)
{
    print_message("           a pixel differs by %.5f at most\n", worst);
    assert_true(worst <= 1 / 255.0);
}
#endif

#include "oracle_scene.h"
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include "base/memory.h"
#include "oracle.h"

/* Points are rebuilt from 32-bit depths, so they lie on a surface only within this slack. */
static const double slack = 1e-4;

static bool on_floor(struct aob_vec3 p, struct aob_vec3 n)
{
    return fabs(p.y) < slack && n.y > 0.999;
}

static double always_open(struct aob_vec3 p, struct aob_vec3 n, double r)
{
    (void)p, (void)n, (void)r;
    return 1;
}

/* The planes measure 40 m, so there is nothing to miss beyond r. */
static double corner(struct aob_vec3 p, struct aob_vec3 n, double r)
{
    (void)n;
    return fabs(p.x) + r <= 20 ? aob_oracle_corner(fmax(p.y, p.z), r) : NAN;
}

/* The part of what a wall of height h hides that lies farther than L to the side is less than d h^2/(6 L^3) of the
 * disc. */
static double wall(struct aob_vec3 p, struct aob_vec3 n, double r)
{
    return on_floor(p, n) && fabs(p.x) + fmin(r, 10) <= 20 ? aob_oracle_wall(p.z, 0.25, r) : NAN;
}

static double sheet(struct aob_vec3 p, struct aob_vec3 n, double r)
{
    return on_floor(p, n) && fabs(p.x) + r <= 20 && fabs(p.z) + r <= 20 ? aob_oracle_sheet(p.x, 0.2, r) : NAN;
}

static double room(struct aob_vec3 p, struct aob_vec3 n, double r)
{
    (void)p, (void)n;
    return r > 0.2 * sqrt(3) ? 0 : NAN;
}

static double disc(struct aob_vec3 p, struct aob_vec3 n, double r)
{
    return on_floor(p, n) ? aob_oracle_disc(hypot(p.x, p.z), 0.15, 0.15, r) : NAN;
}

static const struct aob_oracle oracles[] = {
    {"O1", "plane", "a plane is open: V = 1", always_open},
    {"O2", "corner", "planes that meet at 90 degrees: V = 1 - (acos t - t sqrt(1 - t^2))/pi, t = d/r",
     corner},
    {"O3", "wall",
     "the floor before a wall of height h: V = 1 - (S(t) - b S(t/b))/pi, t = d/r, b = d/sqrt(d^2 + h^2)",
     wall},
    {"O4", "sheet", "the floor below and before a half-plane sheet; V = 1 - (1 - (h/r)^2)/2 below its edge",
     sheet},
    {"O5", "sphere", "an isolated convex solid is open: V = 1", always_open},
    {"O6", "room", "inside a closed box, r beyond its diagonal: V = 0", room},
    {"O7", "disc", "the floor below a disc of radius a; V = 1 - a^2/(a^2 + h^2) on its axis", disc},
};

const struct aob_oracle *aob_oracle_find(const char *scene)
{
    for (size_t i = 0; scene && i < AOB_COUNT(oracles); i++)
        if (strcmp(oracles[i].scene, scene) == 0)
            return &oracles[i];
    return NULL;
}

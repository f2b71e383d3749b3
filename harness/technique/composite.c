#include "composite.h"
#include <math.h>
#include <stddef.h>
#include "base/half.h"
#include "composite/shaders.h"

enum { RINGS = 48, ANGLES = 12, PARTS = 3, LEVELS = AOB_COMPOSITE_SHAPES, COLUMNS = AOB_COMPOSITE_COSINES };

static const double pi = 3.14159265358979323846;

/* As reference/specular.c. */
static const double least_alpha = 1e-3;

static double smith_root(double cosine, double alpha)
{
    return sqrt(cosine * cosine + alpha * alpha * (1 - cosine * cosine));
}

struct view {
    double x, z, alpha, root;
    double sx, sz; /* the view direction, stretched */
};

/* Adds one half vector's share: a point of the disc that faces the stretched view, `a` across the x-z plane and `b` along it. */
static void add_half(const struct view *v, double a, double b, double area, struct aob_composite_lobe lobe[2])
{
    double fold = (1 + v->sz) / 2, along = (1 - fold) * sqrt(1 - a * a) + fold * b;
    double c = sqrt(fmax(1 - a * a - along * along, 0));
    /* `across` is +Y and `along` is stretched view times that. */
    double hx = v->alpha * (v->sx * c - v->sz * along), hy = v->alpha * a,
           hz = fmax(v->sz * c + v->sx * along, 0);
    double size = sqrt(hx * hx + hy * hy + hz * hz), cosine = (hx * v->x + hz * v->z) / size;
    double x = 2 * cosine * hx / size - v->x, z = 2 * cosine * hz / size - v->z;
    if (!(z > 0))
        return;
    double y = 2 * cosine * hy / size;
    double weight = area * (v->z + v->root) * z / (v->root * z + smith_root(z, v->alpha) * v->z);
    double shares[2] = {weight, weight * pow(fmax(1 - cosine, 0), 5)};
    for (int f = 0; f < 2; f++) {
        lobe[f].one += shares[f];
        lobe[f].z += shares[f] * z;
        lobe[f].zz += shares[f] * z * z;
        lobe[f].x += shares[f] * x / v->x;
        lobe[f].xz += shares[f] * x * z / v->x;
        lobe[f].xx_yy += shares[f] * (x * x - y * y) / (v->x * v->x);
    }
}

void aob_composite_moments(double roughness, double cosine, struct aob_composite_lobe lobe[2])
{
    /* Along the normal the quotients by the sine have limits. */
    double z = fmin(cosine, 0.9999), x = sqrt(1 - z * z), alpha = fmax(roughness * roughness, least_alpha);
    double size = hypot(alpha * x, z);
    const struct view view = {x, z, alpha, smith_root(z, alpha), alpha * x / size, z / size};
    lobe[0] = lobe[1] = (struct aob_composite_lobe){0};
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < ANGLES; k++) {
            /* Half of the disc: the other is its mirror image. The rings are dense at its rim, where half vectors turn fast. */
            double turn = (i + 0.5) / RINGS * pi / 2, r = sin(turn), angle = pi * ((k + 0.5) / ANGLES - 0.5);
            add_half(&view, r * cos(angle), r * sin(angle), sin(2 * turn) * sin(pi / 2 / RINGS) / ANGLES,
                     lobe);
        }
}

/* Three pictures of COLUMNS cosines x LEVELS roughnesses, one below the other, even in roughness and in the root of the cosine,
 * since a smooth surface's lobe changes fast where it is seen from the side: the first four moments with the factor 1, with
 * Fresnel's, and the last two of both. */
static void fill(const void *values, void *texels)
{
    uint16_t(*into)[LEVELS][COLUMNS][4] = texels;
    (void)values;
    for (int level = 0; level < LEVELS; level++)
        for (int column = 0; column < COLUMNS; column++) {
            struct aob_composite_lobe lobe[2];
            aob_composite_moments(level / (LEVELS - 1.0), pow(column / (COLUMNS - 1.0), 2), lobe);
            const double parts[PARTS][4] = {{lobe[0].one, lobe[0].z, lobe[0].x, lobe[0].zz},
                                            {lobe[1].one, lobe[1].z, lobe[1].x, lobe[1].zz},
                                            {lobe[0].xz, lobe[0].xx_yy, lobe[1].xz, lobe[1].xx_yy}};
            for (int p = 0; p < PARTS; p++)
                for (int c = 0; c < 4; c++)
                    into[p][level][column][c] = aob_half_from_float((float)parts[p][c]);
        }
}

void aob_composite_identify(struct aob_text *text)
{
    char hash[AOB_KEY_SIZE];
    aob_hash_text(aob_shaders_composite[0].text, hash);
    aob_text_add(text, "1 %s", hash);
}

static aob_tex given(const struct aob_pass_graph *graph, enum aob_output which)
{
    return (aob_tex){aob_graph_gives(graph, which) ? (uint32_t)graph->outputs[which] + 1 : 0};
}

/* Where both lie in one texture it is bound once. */
enum bent { BENT_NONE, BENT_OWN, BENT_PACKED };

static enum bent bent_of(const struct aob_pass_graph *graph)
{
    if (!aob_graph_gives(graph, AOB_OUT_BENT_NORMAL) || aob_graph_gives(graph, AOB_OUT_IRRADIANCE))
        return BENT_NONE;
    return aob_graph_output_component(graph, AOB_OUT_VISIBILITY) ? BENT_PACKED : BENT_OWN;
}

/* What the composite reads of a technique, in the order of its inputs. */
static void bind(const struct aob_pass_graph *graph, struct aob_pass *pass)
{
    static const struct {
        enum aob_output output;
        const char *name, *define;
    } rows[] = {{AOB_OUT_VISIBILITY_RGB, "bounced", "LIT_BOUNCES"},
                {AOB_OUT_SPECULAR, "open_lobe", "LIT_SPECULAR"},
                {AOB_OUT_IRRADIANCE, "irradiance", "LIT_IRRADIANCE"}};
    int in = 2, define = 2;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        aob_tex tex = given(graph, rows[i].output);
        pass->defines[define++] = (struct aob_define){rows[i].define, tex.id != 0};
        if (tex.id)
            pass->in[in++] = (struct aob_bind){.name = rows[i].name, .tex = tex};
    }
    if (bent_of(graph) == BENT_OWN)
        pass->in[in] = (struct aob_bind){.name = "bent", .tex = given(graph, AOB_OUT_BENT_NORMAL)};
}

bool aob_composite_lay(struct aob_pass_graph *graph)
{
    struct aob_graph *interface = &graph->interface;
    if (graph->outputs[AOB_OUT_VISIBILITY] < 0)
        return true; /* the graph is refused for that */
    graph->shaders = aob_shaders_composite;
    aob_tex image = aob_texture(interface, .name = "lit_image", .format = AOB_RGBA16F);
    aob_tex lobes = aob_texture(interface, .name = "lit_lobes", .format = AOB_RGBA16F, .width = COLUMNS,
                                .height = PARTS * LEVELS, .fill = fill);
    struct aob_pass pass = {
        .name = "lit_composite",
        .shader = "composite",
        .reads = AOB_DEPTH | AOB_NORMAL | AOB_MATERIAL | AOB_LIGHT,
        .defines = {{"LIT_PACKED", aob_graph_output_component(graph, AOB_OUT_VISIBILITY) == 3},
                    {"LIT_BENT", (int)bent_of(graph)}},
        .in = {{.name = "lobes", .tex = lobes, .filter = AOB_BILINEAR},
               {.name = "visible", .tex = given(graph, AOB_OUT_VISIBILITY)}},
        .out = {{.name = "lit", .tex = image}}};
    bind(graph, &pass);
    graph->outputs[AOB_OUT_LIT] = (int)image.id - 1;
    if (!aob_pass_add(interface, &pass))
        return false;
    struct aob_graph_pass *laid = &graph->passes[graph->pass_count - 1];
    for (int i = 0; i < laid->in_count; i++)
        laid->in[i].one_level = true; /* an output is its finest level */
    return true;
}

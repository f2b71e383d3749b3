/* What the lit composite lays behind a technique's passes, and the moments in its table against a quadrature of the lobe. */
#include "technique/composite.h"
#include <math.h>
#include <string.h>
#include "base/half.h"
#include "reference/specular_shot.h"
#include "trial.h"

enum { LIT = 1 << AOB_OUT_LIT, IRRADIANCE = 1 << AOB_OUT_IRRADIANCE, BENT = 1 << AOB_OUT_BENT_NORMAL };

/* Over the half vectors, whose density is what peaks: d(light) = 4 (h.v) d(half). */
static void sum_lobe(double alpha, double cosine, int rings, int angles, struct aob_composite_lobe sum[2])
{
    double sine = sqrt(1 - cosine * cosine);
    struct aob_vec3 n = {0, 0, 1}, v = {sine, 0, cosine};
    sum[0] = sum[1] = (struct aob_composite_lobe){0};
    for (int i = 0; i < rings; i++)
        for (int k = 0; k < angles; k++) {
            /* tan = alpha tan(u): dense where the lobe is. */
            double u = (i + 0.5) / rings * M_PI / 2, t = alpha * tan(u), theta = atan(t);
            double stretch = alpha / (cos(u) * cos(u)) / (1 + t * t), phi = (k + 0.5) / angles * 2 * M_PI;
            struct aob_vec3 h = {sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)};
            double hv = aob_vec_dot(h, v);
            struct aob_vec3 l = aob_vec_sub(aob_vec_scale(h, 2 * hv), v);
            if (!(hv > 0) || !(l.z > 0))
                continue;
            double area = stretch * (M_PI / 2 / rings) * (2 * M_PI / angles) * sin(theta);
            double share = ggx_lobe(n, v, l, alpha) * 4 * hv * area;
            for (int f = 0; f < 2; f++, share *= pow(1 - hv, 5)) {
                sum[f].one += share;
                sum[f].z += share * l.z;
                sum[f].zz += share * l.z * l.z;
                sum[f].x += share * l.x / sine;
                sum[f].xz += share * l.x * l.z / sine;
                sum[f].xx_yy += share * (l.x * l.x - l.y * l.y) / (sine * sine);
            }
        }
}

/* As the light is multiplied with them. */
static double difference(const struct aob_composite_lobe *a, const struct aob_composite_lobe *b,
                         double cosine)
{
    double sine = sqrt(1 - cosine * cosine);
    const double off[] = {a->one - b->one,        a->z - b->z,
                          a->zz - b->zz,          (a->x - b->x) * sine,
                          (a->xz - b->xz) * sine, (a->xx_yy - b->xx_yy) * sine * sine};
    double worst = 0;
    for (size_t i = 0; i < AOB_COUNT(off); i++)
        worst = fmax(worst, fabs(off[i]));
    return worst;
}

static void test_moments(void **state)
{
    static const double roughnesses[] = {0.15, 0.3, 0.5, 0.75, 1},
                        cosines[] = {0.05, 0.2, 0.5, 0.8, 0.97, 0.995};
    double worst = 0;
    (void)state;
    for (size_t r = 0; r < AOB_COUNT(roughnesses); r++)
        for (size_t c = 0; c < AOB_COUNT(cosines); c++) {
            struct aob_composite_lobe table[2], sum[2];
            aob_composite_moments(roughnesses[r], cosines[c], table);
            sum_lobe(roughnesses[r] * roughnesses[r], cosines[c], 1500, 360, sum);
            for (int f = 0; f < 2; f++)
                worst = fmax(worst, difference(&table[f], &sum[f], cosines[c]));
        }
    print_message("           moments off by %.5f at most\n", worst);
    assert_true(worst < 0.004);
}

/* A mirror has one direction, and all of the light from there. */
static void test_mirror(void **state)
{
    (void)state;
    for (double cosine = 0.1; cosine < 1; cosine += 0.2) {
        struct aob_composite_lobe lobe[2];
        double edge = pow(1 - cosine, 5);
        aob_composite_moments(0, cosine, lobe);
        const double wanted[6] = {1, cosine, cosine * cosine, -1, -cosine, 1};
        const double *whole = (const double *)&lobe[0], *fresnel = (const double *)&lobe[1];
        for (int i = 0; i < 6; i++) {
            assert_near(whole[i], wanted[i], 2e-3);
            assert_near(fresnel[i], edge * wanted[i], 2e-3);
        }
    }
}

enum { COLUMNS = AOB_COMPOSITE_COSINES, LEVELS = AOB_COMPOSITE_SHAPES };
static uint16_t texels[3][LEVELS][COLUMNS][4];

/* What a bilinear look-up in the middle of four nodes gives. */
static double between(int part, int level, int column, int c)
{
    double mean = 0;
    for (int k = 0; k < 4; k++)
        mean += 0.25 * (double)aob_half_to_float(texels[part][level + k / 2][column + k % 2][c]);
    return mean;
}

static double table_error(int level, int column, double cosine)
{
    struct aob_composite_lobe lobe[2], looked[2];
    double roughness = (level + 0.5) / (LEVELS - 1);
    sum_lobe(fmax(roughness * roughness, 1e-3), cosine, 400, 96, lobe);
    for (int f = 0; f < 2; f++)
        looked[f] = (struct aob_composite_lobe){
            between(f, level, column, 0),         between(f, level, column, 1),
            between(f, level, column, 3),         between(f, level, column, 2),
            between(2, level, column, 2 * f + 0), between(2, level, column, 2 * f + 1)};
    return fmax(difference(&looked[0], &lobe[0], cosine), difference(&looked[1], &lobe[1], cosine));
}

/* Between the table's nodes, in its half floats. A lobe loses what the surface masks where the cosine is about alpha, however small
 * both are: where a mirror is seen within 3 degrees of its surface, that happens within a cell. */
static void test_table(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    double worst = 0, edge = 0;
    (void)state;
    assert_true(try_build_wanted(&graph, build_chain, LIT, &error));
    for (int t = 0; t < graph.texture_count; t++)
        if (graph.textures[t].fill)
            graph.textures[t].fill(NULL, texels);
    for (int level = 0; level + 1 < LEVELS; level++)
        for (int column = 0; column + 1 < COLUMNS; column++) {
            double cosine = pow((column + 0.5) / (COLUMNS - 1), 2), off = table_error(level, column, cosine);
            double *most = cosine < 0.05 ? &edge : &worst;
            *most = fmax(*most, off);
        }
    print_message("           the table is off by %.5f between its nodes, %.5f at the edge\n", worst, edge);
    assert_true(worst < 0.01 && edge < 0.05);
}

static const struct aob_graph_pass *composite_of(const struct aob_pass_graph *graph)
{
    const struct aob_graph_pass *last = &graph->passes[graph->pass_count - 1];
    return strcmp(last->name, "lit_composite") == 0 ? last : NULL;
}

static int define_of(const struct aob_graph_pass *pass, const char *name)
{
    for (int d = 0; d < pass->define_count; d++)
        if (strcmp(pass->defines[d].name, name) == 0)
            return pass->defines[d].value;
    fail_msg("no define %s", name);
    return -1;
}

static bool build_packed(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex open = aob_texture(g, .name = "open", .format = AOB_RGBA16F),
            light = aob_texture(g, .name = "light", .format = AOB_RGBA16F);
    return aob_pass(g, .name = "first", .shader = "one",
                    .out = {{.name = "o", .tex = open}, {.name = "l", .tex = light}}) &&
           aob_output(g, AOB_OUT_VISIBILITY, open) && aob_output(g, AOB_OUT_BENT_NORMAL, open) &&
           aob_output(g, AOB_OUT_IRRADIANCE, light);
}

static bool build_own(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_BENT_NORMAL, AOB_RGBA16F);
}

static void check_layout(bool (*build)(struct aob_graph *, const void *), unsigned wanted, int inputs,
                         int bent, int irradiance)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    assert_true(try_build_wanted(&graph, build, wanted | LIT, &error));
    const struct aob_graph_pass *pass = composite_of(&graph);
    assert_non_null(pass);
    assert_true(pass->live && aob_graph_gives(&graph, AOB_OUT_LIT));
    assert_int_equal(pass->in_count, inputs);
    assert_int_equal(define_of(pass, "LIT_BENT"), bent);
    assert_int_equal(define_of(pass, "LIT_IRRADIANCE"), irradiance);
}

/* It reads what is wanted and given, and nothing else. */
static void test_layout(void **state)
{
    (void)state;
    check_layout(build_chain, 0, 2, 0, 0);
    check_layout(build_chain, BENT | IRRADIANCE, 2, 0, 0); /* it gives none */
    check_layout(build_packed, 0, 2, 0, 0);
    check_layout(build_packed, BENT, 2, 2, 0);
    check_layout(build_packed, BENT | IRRADIANCE, 3, 0, 1);
    check_layout(build_own, BENT, 3, 1, 0);
}

/* An unwanted composite leaves the graph as it is. */
static void test_unwanted(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    assert_true(try_build_wanted(&graph, build_chain, 0, &error));
    assert_null(composite_of(&graph));
    assert_int_equal(graph.pass_count, 3);
    assert_int_equal(graph.texture_count, 3);
    assert_false(aob_graph_gives(&graph, AOB_OUT_LIT));
}

/* Three levels of a visibility, of which the image is the finest. */
static bool build_levels(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex open = aob_texture(g, .name = "open", .format = AOB_R16F, .levels = 3);
    for (uint32_t l = 0; l < 3; l++) {
        static const char *const names[] = {"first", "second", "third"};
        aob_pass(g, .name = names[l], .shader = "one", .out = {{.name = "o", .tex = open, .level = l}});
    }
    return aob_output(g, AOB_OUT_VISIBILITY, open);
}

/* Passes that nothing wanted reads stay dead beside the composite. */
static void test_levels(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    assert_true(try_build_wanted(&graph, build_levels, LIT, &error));
    assert_true(graph.passes[0].live && !graph.passes[1].live && !graph.passes[2].live);
    assert_true(composite_of(&graph)->live);
    assert_int_equal(composite_of(&graph)->in[1].level_count, 1);
}

static bool asked_for_lit;
static bool build_asks(struct aob_graph *g, const void *values)
{
    asked_for_lit = aob_wants(g, AOB_OUT_LIT);
    return build_chain(g, values);
}

/* A module that knew it could draw otherwise where it is looked at. */
static void test_hidden(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    asked_for_lit = true;
    assert_true(try_build_wanted(&graph, build_asks, LIT, &error));
    assert_false(asked_for_lit);
}

static bool build_gives_lit(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_LIT, AOB_RGBA16F);
}

static bool build_taken_name(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = aob_texture(g, .name = "lit_image");
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static bool build_full(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex last = {0};
    for (int i = 0; i < AOB_MAX_PASS; i++) {
        char name[16];
        snprintf(name, sizeof name, "t%d", i);
        last = aob_texture(g, .name = name);
        aob_pass(g, .name = name, .shader = "one", .out = OUT(last));
    }
    return aob_output(g, AOB_OUT_VISIBILITY, last);
}

static bool build_nothing(struct aob_graph *g, const void *values)
{
    (void)g;
    (void)values;
    return true;
}

static void test_refused(void **state)
{
    static const struct {
        bool (*build)(struct aob_graph *, const void *);
        const char *says;
    } rows[] = {{build_gives_lit, "output lit is composed by the harness: no technique gives it"},
                {build_taken_name, "two textures are named 'lit_image'"},
                {build_full, "more than 32 passes"},
                {build_nothing, "the graph gives no output visibility"}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_pass_graph graph;
        struct aob_error error;
        assert_false(try_build_wanted(&graph, rows[i].build, LIT, &error));
        assert_contains(error.text, rows[i].says);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moments), cmocka_unit_test(test_mirror),   cmocka_unit_test(test_table),
        cmocka_unit_test(test_layout),  cmocka_unit_test(test_unwanted), cmocka_unit_test(test_refused),
        cmocka_unit_test(test_levels),  cmocka_unit_test(test_hidden),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What the nodes of glTF 2.0 files say is what is seen: places, deformations, instances, scenes. */
#include "gltf_document.h"
#include "check.h"

static void mirrors_turn_the_winding(void **state)
{
    static const struct {
        const char *nodes;
        struct aob_vec3 low, high;
        double volume;
    } cases[] = {
        {"{'mesh': 0, 'scale': [-1, 1, 1]}", {-1, 0, 0}, {0, 2, 3}, 6},
        {"{'mesh': 0, 'scale': [-2, -1, -1]}", {-2, -2, -3}, {0, 0, 0}, 12},
        {"{'mesh': 0, 'scale': [-1, -1, 1]}", {-1, -2, 0}, {0, 0, 3}, 6},
        {"{'mesh': 0, 'matrix': [0,1,0,0, 1,0,0,0, 0,0,1,0, 5,0,0,1]}", {5, 0, 0}, {7, 1, 3}, 6},
        {"{'children': [1], 'scale': [1, 1, -1]}, {'mesh': 0, 'scale': [1, -1, 1]}",
         {0, -2, -3},
         {1, 0, 0},
         6},
        {"{'children': [1], 'scale': [1, 1, -1]}, {'mesh': 0, 'translation': [0, 0, 1]}",
         {0, 0, -4},
         {1, 2, -1},
         6},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        char rest[400];
        snprintf(rest, sizeof rest, "'scenes': [{'nodes': [0]}], 'nodes': [%s], " MESH, cases[i].nodes);
        load_box(&mesh, rest);
        assert_box(&mesh, 12, cases[i].low, cases[i].high, 1e-12);
        assert_near(mesh_volume(&mesh), cases[i].volume, 1e-12);
        assert_normals_outside(&mesh);
        aob_mesh_finish(&mesh);
    }
}

/* Normals that the file has are mirrored with the faces; under an uneven scale they stay normal to them. */
static void normals_follow_their_nodes(void **state)
{
    static const float corners[3][3] = {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}; /* in the plane x = z */
    static const float normals[3][3] = {{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}};
    static const char *const nodes[] = {"", ", 'scale': [-1, 1, 1]", ", 'scale': [3, 1, 1]",
                                        ", 'scale': [3, 1, -2], 'rotation': [0.6, 0, 0, 0.8]"};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(nodes); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        document_put(&d, corners, 12, 3, F32, "VEC3", "");
        document_put(&d, normals, 12, 3, F32, "VEC3", "");
        add_scene(&d, nodes[i], "'attributes': {'POSITION': 0, 'NORMAL': 1}", "");
        document_load(&d, &mesh);
        const uint32_t *t = mesh.triangles[0];
        struct aob_vec3 a = mesh.positions[t[0]];
        struct aob_vec3 n = aob_vec_normalize(
            aob_vec_cross(aob_vec_sub(mesh.positions[t[1]], a), aob_vec_sub(mesh.positions[t[2]], a)));
        for (int k = 0; k < 3; k++)
            assert_true(aob_vec_length(aob_vec_sub(mesh.normals[t[k]], n)) < 1e-6);
        aob_mesh_finish(&mesh);
    }
}

/* Weights of the mesh, and of the node in their place. */
static void morph_targets_are_applied(void **state)
{
    static const struct {
        const char *node, *mesh;
        double up;
    } cases[] = {{"", ", 'weights': [1, 0]", 10},
                 {", 'weights': [0.5, 0]", ", 'weights': [1, 0]", 5},
                 {", 'weights': [0.25, 2]", "", 8.5},
                 {"", "", 0}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        float up[2][8][3] = {{{0}}};
        for (int k = 0; k < 8; k++) {
            up[0][k][1] = 10;
            up[1][k][1] = 3;
        }
        document_put_box(&d);
        document_put(&d, up[0], 12, 8, F32, "VEC3", "");
        document_put(&d, up[1], 12, 8, F32, "VEC3", "");
        aob_text_add(&d.rest,
                     "'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0%s}], 'meshes': [{'primitives': [{" BOX
                     ", 'targets': [{'POSITION': 2}, {'POSITION': 3}]}]%s}]",
                     cases[i].node, cases[i].mesh);
        document_load(&d, &mesh);
        assert_box(&mesh, 12, aob_vec(0, cases[i].up, 0), aob_vec(1, 2 + cases[i].up, 3), 1e-12);
        aob_mesh_finish(&mesh);
    }
}

/* The first joint is bound at y = 5 and stands at 7 and what `joints` adds to it. Vertices have the weights of the
 * two. */
static void load_skin(struct aob_mesh *mesh, const float weights[2], const char *node, const char *joints)
{
    struct document d = {0};
    uint8_t joint[8][4] = {{0}};
    float weight[8][4] = {{0}}, bound[2][16] = {{0}};
    for (int k = 0; k < 8; k++) {
        joint[k][1] = 1;
        memcpy(weight[k], weights, 2 * sizeof(float));
    }
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < 4; k++)
            bound[j][5 * k] = 1;
    bound[0][13] = -5; /* bound at y = 5 */
    document_put_box(&d);
    document_put(&d, joint, 4, 8, U8, "VEC4", "");
    document_put(&d, weight, 16, 8, F32, "VEC4", "");
    document_put(&d, bound, 64, 2, F32, "MAT4", "");
    aob_text_add(
        &d.rest,
        "'scenes': [{'nodes': [0, 1]}], 'nodes': [{'mesh': 0, 'skin': 0%s}, {'translation': [0, 7, 0], "
        "'children': [2]}, %s], 'skins': [{'joints': [2, 3], 'inverseBindMatrices': 4}], 'meshes': "
        "[{'primitives': [{'attributes': {'POSITION': 0, 'JOINTS_0': 2, 'WEIGHTS_0': 3}, 'indices': 1}]}]",
        node, joints);
    document_load(&d, mesh);
}

static void skins_are_applied(void **state)
{
    static const char joints[] = "{'translation': [0, 8, 0]}, {'rotation': [0, 0, 1, 0]}";
    static const char still[] = "{'translation': [0, 8, 0]}, {}";
    static const char turned[] = "{'translation': [0, 8, 0], 'rotation': [0, 0, 1, 0]}, {}";
    static const char mirror[] = "{'translation': [0, 8, 0], 'scale': [-1, 1, 1]}, {}";
    static const float first[2] = {1, 0}, second[2] = {0, 1}, both[2] = {0.5f, 0.5f}, twice[2] = {2, 2},
                       none[2] = {0, 0};
    static const struct {
        const float *weights;
        const char *node, *joints;
        struct aob_vec3 low, high;
        double volume;
    } cases[] = {{first, "", joints, {0, 10, 0}, {1, 12, 3}, 6},
                 {first, ", 'translation': [100, 0, 0]", joints, {0, 10, 0}, {1, 12, 3}, 6},
                 {second, "", joints, {-1, -2, 0}, {0, 0, 3}, 6},
                 {both, "", still, {0, 5, 0}, {1, 7, 3}, 6},
                 {twice, "", still, {0, 5, 0}, {1, 7, 3}, 6},
                 {none, "", joints, {0, 10, 0}, {1, 12, 3}, 6},
                 {first, "", mirror, {-1, 10, 0}, {0, 12, 3}, 6},
                 {first, "", turned, {-1, 18, 0}, {0, 20, 3}, 6}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        load_skin(&mesh, cases[i].weights, cases[i].node, cases[i].joints);
        assert_box(&mesh, 12, cases[i].low, cases[i].high, 1e-9);
        assert_near(mesh_volume(&mesh), cases[i].volume, 1e-9);
        aob_mesh_finish(&mesh);
    }
}

static void instances_are_placed(void **state)
{
    static const float moves[3][3] = {{0, 0, 0}, {20, 0, 0}, {0, 0, -40}};
    static const float scales[3][3] = {{1, 1, 1}, {2, 2, 2}, {-1, 1, 1}};
    static const int8_t turns[3][4] = {{0, 0, 0, 127}, {0, 127, 0, 0}, {0, 0, 0, 127}};
    (void)state;
    struct document d = {0};
    struct aob_mesh mesh;
    document_put_box(&d);
    document_put(&d, moves, 12, 3, F32, "VEC3", "");
    document_put(&d, scales, 12, 3, F32, "VEC3", "");
    document_put(&d, turns, 4, 3, I8, "VEC4", ", 'normalized': true");
    add_scene(&d,
              ", 'translation': [0, 100, 0], 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': "
              "{'TRANSLATION': 2, 'SCALE': 3, 'ROTATION': 4}}}",
              BOX, ", 'extensionsRequired': ['EXT_mesh_gpu_instancing']");
    document_load(&d, &mesh);
    /* The second is turned by 180 degrees about y, so it lies at 18..20, -6..0. */
    assert_box(&mesh, 36, aob_vec(-1, 100, -40), aob_vec(20, 104, 3), 1e-9);
    assert_near(mesh_volume(&mesh), 6 + 48 + 6, 1e-9);
    aob_mesh_finish(&mesh);
}

static void the_scene_says_what_is_seen(void **state)
{
    static const struct {
        const char *rest;
        size_t triangles;
    } cases[] = {
        {"'scene': 1, 'scenes': [{'nodes': [0, 1]}, {'nodes': [1]}], 'nodes': [{'mesh': 0}, {'mesh': 0}], ",
         12},
        {"'scenes': [{'nodes': [0, 1]}, {'nodes': [1]}], 'nodes': [{'mesh': 0}, {'mesh': 0}], ", 24},
        {"'nodes': [{'mesh': 0}, {'mesh': 0, 'children': [2]}, {'mesh': 0}], ", 36},
        {"'nodes': [{'mesh': 0}, {'mesh': 0, 'children': [2], 'extensions': {'KHR_node_visibility': "
         "{'visible': false}}}, {'mesh': 0}], ",
         12}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        char rest[400];
        snprintf(rest, sizeof rest, "%s" MESH, cases[i].rest);
        load_box(&mesh, rest);
        assert_int_equal(mesh.triangle_count, cases[i].triangles);
        aob_mesh_finish(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mirrors_turn_the_winding),  cmocka_unit_test(normals_follow_their_nodes),
        cmocka_unit_test(morph_targets_are_applied), cmocka_unit_test(skins_are_applied),
        cmocka_unit_test(instances_are_placed),      cmocka_unit_test(the_scene_says_what_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

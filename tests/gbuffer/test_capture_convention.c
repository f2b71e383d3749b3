/* Conventions of depth and normals: the same plane is read from each. */
#include "capture_plane.h"

static void test_depth_conventions(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    for (int k = 0; k < 6; k++) {
        struct aob_capture_desc desc = plain();
        for (int i = 0; i < COUNT; i++) {
            double d = p->depth[i], device = FAR / (FAR - NEAR) - FAR * NEAR / (FAR - NEAR) / d;
            double values[6] = {d, d * p->slant[i], device, 1 - NEAR / d, 1 - device, NEAR / d};
            const double sky[6] = {-1, INFINITY, 1, 1, 0, 0};
            p->z[i] = (float)(i % W ? values[k] : sky[k]);
        }
        desc.convention.depth = k < 2 ? (unsigned)k : k < 4 ? AOB_DEPTH_DEVICE : AOB_DEPTH_DEVICE_REVERSED;
        desc.convention.near = k < 2 ? 0 : NEAR;
        desc.convention.far = k < 2 ? 0 : k % 2 ? INFINITY : FAR;
        struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
        struct aob_capture capture = read_back(&file, &desc);
        check_depth(&capture, p, 0x1p-22, k < 2 ? 0 : NEAR);
        aob_capture_finish(&capture);
    }
    free(p);
}

static void test_orthographic_device_depth(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    for (int i = 0; i < COUNT; i++)
        p->z[i] = (float)(i % W ? 1 - (p->depth[i] - NEAR) / (FAR - NEAR) : 0);
    struct aob_capture_desc desc = {.file = path, .ortho_height = 3};
    desc.convention = (struct aob_convention){.depth = AOB_DEPTH_DEVICE_REVERSED, .near = NEAR, .far = FAR};
    struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    struct aob_capture capture = read_back(&file, &desc);
    for (int i = 0; i < COUNT; i++)
        assert_near(capture.hits.depth[i], (i % W ? p->depth[i] : 0), (FAR - NEAR) * 0x1p-23);
    aob_capture_finish(&capture);
    desc.convention.far = INFINITY;
    expect_refusal(&file, &desc, "finite far");
    free(p);
}

static void test_derived_normals(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    set_z(p, 0);
    struct aob_capture_desc desc = plain();
    struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    struct aob_capture capture = read_back(&file, &desc);
    check_normals(&capture, p, 0.1);
    assert_int_equal(capture.derived, (W - 1) * H);
    aob_capture_finish(&capture);

    /* A step: on both sides of it the nearer neighbour is the one of the same plane. */
    for (int i = 0; i < COUNT; i++)
        if (i % W > 20)
            p->z[i] *= 1.5f;
    file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    capture = read_back(&file, &desc);
    check_normals(&capture, p, 0.1);
    aob_capture_finish(&capture);
    free(p);
}

/* In the world: right, up and back of a camera, which is told by eye, target and up. */
static const struct space {
    struct aob_vec3 eye, right, up, back;
    double world_up[3];
    bool left_handed, world;
} spaces[] = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, true, false},
    {{0, -5, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 1}, false, true},
    {{-5, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, 1}, true, true},
    {{0, 0, -5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, true, true},
    {{5, 0, 0}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, false, true},
};

static void turn_normals(struct plane *p, const struct space *space, int turned)
{
    struct aob_vec3 w =
        aob_vec_add(aob_vec_add(aob_vec_scale(space->right, p->n.x), aob_vec_scale(space->up, p->n.y)),
                    aob_vec_scale(space->back, p->n.z));
    w = aob_vec_scale(w, turned ? -0.95 : 0.95); /* away from the camera, and not quite of unit length */
    for (int i = 0; i < COUNT; i++) {
        p->normal[0][i] = (float)w.x;
        p->normal[1][i] = (float)w.y;
        p->normal[2][i] = (float)w.z;
    }
}

static void test_normal_spaces(void **state)
{
    static const char *const names[3] = {"N.X", "N.Y", "N.Z"};
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    for (size_t k = 0; k < AOB_COUNT(spaces); k++)
        for (int turned = 0; turned < 2; turned++) {
            make_plane(p);
            set_z(p, INFINITY);
            turn_normals(p, &spaces[k], turned);
            struct aob_capture_desc desc = plain();
            desc.has_camera = spaces[k].world;
            desc.eye = spaces[k].eye;
            desc.convention.normals = spaces[k].world ? AOB_NORMALS_WORLD : AOB_NORMALS_VIEW;
            desc.convention.left_handed = spaces[k].left_handed;
            memcpy(desc.convention.up, spaces[k].world_up, sizeof desc.convention.up);
            struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
            add_normals(&file.sheets[0], p, names);
            struct aob_capture capture = read_back(&file, &desc);
            check_normals(&capture, p, 1e-4);
            aob_capture_finish(&capture);
            desc.has_camera = false;
            if (spaces[k].world)
                expect_refusal(&file, &desc, "state eye and target");
        }
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_depth_conventions),
        cmocka_unit_test(test_orthographic_device_depth),
        cmocka_unit_test(test_derived_normals),
        cmocka_unit_test(test_normal_spaces),
    };
    return cmocka_run_group_tests(tests, name_file, remove_file);
}

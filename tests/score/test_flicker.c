/* Flicker of images with a closed form, and the same points found again in a scene that moves. */
#include "score/flicker.h"
#include <stdlib.h>
#include "base/memory.h"
#include "check.h"
#include "rig.h"

enum { W = 24, H = 16, GUARD = 3, WIDE = W + 2 * GUARD, HIGH = H + 2 * GUARD, PIXELS = W * H };

/* A wall at depth 2 before a camera that looks straight at it. */
struct wall {
    struct aob_gbuffer gbuffer;
    float image[PIXELS], truth[PIXELS], se[PIXELS];
};

static void make_wall(struct wall *wall, float depth)
{
    const struct aob_camera camera = {.eye = {0, 0, 2}, .fov_deg = 60};
    *wall =
        (struct wall){.gbuffer = {.projection = aob_camera_projection(&camera, W, H, GUARD), .guard = GUARD}};
    wall->gbuffer.depth = AOB_NEW_ARRAY(float, WIDE *HIGH);
    wall->gbuffer.normal = AOB_NEW_ARRAY(float, 4 * WIDE * HIGH);
    for (size_t i = 0; i < WIDE * HIGH; i++) {
        wall->gbuffer.depth[i] = depth;
        wall->gbuffer.normal[4 * i + 2] = 1;
    }
    for (size_t i = 0; i < PIXELS; i++)
        wall->image[i] = wall->truth[i] = 0.5f;
}

/* Everything was `across` pixels further left and had the depth `then`. */
static void set_velocity(struct wall *wall, float across, float then)
{
    wall->gbuffer.velocity = AOB_NEW_ARRAY(float, 3 * WIDE * HIGH);
    for (size_t i = 0; i < WIDE * HIGH; i++) {
        wall->gbuffer.velocity[3 * i] = across;
        wall->gbuffer.velocity[3 * i + 2] = then;
    }
}

static struct aob_flicker compare(const struct wall *now, const struct wall *before, bool noise)
{
    struct aob_flicker sum = {0};
    const struct aob_flicker_desc desc = {
        .now = {&now->gbuffer, now->image, now->truth, noise ? now->se : NULL},
        .before = {&before->gbuffer, before->image, before->truth, noise ? before->se : NULL},
        .then = aob_affine_identity()};
    aob_flicker_add(&sum, &desc);
    return sum;
}

static void finish(struct wall *now, struct wall *before)
{
    aob_gbuffer_finish(&now->gbuffer);
    aob_gbuffer_finish(&before->gbuffer);
}

/* An error that is there all the time is none; one that changes its sign by 2a is 2a. */
static void what_changes_at_a_place_flickers(void **state)
{
    (void)state;
    struct wall now, before;
    make_wall(&now, 2);
    make_wall(&before, 2);
    for (int i = 0; i < PIXELS; i++)
        now.image[i] = before.image[i] = 0.5f + 0.25f * (float)(i % 2);
    struct aob_flicker sum = compare(&now, &before, false);
    assert_true(aob_flicker_value(&sum) == 0 && aob_flicker_compared(&sum) == 1);
    for (int i = 0; i < PIXELS; i++) {
        now.image[i] = i % 2 ? 0.625f : 0.375f;
        before.image[i] = i % 2 ? 0.375f : 0.625f;
        now.truth[i] = 0.25f; /* and the truth by 1/4, which is the error's change as well */
    }
    sum = compare(&now, &before, false);
    assert_near(aob_flicker_truth_change(&sum), 0.25, 1e-7);
    assert_near(aob_flicker_value(&sum), sqrt((0.5 * 0.5 + 0) / 2), 1e-7);
    finish(&now, &before);
}

/* An image of white noise: its changes have twice its variance, and bilinearly between two pixels 3/2 of it. */
static void noise_flickers_by_its_variance(void **state)
{
    (void)state;
    for (int half = 0; half < 2; half++) {
        struct wall now, before;
        struct aob_flicker sum = {0};
        srand(3);
        for (int repeat = 0; repeat < 400; repeat++) {
            make_wall(&now, 2);
            make_wall(&before, 2);
            set_velocity(&now, half ? 0.5f : 0, 2);
            for (int i = 0; i < PIXELS; i++) {
                now.image[i] = rand() < RAND_MAX / 2 ? 0.6f : 0.4f;
                before.image[i] = rand() < RAND_MAX / 2 ? 0.6f : 0.4f;
            }
            struct aob_flicker one = compare(&now, &before, false);
            sum.change += one.change;
            sum.compared += one.compared;
            finish(&now, &before);
        }
        assert_near(aob_flicker_value(&sum), 0.1 * sqrt(half ? 1.5 : 2), 1e-3);
    }
}

/* What moves with the surface by a whole number of pixels does not flicker; what stays on the screen does. */
static void a_shift_follows_the_surface(void **state)
{
    (void)state;
    struct wall now, before;
    make_wall(&now, 2);
    make_wall(&before, 2);
    set_velocity(&now, 3, 2);
    for (int i = 0; i < PIXELS; i++) {
        before.image[i] = (i % W) % 5 == 0 ? 0.9f : 0.5f;
        now.image[i] = (i % W + 2) % 5 == 0 ? 0.9f : 0.5f; /* (x - 3) % 5 */
    }
    struct aob_flicker sum = compare(&now, &before, false);
    assert_true(aob_flicker_value(&sum) == 0);
    assert_near(aob_flicker_compared(&sum), (W - 3.0) / W, 1e-12); /* the rest was out of the view */
    for (int i = 0; i < PIXELS; i++)
        now.image[i] = before.image[i];
    sum = compare(&now, &before, false);
    assert_true(aob_flicker_value(&sum) > 0.2);
    finish(&now, &before);
}

/* Between pixels a ramp is exact, and a place beyond the last pixel's centre was not in the view. */
static void a_place_between_pixels_is_bilinear(void **state)
{
    (void)state;
    struct wall now, before;
    make_wall(&now, 2);
    make_wall(&before, 2);
    set_velocity(&now, -0.25f, 2);
    for (int i = 0; i < PIXELS; i++) {
        before.image[i] = 0.01f * (float)(i % W);
        now.image[i] = 0.01f * ((float)(i % W) + 0.25f) + 0.125f;
    }
    struct aob_flicker sum = compare(&now, &before, false);
    assert_near(aob_flicker_value(&sum), 0.125, 1e-6);
    assert_near(aob_flicker_compared(&sum), (W - 1.0) / W, 1e-12);
    finish(&now, &before);
}

/* The truths are off by s and -s, so the errors change by 2s. What their standard errors say is taken from it. */
static void noise_of_the_truths_is_no_flicker(void **state)
{
    (void)state;
    const double s = 0.0625;
    for (int half = 0; half < 2; half++) {
        struct wall now, before;
        make_wall(&now, 2);
        make_wall(&before, 2);
        if (half)
            set_velocity(&now, 0.5f, 2);
        for (int i = 0; i < PIXELS; i++) {
            now.truth[i] = 0.5f + (float)s;
            before.truth[i] = 0.5f - (float)s;
            now.se[i] = before.se[i] = (float)s;
        }
        struct aob_flicker sum = compare(&now, &before, true);
        assert_near(aob_flicker_value(&sum), s * sqrt(4 - (half ? 1.5 : 2)), 1e-7);
        assert_near(aob_flicker_truth_change(&sum), s * sqrt(4 - (half ? 1.5 : 2)), 1e-7);
        for (int i = 0; i < PIXELS; i++)
            now.se[i] = before.se[i] = (float)(2 * s); /* more than there is */
        sum = compare(&now, &before, true);
        assert_true(aob_flicker_value(&sum) == 0);
        finish(&now, &before);
    }
}

/* Where something else was seen, behind the camera, sky now or then, or a face turned elsewhere: nothing to compare. */
static void what_comes_into_view_does_not_count(void **state)
{
    (void)state;
    struct wall now, before;
    make_wall(&now, 2);
    make_wall(&before, 2);
    set_velocity(&now, 0, 2);
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++) {
            int i = y * WIDE + x, column = x - GUARD;
            if (column < 4)
                before.gbuffer.depth[i] = 1.5f;
            else if (column < 8)
                now.gbuffer.depth[i] = AOB_GBUFFER_SKY;
            else if (column < 10)
                before.gbuffer.depth[i] = AOB_GBUFFER_SKY;
            else if (column < 12)
                for (int c = 0; c < 3; c++)
                    now.gbuffer.velocity[3 * i + c] = AOB_NO_VELOCITY;
            else if (column < 14) {
                before.gbuffer.normal[4 * i + 2] = 0.8f;
                before.gbuffer.normal[4 * i] = 0.6f;
            }
        }
    for (int i = 0; i < PIXELS; i++)
        now.image[i] = i % W < 14 ? 1 : 0.625f;
    struct aob_flicker sum = compare(&now, &before, false);
    assert_int_equal(sum.surfaces, (W - 4) * H);
    assert_int_equal(sum.compared, (W - 14) * H);
    assert_true(aob_flicker_value(&sum) == 0.125);
    sum = (struct aob_flicker){0};
    assert_true(isnan(aob_flicker_value(&sum)) && isnan(aob_flicker_compared(&sum)));
    finish(&now, &before);
}

/* --- Points of passing_box. --- */

static void rig_frame(struct aob_rig *rig, const struct aob_camera *camera, int frame)
{
    struct aob_mesh mesh = {0};
    aob_scene_find("passing_box")->build(&mesh);
    aob_mesh_move(&mesh, frame);
    aob_rig_init(rig, &mesh, camera, 160, 90, 4);
    aob_mesh_finish(&mesh);
    size_t count = (size_t)rig->hits.width * (size_t)rig->hits.height;
    if (rig->hits.velocity && !rig->gbuffer.velocity) {
        rig->gbuffer.velocity = AOB_NEW_ARRAY(float, 3 * count);
        for (size_t i = 0; i < 3 * count; i++)
            rig->gbuffer.velocity[i] = rig->hits.velocity[i / 3][i % 3];
    }
}

/* A picture that is painted on the surfaces: waves along each axis, which go with what moves. */
static void paint(const struct aob_rig *rig, int frame, float *image)
{
    for (int y = 0; y < rig->height; y++)
        for (int x = 0; x < rig->width; x++) {
            struct aob_vec3 p = {0, 0, 0};
            size_t at = (size_t)(y + rig->guard) * (size_t)rig->hits.width + (size_t)(x + rig->guard);
            aob_rig_position(rig, x, y, &p);
            double along = p.x - (rig->hits.primitive[at] >= 16 ? 0.1 * frame : 0);
            image[y * rig->width + x] =
                (float)(0.5 + 0.15 * (sin(2 * along) + sin(2 * p.y + 1) + sin(2 * p.z + 2)));
        }
}

/* Both move, and turn: almost every point is found again, as what it was; with the motion left out it is not. */
static void points_of_a_moving_scene_are_found_again(void **state)
{
    (void)state;
    const struct aob_camera first = {.eye = {0, 1.5, 5}, .target = {0, 0.6, 0.3}, .fov_deg = 50};
    const struct aob_camera second = {.eye = {0.15, 1.45, 4.9},
                                      .target = {0.3, 0.6, 0.3},
                                      .fov_deg = 50,
                                      .moves = true,
                                      .previous_eye = first.eye,
                                      .previous_target = first.target};
    struct aob_rig now, before;
    float *images[2] = {AOB_NEW_ARRAY(float, 160 * 90), AOB_NEW_ARRAY(float, 160 * 90)},
          *truth = AOB_NEW_ARRAY(float, 160 * 90);
    struct aob_flicker sum = {0}, wrong = {0};
    rig_frame(&before, &first, 5);
    rig_frame(&now, &second, 6);
    paint(&before, 5, images[0]);
    paint(&now, 6, images[1]);
    struct aob_flicker_desc desc = {.now = {&now.gbuffer, images[1], truth, NULL},
                                    .before = {&before.gbuffer, images[0], truth, NULL},
                                    .then = aob_camera_then(&second)};
    aob_flicker_add(&sum, &desc);
    assert_true(aob_flicker_compared(&sum) > 0.85);
    assert_true(aob_flicker_value(&sum) < 5e-4);
    paint(&now, 5, images[1]); /* what moves has lost its paint by a step */
    aob_flicker_add(&wrong, &desc);
    assert_true(aob_flicker_value(&wrong) > 3e-3);
    for (int i = 0; i < 2; i++)
        free(images[i]);
    free(truth);
    aob_rig_finish(&now);
    aob_rig_finish(&before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_changes_at_a_place_flickers),
        cmocka_unit_test(noise_flickers_by_its_variance),
        cmocka_unit_test(a_shift_follows_the_surface),
        cmocka_unit_test(a_place_between_pixels_is_bilinear),
        cmocka_unit_test(noise_of_the_truths_is_no_flicker),
        cmocka_unit_test(what_comes_into_view_does_not_count),
        cmocka_unit_test(points_of_a_moving_scene_are_found_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

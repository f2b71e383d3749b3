/* Frames drawn by lot: what they claim to hold, and that they are the same again. No device. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "stress/fuzz_frame.h"
#include "technique/param.h"
#include "technique/registry.h"

static struct aob_fuzz_name name_of(size_t technique, uint64_t index)
{
    return (struct aob_fuzz_name){aob_builtin_techniques[technique], "vulkan", 5, index};
}

/* Where the prelude would say that the pixel is, without the shift of a whole view. */
static struct aob_vec3 to_eye(const struct aob_fuzz_frame *frame, size_t i)
{
    const struct aob_projection *p = &frame->gbuffer.projection;
    double x = (double)(i % (size_t)p->width) + 0.5, y = (double)(i / (size_t)p->width) + 0.5;
    struct aob_vec3 at = aob_vec((x - p->cx) * p->sx, -(y - p->cy) * p->sy, -1);
    return p->perspective ? aob_vec_normalize(aob_vec_scale(at, -1)) : aob_vec(0, 0, 1);
}

static void check_normal(const float *n, struct aob_vec3 eye)
{
    struct aob_vec3 v = aob_vec((double)n[0], (double)n[1], (double)n[2]);
    assert_near(aob_vec_length(v), 1, 1e-6);
    assert_true(aob_vec_dot(v, eye) > 0);
}

/* What a kind of pixel promises, and that all kinds come. */
static void check_pixels(const struct aob_fuzz_frame *frame, size_t kinds[3])
{
    for (size_t i = 0; i < aob_fuzz_frame_pixels(frame); i++) {
        float depth = frame->gbuffer.depth[i];
        kinds[frame->pixels[i]]++;
        if (frame->pixels[i] == AOB_FUZZ_SKY)
            assert_true(depth == AOB_GBUFFER_SKY);
        if (frame->pixels[i] != AOB_FUZZ_SURFACE)
            continue;
        assert_true(depth > 1e-3f && depth < 1e8f);
        check_normal(&frame->gbuffer.normal[4 * i], to_eye(frame, i));
        check_normal(&frame->gbuffer.shading[4 * i], to_eye(frame, i));
    }
}

static void frames_are_what_they_say(void **state)
{
    (void)state;
    size_t kinds[3] = {0}, guards[AOB_FUZZ_GUARD + 1] = {0}, flat = 0, sizes = 0, shifted = 0;
    for (uint64_t index = 0; index < 4000; index++) {
        struct aob_fuzz_frame frame;
        const struct aob_fuzz_name name = name_of(index % 9, index * 13);
        aob_fuzz_frame_init(&frame, &name);
        int width = aob_fuzz_frame_width(&frame), height = aob_fuzz_frame_height(&frame);
        assert_in_range(width, 1, AOB_FUZZ_SIDE);
        assert_in_range(height, 1, AOB_FUZZ_SIDE);
        sizes |= (size_t)1 << width;
        guards[frame.gbuffer.guard]++;
        flat += !frame.gbuffer.projection.perspective;
        shifted += fabs(frame.gbuffer.projection.cx - 0.5 * frame.gbuffer.projection.width) > 1e-9;
        check_pixels(&frame, kinds);
        assert_in_range(frame.triangle_count, 1, AOB_FUZZ_TRIANGLES);
        aob_fuzz_frame_finish(&frame);
    }
    for (size_t i = 0; i < 3; i++)
        assert_true(kinds[i] > 1000);
    for (size_t i = 0; i <= AOB_FUZZ_GUARD; i++)
        assert_true(guards[i] > 100);
    assert_true(flat > 400 && flat < 3000 && shifted > 400 && shifted < 3000);
    assert_true(sizes == ((size_t)2 << AOB_FUZZ_SIDE) - 2); /* every side from 1 on */
}

/* Within its bounds and rules; every bound of a uniform is met in some thousand frames. */
static void values_keep_their_bounds(void **state)
{
    (void)state;
    for (size_t t = 0; aob_builtin_techniques[t]; t++) {
        const struct aob_technique *technique = aob_builtin_techniques[t];
        bool least[AOB_MAX_PARAM] = {false}, most[AOB_MAX_PARAM] = {false};
        for (uint64_t index = 0; index < 400; index++) {
            struct aob_fuzz_frame frame;
            const struct aob_fuzz_name name = name_of(t, index * 97);
            aob_fuzz_frame_init(&frame, &name);
            for (uint32_t i = 0; i < technique->param_count; i++) {
                const struct aob_param *p = &technique->params[i];
                double v = frame.params[i];
                assert_true(aob_param_obeys(p, v));
                assert_true(p->choices || (v >= p->min && v <= p->max));
                least[i] = least[i] || v == p->min;
                most[i] = most[i] || v == p->max;
            }
            aob_fuzz_frame_finish(&frame);
        }
        for (uint32_t i = 0; i < technique->param_count; i++)
            if (technique->params[i].stage == AOB_UNIFORM && !technique->params[i].choices &&
                !technique->check)
                assert_true(least[i] && most[i]);
    }
}

/* A share of each output's frames want it; lights are dark, plain, and stronger than half floats hold. */
static void lights_and_materials_are_drawn(void **state)
{
    (void)state;
    size_t wanted[AOB_OPTION_COUNT] = {0}, dark = 0, strong = 0, ends = 0, pixels = 0;
    for (uint64_t index = 0; index < 1000; index++) {
        struct aob_fuzz_frame frame;
        const struct aob_fuzz_name name = name_of(index % 9, index * 513);
        aob_fuzz_frame_init(&frame, &name);
        for (size_t i = AOB_OPTION_FIRST_SWITCH; i < AOB_OPTION_COUNT; i++)
            wanted[i] += frame.options[i] == 1;
        for (int c = 0; c < 3; c++) {
            assert_true(aob_light_least(&frame.light, c) >= -1e-6 * frame.light.sh[0][c]);
            dark += frame.light.sh[0][c] == 0;
            strong += frame.light.sh[0][c] > 1e5;
        }
        for (size_t i = 0; i < aob_fuzz_frame_pixels(&frame); i++, pixels++) {
            float metalness = frame.gbuffer.shine[2 * i + 1];
            assert_true(metalness >= 0 && metalness <= 1);
            ends += metalness == 1;
        }
        aob_fuzz_frame_finish(&frame);
    }
    for (size_t i = AOB_OPTION_FIRST_SWITCH; i < AOB_OPTION_COUNT; i++)
        assert_in_range(wanted[i], 300, 700);
    assert_true(dark > 200 && strong > 100 && ends > pixels / 5 && ends < pixels / 2);
}

static void assert_same(const struct aob_fuzz_frame *a, const struct aob_fuzz_frame *b, bool same)
{
    bool alike = memcmp(&a->gbuffer.projection, &b->gbuffer.projection, sizeof a->gbuffer.projection) == 0 &&
                 memcmp(a->params, b->params, sizeof a->params) == 0 &&
                 memcmp(&a->light, &b->light, sizeof a->light) == 0 &&
                 memcmp(a->gbuffer.depth, b->gbuffer.depth, aob_fuzz_frame_pixels(a) * sizeof(float)) == 0;
    assert_int_equal(alike, same);
}

static void a_name_is_a_frame(void **state)
{
    (void)state;
    const struct aob_fuzz_name name = name_of(2, 77), next = name_of(2, 78);
    struct aob_fuzz_name seed = name, backend = name;
    struct aob_fuzz_frame one, again, other;
    seed.seed++;
    backend.backend = "gl-egl";
    aob_fuzz_frame_init(&one, &name);
    aob_fuzz_frame_init(&again, &name);
    assert_same(&one, &again, true);
    aob_fuzz_frame_finish(&again);
    aob_fuzz_frame_copy(&again, &one);
    assert_same(&one, &again, true);
    aob_fuzz_frame_finish(&again);
    const struct aob_fuzz_name *const names[] = {&next, &seed, &backend};
    for (size_t i = 0; i < 3; i++) {
        aob_fuzz_frame_init(&other, names[i]);
        assert_same(&one, &other, false);
        aob_fuzz_frame_finish(&other);
    }
    aob_fuzz_frame_finish(&one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_what_they_say), cmocka_unit_test(values_keep_their_bounds),
        cmocka_unit_test(lights_and_materials_are_drawn), cmocka_unit_test(a_name_is_a_frame)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

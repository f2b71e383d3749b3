/* Which channels are taken for depth and normal, and what is said about it. */
#include "check.h"
#include "base/memory.h"
#include "gbuffer/capture_channel.h"

enum { MOST = 16 };
struct choice {
    const char *names[MOST]; /* in the order of a file: by the alphabet within a part */
    const char *depth, *normal;
    const char *other_depth, *other_normal; /* NULL: none is told */
    bool mixed;
    const char *depth_channel, *normal_channel; /* that the user names; NULL: none */
};

static size_t count_names(const struct choice *choice)
{
    size_t count = 0;
    while (count < MOST && choice->names[count])
        count++;
    return count;
}

static void expect_name(const struct choice *choice, const char *what, int at, const char *wanted)
{
    const char *got = at >= 0 ? choice->names[at] : NULL;
    if (!got != !wanted || (got && strcmp(got, wanted) != 0))
        fail_msg("%s of the file with %s: %s, not %s", what, choice->names[0], got ? got : "none",
                 wanted ? wanted : "none");
}

static void check_choice(const struct choice *choice)
{
    struct aob_capture_channels channels;
    struct aob_convention convention = {0};
    struct aob_error error = {{0}};
    if (choice->depth_channel)
        strcpy(convention.depth_channel, choice->depth_channel);
    if (choice->normal_channel)
        strcpy(convention.normal_channel, choice->normal_channel);
    if (!aob_capture_channels_choose(&channels, choice->names, count_names(choice), &convention, &error))
        fail_msg("%s", error.text);
    expect_name(choice, "depth", channels.depth, choice->depth);
    expect_name(choice, "normal", channels.normal[0], choice->normal);
    expect_name(choice, "other depth", channels.other_depth, choice->other_depth);
    expect_name(choice, "other normal", channels.other_normal, choice->other_normal);
    assert_int_equal(channels.mixed, choice->mixed);
}

static void check_choices(const struct choice *choices, size_t count)
{
    for (size_t i = 0; i < count; i++)
        check_choice(&choices[i]);
}

/* Depth and normal of one layer, wherever in the name the layer stands. */
static void test_layers(void **state)
{
    static const struct choice choices[] = {
        {.names = {"Bg.Depth.Z", "Fg.Depth.Z", "Fg.N.X", "Fg.N.Y", "Fg.N.Z"},
         .depth = "Fg.Depth.Z",
         .normal = "Fg.N.X",
         .other_depth = "Bg.Depth.Z"},
        {.names = {"Bg.Depth.Z", "Bg.N.X", "Bg.N.Y", "Bg.N.Z", "Fg.Depth.Z", "Fg.N.X", "Fg.N.Y", "Fg.N.Z"},
         .depth = "Bg.Depth.Z",
         .normal = "Bg.N.X",
         .other_depth = "Fg.Depth.Z"},
        {.names = {"Bg.Depth.Z", "Bg.N.X", "Bg.N.Y", "Bg.N.Z", "Fg.Depth.Z", "Fg.N.X", "Fg.N.Y", "Fg.N.Z"},
         .depth = "Fg.Depth.Z",
         .normal = "Fg.N.X",
         .depth_channel = "Fg.Depth.Z"},
        {.names = {"Bg.Depth.Z", "Bg.N.X", "Bg.N.Y", "Bg.N.Z", "Fg.Depth.Z", "Fg.N.X", "Fg.N.Y", "Fg.N.Z"},
         .depth = "Fg.Depth.Z",
         .normal = "Fg.N.X",
         .other_depth = "Bg.Depth.Z",
         .normal_channel = "Fg.N"},
        {.names = {"Bg.Depth.Z", "Fg.N.X", "Fg.N.Y", "Fg.N.Z"},
         .depth = "Bg.Depth.Z",
         .normal = "Fg.N.X",
         .mixed = true},
        {.names = {"Bg.Depth.Z", "Fg.N.X", "Fg.N.Y", "Fg.N.Z"},
         .depth = "Bg.Depth.Z",
         .normal = "Fg.N.X",
         .depth_channel = "Bg.Depth.Z",
         .normal_channel = "Fg.N"},
        {.names = {"Fg.N.X", "Fg.N.Y", "Fg.N.Z", "Fg.Normal.X", "Fg.Normal.Y", "Fg.Normal.Z", "Fg.Z"},
         .depth = "Fg.Z",
         .normal = "Fg.N.X",
         .other_normal = "Fg.Normal.X"},
    };
    (void)state;
    check_choices(choices, AOB_COUNT(choices));
}

/* Views of a stereo image, as OpenEXR's multi-view files and parts name them. */
static void test_views(void **state)
{
    static const struct choice choices[] = {
        {.names = {"Fg.left.N.X", "Fg.left.N.Y", "Fg.left.N.Z", "left.Fg.Depth.Z", "right.Fg.Depth.Z"},
         .depth = "left.Fg.Depth.Z",
         .normal = "Fg.left.N.X",
         .other_depth = "right.Fg.Depth.Z"},
        {.names = {"Depth.left.Z", "Depth.right.Z", "N.right.X", "N.right.Y", "N.right.Z"},
         .depth = "Depth.right.Z",
         .normal = "N.right.X",
         .other_depth = "Depth.left.Z"},
        {.names = {"N.X", "N.Y", "N.Z", "Z", "right.N.X", "right.N.Y", "right.N.Z", "right.Z"},
         .depth = "Z",
         .normal = "N.X",
         .other_depth = "right.Z"},
        {.names = {"depth.left.V", "depth.right.V", "normal.left.R", "normal.left.G", "normal.left.B"},
         .depth = "depth.left.V",
         .normal = "normal.left.R",
         .other_depth = "depth.right.V"},
        {.names = {"a.b.c.d.e.Depth.Z", "e.d.c.b.a.Normal.X", "e.d.c.b.a.Normal.Y", "e.d.c.b.a.Normal.Z"},
         .depth = "a.b.c.d.e.Depth.Z",
         .normal = "e.d.c.b.a.Normal.X"},
    };
    (void)state;
    check_choices(choices, AOB_COUNT(choices));
}

/* A depth that is stored as a colour is one; what lies below a depth's name is not. */
static void test_what_is_a_depth(void **state)
{
    static const struct choice choices[] = {
        {.names = {"Depth.B", "Depth.G", "Depth.R"}, .depth = "Depth.R"},
        {.names = {"ViewLayer.Depth.Z", "ViewLayer.Mist.Z"}, .depth = "ViewLayer.Depth.Z"},
        {.names = {"P.X", "P.Y", "P.Z", "Z"}, .depth = "Z"},
        {.names = {"InverseDepth.Z", "SceneDepth.R"}, .depth = "SceneDepth.R"},
        {.names = {"ViewLayer.Denoising Depth.Z", "ViewLayer.Depth.Z"}, .depth = "ViewLayer.Depth.Z"},
        {.names = {"VL.Denoising Depth.left.Z", "VL.Depth.left.Z"}, .depth = "VL.Depth.left.Z"},
        {.names = {"VL.A.Mist.left.Z", "VL.Depth.left.Z"}, .depth = "VL.Depth.left.Z"},
        {.names = {"VL.A.left.Z", "VL.Depth.left.Z"},
         .depth = "VL.Depth.left.Z",
         .other_depth = "VL.A.left.Z"},
        {.names = {"MistDepth.Z", "SceneDepth.R"}, .depth = "SceneDepth.R"},
    };
    (void)state;
    check_choices(choices, AOB_COUNT(choices));
}

static void expect_no_depth(const char *const *names, size_t count)
{
    struct aob_capture_channels channels;
    const struct aob_convention convention = {0};
    struct aob_error error = {{0}};
    if (aob_capture_channels_choose(&channels, names, count, &convention, &error))
        fail_msg("%s is taken for a depth", names[channels.depth]);
    assert_contains(error.text, "no channel is a depth by its name");
    for (size_t i = 0; i < count; i++)
        assert_contains(error.text, names[i]);
}

static void test_no_depth(void **state)
{
    static const char *const alone[] = {"ViewLayer.Combined.R",
                                        "ViewLayer.Mist.Z",
                                        "Mist.Z",
                                        "mist.V",
                                        "MistDepth.R",
                                        "MistDepth.Z",
                                        "InvDepth.Z",
                                        "reciprocalDepth.Z",
                                        "disparity.Z",
                                        "Disparity.left.Z",
                                        "VL.Mist.left.Z",
                                        "VL.A.Mist.left.Z",
                                        "VL.Denoising Depth.left.Z",
                                        "Inverse.Depth.left.V",
                                        "RecipDepth",
                                        "N.Z"};
    static const char *const vector[] = {"P.X", "P.Z"}, *const colour[] = {"depth.AO.R", "depth.AO.G",
                                                                           "depth.AO.B"};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(alone); i++)
        expect_no_depth(&alone[i], 1);
    expect_no_depth(vector, AOB_COUNT(vector));
    expect_no_depth(colour, AOB_COUNT(colour));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layers),
        cmocka_unit_test(test_views),
        cmocka_unit_test(test_what_is_a_depth),
        cmocka_unit_test(test_no_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

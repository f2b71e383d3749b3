/* Which channels are taken for base colour, roughness and metalness, and what is said about it. */
#include "check.h"
#include "base/memory.h"
#include "gbuffer/capture_material_channel.h"

enum { MOST = 16 };
struct choice {
    const char *names[MOST];                                                 /* in the order of a file */
    const char *layer;                                                       /* of the depth */
    const char *found[AOB_MATERIAL_CHANNELS], *other[AOB_MATERIAL_CHANNELS]; /* NULL: none */
    bool mixed;                                                              /* the base colour */
    const char *named[AOB_MATERIAL_CHANNELS];                                /* by the user; NULL: not */
    bool none;                                                               /* materials none */
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

static bool choose(const struct choice *choice, struct aob_capture_material_channels *channels,
                   struct aob_error *error)
{
    struct aob_convention convention = {.no_materials = choice->none};
    for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++)
        if (choice->named[m])
            strcpy(convention.material_channels[m], choice->named[m]);
    return aob_capture_materials_choose(channels, choice->names, count_names(choice),
                                        choice->layer ? choice->layer : "", &convention, error);
}

static void check_choices(const struct choice *choices, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct aob_capture_material_channels channels;
        struct aob_error error = {{0}};
        if (!choose(&choices[i], &channels, &error))
            fail_msg("%s", error.text);
        for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++) {
            expect_name(&choices[i], aob_material_channel_names[m], channels.of[m].at[0],
                        choices[i].found[m]);
            expect_name(&choices[i], "another", channels.of[m].other, choices[i].other[m]);
        }
        assert_int_equal(channels.of[AOB_MATERIAL_ALBEDO].mixed, choices[i].mixed);
    }
}

static void test_names(void **state)
{
    static const struct choice choices[] = {
        {.names = {"N.X", "Z", "albedo.B", "albedo.G", "albedo.R", "metalness", "roughness"},
         .found = {"albedo.R", "roughness", "metalness"}},
        {.names = {"BASE_COLOR.b", "BASE_COLOR.g", "BASE_COLOR.r", "Metallic.V", "Roughness.V"},
         .found = {"BASE_COLOR.r", "Roughness.V", "Metallic.V"}},
        {.names = {"FinalImageBaseColor.B", "FinalImageBaseColor.G", "FinalImageBaseColor.R",
                   "FinalImageRoughness.B", "FinalImageRoughness.G", "FinalImageRoughness.R"},
         .found = {"FinalImageBaseColor.R", "FinalImageRoughness.R", NULL}},
        {.names = {"ViewLayer.DiffCol.B", "ViewLayer.DiffCol.G", "ViewLayer.DiffCol.R"},
         .layer = "viewlayer.",
         .found = {"ViewLayer.DiffCol.R"}},
        {.names = {"diffuse_albedo.B", "diffuse_albedo.G", "diffuse_albedo.R", "specular_albedo.B",
                   "specular_albedo.G", "specular_albedo.R", "coat_roughness", "specular_roughness"},
         .found = {"diffuse_albedo.R"}},
        {.names = {"Reflection Albedo.B", "Reflection Albedo.G", "Reflection Albedo.R", "inv_roughness",
                   "reciprocal_roughness"},
         .found = {NULL}},
    };
    (void)state;
    check_choices(choices, AOB_COUNT(choices));
}

static void test_which_of_several(void **state)
{
    static const struct choice choices[] = {
        {.names = {"Bg.albedo.B", "Bg.albedo.G", "Bg.albedo.R", "Fg.albedo.B", "Fg.albedo.G", "Fg.albedo.R"},
         .layer = "fg.",
         .found = {"Fg.albedo.R"}},
        {.names = {"Bg.albedo.B", "Bg.albedo.G", "Bg.albedo.R"},
         .layer = "fg.",
         .found = {"Bg.albedo.R"},
         .mixed = true},
        {.names = {"albedo.B", "albedo.G", "albedo.R", "BaseColor.B", "BaseColor.G", "BaseColor.R",
                   "roughness", "MyRoughness"},
         .found = {"albedo.R", "roughness"},
         .other = {"BaseColor.R", "MyRoughness"}},
        {.names = {"MyAlbedo.B", "MyAlbedo.G", "MyAlbedo.R", "albedo.B", "albedo.G", "albedo.R"},
         .found = {"albedo.R"},
         .other = {"MyAlbedo.R"}},
        {.names = {"albedo.B", "albedo.G", "albedo.R", "paint.B", "paint.G", "paint.R", "gloss", "roughness"},
         .found = {"paint.R", "gloss"},
         .named = {"paint", "gloss"}},
        {.names = {"albedo.B", "albedo.G", "albedo.R", "roughness", "metalness"}, .none = true},
    };
    (void)state;
    check_choices(choices, AOB_COUNT(choices));
}

/* Light, other lobes, what is smoothed for a denoiser. */
static void test_what_is_none(void **state)
{
    static const struct choice choices[] = {
        {.names = {"diffuse.B", "diffuse.G", "diffuse.R"}},
        {.names = {"Denoising Albedo.B", "Denoising Albedo.G", "Denoising Albedo.R"}},
        {.names = {"coat_albedo.B", "coat_albedo.G", "coat_albedo.R", "sheen_roughness"}},
        {.names = {"roughness.G", "metalness.A", "albedo.A"}},
    };
    (void)state;
    check_choices(choices, AOB_COUNT(choices));
}

static void test_refused(void **state)
{
    static const struct {
        struct choice choice;
        const char *says;
    } refused[] = {
        {{.names = {"albedo.G", "albedo.R"}}, "its base colour has albedo.R, and not all of .R .G .B: write"},
        {{.names = {"albedo.R"}, .named = {"paint"}}, "albedo_channel: it has no channels 'paint' with .R"},
        {{.names = {"roughness"}, .named = {NULL, "gloss"}}, "roughness_channel: it has no channel 'gloss'"},
        {{.names = {"Z"}, .named = {NULL, NULL, "metal"}}, "metalness_channel: it has no channel 'metal'"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(refused); i++) {
        struct aob_capture_material_channels channels;
        struct aob_error error = {{0}};
        assert_false(choose(&refused[i].choice, &channels, &error));
        assert_contains(error.text, refused[i].says);
        assert_null(strchr(error.text, '\n'));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_which_of_several),
        cmocka_unit_test(test_what_is_none),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What a plan of a capture says: what it was compared with, which effects the file has no data for, and how far the sets differ. */
#include "check.h"
#include <math.h>
#include <string.h>
#include "config/convention.h"
#include "effects/capture_words.h"

enum {
    V = 1 << AOB_EFFECT_VISIBILITY,
    BOUNCES = 1 << AOB_EFFECT_MULTI_BOUNCE,
    LIGHT = 1 << AOB_EFFECT_DIRECTIONAL,
    SPECULAR = 1 << AOB_EFFECT_SPECULAR,
    HALF = 1 << AOB_EFFECT_HALF_SIZE,
    COLOUR = 1 << AOB_MATERIAL_ALBEDO,
    ROUGH = 1 << AOB_MATERIAL_ROUGHNESS
};

static void check_text(struct aob_text *text, const char *words)
{
    assert_string_equal(text->data, words);
    aob_text_finish(text);
}

static void check_against(unsigned materials, unsigned reference, const char *words)
{
    const struct aob_effect_answer answer = {
        .no_truth = true, .materials = materials, .reference = reference};
    struct aob_text text = {0};
    aob_effect_against(&answer, 0, &text);
    check_text(&text, words);
}

static void test_against(void **state)
{
    const struct aob_effect_answer scene = {0};
    struct aob_text text = {0};
    (void)state;
    aob_effect_against(&scene, 8, &text);
    check_text(&text, "against 8 rays a pixel");
    check_against(COLOUR | ROUGH, V | BOUNCES | SPECULAR,
                  "in its own materials, against its own of full size with visibility + multi_bounce + "
                  "specular, which no truth has judged");
    check_against(COLOUR, V | BOUNCES,
                  "in its base colour and matt, since it has no roughness, against its own of full size with "
                  "visibility + multi_bounce, which no truth has judged");
    check_against(ROUGH, V | SPECULAR,
                  "in its roughness and one base colour, against its own of full size with visibility + "
                  "specular, which no truth has judged");
    check_against(0, V,
                  "in one white material, against its own of full size with visibility, which no truth has "
                  "judged");
}

static struct aob_effect_answer answer_of(unsigned lacks)
{
    struct aob_effect_answer a = {.ask = {0.02, INFINITY, NULL},
                                  .no_truth = true,
                                  .lacks = lacks,
                                  .open = V | HALF | LIGHT,
                                  .reference = V | LIGHT,
                                  .count = 3};
    a.candidates[0] = (struct aob_effect_candidate){.set = V, .error.rmse = 0.01, .ms = 2};
    a.candidates[1] = (struct aob_effect_candidate){.set = V | HALF, .error.rmse = 0.05, .ms = 1};
    a.candidates[2] = (struct aob_effect_candidate){.set = V | LIGHT, .error.rmse = 0, .ms = 3};
    a.bounds.most[AOB_EFFECT_SPECULAR] = lacks & SPECULAR ? (double)INFINITY : 0.003;
    a.bounds.most[AOB_EFFECT_MULTI_BOUNCE] = INFINITY;
    aob_effect_answer_choose(&a);
    return a;
}

static void check_says(const struct aob_effect_answer *a, enum aob_effect_id id, enum aob_effect_why why,
                       const char *words)
{
    struct aob_text text = {0};
    assert_int_equal(aob_effect_answer_why(a, id), why);
    aob_effect_answer_explain(a, id, &text);
    check_text(&text, words);
}

static void test_sentences(void **state)
{
    struct aob_effect_answer bare = answer_of(BOUNCES | SPECULAR), rough = answer_of(BOUNCES);
    (void)state;
    assert_int_equal(bare.candidates[bare.chosen].set, V);
    check_says(&bare, AOB_EFFECT_MULTI_BOUNCE, AOB_WHY_NO_DATA,
               "not known: the file has no base colour (albedo.R .G .B), and bounces depend on it");
    check_says(&bare, AOB_EFFECT_SPECULAR, AOB_WHY_NO_DATA,
               "not known: the file has no roughness, and how wide a surface mirrors depends on it");
    check_says(
        &rough, AOB_EFFECT_SPECULAR, AOB_WHY_RULE,
        "no: what these surfaces mirror is so little, or so wide, that its occlusion changes the image "
        "by 0.3 % at most, of a tolerance of 2 %");
    check_says(&bare, AOB_EFFECT_HALF_SIZE, AOB_WHY_MEASURED,
               "no: with it the image differs by 5 % in place of 1 %, and a frame takes 1 ms less");
    check_says(&bare, AOB_EFFECT_DIRECTIONAL, AOB_WHY_MEASURED,
               "no: with it the image differs by 0 % in place of 1 %, and a frame takes 1 ms more");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against),
        cmocka_unit_test(test_sentences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

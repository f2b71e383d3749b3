#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include "gpu/glsl.h"

static const enum aob_glsl_client clients[] = {AOB_GLSL_VULKAN, AOB_GLSL_OPENGL};
static const uint32_t spirv_magic = 0x07230203;

static uint32_t *compile(const char *text, enum aob_glsl_client client, size_t *count,
                         struct aob_error *error)
{
    return aob_glsl_compile(text, AOB_GLSL_FRAGMENT, client, count, error);
}

static void expect_error(const char *text, const char *expected)
{
    for (size_t i = 0; i < 2; i++) {
        struct aob_error error = {""};
        size_t count;
        assert_null(compile(text, clients[i], &count, &error));
        assert_string_equal(error.text, expected);
    }
}

static void compiles_for_both_clients(void **state)
{
    (void)state;
    const char *text = "layout(std140, BIND(0)) uniform Block { float gain; };\n"
                       "layout(BIND(1)) uniform sampler2D a;\n"
                       "layout(r32f, BIND(9)) uniform readonly image2D b;\n"
                       "layout(location = 0) out float r;\n"
                       "void main() {\n"
                       "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
                       "    r = gain * texelFetch(a, p, 0).x + imageLoad(b, p).x;\n"
                       "}\n";
    for (size_t i = 0; i < 2; i++) {
        struct aob_error error = {""};
        size_t count = 0;
        uint32_t *words = compile(text, clients[i], &count, &error);
        if (!words)
            fail_msg("%s", error.text);
        assert_true(count > 5);
        assert_int_equal(words[0], spirv_magic);
        assert_int_equal(aob_glsl_bindings(words, count), 1u << 0 | 1u << 1 | 1u << 9);
        free(words);
    }
}

static void compiles_the_screen_triangle(void **state)
{
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        size_t count = 0;
        uint32_t *words =
            aob_glsl_compile(aob_glsl_screen_triangle, AOB_GLSL_VERTEX, clients[i], &count, NULL);
        assert_non_null(words);
        assert_int_equal(aob_glsl_bindings(words, count), 0);
        free(words);
    }
}

static void finds_the_storage_buffer(void **state)
{
    (void)state;
    static const char text[] = "layout(std140, BIND(0)) uniform Block { float f; };\n"
                               "layout(std430, BIND_STORAGE) buffer Words { uint words[]; };\n"
                               "layout(location = 0) out float r;\nvoid main() { words[0] = 1u; r = f; }\n";
    for (int client = AOB_GLSL_VULKAN; client <= AOB_GLSL_OPENGL; client++) {
        size_t count;
        uint32_t *words = compile(text, (enum aob_glsl_client)client, &count, NULL);
        assert_true(aob_glsl_bindings(words, count) == ((uint64_t)1 << AOB_GLSL_STORAGE | 1));
        free(words);
    }
}

static void names_the_first_error_and_its_line(void **state)
{
    (void)state;
    expect_error("void main()\n{\n    x = 1;\n    y = 2;\n}\n",
                 "fragment shader, line 3: 'x' : undeclared identifier");
    expect_error("#line 1 2\nvoid main() { x = 1; }\n", "fragment shader, 2:1: 'x' : undeclared identifier");
}

static void refuses_junk(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "", "\x01\xff junk", "void main() {", "void f() {}", "#version 300 es\nvoid main() {}", "#error no"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct aob_error error = {""};
        size_t count;
        assert_null(compile(texts[i], AOB_GLSL_VULKAN, &count, &error));
        assert_int_equal(strncmp(error.text, "fragment shader, ", 17), 0);
        assert_null(strchr(error.text, '\n'));
    }
}

static void gives_equal_words_for_equal_text(void **state)
{
    (void)state;
    const char *text = "layout(location = 0) out float r;\nvoid main() { r = sin(gl_FragCoord.x); }\n";
    size_t count_a = 0, count_b = 0;
    uint32_t *a = compile(text, AOB_GLSL_OPENGL, &count_a, NULL);
    uint32_t *b = compile(text, AOB_GLSL_OPENGL, &count_b, NULL);
    assert_non_null(a);
    assert_int_equal(count_a, count_b);
    assert_memory_equal(a, b, count_a * sizeof *a);
    free(a);
    free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(compiles_for_both_clients),          cmocka_unit_test(compiles_the_screen_triangle),
        cmocka_unit_test(names_the_first_error_and_its_line), cmocka_unit_test(refuses_junk),
        cmocka_unit_test(gives_equal_words_for_equal_text),   cmocka_unit_test(finds_the_storage_buffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

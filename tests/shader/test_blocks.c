/* Slots of single expressions, as the table says them, and of the rules beyond it: a product within a sum, a constant factor
 * or divisor, a clamp to 0..1. No device is needed. */
#include "check.h"
#include <spirv-tools/libspirv.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "gpu/glsl.h"
#include "shader/blocks.h"
#include "shader/optimise.h"

/* a, b, i, j, u and m are an invocation's own; c, d, k, w and n are the same for all. */
static const char head[] =
    "layout(location = 0) flat in vec4 a;\n"
    "layout(location = 1) flat in vec4 b;\n"
    "layout(location = 2) flat in ivec4 i;\n"
    "layout(location = 3) flat in ivec4 j;\n"
    "layout(location = 4) flat in uvec4 u;\n"
    "layout(location = 5) flat in mat3 m;\n"
    "layout(std140, BIND(0)) uniform B { vec4 c, d; ivec4 k; uvec4 w; mat3 n; vec4 l[8]; };\n"
    "layout(std430, BIND(3)) buffer S { vec4 x[]; };\n"
    "layout(std430, BIND(4)) buffer T { vec4 y; } e[2];\n"
    "layout(location = 0) out vec4 o;\n"
    "layout(BIND(1)) uniform sampler2D s;\n"
    "layout(r32f, BIND(2)) uniform readonly image2D t;\n";

static struct aob_operations sum_of(const struct aob_blocks *blocks)
{
    struct aob_operations sum = {0};
    for (size_t i = 0; i < blocks->count; i++) {
        sum.alu += blocks->each[i].alu;
        sum.special += blocks->each[i].special;
        sum.image += blocks->each[i].image;
    }
    return sum;
}

/* Of `o = EXPRESSION`, whatever its type. */
static bool count(const char *type, const char *expression, enum aob_glsl_client client,
                  struct aob_operations *sum, struct aob_error *error)
{
    struct aob_text text = {0};
    struct aob_spirv spirv;
    struct aob_blocks blocks;
    size_t size;
    char why[256] = "";
    aob_text_add(&text, "%svoid main() { o = vec4(0.0); o%s = %s; }\n", head, type, expression);
    uint32_t *words = aob_glsl_compile(text.data, AOB_GLSL_FRAGMENT, client, &size, error);
    if (!words)
        fail_msg("%s: %s", expression, error->text);
    uint32_t *optimised = aob_shader_optimise(words, size, &size, why, sizeof why);
    if (!optimised)
        fail_msg("%s: %s", expression, why);
    assert_true(aob_spirv_init(&spirv, optimised, size, error));
    bool ok = aob_blocks_init(&blocks, &spirv, error);
    if (ok) {
        *sum = sum_of(&blocks);
        assert_int_equal(blocks.first, 0);
        aob_blocks_finish(&blocks);
    }
    aob_spirv_finish(&spirv);
    free(optimised);
    free(words);
    aob_text_finish(&text);
    return ok;
}

static const struct {
    const char *type, *expression;
    double alu, special, image;
} known[] = {
    {"", "a + b", 4, 0, 0},
    {".xyz", "a.xyz * b.xyz", 3, 0, 0},
    {".xyz", "a.xyz * b.x + b.xyz", 3, 0, 0},
    {".x", "a.x * a.y + b.x * b.y", 2, 0, 0},
    {".xyz", "a.xyz * b.x + b.xyz * a.y", 6, 0, 0}, /* one of the products */
    {".x", "a.x * a.y - a.z", 1, 0, 0},
    {".x", "a.z - a.x * a.y", 1, 0, 0},
    {".x", "a.z + (-(a.x * a.y))", 1, 0, 0},
    {".xy", "a.x * a.y + vec2(a.z, a.x * a.y)", 3, 0, 0}, /* two uses: the product stands by itself */
    {".x", "dot(a.xyz, b.xyz)", 3, 0, 0},
    {".xyz", "cross(a.xyz, b.xyz)", 6, 0, 0},
    {".xyz", "normalize(a.xyz)", 6, 1, 0},
    {".x", "length(a.xyz)", 3, 1, 0},
    {".xyz", "m * a.xyz", 9, 0, 0},
    {".x", "a.x / a.y", 1, 1, 0},
    {".xy", "a.xy / a.zw", 2, 2, 0},
    {".x", "pow(a.x, a.y)", 1, 2, 0},
    {".x", "exp(a.x) + log(a.y)", 3, 2, 0},
    {".x", "exp2(a.x) + log2(a.y)", 1, 2, 0},
    {".x", "sin(a.x) + cos(a.y)", 1, 2, 0},
    {".x", "inversesqrt(a.x)", 0, 1, 0},
    {".x", "acos(a.x)", 9, 1, 0},
    {".x", "atan(a.x, a.y)", 18, 1, 0},
    {".x", "mod(a.x, a.y)", 3, 1, 0},
    {".x", "-abs(a.x) + b.x", 1, 0, 0},
    {".x", "clamp(a.x, 0.0, 1.0)", 0, 0, 0},
    {".xy", "clamp(a.xy, vec2(0.0), vec2(1.0))", 0, 0, 0},
    {".x", "clamp(a.x, 0.0, 2.0)", 2, 0, 0},
    {".x", "clamp(a.x, a.y, a.z)", 2, 0, 0},
    {".x", "max(a.x, a.y)", 1, 0, 0},
    {".x", "mix(a.z, a.w, a.x < a.y)", 2, 0, 0},
    {".xy", "vec2(lessThan(a.xy, b.xy))", 4, 0, 0},
    {".x", "mix(a.z, a.w, all(lessThan(a.xy, b.xy)) && a.z < 1.0)", 4, 0, 0},
    {".x", "float(i.x)", 1, 0, 0},
    {".x", "float(i.x * j.x)", 5, 0, 0},
    {".x", "float(i.x * 8)", 2, 0, 0},
    {".x", "float(i.x * 7)", 5, 0, 0},
    {".x", "float(i.x / 8)", 5, 0, 0},
    {".x", "float(i.x / 7)", 9, 0, 0},
    {".x", "float(i.x % 7)", 17, 0, 0},
    {".x", "float(u.x / 8u)", 2, 0, 0},
    {".x", "float(u.x % 8u)", 2, 0, 0},
    {".x", "float(u.x / 7u)", 7, 0, 0},
    {".x", "float(i.x / j.x)", 38, 1, 0},
    {".x", "float(i.x << 2 ^ j.x)", 3, 0, 0},
    {".x", "float(u.x >> 3 & 7u)", 3, 0, 0},
    {"", "textureLod(s, a.xy, 0.0)", 0, 0, 1},
    {"", "textureGather(s, a.xy)", 0, 0, 1},
    {"", "texelFetch(s, i.xy, 0) + texelFetch(s, j.xy, 0)", 4, 0, 2},
    {"", "imageLoad(t, i.xy)", 0, 0, 1},
    /* The same for all invocations: no one computes it. */
    {"", "c + d", 0, 0, 0},
    {".x", "a.x + (c.x * d.x + sqrt(c.y))", 1, 0, 0},
    {".xy", "a.xy + vec2((k.xy + 1) / 2 - 1)", 2, 0, 0},
    {".x", "a.x + float(k.x / k.y) + 1.0 / c.x", 2, 0, 0},
    {".x", "a.x * (n * d.xyz).y", 1, 0, 0},
    {".x", "a.x + l[k.x].y * 2.0", 1, 0, 0},
    {".x", "a.x + max(l[i.x & 7].y, c.x)", 3, 0, 0}, /* which one is an invocation's own */
    {".x", "a.x + max(x[0].y, c.x)", 2, 0, 0},       /* another invocation may have written it */
    {".x", "a.x + max(e[1].y.x, c.x)", 2, 0, 0},
    {".x", "a.x * c.x + c.y * d.y", 1, 0, 0}, /* the sum takes the product in that counts */
    {".x", "a.x * b.x + c.y * d.y", 1, 0, 0},
    {".x", "a.x / c.x", 1, 0, 0}, /* times its reciprocal */
    {".x", "c.x / a.x", 1, 1, 0},
    {".x", "float(i.x / k.x)", 38, 1, 0},
    {".xy", "vec2(textureSize(s, 0))", 0, 0, 0},
    {".xy", "a.xy * vec2(textureSize(s, 0) - 1)", 2, 0, 0},
    {".x", "a.x + textureLod(s, c.xy, 0.0).x * 2.0", 1, 0, 1}, /* an operation on an image always counts */
    {".x", "mix(c.y, c.z, a.x < c.x) + 1.0", 3, 0, 0},         /* which one is an invocation's own */
    {".x", "(a.x < c.x ? c.y : c.z) + 1.0", 2, 0, 0}, /* so it is of two branches: a comparison and a sum */
};

static void test_expressions(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t i = 0; i < AOB_COUNT(known); i++)
        for (int client = AOB_GLSL_VULKAN; client <= AOB_GLSL_OPENGL; client++) {
            struct aob_operations sum;
            struct aob_error error = {""};
            if (!count(known[i].type, known[i].expression, (enum aob_glsl_client)client, &sum, &error))
                fail_msg("%s: %s", known[i].expression, error.text);
            if (sum.alu != known[i].alu || sum.special != known[i].special || sum.image != known[i].image)
                wrong += printf("%s, client %d: alu %.0f, special %.0f, image %.0f\n", known[i].expression,
                                client, sum.alu, sum.special, sum.image);
        }
    assert_int_equal(wrong, 0);
}

static void test_what_is_not_in_the_table(void **state)
{
    (void)state;
    struct aob_operations sum;
    struct aob_error error = {""};
    assert_false(count(".x", "determinant(m)", AOB_GLSL_VULKAN, &sum, &error));
    assert_string_equal(error.text, "instruction 33 of GLSL.std.450 cannot be counted: it has no row in "
                                    "shader/operation.c");
    assert_false(count(".x", "(m * m)[0][0]", AOB_GLSL_VULKAN, &sum, &error));
    assert_string_equal(error.text,
                        "instruction 146 of SPIR-V cannot be counted: it has no row in shader/operation.c");
}

static void assemble(const char *text, spv_binary *binary)
{
    spv_context context = spvContextCreate(SPV_ENV_UNIVERSAL_1_5);
    assert_int_equal(spvTextToBinaryWithOptions(context, text, strlen(text),
                                                SPV_TEXT_TO_BINARY_OPTION_PRESERVE_NUMERIC_IDS, binary, NULL),
                     SPV_SUCCESS);
    spvContextDestroy(context);
}

/* %1 is a product, and 1 is the number of a component that another instruction takes. */
static const char literal[] = "OpCapability Shader\n"
                              "OpMemoryModel Logical GLSL450\n"
                              "OpEntryPoint Fragment %10 \"main\" %11 %24\n"
                              "OpExecutionMode %10 OriginUpperLeft\n"
                              "%12 = OpTypeVoid\n"
                              "%13 = OpTypeFunction %12\n"
                              "%14 = OpTypeFloat 32\n"
                              "%15 = OpTypeVector %14 2\n"
                              "%16 = OpTypePointer Output %14\n"
                              "%11 = OpVariable %16 Output\n"
                              "%23 = OpTypePointer Input %15\n"
                              "%24 = OpVariable %23 Input\n"
                              "%17 = OpConstant %14 3\n"
                              "%10 = OpFunction %12 None %13\n"
                              "%19 = OpLabel\n"
                              "%18 = OpLoad %15 %24\n"
                              "%25 = OpCompositeExtract %14 %18 0\n"
                              "%1 = OpFMul %14 %25 %17\n"
                              "%20 = OpFAdd %14 %1 %17\n"
                              "%21 = OpCompositeExtract %14 %18 1\n"
                              "%22 = OpFAdd %14 %20 %21\n"
                              "OpStore %11 %22\n"
                              "OpReturn\n"
                              "OpFunctionEnd\n";

static void test_literals_are_no_values(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_spirv spirv;
    struct aob_blocks blocks;
    spv_binary binary = NULL;
    assemble(literal, &binary);
    assert_true(aob_spirv_init(&spirv, binary->code, binary->wordCount, &error));
    assert_true(aob_blocks_init(&blocks, &spirv, &error));
    assert_true(sum_of(&blocks).alu == 2); /* the product is part of the sum that alone uses it */
    aob_blocks_finish(&blocks);
    aob_spirv_finish(&spirv);
    spvBinaryDestroy(binary);
}

/* Instruction 4 of GLSL.std.450 is an absolute value, and free. */
static const char other_set[] = "OpCapability Shader\n"
                                "%2 = OpExtInstImport \"OpenCL.std\"\n"
                                "OpMemoryModel Logical GLSL450\n"
                                "OpEntryPoint Fragment %10 \"main\" %11\n"
                                "OpExecutionMode %10 OriginUpperLeft\n"
                                "%12 = OpTypeVoid\n"
                                "%13 = OpTypeFunction %12\n"
                                "%14 = OpTypeFloat 32\n"
                                "%16 = OpTypePointer Output %14\n"
                                "%11 = OpVariable %16 Output\n"
                                "%17 = OpConstant %14 3\n"
                                "%10 = OpFunction %12 None %13\n"
                                "%19 = OpLabel\n"
                                "%20 = OpExtInst %14 %2 asinh %17\n"
                                "OpStore %11 %20\n"
                                "OpReturn\n"
                                "OpFunctionEnd\n";

static void test_another_set(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_spirv spirv;
    struct aob_blocks blocks;
    spv_binary binary = NULL;
    assemble(other_set, &binary);
    assert_true(aob_spirv_init(&spirv, binary->code, binary->wordCount, &error));
    assert_false(aob_blocks_init(&blocks, &spirv, &error));
    assert_string_equal(error.text,
                        "instruction 4 of OpenCL.std cannot be counted: of the sets of instructions "
                        "only GLSL.std.450 has a table");
    aob_spirv_finish(&spirv);
    spvBinaryDestroy(binary);
}

static void test_words_that_are_not_valid(void **state)
{
    (void)state;
    size_t count;
    char why[64] = "";
    const uint32_t words[] = {0x07230203, 0x00010500, 0,
                              1,          0,          1}; /* a head, and an instruction of no words */
    assert_null(aob_shader_optimise(words, AOB_COUNT(words), &count, why, sizeof why));
    assert_contains(why, "Invalid instruction word count");
}

/* Words that are cut anywhere are no module, or one of fewer functions; none is read beyond its end. */
static void test_cut_words(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_spirv spirv;
    size_t size;
    uint32_t *words = aob_glsl_compile("layout(location = 0) out float o;\nvoid main() { o = 1.0; }\n",
                                       AOB_GLSL_FRAGMENT, AOB_GLSL_VULKAN, &size, &error);
    for (size_t cut = 0; cut < size; cut++) {
        uint32_t *part = AOB_NEW_ARRAY(uint32_t, cut + 1);
        memcpy(part, words, 4 * cut);
        if (aob_spirv_init(&spirv, part, cut, &error))
            aob_spirv_finish(&spirv);
        free(part);
    }
    free(words);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_expressions),
                                       cmocka_unit_test(test_what_is_not_in_the_table),
                                       cmocka_unit_test(test_literals_are_no_values),
                                       cmocka_unit_test(test_another_set),
                                       cmocka_unit_test(test_words_that_are_not_valid),
                                       cmocka_unit_test(test_cut_words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

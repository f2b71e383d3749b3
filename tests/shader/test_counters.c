/* Counters within a module that was written by hand: it stays valid, wherever its blocks begin. */
#include "check.h"
#include <spirv-tools/libspirv.h>
#include <stdlib.h>
#include <string.h>
#include "shader/counters.h"

/* A block that begins with the marks of lines, between which a value comes from other blocks. */
static const char lines[] = "OpCapability Shader\n"
                            "OpMemoryModel Logical GLSL450\n"
                            "OpEntryPoint Fragment %main \"main\" %out\n"
                            "OpExecutionMode %main OriginUpperLeft\n"
                            "%file = OpString \"a.glsl\"\n"
                            "OpDecorate %out Location 0\n"
                            "%void = OpTypeVoid\n"
                            "%none = OpTypeFunction %void\n"
                            "%float = OpTypeFloat 32\n"
                            "%bool = OpTypeBool\n"
                            "%pointer = OpTypePointer Output %float\n"
                            "%out = OpVariable %pointer Output\n"
                            "%true = OpConstantTrue %bool\n"
                            "%a = OpConstant %float 1\n"
                            "%b = OpConstant %float 2\n"
                            "%main = OpFunction %void None %none\n"
                            "%first = OpLabel\n"
                            "OpSelectionMerge %last None\n"
                            "OpBranchConditional %true %middle %last\n"
                            "%middle = OpLabel\n"
                            "OpBranch %last\n"
                            "%last = OpLabel\n"
                            "OpLine %file 1 1\n"
                            "%x = OpPhi %float %a %first %b %middle\n"
                            "OpNoLine\n"
                            "%y = OpPhi %float %b %first %a %middle\n"
                            "%sum = OpFAdd %float %x %y\n"
                            "OpStore %out %sum\n"
                            "OpReturn\n"
                            "OpFunctionEnd\n";

static void assert_valid(spv_context context, const uint32_t *words, size_t count)
{
    spv_const_binary_t binary = {words, count};
    spv_diagnostic why = NULL;
    if (spvValidate(context, &binary, &why) != SPV_SUCCESS)
        fail_msg("%s", why ? why->error : "not valid");
    spvDiagnosticDestroy(why);
}

static void test_marks_of_lines(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_spirv spirv;
    size_t count = 0;
    spv_binary binary = NULL;
    spv_context context = spvContextCreate(SPV_ENV_VULKAN_1_3);
    assert_int_equal(spvTextToBinary(context, lines, strlen(lines), &binary, NULL), SPV_SUCCESS);
    assert_valid(context, binary->code, binary->wordCount);
    assert_true(aob_spirv_init(&spirv, binary->code, binary->wordCount, &error));
    uint32_t *words = aob_counters_insert(&spirv, 0, &count);
    assert_true(count > binary->wordCount);
    assert_valid(context, words, count);
    free(words);
    aob_spirv_finish(&spirv);
    spvBinaryDestroy(binary);
    spvContextDestroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_marks_of_lines)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

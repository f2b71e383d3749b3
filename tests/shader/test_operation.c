/* The table's numbers are those of the names that stand beside them, by SPIRV-Tools and by Khronos' list. */
#include "check.h"
#include <glslang/SPIRV/GLSL.std.450.h>
#include <spirv-tools/libspirv.h>
#include <string.h>
#include "base/memory.h"
#include "shader/operation.h"

static void test_instructions(void **state)
{
    (void)state;
    for (size_t i = 0; i < aob_operations_count; i++) {
        const struct aob_operation *row = &aob_operations[i];
        assert_string_equal(row->name + 2, spvOpcodeString(row->number)); /* without "Op" */
        assert_ptr_equal(aob_operation_find(row->number), row);
    }
}

static const struct {
    const char *name;
    int number;
} extended[] = {
#define ROW(name)                                                                                            \
    {                                                                                                        \
#name, GLSLstd450##name                                                                              \
    }
    ROW(Round),  ROW(RoundEven),   ROW(Trunc),    ROW(FAbs),     ROW(SAbs),         ROW(FSign),
    ROW(SSign),  ROW(Floor),       ROW(Ceil),     ROW(Fract),    ROW(Radians),      ROW(Degrees),
    ROW(Sin),    ROW(Cos),         ROW(Tan),      ROW(Asin),     ROW(Acos),         ROW(Atan),
    ROW(Atan2),  ROW(Pow),         ROW(Exp),      ROW(Log),      ROW(Exp2),         ROW(Log2),
    ROW(Sqrt),   ROW(InverseSqrt), ROW(FMin),     ROW(UMin),     ROW(SMin),         ROW(FMax),
    ROW(UMax),   ROW(SMax),        ROW(FClamp),   ROW(UClamp),   ROW(SClamp),       ROW(FMix),
    ROW(Step),   ROW(SmoothStep),  ROW(Fma),      ROW(Ldexp),    ROW(PackHalf2x16), ROW(UnpackHalf2x16),
    ROW(Cross),  ROW(FindILsb),    ROW(FindSMsb), ROW(FindUMsb), ROW(NMin),         ROW(NMax),
    ROW(NClamp),
#undef ROW
};

static void test_extended_instructions(void **state)
{
    (void)state;
    assert_int_equal(aob_operations_extended_count, AOB_COUNT(extended));
    for (size_t i = 0; i < AOB_COUNT(extended); i++) {
        const struct aob_operation *row = aob_operation_find_extended((uint32_t)extended[i].number);
        assert_non_null(row);
        assert_string_equal(row->name, extended[i].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_instructions),
                                       cmocka_unit_test(test_extended_instructions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

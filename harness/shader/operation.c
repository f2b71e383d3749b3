#include "operation.h"
#include "base/memory.h"

const struct aob_operation aob_operations[] = {
    /* Of functions, blocks and variables: no slots. What decides a branch has been counted as a comparison. */
    {56, "OpFunctionEnd", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {8, "OpLine", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {317, "OpNoLine", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {252, "OpKill", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {253, "OpReturn", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {255, "OpUnreachable", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {4416, "OpTerminateInvocation", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {248, "OpLabel", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {249, "OpBranch", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {246, "OpLoopMerge", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {247, "OpSelectionMerge", .alu = 0, .no_result = true, .ids = AOB_NO_IDS},
    {54, "OpFunction", .alu = 0, .ids = AOB_NO_IDS},
    {55, "OpFunctionParameter", .alu = 0, .ids = AOB_NO_IDS},
    {250, "OpBranchConditional", .alu = 0, .no_result = true, .ids = 1},
    {251, "OpSwitch", .alu = 0, .no_result = true, .ids = 1},
    {254, "OpReturnValue", .alu = 0, .no_result = true, .ids = 1},
    {57, "OpFunctionCall", .alu = 0},
    {59, "OpVariable", .alu = 0, .ids = AOB_NO_IDS},
    /* Loads, stores and addresses: uniforms, inputs and outputs lie in registers. */
    {61, "OpLoad", .alu = 0, .ids = 1},
    {62, "OpStore", .alu = 0, .no_result = true, .ids = 2},
    {65, "OpAccessChain", .alu = 0},
    {66, "OpInBoundsAccessChain", .alu = 0},
    /* Registers by other names. */
    {1, "OpUndef", .alu = 0, .ids = AOB_NO_IDS},
    {245, "OpPhi", .alu = 0},
    {79, "OpVectorShuffle", .alu = 0, .ids = 2},
    {80, "OpCompositeConstruct", .alu = 0},
    {81, "OpCompositeExtract", .alu = 0, .ids = 1},
    {82, "OpCompositeInsert", .alu = 0, .ids = 2},
    {83, "OpCopyObject", .alu = 0},
    {84, "OpTranspose", .alu = 0},
    {124, "OpBitcast", .alu = 0},
    {400, "OpCopyLogical", .alu = 0},
    /* A modifier of the instruction that uses it. */
    {127, "OpFNegate", .alu = 0},
    /* Masks of lanes, which are combined beside the full-rate unit or within the comparison. */
    {154, "OpAny", .alu = 0},
    {155, "OpAll", .alu = 0},
    {164, "OpLogicalEqual", .alu = 0},
    {165, "OpLogicalNotEqual", .alu = 0},
    {166, "OpLogicalOr", .alu = 0},
    {167, "OpLogicalAnd", .alu = 0},
    {168, "OpLogicalNot", .alu = 0},
    /* Images. The size of one is in its descriptor. */
    {86, "OpSampledImage", .alu = 0},
    {100, "OpImage", .alu = 0},
    {103, "OpImageQuerySizeLod", .alu = 0},
    {104, "OpImageQuerySize", .alu = 0},
    {106, "OpImageQueryLevels", .alu = 0},
    {87, "OpImageSampleImplicitLod", .image = 1, .per = AOB_PER_INSTRUCTION, .ids = 2, .more = true},
    {88, "OpImageSampleExplicitLod", .image = 1, .per = AOB_PER_INSTRUCTION, .ids = 2, .more = true},
    {95, "OpImageFetch", .image = 1, .per = AOB_PER_INSTRUCTION, .ids = 2, .more = true},
    {96, "OpImageGather", .image = 1, .per = AOB_PER_INSTRUCTION, .ids = 3, .more = true},
    {98, "OpImageRead", .image = 1, .per = AOB_PER_INSTRUCTION, .ids = 2, .more = true},
    /* Full rate, one slot a component. */
    {109, "OpConvertFToU", .alu = 1},
    {110, "OpConvertFToS", .alu = 1},
    {111, "OpConvertSToF", .alu = 1},
    {112, "OpConvertUToF", .alu = 1},
    {126, "OpSNegate", .alu = 1},
    {128, "OpIAdd", .alu = 1},
    {129, "OpFAdd", .alu = 1},
    {130, "OpISub", .alu = 1},
    {131, "OpFSub", .alu = 1},
    {133, "OpFMul", .alu = 1},
    {142, "OpVectorTimesScalar", .alu = 1},
    {143, "OpMatrixTimesScalar", .alu = 1},
    {156, "OpIsNan", .alu = 1},
    {157, "OpIsInf", .alu = 1},
    {169, "OpSelect", .alu = 1},
    {170, "OpIEqual", .alu = 1},
    {171, "OpINotEqual", .alu = 1},
    {172, "OpUGreaterThan", .alu = 1},
    {173, "OpSGreaterThan", .alu = 1},
    {174, "OpUGreaterThanEqual", .alu = 1},
    {175, "OpSGreaterThanEqual", .alu = 1},
    {176, "OpULessThan", .alu = 1},
    {177, "OpSLessThan", .alu = 1},
    {178, "OpULessThanEqual", .alu = 1},
    {179, "OpSLessThanEqual", .alu = 1},
    {180, "OpFOrdEqual", .alu = 1},
    {181, "OpFUnordEqual", .alu = 1},
    {182, "OpFOrdNotEqual", .alu = 1},
    {183, "OpFUnordNotEqual", .alu = 1},
    {184, "OpFOrdLessThan", .alu = 1},
    {185, "OpFUnordLessThan", .alu = 1},
    {186, "OpFOrdGreaterThan", .alu = 1},
    {187, "OpFUnordGreaterThan", .alu = 1},
    {188, "OpFOrdLessThanEqual", .alu = 1},
    {189, "OpFUnordLessThanEqual", .alu = 1},
    {190, "OpFOrdGreaterThanEqual", .alu = 1},
    {191, "OpFUnordGreaterThanEqual", .alu = 1},
    {194, "OpShiftRightLogical", .alu = 1},
    {195, "OpShiftRightArithmetic", .alu = 1},
    {196, "OpShiftLeftLogical", .alu = 1},
    {197, "OpBitwiseOr", .alu = 1},
    {198, "OpBitwiseXor", .alu = 1},
    {199, "OpBitwiseAnd", .alu = 1},
    {200, "OpNot", .alu = 1},
    {201, "OpBitFieldInsert", .alu = 1},
    {202, "OpBitFieldSExtract", .alu = 1},
    {203, "OpBitFieldUExtract", .alu = 1},
    {204, "OpBitReverse", .alu = 1},
    {205, "OpBitCount", .alu = 1},
    {207, "OpDPdx", .alu = 1},
    {208, "OpDPdy", .alu = 1},
    /* A component of a product of vectors, a multiplication or addition to it. */
    {148, "OpDot", .alu = 1, .per = AOB_PER_OPERAND},
    {144, "OpVectorTimesMatrix", .alu = 1, .per = AOB_PER_ELEMENT},
    {145, "OpMatrixTimesVector", .alu = 1, .per = AOB_PER_ELEMENT},
    /* A component by its number is chosen. */
    {77, "OpVectorExtractDynamic", .alu = 1, .per = AOB_PER_OPERAND},
    /* A product of whole numbers of 32 bits runs at a quarter of the rate. */
    {132, "OpIMul", .alu = 4, .constant = AOB_CONSTANT_WHOLE, .by_power = 1, .by_constant = 4},
    /* A reciprocal and a product. */
    {136, "OpFDiv", .alu = 1, .special = 1, .constant = AOB_CONSTANT_FLOAT, .by_constant = 1},
    /* x - y floor(x / y), or with trunc. */
    {141, "OpFMod", .alu = 3, .special = 1},
    {140, "OpFRem", .alu = 3, .special = 1},
    /* An estimate of the reciprocal, two refinements and the signs, as Mesa's nir_lower_idiv.c and LLVM's AMDGPU do. By a constant: shifts,
     * or the upper half of a product (Granlund, Montgomery: Division by Invariant Integers using Multiplication, 1994). */
    {134, "OpUDiv", .alu = 30, .special = 1, .constant = AOB_CONSTANT_WHOLE, .by_power = 1, .by_constant = 6},
    {137, "OpUMod", .alu = 28, .special = 1, .constant = AOB_CONSTANT_WHOLE, .by_power = 1,
     .by_constant = 11},
    {135, "OpSDiv", .alu = 37, .special = 1, .constant = AOB_CONSTANT_WHOLE, .by_power = 4, .by_constant = 8},
    {138, "OpSRem", .alu = 33, .special = 1, .constant = AOB_CONSTANT_WHOLE, .by_power = 5,
     .by_constant = 13},
    {139, "OpSMod", .alu = 38, .special = 1, .constant = AOB_CONSTANT_WHOLE, .by_power = 1,
     .by_constant = 16},
    /* GLSL.std.450: aob_operations_extended has its slots. */
    {12, "OpExtInst", .alu = 0, .ids = 1, .more = true},
};
const size_t aob_operations_count = AOB_COUNT(aob_operations);

const struct aob_operation aob_operations_extended[] = {
    /* A modifier of the instruction that uses it. */
    {4, "FAbs", .alu = 0},
    /* Full rate. */
    {1, "Round", .alu = 1},
    {2, "RoundEven", .alu = 1},
    {3, "Trunc", .alu = 1},
    {5, "SAbs", .alu = 1},
    {8, "Floor", .alu = 1},
    {9, "Ceil", .alu = 1},
    {10, "Fract", .alu = 1},
    {11, "Radians", .alu = 1},
    {12, "Degrees", .alu = 1},
    {37, "FMin", .alu = 1},
    {38, "UMin", .alu = 1},
    {39, "SMin", .alu = 1},
    {40, "FMax", .alu = 1},
    {41, "UMax", .alu = 1},
    {42, "SMax", .alu = 1},
    {50, "Fma", .alu = 1},
    {53, "Ldexp", .alu = 1},
    {73, "FindILsb", .alu = 1},
    {74, "FindSMsb", .alu = 1},
    {75, "FindUMsb", .alu = 1},
    {79, "NMin", .alu = 1},
    {80, "NMax", .alu = 1},
    /* Two comparisons and a difference; a minimum and a maximum; a comparison and a selection; a difference and a product. */
    {6, "FSign", .alu = 3},
    {7, "SSign", .alu = 2},
    {43, "FClamp", .alu = 2, .constant = AOB_CONSTANT_RANGE},
    {44, "UClamp", .alu = 2},
    {45, "SClamp", .alu = 2},
    {81, "NClamp", .alu = 2, .constant = AOB_CONSTANT_RANGE},
    {48, "Step", .alu = 2},
    {46, "FMix", .alu = 2},
    /* Quarter rate. */
    {13, "Sin", .special = 1},
    {14, "Cos", .special = 1},
    {29, "Exp2", .special = 1},
    {30, "Log2", .special = 1},
    {31, "Sqrt", .special = 1},
    {32, "InverseSqrt", .special = 1},
    /* Sine over cosine; e and its logarithm through 2; a logarithm, a product and a power. */
    {15, "Tan", .alu = 1, .special = 3},
    {27, "Exp", .alu = 1, .special = 1},
    {28, "Log", .alu = 1, .special = 1},
    {26, "Pow", .alu = 1, .special = 2},
    /* (x - a) / (b - a), then t t (3 - 2 t). */
    {49, "SmoothStep", .alu = 6, .special = 1},
    /* As the reference implementations of NVIDIA's Cg Toolkit 3.1, which are formulas of Abramowitz and Stegun. */
    {16, "Asin", .alu = 8, .special = 1},
    {17, "Acos", .alu = 9, .special = 1},
    {18, "Atan", .alu = 15, .special = 1},
    {25, "Atan2", .alu = 18, .special = 1},
    /* A product, and a product and a difference of it. */
    {68, "Cross", .alu = 2},
    /* A conversion of two, or to two. */
    {58, "PackHalf2x16", .alu = 1},
    {62, "UnpackHalf2x16", .alu = 1},
};
const size_t aob_operations_extended_count = AOB_COUNT(aob_operations_extended);

static const struct aob_operation *find(const struct aob_operation *table, size_t count, uint32_t number)
{
    for (size_t i = 0; i < count; i++)
        if (table[i].number == number)
            return &table[i];
    return NULL;
}

const struct aob_operation *aob_operation_find(uint32_t op)
{
    return find(aob_operations, aob_operations_count, op);
}

const struct aob_operation *aob_operation_find_extended(uint32_t number)
{
    return find(aob_operations_extended, aob_operations_extended_count, number);
}

uint32_t aob_operation_value(const struct aob_operation *operation, uint32_t length, uint32_t index)
{
    uint32_t ids = operation->ids == AOB_NO_IDS ? 0 : operation->ids, word = operation->no_result ? 1 : 3;
    word += index;
    if (operation->ids && index >= ids)
        word = operation->more ? word + 1 : length; /* behind the literal */
    return word < length ? word : 0;
}

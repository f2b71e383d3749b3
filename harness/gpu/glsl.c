#include "glsl.h"
#include "base/memory.h"
#include "base/text.h"
#include "gpu/texts.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>

const char *const aob_glsl_screen_triangle = aob_text_gpu_screen_triangle;

static const char *const prefix[] = {
    [AOB_GLSL_VULKAN] = "#version 450\n#extension GL_EXT_control_flow_attributes : require\n"
                        "#define BIND(n) set = 0, binding = n\n"
                        "#define BIND_STORAGE set = 0, binding = 32\n"
                        "#define VERTEX_ID gl_VertexIndex\n",
    [AOB_GLSL_OPENGL] = "#version 450\n#extension GL_EXT_control_flow_attributes : require\n"
                        "#define BIND(n) binding = n\n"
                        "#define BIND_STORAGE binding = 0\n"
                        "#define VERTEX_ID gl_VertexID\n",
};

static const char *const stage_names[] = {[AOB_GLSL_VERTEX] = "vertex", [AOB_GLSL_FRAGMENT] = "fragment"};

static const glslang_stage_t stages[] = {
    [AOB_GLSL_VERTEX] = GLSLANG_STAGE_VERTEX,
    [AOB_GLSL_FRAGMENT] = GLSLANG_STAGE_FRAGMENT,
};

static void start_glslang(void)
{
    glslang_initialize_process();
}

static glslang_input_t describe_input(const char *code, enum aob_glsl_stage stage,
                                      enum aob_glsl_client client)
{
    bool vulkan = client == AOB_GLSL_VULKAN;
    int messages = GLSLANG_MSG_DEFAULT_BIT | GLSLANG_MSG_SPV_RULES_BIT;
    return (glslang_input_t){
        .language = GLSLANG_SOURCE_GLSL,
        .stage = stages[stage],
        .client = vulkan ? GLSLANG_CLIENT_VULKAN : GLSLANG_CLIENT_OPENGL,
        .client_version = vulkan ? GLSLANG_TARGET_VULKAN_1_3 : GLSLANG_TARGET_OPENGL_450,
        .target_language = GLSLANG_TARGET_SPV,
        .target_language_version = vulkan ? GLSLANG_TARGET_SPV_1_5 : GLSLANG_TARGET_SPV_1_0,
        .code = code,
        .default_version = 450,
        .default_profile = GLSLANG_CORE_PROFILE,
        .messages = messages | (vulkan ? GLSLANG_MSG_VULKAN_RULES_BIT : 0),
        .resource = glslang_default_resource(),
    };
}

/* glslang writes "ERROR: 0:12: why", a line each; string 0 is the whole text and need not be named. */
static void fail_with_log(struct aob_error *error, enum aob_glsl_stage stage, const char *log)
{
    static const char mark[] = "ERROR: ";
    const char *found = log ? strstr(log, mark) : NULL;
    const char *line = found ? found + strlen(mark) : log && *log ? log : "glslang gives no reason";
    bool numbered = found && !strncmp(line, "0:", 2);
    line += numbered ? 2 : 0;
    size_t size = strcspn(line, "\r\n");
    while (size && line[size - 1] == ' ')
        size--;
    aob_fail(error, "%s shader, %s%.*s", stage_names[stage], numbered ? "line " : "", (int)size, line);
}

static uint32_t *generate(glslang_program_t *program, enum aob_glsl_stage stage, size_t *word_count)
{
    glslang_spv_options_t options = {.disable_optimizer = true};
    glslang_program_SPIRV_generate_with_options(program, stages[stage], &options);
    *word_count = glslang_program_SPIRV_get_size(program);
    uint32_t *words = AOB_NEW_ARRAY(uint32_t, *word_count);
    glslang_program_SPIRV_get(program, words);
    return words;
}

static uint32_t *compile(const char *code, enum aob_glsl_stage stage, enum aob_glsl_client client,
                         size_t *word_count, struct aob_error *error)
{
    glslang_input_t input = describe_input(code, stage, client);
    glslang_shader_t *shader = glslang_shader_create(&input);
    glslang_program_t *program = glslang_program_create();
    uint32_t *words = NULL;
    if (!glslang_shader_preprocess(shader, &input) || !glslang_shader_parse(shader, &input)) {
        fail_with_log(error, stage, glslang_shader_get_info_log(shader));
        goto done;
    }
    glslang_program_add_shader(program, shader);
    if (glslang_program_link(program, (int)input.messages))
        words = generate(program, stage, word_count);
    else
        fail_with_log(error, stage, glslang_program_get_info_log(program));
done:
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    return words;
}

uint32_t *aob_glsl_compile(const char *text, enum aob_glsl_stage stage, enum aob_glsl_client client,
                           size_t *word_count, struct aob_error *error)
{
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, start_glslang);
    struct aob_text code = {0};
    aob_text_add(&code, "%s%s#line 1\n%s", prefix[client], aob_text_gpu_arithmetic, text);
    uint32_t *words = compile(code.data, stage, client, word_count, error);
    aob_text_finish(&code);
    return words;
}

enum {
    HEADER_WORDS = 5,
    OP_TYPE_POINTER = 32,
    OP_VARIABLE = 59,
    OP_DECORATE = 71,
    DECORATION_BUFFER_BLOCK = 3,
    DECORATION_BINDING = 33,
    CLASS_STORAGE_BUFFER = 12,
};

/* Of an instruction of at least three operands, the operand `index` of the first whose operand `match` is `value`; 0:
 * there is none, and no id is 0. */
static uint32_t find_operand(const uint32_t *words, size_t word_count, uint32_t op, size_t match,
                             uint32_t value, size_t index)
{
    for (size_t at = HEADER_WORDS; at < word_count && words[at] >> 16; at += words[at] >> 16)
        if ((words[at] & 0xffff) == op && at + 3 < word_count && words[at + match] == value)
            return words[at + index];
    return 0;
}

/* The variable that is a storage buffer: by its class, or in SPIR-V 1.0 by a decoration of its type. 0: there is none. */
static uint32_t find_storage(const uint32_t *words, size_t word_count)
{
    uint32_t variable = find_operand(words, word_count, OP_VARIABLE, 3, CLASS_STORAGE_BUFFER, 2);
    uint32_t block = find_operand(words, word_count, OP_DECORATE, 2, DECORATION_BUFFER_BLOCK, 1);
    uint32_t pointer = block ? find_operand(words, word_count, OP_TYPE_POINTER, 3, block, 1) : 0;
    return pointer ? find_operand(words, word_count, OP_VARIABLE, 1, pointer, 2) : variable;
}

uint64_t aob_glsl_bindings(const uint32_t *words, size_t word_count)
{
    uint64_t bindings = 0;
    uint32_t storage = find_storage(words, word_count);
    for (size_t at = HEADER_WORDS; at < word_count && words[at] >> 16; at += words[at] >> 16) {
        bool is_binding =
            (words[at] & 0xffff) == OP_DECORATE && at + 3 < word_count && words[at + 2] == DECORATION_BINDING;
        if (is_binding && words[at + 1] == storage)
            bindings |= (uint64_t)1 << AOB_GLSL_STORAGE;
        else if (is_binding)
            bindings |= (uint64_t)1 << (words[at + 3] < AOB_GLSL_STORAGE ? words[at + 3] : 63);
    }
    return bindings;
}

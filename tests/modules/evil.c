/* Techniques that misbehave, each in its own way: a sweep must name every one and lose nothing else. */
#include <aobudget/technique.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

struct values {
    float radius;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .min = 0.01, .max = 10, .initial = 0.5,
              .doc = "R."),
};
static const struct aob_shader shaders[] = {
    {"black", "void main() { visibility = 0.0; }\n"},
    {"white", "void main() { visibility = 1.0; }\n"},
    {"constant", "void main() { visibility = 0.7; }\n"},
    {"half", "void main() { visibility = float(aob_pixel.x & 1); }\n"},
    {"nan", "void main() { visibility = sqrt(-1.0 - float(aob_pixel.x)); }\n"},
    {"unfinished", "void main() { visibility = \n"},
    {NULL, NULL}};

static bool draw(struct aob_graph *graph, const char *shader)
{
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R16F);
    return aob_pass(graph, .name = "only", .shader = shader,
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

#define EVIL(id, ...)                                                                                        \
    static bool build_##id(struct aob_graph *graph, const void *values)                                      \
    {                                                                                                        \
        (void)values;                                                                                        \
        (void)graph;                                                                                         \
        __VA_ARGS__                                                                                          \
    }                                                                                                        \
    AOB_TECHNIQUE(id, .title = #id, .citation = "tests", .params = params, .param_count = 1,                 \
                  .values_size = sizeof(struct values), .shaders = shaders, .build = build_##id)

static volatile size_t grown;

static void grow(void)
{
    for (char *block; (block = malloc((size_t)1 << 26)); grown++)
        memset(block, 1, (size_t)1 << 26);
    abort();
}

/* To standard error and to where the answers go, in one endless line. */
static void flood(void)
{
    static char block[1 << 20];
    for (memset(block, 'x', sizeof block);
         write(2, block, sizeof block) > 0 && write(3, block, sizeof block) > 0;)
        grown++;
}

/* What is left open and written still works, so it is the cases behind that cannot read their truths. */
static void narrow(void)
{
    struct rlimit none = {4, 4};
    setrlimit(RLIMIT_NOFILE, &none);
}

EVIL(evil_crash, raise(SIGSEGV); return true;);
EVIL(evil_loop, for (;;) grown++; return true;);
EVIL(evil_growth, grow(); return true;);
EVIL(evil_exit, exit(0); return true;);
EVIL(evil_graph, return aob_output(graph, AOB_OUT_VISIBILITY, (aob_tex){77}););
EVIL(evil_black, return draw(graph, "black"););
EVIL(evil_white, return draw(graph, "white"););
EVIL(evil_constant, return draw(graph, "constant"););
EVIL(evil_nan, return draw(graph, "nan"););
EVIL(evil_words, fputs("error: caf\351 \033[1m\n", stderr); abort(););
EVIL(evil_flood, flood(); return true;);
EVIL(evil_folder, return chdir("/") == 0 && draw(graph, "half"););
EVIL(evil_limits, narrow(); return draw(graph, "half"););
EVIL(evil_shader, return draw(graph, "unfinished"););

AOB_MODULE(&aob_technique_evil_crash, &aob_technique_evil_loop, &aob_technique_evil_growth,
           &aob_technique_evil_exit, &aob_technique_evil_graph, &aob_technique_evil_black,
           &aob_technique_evil_white, &aob_technique_evil_constant, &aob_technique_evil_nan,
           &aob_technique_evil_words, &aob_technique_evil_flood, &aob_technique_evil_folder,
           &aob_technique_evil_limits, &aob_technique_evil_shader);

/* A technique whose processes die as they are told: the file that MORTAL names has a letter for each process that comes to
 * build its passes, in the order in which they come: x dies, anything else, or nothing, lives. */
#include <aobudget/technique.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct aob_shader shaders[] = {
    {"stripes", "void main() { visibility = float(aob_pixel.x & 1); }\n"}, {NULL, NULL}};

/* Takes the first letter off. */
static char next_fate(void)
{
    char fates[64] = {0};
    const char *path = getenv("MORTAL");
    FILE *file = path ? fopen(path, "r+") : NULL;
    if (!file)
        return '.';
    size_t size = fread(fates, 1, sizeof fates - 1, file);
    rewind(file);
    fprintf(file, "%s%*s", size ? fates + 1 : "", size ? 1 : 0, "");
    fclose(file);
    return fates[0];
}

static bool build(struct aob_graph *graph, const void *values)
{
    static bool told;
    (void)values;
    if (!told && next_fate() == 'x')
        abort();
    told = true;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R16F);
    return aob_pass(graph, .name = "only", .shader = "stripes",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(mortal, .title = "Dies as it is told", .citation = "tests", .shaders = shaders, .build = build,
              .values_size = 4);
AOB_MODULE(&aob_technique_mortal);

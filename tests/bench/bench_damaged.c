/* What becomes of damaged files: lines ROW VALUE UNIT for ./dev bench. `bench_damaged FILES` damages as many of each
 * kind. A crash of the harness would end this program. */
#include "gbuffer/damaged_captures.h"
#include "scene/damaged_mesh.h"

static void captures(int files, struct damaged_counts *counts)
{
    int kinds = (int)AOB_COUNT(damaged_kinds);
    damaged_captures((files + kinds - 1) / kinds, 99, counts);
}

static const struct kind {
    const char *name;
    void (*run)(int files, struct damaged_counts *counts);
} kinds[] = {{"meshes", damaged_meshes}, {"captures", captures}};

static void print(const char *kind, const char *what, int files)
{
    printf("%s_%s %d files\n", kind, what, files);
}

int main(int argc, char **argv)
{
    int files = argc > 1 ? atoi(argv[1]) : 0;
    for (size_t i = 0; files > 0 && i < AOB_COUNT(kinds); i++) {
        struct damaged_counts c = {0};
        kinds[i].run(files, &c);
        print(kinds[i].name, "files", c.loaded + c.refused);
        print(kinds[i].name, "loaded", c.loaded);
        print(kinds[i].name, "agreed", c.agreed);
        print(kinds[i].name, "late", c.late);
        print(kinds[i].name, "crashed", c.crashed);
        print(kinds[i].name, "faults", c.faults);
    }
    return files <= 0;
}

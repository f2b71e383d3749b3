/* seal_copies FILE FOLDER: copies a sealed file to FOLDER/KEY.exr for each KEY of standard input, each with its own seal. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/sealed.h"

int main(int argc, char **argv)
{
    char key[256], name[512];
    struct aob_error error = {{0}};
    bool ok = argc == 3;
    while (ok && fgets(key, sizeof key, stdin)) {
        key[strcspn(key, "\n")] = '\0';
        snprintf(name, sizeof name, "%s.exr", key);
        char *path = aob_path_join(argv[2], name);
        ok = aob_sealed_copy_unflushed(argv[1], path, &error);
        free(path);
    }
    if (!ok)
        fprintf(stderr, "seal_copies: %s\n", error.text);
    return ok ? 0 : 1;
}

/* Profile files that a test writes into a folder of its own, which goes with the group of tests. */
#ifndef AOB_TESTS_PROFILE_PROFILE_FILE_H
#define AOB_TESTS_PROFILE_PROFILE_FILE_H
#include "check.h"
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "profile/profile.h"

#define FACT(value) "{value: " value ", unverified: made}"

static char folder[] = "/tmp/aobudget-profile-XXXXXX",
            path[64]; /* path: of made.yaml, beside which others may lie */

static void write_beside(const char *name, const char *text)
{
    struct aob_error error = {{0}};
    char *file = aob_path_join(folder, name);
    if (!aob_file_write(file, text, strlen(text), &error))
        fail_msg("%s", error.text);
    free(file);
}

static void write_file(const char *text)
{
    write_beside("made.yaml", text);
}

static int open_folder(void **state)
{
    (void)state;
    bool ok = mkdtemp(folder);
    snprintf(path, sizeof path, "%s/made.yaml", folder);
    return ok ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return system(command);
}
#endif

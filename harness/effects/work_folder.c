#include "work_folder.h"
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>

bool aob_work_folder_create(char path[AOB_WORK_FOLDER], struct aob_error *error)
{
    snprintf(path, AOB_WORK_FOLDER, "/tmp/aobudget-effects-XXXXXX");
    return mkdtemp(path) || aob_fail(error, "%s: cannot create a folder for the frames", path);
}

static int remove_one(const char *path, const struct stat *what, int kind, struct FTW *place)
{
    (void)what;
    (void)kind;
    (void)place;
    return remove(path);
}

void aob_work_folder_remove(const char *path)
{
    nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

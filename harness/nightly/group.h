/* Suspects that are settled together: those of one module and one old build of it, which are measured beside each other; and
 * those of one earlier night, whose images are compared with this night's as both are stored. */
#ifndef AOB_NIGHTLY_GROUP_H
#define AOB_NIGHTLY_GROUP_H
#include "compare/contest.h"
#include "base/table.h"
#include "old_files.h"
#include "start.h"
#include "suspect.h"

struct aob_group {
    char *name;            /* of its folder: "beside/1", "images/1" */
    char *folder;          /* that, below the night's */
    bool beside;           /* measured; else the images are compared as they are stored */
    char *module;          /* of the new build, as the records have it; "": built in */
    char *old;             /* file of the old build; or the folder of the earlier night's run */
    char *old_module;      /* as the records there have it */
    struct aob_table keys; /* of the cases, this night's */
    struct aob_suspect **items;
    size_t count, capacity;
    struct aob_contest contest;
    bool tried, ready; /* aob_group_measure was called; the contest has been read */
};
struct aob_groups {          /* zero it first */
    struct aob_group **list; /* each stays where it is, since a contest points into itself */
    size_t count, capacity;
};

/* The group that is measured of the module of `now` and the old build in a file; made where it is not there. */
struct aob_group *aob_groups_beside(struct aob_groups *groups, const char *night_folder,
                                    const struct aob_point *now, const char *old);
/* The group of images of that module and the earlier night whose run is in the folder `old`, where `before` is of. */
struct aob_group *aob_groups_stored(struct aob_groups *groups, const char *night_folder,
                                    const struct aob_point *now, const struct aob_point *before,
                                    const char *old);
void aob_group_add(struct aob_group *group, struct aob_suspect *suspect);

/* Measures the suspects of a module again beside the old build. Then, of either kind, reads what both sides are. False with
 * the cause; the night goes on without it. */
bool aob_group_measure(struct aob_group *group, const struct aob_nightly_desc *desc, const char *run,
                       struct aob_error *error);

/* Its item for a suspect; NULL: there is none. */
const struct aob_compared *aob_group_item(const struct aob_group *group, const struct aob_suspect *suspect);
void aob_groups_finish(struct aob_groups *groups);
#endif

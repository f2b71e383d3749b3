/* Which figures a report has. */
#ifndef AOB_REPORTS_PAGE_GALLERY_PLAN_H
#define AOB_REPORTS_PAGE_GALLERY_PLAN_H
#include "gallery.h"

/* Decides everything; draws nothing. The rows must outlive the gallery.
 * A section gets, for each target and technique, the triptych, map, split and .vti of the case with the lowest band RMSE
 * against that target among those on the section's backend (backends differ by less than can be seen) of which the run
 * keeps both image and truth; the landscape of the best of them; of each output besides visibility (output_look.h) the
 * pictures and the map of the case that is the nearest to the target in band, where it is the case's own; and a chart of
 * quality. For no target: the charts of
 * time, and the image of each technique that has no score in the section. What is not split has no split. */
void aob_gallery_plan(struct aob_gallery *gallery, const struct aob_rows *rows);

/* Instead of that: the triptychs of so many rows against their own targets (NULLs are passed over), each without its
 * parameters in the subtitle, in `folder`, named after technique, scene and view: "FOLDER/gtao-corner-front.png". */
void aob_gallery_plan_triptychs(struct aob_gallery *gallery, const struct aob_rows *rows,
                                const struct aob_row *const *which, size_t count, const char *folder);
#endif

/* Which figures a report has, and drawing them with aobudget-plot. */
#ifndef AOB_REPORTS_PAGE_GALLERY_H
#define AOB_REPORTS_PAGE_GALLERY_H
#include "rows.h"

enum aob_figure_kind {
    AOB_FIGURE_TRIPTYCH,
    AOB_FIGURE_MAP,
    AOB_FIGURE_SPLIT,
    AOB_FIGURE_HEIGHT,
    AOB_FIGURE_VTI,
    AOB_FIGURE_CHART
};

struct aob_figure {
    enum aob_figure_kind kind;
    size_t section;
    const struct aob_row *row;    /* of an image; NULL for a chart */
    const char *title;            /* within `job` */
    char *file;                   /* relative to the page: "figures/0003-corner-front-gtao.png" */
    char *failure;                /* why there is no such file; NULL: there is */
    json_t *job;                  /* as in figure.h */
    const struct aob_row **front; /* the Pareto set of a quality chart, cheapest first; NULL for others */
    size_t front_count;
};

/* One scene seen in one view, in one run. */
struct aob_section {
    size_t run;
    const char *scene, *view;
};

struct aob_gallery {
    const struct aob_rows *rows;
    const char *folder; /* of the figures, below the page's */
    struct aob_section *sections;
    size_t section_count, section_capacity;
    const char **techniques; /* in the order of the journal: the place is the technique's colour */
    size_t technique_count, technique_capacity;
    struct aob_figure *figures;
    size_t count, capacity;
};

/* Decides everything; draws nothing. The rows must outlive the gallery.
 * A section gets, for each technique, the triptych, map, split and .vti of the case with the lowest band RMSE
 * among those with an image on the first backend (backends differ by less than can be seen); the landscape of
 * the best of them; and the charts of curves.h. What has no score has no map, what is not split no split. */
void aob_gallery_plan(struct aob_gallery *gallery, const struct aob_rows *rows);

/* Instead of that: the triptychs of so many rows (NULLs are passed over), each without its parameters in the subtitle, in
 * `folder`, named after technique, scene and view: "FOLDER/gtao-corner-front.png". */
void aob_gallery_plan_triptychs(struct aob_gallery *gallery, const struct aob_rows *rows,
                                const struct aob_row *const *which, size_t count, const char *folder);

/* Runs `plotter` over all figures, writing below `out`. Every figure that was not drawn gets a failure; so
 * nothing is returned. `plotter` NULL: all fail. */
void aob_gallery_draw(struct aob_gallery *gallery, const char *plotter, const char *out);

void aob_gallery_finish(struct aob_gallery *gallery);

/* A new figure; the gallery takes `job` over and completes it. The file is named after section, `name` and
 * end. */
struct aob_figure *aob_gallery_add(struct aob_gallery *gallery, enum aob_figure_kind kind, size_t section,
                                   const char *name, const char *end, json_t *job);

/* Path of aobudget-plot, beside `program`; NULL if that is NULL or there is none. free() it. */
char *aob_gallery_plotter(const char *program);

/* The place of the row's section or technique in the lists above. */
size_t aob_gallery_section(const struct aob_gallery *gallery, const struct aob_row *row);
size_t aob_gallery_technique(const struct aob_gallery *gallery, const char *name);

/* The backend of the section's first good row. */
const char *aob_gallery_backend(const struct aob_gallery *gallery, size_t section);
#endif

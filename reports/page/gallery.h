/* The figures of a report, and drawing them with aobudget-plot. gallery_plan.h decides which there are. */
#ifndef AOB_REPORTS_PAGE_GALLERY_H
#define AOB_REPORTS_PAGE_GALLERY_H
#include "output_look.h"
#include "rows.h"

enum aob_figure_kind {
    AOB_FIGURE_TRIPTYCH,
    AOB_FIGURE_MAP,
    AOB_FIGURE_SPLIT,
    AOB_FIGURE_HEIGHT,
    AOB_FIGURE_VTI,
    AOB_FIGURE_OUTPUT,     /* an output besides visibility: its pictures, as a triptych */
    AOB_FIGURE_OUTPUT_MAP, /* and where it errs */
    AOB_FIGURE_CHART,
    AOB_FIGURE_CACHE,    /* a chart of cache figures */
    AOB_FIGURE_OVER_TIME /* a chart of a sequence */
};

/* The target of what is compared with no truth. */
#define AOB_NO_TARGET ((size_t)-1)

struct aob_figure {
    enum aob_figure_kind kind;
    size_t section, target;
    const struct aob_row *row;          /* of an image; NULL for a chart */
    const struct aob_score *score;      /* the row's against the target; NULL without one */
    const struct aob_output_look *look; /* NULL: it is of visibility, or a chart */
    const char *title;                  /* within `job` */
    char *file;                         /* relative to the page: "figures/0003-corner-front-gtao.png" */
    char *failure;                      /* why there is no such file; NULL: there is */
    json_t *job;                        /* as in figure.h */
    char *note;                         /* a line below it; NULL: none */
    const struct aob_row **front; /* the Pareto set of a quality chart, cheapest first; NULL for others */
    size_t front_count;
};

/* The figures of one section against one target; or of no target: charts of time, images without a score. */
struct aob_panel {
    size_t section, target;
    size_t first, count; /* of the gallery's figures */
    size_t cases;        /* of the section that have a score against the target */
};

struct aob_gallery {
    const struct aob_rows *rows;
    const char *folder; /* of the figures, below the page's */
    struct aob_panel
        *panels; /* of each section: one for each of the rows' targets, then the one of no target */
    size_t panel_count, panel_capacity;
    struct aob_figure *figures;
    size_t count, capacity;
};

/* Runs `plotter` over all figures, writing below `out`. Every figure that was not drawn gets a failure; so
 * nothing is returned. `plotter` NULL: all fail. */
void aob_gallery_draw(struct aob_gallery *gallery, const char *plotter, const char *out);

void aob_gallery_finish(struct aob_gallery *gallery);

/* A new figure of the panel's section and target; the gallery takes `job` over and completes it. The file is named
 * after section, `name` and end. */
struct aob_figure *aob_gallery_add(struct aob_gallery *gallery, const struct aob_panel *panel,
                                   enum aob_figure_kind kind, const char *name, const char *end, json_t *job);

/* Letters, digits, dashes and _ stay; what else is in a hostile name becomes a dash, in place. */
void aob_gallery_plain_name(char *name);

/* Path of aobudget-plot, beside `program`; NULL if that is NULL or there is none. free() it. */
char *aob_gallery_plotter(const char *program);
#endif

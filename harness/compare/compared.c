#include "compared.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "map_list.h"
#include "plane.h"
#include "quotient.h"
#include "reports/page/gallery.h"

static const char *folder_of(const struct aob_compared_table *table, const struct aob_row *row)
{
    return table->rows->runs[row->run].folder;
}

void aob_compared_cost(struct aob_compared_table *table)
{
    table->items = AOB_NEW_ARRAY(struct aob_compared, table->couples->count + 1);
    for (size_t i = 0; i < table->couples->count; i++) {
        struct aob_compared *item = &table->items[i];
        const struct aob_couple *couple = item->couple = &table->couples->items[i];
        const struct aob_cost_side a = {folder_of(table, couple->a), couple->a->json},
                                   b = {folder_of(table, couple->b), couple->b->json};
        aob_cost_compare(&a, &b, &item->cost, &item->unfit);
    }
}

static void widen(struct aob_compared_table *table, double alpha)
{
    size_t used = 0;
    for (size_t i = 0; i < table->couples->count; i++)
        used += !*table->items[i].unfit.text;
    table->alpha = alpha > 0 ? alpha : aob_compare_alpha(used);
    for (size_t i = 0; i < table->couples->count; i++) {
        struct aob_compared *item = &table->items[i];
        item->wide = aob_widen(&item->cost.cost, item->cost.processes, table->alpha);
    }
}

static struct aob_error_side error_of(const struct aob_score *score)
{
    if (!score)
        return (struct aob_error_side){NAN, NAN, NAN};
    const struct aob_metrics *m = &score->metrics;
    return (struct aob_error_side){m->rmse, m->reference_se, m->band_pixels > 0 ? m->band_pixels : m->pixels};
}

/* Truths are named by what they depend on, rays a pixel included. */
static bool share_truth(const struct aob_score *a, const struct aob_score *b)
{
    return a && b && *a->truth && strcmp(a->truth, b->truth) == 0;
}

/* Both errors against the target of A's own. */
static void find_errors(struct aob_compared *item)
{
    const struct aob_score *a = aob_row_own_score(item->couple->a);
    const struct aob_score *b = a ? aob_row_score(item->couple->b, a->target) : NULL;
    bool one = item->image_read && share_truth(a, b);
    item->errors = (struct aob_error_pair){error_of(a), error_of(b), one ? item->image.rmse : NAN};
}

static bool read_image(const struct aob_compared_table *table, const struct aob_row *row,
                       struct aob_image *image)
{
    if (!*row->image)
        return false;
    char *path = aob_path_join(folder_of(table, row), row->image);
    bool ok = aob_image_read(image, path, NULL);
    free(path);
    return ok;
}

/* "maps/0001-corner-front-gtao" */
static char *map_name(const struct aob_compared *item, size_t at)
{
    const struct aob_row *row = item->couple->a;
    struct aob_text text = {0}, name = {0};
    aob_text_add(&text, "%.40s-%.40s-%.60s", row->scene, row->view, row->name);
    aob_gallery_plain_name(text.data);
    aob_text_add(&name, "maps/%04zu-%s", at, text.data);
    aob_text_finish(&text);
    return name.data;
}

static char *map_path(const struct aob_compared_table *table, const struct aob_compared *item,
                      const char *ending)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s%s", item->map, ending);
    char *path = aob_path_join(table->folder, name.data);
    aob_text_finish(&name);
    return path;
}

/* Also of a second table, which this comparison may not have (compare.c). */
static void discard_maps(const struct aob_compared_table *table)
{
    char *then = aob_path_join(table->folder, "then");
    aob_map_list_discard(table->folder);
    aob_map_list_discard(then);
    free(then);
}

static bool keep_map(const struct aob_compared_table *table, struct aob_compared *item,
                     const struct aob_image *a, const struct aob_image *b, struct aob_error *error)
{
    item->map = map_name(item, (size_t)(item - table->items));
    char *path = map_path(table, item, ".exr");
    bool ok = aob_map_list_add(table->folder, item->map, error) && aob_image_change_write(a, b, path, error);
    free(path);
    return ok;
}

/* By the images where both are kept, else by their digests. What is known of neither cannot be told from a speed-up that
 * changed the picture. */
static bool compare_images(const struct aob_compared_table *table, struct aob_compared *item,
                           struct aob_error *error)
{
    const struct aob_row *rows[2] = {item->couple->a, item->couple->b};
    struct aob_image images[2] = {{0}, {0}};
    bool ok = true;
    if (!aob_row_is_ok(rows[0]) || !aob_row_is_ok(rows[1]))
        return true;
    item->image_read = read_image(table, rows[0], &images[0]) && read_image(table, rows[1], &images[1]) &&
                       aob_image_change_measure(&item->image, &images[0], &images[1], NULL);
    if (item->image_read) {
        ok = !item->image.moved || keep_map(table, item, &images[0], &images[1], error);
    } else {
        const char *a = aob_member_text(rows[0]->json, "image_digest"),
                   *b = aob_member_text(rows[1]->json, "image_digest");
        item->image.moved = *a && *b && strcmp(a, b) != 0;
        if ((!*a || !*b) && !*item->unfit.text)
            aob_fail(&item->unfit, "whether the image changed is not known: the runs keep no images");
    }
    aob_image_finish(&images[0]);
    aob_image_finish(&images[1]);
    return ok;
}

static void judge(const struct aob_compared_table *table, struct aob_compared *item)
{
    item->judgement =
        aob_judge(&(struct aob_comparison){.cost = item->wide,
                                           .lasting = aob_lasting_half_width(&item->cost.cost, table->alpha),
                                           .control = item->cost.control,
                                           .resolution = table->precision,
                                           .rounds = item->cost.rounds,
                                           .processes = item->cost.processes,
                                           .invalid = *item->unfit.text ? item->unfit.text : NULL,
                                           .moved = item->image.moved,
                                           .errors = item->errors,
                                           .elsewhere = *item->blame.text ? item->blame.text : NULL});
}

/* Of what a row's run says of its technique; "": nothing. */
static const char *digest_of(const struct aob_compared_table *table, const struct aob_row *row)
{
    json_t *techniques = json_object_get(table->rows->runs[row->run].info, "techniques"), *technique;
    size_t at;
    json_array_foreach(techniques, at, technique)
    {
        if (aob_row_is_of(row, technique))
            return aob_member_text(technique, "digest");
    }
    return "";
}

/* One key says so, and cases that were only compared with other truths have two. */
static bool same_build(const struct aob_compared_table *table, const struct aob_couple *couple)
{
    const char *a = digest_of(table, couple->a);
    return couple->same_key || (*a && strcmp(a, digest_of(table, couple->b)) == 0);
}

/* Times of one block have a control in their own rounds: nothing but the modules differs there. */
static void find_blame(const struct aob_compared_table *table)
{
    size_t count = table->couples->count;
    struct aob_blame_couple *couples = AOB_NEW_ARRAY(struct aob_blame_couple, count + 1);
    struct aob_blame *blames = AOB_NEW_ARRAY(struct aob_blame, count + 1);
    for (size_t i = 0; i < count; i++) {
        const struct aob_compared *item = &table->items[i];
        couples[i] = (struct aob_blame_couple){item->wide, item->judgement.cost, item->judgement.delta,
                                               same_build(table, item->couple)};
    }
    aob_blame_find(couples, count, table->same_program, blames);
    for (size_t i = 0; i < count; i++) {
        if (table->items[i].cost.paired)
            continue;
        table->items[i].blame = blames[i];
        judge(table, &table->items[i]);
    }
    free(couples);
    free(blames);
}

bool aob_compared_judge(struct aob_compared_table *table, double alpha, struct aob_error *error)
{
    bool ok = true;
    discard_maps(table);
    widen(table, alpha);
    for (size_t i = 0; i < table->couples->count && ok; i++) {
        struct aob_compared *item = &table->items[i];
        ok = compare_images(table, item, error);
        find_errors(item);
        judge(table, item);
    }
    if (ok)
        find_blame(table);
    return ok;
}

void aob_compared_finish(struct aob_compared_table *table)
{
    for (size_t i = 0; table->items && i < table->couples->count; i++)
        free(table->items[i].map);
    free(table->items);
    table->items = NULL;
}

static void add_figure(struct aob_gallery *gallery, const struct aob_compared_table *table,
                       const struct aob_compared *item, bool picture)
{
    const struct aob_image_change *image = &item->image;
    struct aob_text title = {0}, file = {0};
    char *map = map_path(table, item, ".exr");
    aob_row_describe(item->couple->a, &title);
    aob_text_add(&file, "%s%s", item->map, picture ? ".png" : ".vti");
    json_t *job = json_pack(
        "{s:s, s:s, s:o, s:s, s:s, s:s, s:s}", "kind", picture ? "triptych" : "vti", "title", title.data,
        "subtitle",
        json_sprintf("largest difference %.4f \u00b7 RMSE %.4f \u00b7 %.2f %% of pixels by more than 1/255",
                     image->max, image->rmse, 100 * image->share),
        "technique_name", "B", "reference_name", "A", "image", map, "limit_group", item->map);
    *AOB_PUSH(gallery->figures, gallery->count, gallery->capacity) =
        (struct aob_figure){.kind = picture ? AOB_FIGURE_TRIPTYCH : AOB_FIGURE_VTI,
                            .file = file.data,
                            .job = job ? job : json_object()};
    free(map);
    aob_text_finish(&title);
}

void aob_compared_draw(const struct aob_compared_table *table, const char *program)
{
    struct aob_gallery gallery = {.folder = "maps"};
    for (size_t i = 0; i < table->couples->count; i++) {
        if (!table->items[i].map)
            continue;
        add_figure(&gallery, table, &table->items[i], true);
        add_figure(&gallery, table, &table->items[i], false);
    }
    if (aob_plane_any(table) && aob_map_list_add(table->folder, AOB_PLANE_NAME, NULL))
        aob_plane_add(&gallery, table);
    char *plotter = aob_gallery_plotter(program);
    char *maps = aob_path_join(table->folder, "maps");
    if (gallery.count && aob_folder_create(maps, NULL))
        aob_gallery_draw(&gallery, plotter, table->folder);
    for (size_t i = 0; i < gallery.count; i++) {
        if (!gallery.figures[i].failure)
            continue;
        aob_warn("%s/%s: %s; its numbers are in the table and in the .exr files", table->folder,
                 gallery.figures[i].file, gallery.figures[i].failure);
        break;
    }
    free(maps);
    free(plotter);
    aob_gallery_finish(&gallery);
}

enum aob_outcome aob_compared_outcome(const struct aob_compared_table *table)
{
    enum aob_outcome all = AOB_OUTCOME_GOOD;
    for (size_t i = 0; i < table->couples->count; i++) {
        const struct aob_compared *item = &table->items[i];
        enum aob_outcome own = aob_judgement_outcome(&item->judgement, item->blame.excused);
        if (own == AOB_OUTCOME_WORSE)
            return own;
        all = own == AOB_OUTCOME_OPEN ? own : all;
    }
    return all;
}

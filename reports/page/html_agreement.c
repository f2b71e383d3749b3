#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "html.h"
#include "places.h"
#include "store/image.h"

/* What the images of two backends have in common, over all cases that differ in nothing else. */
struct pair {
    const char *a, *b; /* backends, by the alphabet */
    size_t images, unread;
    double largest, squares, pixels;
};
struct agreement {
    const struct aob_rows *rows;
    struct pair *pairs;
    size_t count, capacity;
    json_t *places;
};

/* Cases that differ in nothing but the backend. */
struct twins {
    size_t *rows;
    size_t count, capacity;
};

static struct pair *pair_of(struct agreement *agreement, const char *a, const char *b)
{
    bool turned = strcmp(a, b) > 0;
    const char *first = turned ? b : a, *second = turned ? a : b;
    size_t place = aob_place(agreement->places, json_pack("[s, s]", first, second));
    if (place == agreement->count)
        *AOB_PUSH(agreement->pairs, agreement->count, agreement->capacity) =
            (struct pair){.a = first, .b = second};
    return &agreement->pairs[place];
}

/* A value that is no number in one image only is as far off as can be. */
static void compare(struct pair *pair, const struct aob_image *a, const struct aob_image *b)
{
    const float *p = aob_image_channel(a, "technique.AO"), *q = aob_image_channel(b, "technique.AO");
    if (!p || !q || a->width != b->width || a->height != b->height) {
        pair->unread++;
        return;
    }
    size_t count = (size_t)a->width * (size_t)a->height;
    for (size_t i = 0; i < count; i++) {
        double difference = isnan(p[i]) && isnan(q[i]) ? 0 : fabs((double)p[i] - q[i]);
        if (isnan(difference))
            difference = HUGE_VAL;
        pair->largest = fmax(pair->largest, difference);
        pair->squares += difference * difference;
    }
    pair->images++;
    pair->pixels += (double)count;
}

/* An image that cannot be read has no channels, which compare() says. */
static void read_image(const struct aob_rows *rows, const struct aob_row *row, struct aob_image *image)
{
    struct aob_text path = {0};
    *image = (struct aob_image){0};
    aob_text_add(&path, "%s/%s", rows->runs[row->run].folder, row->image);
    if (!aob_image_read(image, path.data, NULL))
        *image = (struct aob_image){0};
    aob_text_finish(&path);
}

static void compare_twins(struct agreement *agreement, const struct twins *twins)
{
    const struct aob_row *list = agreement->rows->list;
    struct aob_image *images = AOB_NEW_ARRAY(struct aob_image, twins->count);
    for (size_t i = 0; i < twins->count; i++) {
        const struct aob_row *row = &list[twins->rows[i]];
        read_image(agreement->rows, row, &images[i]);
        for (size_t k = 0; k < i; k++)
            if (strcmp(list[twins->rows[k]].backend, row->backend) != 0)
                compare(pair_of(agreement, list[twins->rows[k]].backend, row->backend), &images[k],
                        &images[i]);
    }
    for (size_t i = 0; i < twins->count; i++)
        aob_image_finish(&images[i]);
    free(images);
}

/* `null` draws nothing that another backend could agree with. */
static bool draws(const struct aob_row *row)
{
    return aob_row_is_ok(row) && *row->image && strcmp(row->backend, "null") != 0;
}

/* By the names of scene and view: two backends may have drawn one case in two runs. */
static json_t *identity_of(const struct aob_row *row)
{
    return json_pack("[s, s, s, i, i, O?, O?, O?, O?]", row->scene, row->view, row->technique, row->width,
                     row->height, json_object_get(row->json, "revision"),
                     json_object_get(row->json, "params"), json_object_get(row->json, "options"),
                     json_object_get(row->json, "camera"));
}

static void add_pair(struct aob_text *page, const struct pair *pair)
{
    aob_text_add(page, "<p>");
    aob_html_escape(page, pair->a);
    aob_text_add(page, " and ");
    aob_html_escape(page, pair->b);
    aob_text_add(page, ": %zu pair%s of images", pair->images, pair->images == 1 ? "" : "s");
    if (pair->images)
        aob_text_add(page, ", largest difference %.3g in any pixel, RMS %.3g", pair->largest,
                     sqrt(pair->squares / pair->pixels));
    if (pair->unread)
        aob_text_add(page, "; %zu more could not be read", pair->unread);
    aob_text_add(page, ".</p>\n");
}

static bool has_several_backends(const struct aob_rows *rows)
{
    const struct aob_row *first = NULL;
    for (size_t i = 0; i < rows->count; i++) {
        if (draws(&rows->list[i]) && first && strcmp(first->backend, rows->list[i].backend) != 0)
            return true;
        if (draws(&rows->list[i]) && !first)
            first = &rows->list[i];
    }
    return false;
}

static void compare_all(struct agreement *agreement)
{
    const struct aob_rows *rows = agreement->rows;
    struct twins *twins = NULL;
    size_t count = 0, capacity = 0;
    json_t *identities = json_object();
    for (size_t i = 0; i < rows->count; i++) {
        if (!draws(&rows->list[i]))
            continue;
        size_t place = aob_place(identities, identity_of(&rows->list[i]));
        if (place == count)
            AOB_PUSH(twins, count, capacity);
        *AOB_PUSH(twins[place].rows, twins[place].count, twins[place].capacity) = i;
    }
    for (size_t i = 0; i < count; i++) {
        if (twins[i].count > 1)
            compare_twins(agreement, &twins[i]);
        free(twins[i].rows);
    }
    json_decref(identities);
    free(twins);
}

void aob_html_agreement(struct aob_text *page, const struct aob_rows *rows)
{
    struct agreement agreement = {.rows = rows, .places = json_object()};
    if (has_several_backends(rows)) {
        compare_all(&agreement);
        aob_text_add(page, "<h3>Do the backends agree?</h3>\n%s",
                     agreement.count ? "" : "<p>No two cases differ in the backend alone.</p>\n");
        for (size_t i = 0; i < agreement.count; i++)
            add_pair(page, &agreement.pairs[i]);
    }
    json_decref(agreement.places);
    free(agreement.pairs);
}

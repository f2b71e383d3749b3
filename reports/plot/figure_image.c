#include "figure_image.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

const char *aob_figure_text(const json_t *object, const char *name, const char *otherwise)
{
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : otherwise;
}

static void forget(struct aob_figure_cache *cache, int which)
{
    aob_image_finish(&cache->files[which].image);
    free(cache->files[which].path);
    cache->files[which].path = NULL;
}

void aob_figure_cache_finish(struct aob_figure_cache *cache)
{
    forget(cache, 0);
    forget(cache, 1);
    free(cache->error);
    cache->error = NULL;
}

static const struct aob_image *read_file(struct aob_figure_cache *cache, int which, const char *path,
                                         struct aob_error *error)
{
    if (cache->files[which].path && strcmp(cache->files[which].path, path) == 0)
        return &cache->files[which].image;
    forget(cache, which);
    if (!aob_image_read(&cache->files[which].image, path, error))
        return NULL;
    cache->files[which].path = aob_strdup(path);
    return &cache->files[which].image;
}

/* The sky is not judged: there is no error where Z is infinite. */
static void subtract(const struct aob_figure_image *from, float *error)
{
    const float *z = aob_image_channel(from->image, "Z");
    size_t count = (size_t)from->image->width * (size_t)from->image->height;
    for (size_t i = 0; i < count; i++)
        error[i] = z && isinf(z[i]) ? 0 : from->technique[i] - from->reference[i];
}

static bool take_truth(struct aob_figure_image *from, struct aob_figure_cache *cache, const char *path,
                       struct aob_error *error)
{
    const struct aob_image *truth = read_file(cache, 1, path, error);
    if (!truth)
        return false;
    if (truth->width != from->image->width || truth->height != from->image->height)
        return aob_fail(error, "%s: is %d x %d pixels, the technique's image %d x %d", path, truth->width,
                        truth->height, from->image->width, from->image->height);
    from->reference = aob_image_channel(truth, "AO");
    if (!from->reference)
        return aob_fail(error, "%s: has no channel AO", path);
    from->error = NULL;
    if (from->technique) {
        free(cache->error);
        cache->error = AOB_NEW_ARRAY(float, (size_t)truth->width *(size_t)truth->height);
        subtract(from, cache->error);
        from->error = cache->error;
    }
    return true;
}

bool aob_figure_image_load(struct aob_figure_image *from, struct aob_figure_cache *cache,
                           const json_t *figure, struct aob_error *error)
{
    const char *path = aob_figure_text(figure, "image", NULL);
    const char *truth = aob_figure_text(figure, "reference_image", NULL);
    if (!path)
        return aob_fail(error, "the figure names no image");
    const struct aob_image *image = read_file(cache, 0, path, error);
    if (!image)
        return false;
    *from = (struct aob_figure_image){
        .image = image,
        .technique = aob_image_channel(image, aob_figure_text(figure, "technique", "technique.AO")),
        .reference = aob_image_channel(image, aob_figure_text(figure, "reference", "reference.AO")),
        .error = aob_image_channel(image, aob_figure_text(figure, "error", "error.AO")),
    };
    return !truth || take_truth(from, cache, truth, error);
}

#include "gltf.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"

const size_t aob_gltf_none = SIZE_MAX;

void aob_gltf_init(struct aob_gltf *gltf, const struct aob_gltf_file *file)
{
    *gltf = (struct aob_gltf){.file = file};
    gltf->buffer_count = aob_gltf_count(gltf, "buffers");
    gltf->view_count = aob_gltf_count(gltf, "bufferViews");
    gltf->buffers = AOB_NEW_ARRAY(struct aob_gltf_bytes, gltf->buffer_count + 1);
    gltf->views = AOB_NEW_ARRAY(struct aob_gltf_bytes, gltf->view_count + 1);
}

void aob_gltf_finish(struct aob_gltf *gltf)
{
    for (size_t i = 0; i < gltf->buffer_count; i++)
        free(gltf->buffers[i].owned);
    for (size_t i = 0; i < gltf->view_count; i++)
        free(gltf->views[i].owned);
    free(gltf->buffers);
    free(gltf->views);
    *gltf = (struct aob_gltf){0};
}

size_t aob_gltf_count(const struct aob_gltf *gltf, const char *array)
{
    return json_array_size(json_object_get(gltf->file->root, array));
}

const json_t *aob_gltf_element(const struct aob_gltf *gltf, const char *array, size_t index,
                               struct aob_error *error)
{
    const json_t *element = json_array_get(json_object_get(gltf->file->root, array), index);
    if (json_is_object(element))
        return element;
    if (index == aob_gltf_none)
        aob_fail(error, "%s: an index of its %s is missing: the file is damaged", gltf->file->path, array);
    else
        aob_fail(error, "%s: it names number %zu of its %zu %s: the file is damaged", gltf->file->path, index,
                 aob_gltf_count(gltf, array), array);
    return NULL;
}

struct aob_gltf_label aob_gltf_label(const char *what, size_t index)
{
    struct aob_gltf_label label;
    snprintf(label.text, sizeof label.text, "%s %zu", what, index);
    return label;
}

bool aob_gltf_whole(const struct aob_gltf *gltf, const json_t *object, const char *label, const char *key,
                    size_t fallback, size_t *value, struct aob_error *error)
{
    const json_t *member = json_object_get(object, key);
    double number = member ? json_number_value(member) : -1;
    *value = fallback;
    if (!member)
        return true;
    if (!json_is_number(member) || number < 0 || number != floor(number) ||
        number >= ldexp(1, AOB_GLTF_MAX_WHOLE_BITS))
        return aob_fail(error, "%s: %s: its %s is no whole number: the file is damaged", gltf->file->path,
                        label, key);
    *value = (size_t)number;
    return true;
}

bool aob_gltf_vector(const struct aob_gltf *gltf, const json_t *object, const char *label, const char *key,
                     double *values, size_t count, struct aob_error *error)
{
    const json_t *member = json_object_get(object, key);
    double read[16];
    if (!member)
        return true;
    if (count > AOB_COUNT(read) || !aob_json_to_vector(member, read, count))
        return aob_fail(error, "%s: %s: its %s is not %zu numbers: the file is damaged", gltf->file->path,
                        label, key, count);
    for (size_t i = 0; i < count; i++)
        values[i] = read[i];
    return true;
}

const json_t *aob_gltf_extension(const json_t *object, const char *name)
{
    return json_object_get(json_object_get(object, "extensions"), name);
}

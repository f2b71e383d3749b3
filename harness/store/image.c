#include "image.h"
#include "base/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

float *aob_image_channel(const struct aob_image *image, const char *name)
{
    for (size_t i = 0; i < image->channel_count; i++)
        if (strcmp(image->channels[i].name, name) == 0)
            return image->channels[i].pixels;
    return NULL;
}

float *aob_image_add(struct aob_image *image, const char *name)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    float *old = aob_image_channel(image, name);
    if (old)
        return memset(old, 0, pixels * sizeof *old);
    struct aob_channel *channel = AOB_PUSH(image->channels, image->channel_count, image->channel_capacity);
    snprintf(channel->name, sizeof channel->name, "%s", name);
    channel->pixels = AOB_NEW_ARRAY(float, pixels);
    return channel->pixels;
}

void aob_image_add_part(struct aob_image *image, const char *name, const float *from, size_t stride)
{
    float *channel = aob_image_add(image, name);
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
        channel[i] = from[i * stride];
}

float *aob_image_interleaved(const struct aob_image *image, const char *const *names, size_t count,
                             size_t stride)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t c = 0; c < count; c++)
        if (!aob_image_channel(image, names[c]))
            return NULL;
    float *into = AOB_NEW_ARRAY(float, stride *pixels);
    for (size_t c = 0; c < count; c++) {
        const float *from = aob_image_channel(image, names[c]);
        for (size_t i = 0; i < pixels; i++)
            into[stride * i + c] = from[i];
    }
    return into;
}

/* The attribute of this name, emptied, or a new one. */
static struct aob_attribute *attribute_slot(struct aob_image *image, const char *name)
{
    struct aob_attribute *slot = NULL;
    for (size_t i = 0; i < image->attribute_count && !slot; i++)
        if (strcmp(image->attributes[i].name, name) == 0)
            slot = &image->attributes[i];
    if (!slot)
        slot = AOB_PUSH(image->attributes, image->attribute_count, image->attribute_capacity);
    free(slot->text);
    *slot = (struct aob_attribute){0};
    snprintf(slot->name, sizeof slot->name, "%s", name);
    return slot;
}

void aob_image_set_number(struct aob_image *image, const char *name, double value)
{
    struct aob_attribute *slot = attribute_slot(image, name);
    slot->count = 1;
    slot->values[0] = value;
}

void aob_image_set_vec3(struct aob_image *image, const char *name, const double value[3])
{
    struct aob_attribute *slot = attribute_slot(image, name);
    slot->count = 3;
    memcpy(slot->values, value, sizeof slot->values);
}

void aob_image_set_text(struct aob_image *image, const char *name, const char *text)
{
    attribute_slot(image, name)->text = aob_strdup(text);
}

void aob_image_finish(struct aob_image *image)
{
    for (size_t i = 0; i < image->channel_count; i++)
        free(image->channels[i].pixels);
    for (size_t i = 0; i < image->attribute_count; i++)
        free(image->attributes[i].text);
    free(image->channels);
    free(image->attributes);
    *image = (struct aob_image){0};
}

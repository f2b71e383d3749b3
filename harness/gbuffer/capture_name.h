/* A channel's name in a capture, in parts: "left.Fg.Depth.Z" has four. It serves capture_channel.c and
 * capture_material_channel.c. Parts are compared in lower case, letters and digits only. */
#ifndef AOB_GBUFFER_CAPTURE_NAME_H
#define AOB_GBUFFER_CAPTURE_NAME_H
#include <stdbool.h>
#include <stddef.h>

enum { AOB_CAPTURE_NAME = 64, AOB_CAPTURE_PARTS = AOB_CAPTURE_NAME / 2 + 1 };
struct aob_capture_name {
    char text[AOB_CAPTURE_NAME + AOB_CAPTURE_PARTS];
    const char *parts[AOB_CAPTURE_PARTS];
    int count;
};

/* False if the name is too long for a channel of an image. */
bool aob_capture_name_split(struct aob_capture_name *name, const char *text);

bool aob_capture_name_ends(const char *part, const char *end);

/* The place of the last part but one that is such a word, or of one before it; -1: there is none. */
int aob_capture_name_find(const struct aob_capture_name *name, bool (*is)(const char *word));

/* Prints all parts but the last and the word's, in one order whatever theirs is. */
void aob_capture_name_layer(const struct aob_capture_name *name, int word, char layer[AOB_CAPTURE_NAME]);

/* The length of the name without its last part and the dot before it; 0 of one part. */
size_t aob_capture_name_stem(const char *name);

/* The channel with the same parts but this last one, or AOB_CHANNEL_NONE (capture_channel.h). */
int aob_capture_name_sibling(const char *const *names, size_t count, const char *name, size_t stem,
                             const char *last);
#endif

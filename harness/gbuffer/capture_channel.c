#include "capture_channel.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "capture_name.h"

/* What has such a word anywhere in its name is no depth: Blender's mist, an inverse of the depth, or a pass that is
 * smoothed for a denoiser. */
static bool is_other(const struct aob_capture_name *name)
{
    static const char *const words[] = {"mist", "inv", "recip", "dispar", "denois"};
    for (int i = 0; i < name->count; i++)
        for (size_t k = 0; k < AOB_COUNT(words); k++)
            if (strstr(name->parts[i], words[k]))
                return true;
    return false;
}

static bool is_depth(const char *word)
{
    return strcmp(word, "z") == 0 || aob_capture_name_ends(word, "depth");
}

static bool is_plain_normal(const char *word)
{
    static const char *const exact[] = {"n", "nn", "normal", "normals"};
    for (size_t i = 0; i < AOB_COUNT(exact); i++)
        if (strcmp(word, exact[i]) == 0)
            return true;
    return false;
}

static bool is_normal(const char *word)
{
    bool tail = aob_capture_name_ends(word, "normal") || aob_capture_name_ends(word, "normals");
    return is_plain_normal(word) || (tail && !strstr(word, "denois"));
}

enum { WORST = 99 };

/* A depth, or a normal by its X. */
struct candidate {
    int at, rank, normal[3];
    char layer[AOB_CAPTURE_NAME];
};
struct candidates {
    struct candidate *all;
    size_t count, capacity;
};

/* Names that end in Z. A vector's Z is none. */
static int rank_z(const struct aob_capture_name *name, int word, bool vector)
{
    if (name->count == 1)
        return 1;
    if (word == name->count - 2)
        return 2;
    if (vector || is_normal(name->parts[name->count - 2]))
        return WORST;
    return word >= 0 ? 3 : 4;
}

static int rank_depth(const char *const *names, size_t count, size_t at, const struct aob_capture_name *name,
                      int word)
{
    const char *last = name->parts[name->count - 1];
    size_t stem = aob_capture_name_stem(names[at]);
    if (is_other(name))
        return WORST;
    if (strcmp(last, "z") == 0)
        return rank_z(name, word, stem && aob_capture_name_sibling(names, count, names[at], stem, "X") >= 0);
    if (is_depth(last))
        return 7;
    if (word < 0 || strlen(last) != 1 || !strchr("vryx", *last))
        return WORST;
    if (word == name->count - 2)
        return strchr("vr", *last) ? 5 : 6;
    return aob_capture_name_sibling(names, count, names[at], stem, "G") < 0
               ? 8
               : WORST; /* a colour below DEPTH is none */
}

static bool take_normal(const char *const *names, size_t count, const char *name, size_t stem, int normal[3])
{
    static const char *const lasts[2][3] = {{"X", "Y", "Z"}, {"R", "G", "B"}};
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++)
            normal[c] = aob_capture_name_sibling(names, count, name, stem, lasts[k][c]);
        if (normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0)
            return true;
    }
    normal[0] = normal[1] = normal[2] = AOB_CHANNEL_NONE;
    return false;
}

static int rank_normal(const struct aob_capture_name *name, int word)
{
    if (word < 0)
        return WORST;
    if (word < name->count - 2)
        return 3;
    return is_plain_normal(name->parts[word]) ? 1 : 2;
}

static void list_depths(struct candidates *list, const char *const *names, size_t count)
{
    struct aob_capture_name name;
    for (size_t i = 0; i < count; i++) {
        if (!aob_capture_name_split(&name, names[i]))
            continue;
        int word = aob_capture_name_find(&name, is_depth);
        struct candidate c = {.at = (int)i, .rank = rank_depth(names, count, i, &name, word)};
        aob_capture_name_layer(&name, word, c.layer);
        if (c.rank < WORST)
            *AOB_PUSH(list->all, list->count, list->capacity) = c;
    }
}

static void list_normals(struct candidates *list, const char *const *names, size_t count)
{
    struct aob_capture_name name;
    for (size_t i = 0; i < count; i++) {
        if (!aob_capture_name_split(&name, names[i]))
            continue;
        int word = aob_capture_name_find(&name, is_normal);
        struct candidate c = {.at = (int)i, .rank = rank_normal(&name, word)};
        aob_capture_name_layer(&name, word, c.layer);
        if (c.rank < WORST &&
            take_normal(names, count, names[i], aob_capture_name_stem(names[i]), c.normal) &&
            c.normal[0] == (int)i)
            *AOB_PUSH(list->all, list->count, list->capacity) = c;
    }
}

static bool has_layer(const struct candidates *list, const char *layer)
{
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->all[i].layer, layer) == 0)
            return true;
    return false;
}

/* The best by rank, of several the first whose layer is among `near`. A depth may be stored as a colour (R, G, B), whose
 * other channels are no other depths: those with the stem of `except` are left out (NULL: none are). */
static const struct candidate *choose_depth(const struct candidates *depths, const struct candidates *near,
                                            const char *const *names, const char *except)
{
    const struct candidate *best = NULL;
    for (size_t i = 0; i < depths->count; i++) {
        const struct candidate *c = &depths->all[i];
        size_t stem = aob_capture_name_stem(names[c->at]);
        if (except && (strcmp(names[c->at], except) == 0 || (stem && aob_capture_name_stem(except) == stem &&
                                                             strncmp(names[c->at], except, stem) == 0)))
            continue;
        bool nearer =
            best && c->rank == best->rank && has_layer(near, c->layer) && !has_layer(near, best->layer);
        if (!best || c->rank < best->rank || nearer)
            best = c;
    }
    return best;
}

/* Of the layer, where there is one, the best by rank; `except` is left out (NULL: none is). */
static const struct candidate *choose_normal(const struct candidates *normals, const char *layer,
                                             const struct candidate *except)
{
    const struct candidate *best = NULL;
    for (size_t i = 0; i < normals->count; i++) {
        const struct candidate *c = &normals->all[i];
        bool same = strcmp(c->layer, layer) == 0, best_same = best && strcmp(best->layer, layer) == 0;
        if (c != except && (!best || same > best_same || (same == best_same && c->rank < best->rank)))
            best = c;
    }
    return best;
}

void aob_capture_channel_print(const char *name, char *text, size_t size)
{
    size_t used = 0;
    for (; name[used] && used + 1 < size; used++)
        text[used] = name[used] >= ' ' && name[used] <= '~' ? name[used] : '?';
    text[used] = '\0';
}

static bool fail_channels(const char *what, const char *const *names, size_t count, struct aob_error *error)
{
    struct aob_text all = {0};
    for (size_t i = 0; i < count; i++) {
        char name[AOB_CAPTURE_NAME];
        if (all.size > 300) {
            aob_text_add(&all, ", ...");
            break;
        }
        aob_capture_channel_print(names[i], name, sizeof name);
        aob_text_add(&all, "%s%s", i ? ", " : "", name);
    }
    aob_fail(error, "%s; it has %s", what, all.data ? all.data : "none");
    aob_text_finish(&all);
    return false;
}

static int find_name(const char *const *names, size_t count, const char *wanted)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(names[i], wanted) == 0)
            return (int)i;
    return AOB_CHANNEL_NONE;
}

static bool name_depth(struct candidates *depths, const char *const *names, size_t count, const char *wanted,
                       struct aob_error *error)
{
    char text[160];
    struct aob_capture_name name;
    int at = find_name(names, count, wanted);
    snprintf(text, sizeof text, "it has no channel '%s'", wanted);
    if (at < 0 || !aob_capture_name_split(&name, wanted))
        return fail_channels(text, names, count, error);
    struct candidate c = {.at = at};
    aob_capture_name_layer(&name, aob_capture_name_find(&name, is_depth), c.layer);
    *AOB_PUSH(depths->all, depths->count, depths->capacity) = c;
    return true;
}

static bool name_normal(struct candidates *normals, const char *const *names, size_t count,
                        const char *wanted, struct aob_error *error)
{
    char text[160];
    struct aob_capture_name name;
    struct candidate c = {0};
    snprintf(text, sizeof text, "it has no channels '%s' with .X .Y .Z or .R .G .B", wanted);
    if (!take_normal(names, count, wanted, strlen(wanted), c.normal) ||
        !aob_capture_name_split(&name, names[c.normal[0]]))
        return fail_channels(text, names, count, error);
    c.at = c.normal[0];
    aob_capture_name_layer(&name, aob_capture_name_find(&name, is_normal), c.layer);
    *AOB_PUSH(normals->all, normals->count, normals->capacity) = c;
    return true;
}

static bool list_all(struct candidates *depths, struct candidates *normals, const char *const *names,
                     size_t count, const struct aob_convention *c, struct aob_error *error)
{
    if (!*c->depth_channel)
        list_depths(depths, names, count);
    else if (!name_depth(depths, names, count, c->depth_channel, error))
        return false;
    if (!depths->count)
        return fail_channels("no channel is a depth by its name: name one by depth_channel", names, count,
                             error);
    if (c->normals == AOB_NORMALS_DERIVED)
        return true;
    if (*c->normal_channel)
        return name_normal(normals, names, count, c->normal_channel, error);
    list_normals(normals, names, count);
    return true;
}

static void choose(struct aob_capture_channels *channels, const struct candidates *depths,
                   const struct candidates *normals, const char *const *names)
{
    const struct candidate *depth = choose_depth(depths, normals, names, NULL);
    const struct candidate *other = choose_depth(depths, normals, names, names[depth->at]);
    const struct candidate *normal = choose_normal(normals, depth->layer, NULL);
    channels->depth = depth->at;
    strcpy(channels->layer, depth->layer);
    if (other)
        channels->other_depth = other->at;
    if (!normal)
        return;
    memcpy(channels->normal, normal->normal, sizeof normal->normal);
    channels->mixed = strcmp(normal->layer, depth->layer) != 0;
    const struct candidate *second = choose_normal(normals, normal->layer, normal);
    if (second && (channels->mixed || strcmp(second->layer, normal->layer) == 0))
        channels->other_normal = second->at;
}

bool aob_capture_channels_choose(struct aob_capture_channels *channels, const char *const *names,
                                 size_t count, const struct aob_convention *c, struct aob_error *error)
{
    struct candidates depths = {0}, normals = {0};
    *channels =
        (struct aob_capture_channels){.depth = AOB_CHANNEL_NONE,
                                      .normal = {AOB_CHANNEL_NONE, AOB_CHANNEL_NONE, AOB_CHANNEL_NONE},
                                      .other_depth = AOB_CHANNEL_NONE,
                                      .other_normal = AOB_CHANNEL_NONE};
    bool ok = list_all(&depths, &normals, names, count, c, error);
    if (ok)
        choose(channels, &depths, &normals, names);
    if (*c->depth_channel && *c->normal_channel)
        channels->mixed = false;
    free(depths.all);
    free(normals.all);
    return ok;
}

#include "capture_channel.h"
#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include "base/memory.h"
#include "base/text.h"

enum { NAME_SIZE = 64, WORST = 99 };

/* The last two parts of a name, lower case, letters and digits only. */
struct word {
    char layer[NAME_SIZE], last[NAME_SIZE];
    size_t stem; /* bytes before the dot of the last part; 0: there is none */
    bool fits;   /* the name is short enough to be a channel of an image */
};

static void fold(const char *from, size_t size, char into[NAME_SIZE])
{
    size_t used = 0;
    for (size_t i = 0; i < size && used + 1 < NAME_SIZE; i++)
        if (isalnum((unsigned char)from[i]))
            into[used++] = (char)tolower((unsigned char)from[i]);
    into[used] = '\0';
}

static struct word split(const char *name)
{
    struct word word = {.fits = strlen(name) < NAME_SIZE};
    const char *dot = strrchr(name, '.');
    fold(dot ? dot + 1 : name, strlen(dot ? dot + 1 : name), word.last);
    word.stem = dot ? (size_t)(dot - name) : 0;
    const char *start = name + word.stem;
    while (start > name && start[-1] != '.')
        start--;
    fold(start, (size_t)(name + word.stem - start), word.layer);
    return word;
}

static bool ends_with(const char *text, const char *end)
{
    size_t size = strlen(text), tail = strlen(end);
    return size >= tail && strcmp(text + size - tail, end) == 0;
}

static bool is_depth(const char *word)
{
    return strcmp(word, "z") == 0 || (ends_with(word, "depth") && !strstr(word, "denois"));
}

/* The channel of the same layer with this last part, or AOB_CHANNEL_NONE. */
static int sibling(const char *const *names, size_t count, const char *name, size_t stem, const char *last)
{
    for (size_t i = 0; i < count; i++)
        if (strncmp(names[i], name, stem) == 0 && names[i][stem] == '.' && strlen(names[i]) < NAME_SIZE &&
            strcasecmp(names[i] + stem + 1, last) == 0)
            return (int)i;
    return AOB_CHANNEL_NONE;
}

static int rank_depth(const char *const *names, size_t count, size_t at)
{
    struct word word = split(names[at]);
    if (!word.fits)
        return WORST;
    if (strcmp(word.last, "z") == 0) {
        if (!word.stem)
            return 1;
        if (is_depth(word.layer))
            return 2;
        return sibling(names, count, names[at], word.stem, "X") == AOB_CHANNEL_NONE ? 3 : WORST;
    }
    if (word.stem && is_depth(word.layer) && strlen(word.last) == 1 && strchr("vr", *word.last))
        return 4;
    if (word.stem && is_depth(word.layer) && strlen(word.last) == 1 && strchr("yx", *word.last))
        return 5;
    return is_depth(word.last) ? 6 : WORST;
}

static int rank_normal(const char *layer)
{
    static const char *const exact[] = {"n", "nn", "normal", "normals"};
    for (size_t i = 0; i < AOB_COUNT(exact); i++)
        if (strcmp(layer, exact[i]) == 0)
            return 1;
    bool tail = ends_with(layer, "normal") || ends_with(layer, "normals");
    return tail && !strstr(layer, "denois") ? 2 : WORST;
}

static bool take_normal(const char *const *names, size_t count, const char *name, size_t stem, int normal[3])
{
    static const char *const lasts[2][3] = {{"X", "Y", "Z"}, {"R", "G", "B"}};
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++)
            normal[c] = sibling(names, count, name, stem, lasts[k][c]);
        if (normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0)
            return true;
    }
    normal[0] = normal[1] = normal[2] = AOB_CHANNEL_NONE;
    return false;
}

/* A depth may be stored as a colour (R, G, B). Its second channel is no second depth. */
static bool same_layer(const char *a, const char *b)
{
    size_t stem = split(a).stem;
    return stem && split(b).stem == stem && strncmp(a, b, stem) == 0;
}

static void find_depth(struct aob_capture_channels *channels, const char *const *names, size_t count)
{
    int best = WORST;
    for (size_t i = 0; i < count; i++) {
        int rank = rank_depth(names, count, i);
        if (rank >= WORST ||
            (channels->depth >= 0 && same_layer(names[i], names[channels->depth]) && rank >= best))
            continue;
        int loser = rank < best ? channels->depth : (int)i;
        if (rank < best) {
            best = rank;
            channels->depth = (int)i;
        }
        if (loser >= 0 && !same_layer(names[loser], names[channels->depth]))
            channels->other_depth = loser;
    }
}

static void find_normal(struct aob_capture_channels *channels, const char *const *names, size_t count)
{
    int best = WORST, normal[3];
    for (size_t i = 0; i < count; i++) {
        struct word word = split(names[i]);
        int rank = word.stem ? rank_normal(word.layer) : WORST;
        if (rank >= WORST || !take_normal(names, count, names[i], word.stem, normal) || normal[0] != (int)i)
            continue;
        int loser = rank < best ? channels->normal[0] : (int)i;
        if (loser >= 0)
            channels->other_normal = loser;
        if (rank < best) {
            best = rank;
            memcpy(channels->normal, normal, sizeof normal);
        }
    }
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
        char name[NAME_SIZE];
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

bool aob_capture_channels_choose(struct aob_capture_channels *channels, const char *const *names,
                                 size_t count, const struct aob_convention *c, struct aob_error *error)
{
    char text[160];
    *channels = (struct aob_capture_channels){AOB_CHANNEL_NONE,
                                              {AOB_CHANNEL_NONE, AOB_CHANNEL_NONE, AOB_CHANNEL_NONE},
                                              AOB_CHANNEL_NONE,
                                              AOB_CHANNEL_NONE};
    if (*c->depth_channel)
        channels->depth = find_name(names, count, c->depth_channel);
    else
        find_depth(channels, names, count);
    if (channels->depth < 0 && !*c->depth_channel)
        return fail_channels("no channel is a depth by its name: name one by depth_channel", names, count,
                             error);
    snprintf(text, sizeof text, "it has no channel '%s'", c->depth_channel);
    if (channels->depth < 0)
        return fail_channels(text, names, count, error);
    if (c->normals == AOB_NORMALS_DERIVED)
        return true;
    if (!*c->normal_channel)
        find_normal(channels, names, count);
    else if (!take_normal(names, count, c->normal_channel, strlen(c->normal_channel), channels->normal)) {
        snprintf(text, sizeof text, "it has no channels '%s' with .X .Y .Z or .R .G .B", c->normal_channel);
        return fail_channels(text, names, count, error);
    }
    return true;
}

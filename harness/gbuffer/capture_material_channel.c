#include "capture_material_channel.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "capture_name.h"

enum { MOST_WORDS = 8, NONE = 99 };

static const char *const words[AOB_MATERIAL_CHANNELS][MOST_WORDS] = {
    {"albedo", "basecolor", "basecolour", "diffcol", "diffusecolor", "diffusecolour", "diffusefilter"},
    {"roughness"},
    {"metalness", "metallic"}};

/* 1: it is such a word; 2: it ends with one; NONE. */
static int rank_word(const char *part, enum aob_material_channel which)
{
    static const char *const others[] = {"denois",  "spec", "coat", "sheen",      "transmi",
                                         "refract", "refl", "sss",  "subsurface", "volume",
                                         "emis",    "inv",  "recip"};
    for (size_t i = 0; i < AOB_COUNT(others); i++)
        if (strstr(part, others[i]))
            return NONE;
    int rank = NONE;
    for (size_t i = 0; i < MOST_WORDS && words[which][i]; i++)
        if (strcmp(part, words[which][i]) == 0)
            return 1;
        else if (aob_capture_name_ends(part, words[which][i]))
            rank = 2;
    return rank;
}

struct candidate {
    int at[3], rank;
    bool near; /* of the depth's layer */
    char layer[AOB_CAPTURE_NAME];
};
struct search {
    const char *const *names;
    size_t count;
    const char *layer;
    enum aob_material_channel which;
    struct candidate best, second; /* rank NONE: there is none */
    int lacking; /* a channel of a base colour that lacks another of its three; else AOB_CHANNEL_NONE */
};

/* The place of the word in the name, and its rank; -1: there is none. */
static int find_word(const struct aob_capture_name *name, enum aob_material_channel which, int *rank)
{
    int last = name->count - 1;
    for (int at = which == AOB_MATERIAL_ALBEDO ? last - 1 : last; at >= 0; at--) {
        *rank = rank_word(name->parts[at], which);
        if (*rank != NONE)
            return at;
    }
    return -1;
}

static bool is_better(const struct candidate *a, const struct candidate *b)
{
    if (b->rank == NONE || a->near != b->near)
        return b->rank == NONE || a->near;
    return a->rank < b->rank;
}

static void offer(struct search *search, const struct candidate *candidate)
{
    if (is_better(candidate, &search->best)) {
        search->second = search->best;
        search->best = *candidate;
    } else if (is_better(candidate, &search->second))
        search->second = *candidate;
}

/* Each base colour is offered once, by its R. */
static void offer_colour(struct search *search, size_t i, struct candidate *candidate)
{
    static const char *const lasts[3] = {"R", "G", "B"};
    size_t stem = aob_capture_name_stem(search->names[i]);
    int found = 0, own = -1;
    for (int c = 0; c < 3; c++) {
        candidate->at[c] =
            aob_capture_name_sibling(search->names, search->count, search->names[i], stem, lasts[c]);
        found += candidate->at[c] >= 0;
        own = candidate->at[c] == (int)i ? c : own;
    }
    if (own == 0 && found == 3)
        offer(search, candidate);
    else if (own >= 0 && found < 3)
        search->lacking = (int)i;
}

/* The word itself, else the first of the four behind it. */
static void offer_number(struct search *search, size_t i, const struct aob_capture_name *name, int word,
                         struct candidate *candidate)
{
    static const char lasts[] = "vryx";
    const char *last = name->parts[name->count - 1], *place = strchr(lasts, *last);
    size_t stem = aob_capture_name_stem(search->names[i]);
    if (word < name->count - 1) {
        if (strlen(last) != 1 || !place)
            return;
        for (const char *before = lasts; before < place; before++) {
            const char one[2] = {*before, '\0'};
            if (aob_capture_name_sibling(search->names, search->count, search->names[i], stem, one) >= 0)
                return;
        }
    }
    candidate->at[0] = (int)i;
    offer(search, candidate);
}

static void search_all(struct search *search)
{
    struct aob_capture_name name;
    for (size_t i = 0; i < search->count; i++) {
        struct candidate candidate = {.at = {AOB_CHANNEL_NONE, AOB_CHANNEL_NONE, AOB_CHANNEL_NONE}};
        if (!aob_capture_name_split(&name, search->names[i]))
            continue;
        int word = find_word(&name, search->which, &candidate.rank);
        if (word < 0)
            continue;
        aob_capture_name_layer(&name, word, candidate.layer);
        candidate.near = strcmp(candidate.layer, search->layer) == 0;
        if (search->which == AOB_MATERIAL_ALBEDO)
            offer_colour(search, i, &candidate);
        else
            offer_number(search, i, &name, word, &candidate);
    }
}

static bool judge_found(const struct search *search, struct aob_error *error)
{
    char name[AOB_CAPTURE_NAME];
    if (search->best.rank != NONE || search->lacking < 0)
        return true;
    aob_capture_channel_print(search->names[search->lacking], name, sizeof name);
    return aob_fail(error,
                    "its base colour has %s, and not all of .R .G .B: write the three, or state materials "
                    "none",
                    name);
}

static int find_name(const struct search *search, const char *wanted)
{
    for (size_t i = 0; i < search->count; i++)
        if (strcmp(search->names[i], wanted) == 0)
            return (int)i;
    return AOB_CHANNEL_NONE;
}

static bool take_named(const struct search *search, const char *wanted,
                       struct aob_capture_material_channel *channel, struct aob_error *error)
{
    static const char *const lasts[3] = {"R", "G", "B"};
    const char *what = aob_material_channel_names[search->which];
    if (search->which != AOB_MATERIAL_ALBEDO) {
        channel->at[0] = find_name(search, wanted);
        return channel->at[0] >= 0 || aob_fail(error, "%s_channel: it has no channel '%s'", what, wanted);
    }
    for (int c = 0; c < 3; c++)
        channel->at[c] =
            aob_capture_name_sibling(search->names, search->count, wanted, strlen(wanted), lasts[c]);
    return (channel->at[0] >= 0 && channel->at[1] >= 0 && channel->at[2] >= 0) ||
           aob_fail(error, "%s_channel: it has no channels '%s' with .R .G .B", what, wanted);
}

bool aob_capture_materials_choose(struct aob_capture_material_channels *channels, const char *const *names,
                                  size_t count, const char *layer, const struct aob_convention *convention,
                                  struct aob_error *error)
{
    bool ok = true;
    for (int which = 0; which < AOB_MATERIAL_CHANNELS; which++) {
        struct aob_capture_material_channel *channel = &channels->of[which];
        struct search search = {.names = names,
                                .count = count,
                                .layer = layer,
                                .which = (enum aob_material_channel)which,
                                .best.rank = NONE,
                                .second.rank = NONE,
                                .lacking = AOB_CHANNEL_NONE};
        *channel = (struct aob_capture_material_channel){
            {AOB_CHANNEL_NONE, AOB_CHANNEL_NONE, AOB_CHANNEL_NONE}, AOB_CHANNEL_NONE, false};
        if (convention->no_materials)
            continue;
        const char *wanted = convention->material_channels[which];
        if (*wanted) {
            ok = ok && take_named(&search, wanted, channel, error);
            continue;
        }
        search_all(&search);
        ok = ok && judge_found(&search, error);
        if (search.best.rank == NONE)
            continue;
        memcpy(channel->at, search.best.at, sizeof channel->at);
        channel->mixed = !search.best.near;
        if (search.second.rank != NONE && strcmp(search.second.layer, search.best.layer) == 0)
            channel->other = search.second.at[0];
    }
    return ok;
}

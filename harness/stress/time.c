#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "groups.h"
#include "sets.h"

/* Frames that follow each other: what may be kept from one to the next, and what may not. */

enum { LONG = 64, SHORT = 16, REST = SHORT / 2 };

struct film {
    struct aob_shot shot;
    const struct aob_exhibit *frames[LONG];
    bool wanted[LONG];
    float *images[LONG];
};

/* Draws `count` frames and gives the last; NULL where that fails. */
static const float *draw(struct aob_trial *trial, struct film *film, size_t count, size_t anew)
{
    film->wanted[count - 1] = true;
    const struct aob_film desc = {.shot = &film->shot, .frames = film->frames, .count = count, .anew = anew};
    return aob_trial_film(trial, &desc, film->wanted, film->images) ? film->images[count - 1] : NULL;
}

static void show(struct film *film, const struct aob_exhibit *exhibit, size_t first, size_t behind)
{
    for (size_t i = first; i < behind; i++)
        film->frames[i] = exhibit;
}

static void take_same(struct aob_trial *trial, struct film *film, const struct aob_exhibit *exhibit,
                      const float *image, const float *wanted, const char *how)
{
    film->shot.exhibit = exhibit;
    if (image && wanted)
        aob_trial_take(trial, aob_difference_of(exhibit, image, wanted, NULL).most,
                       &(struct aob_seen){&film->shot, image, wanted}, "%s", how);
}

/* Against what the last of many frames shows. */
static void ask_still_converges(struct aob_trial *trial)
{
    static const char *const sets[] = {"history=64", "history=64 blur=0"};
    for (size_t s = 0; s < AOB_COUNT(sets); s++) {
        const struct aob_exhibit *exhibit = aob_set_default(trial);
        struct film film = {.shot = {.exhibit = exhibit, .radius = 0.8, .set = sets[s]}};
        show(&film, exhibit, 0, LONG);
        film.wanted[0] = film.wanted[REST - 1] = true;
        const float *many = draw(trial, &film, LONG, 0), *some = film.images[REST - 1];
        if (!many)
            return;
        double one = aob_difference_of(exhibit, film.images[0], many, NULL).rmse,
               eight = aob_difference_of(exhibit, some, many, NULL).rmse;
        aob_trial_take(trial, eight / one, &(struct aob_seen){&film.shot, some, many},
                       "%s: %.4f from 64 frames after one, %.4f after 8", sets[s], one, eight);
    }
}

/* The still life and a box at x, which moves if its step is not 0: the view after so many of its steps. NAN: no box. */
static struct aob_exhibit *make_room(struct aob_trial *trial, double x, double step, int steps)
{
    struct aob_mesh mesh = {0};
    aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
    if (step != 0)
        aob_mesh_start(&mesh, aob_vec(step, 0, 0));
    if (isfinite(x))
        aob_mesh_add_box(&mesh, aob_vec(x, 0, 0.7), aob_vec(x + 0.5, 0.6, 1.1), 10);
    if (step != 0) {
        aob_mesh_rest(&mesh);
        aob_mesh_move(&mesh, steps);
    }
    return aob_trial_exhibit(
        trial,
        &(struct aob_exhibit_desc){
            .mesh = &mesh, .camera = aob_still_life_camera(1, aob_vec(0, 0, 0)), .width = 96, .height = 64});
}

/* A box slides to its place, and one vanishes; then eight frames of rest. What is wanted is what always stood so. */
static void ask_no_trail(struct aob_trial *trial)
{
    static const double steps[] = {0, 0.1, 0.01};
    for (size_t s = 0; s < AOB_COUNT(steps); s++) {
        struct film moved = {.shot = {.radius = 0.5, .set = "history=32 slices=32 steps=16"}}, still = moved;
        double place = steps[s] > 0 ? 0.4 : NAN, start = steps[s] > 0 ? place - REST * steps[s] : 0.4;
        const struct aob_exhibit *rests = make_room(trial, place, 0, 0);
        show(&still, rests, 0, SHORT);
        show(&moved, rests, REST + 1, SHORT);
        for (int t = 0; t <= REST; t++)
            moved.frames[t] = make_room(trial, start, steps[s], t);
        if (!(steps[s] > 0))
            moved.frames[REST] = rests;
        const float *image = draw(trial, &moved, SHORT, 0), *wanted = draw(trial, &still, SHORT, 0);
        char how[80];
        aob_line_print(how, sizeof how,
                       steps[s] > 0 ? "a box that slid by %g a frame" : "a box that was there", steps[s]);
        take_same(trial, &moved, rests, image, wanted, how);
    }
}

/* The default set with numbers that are none in every seventh pixel. */
static struct aob_exhibit *make_hostile(struct aob_trial *trial)
{
    static const float values[] = {NAN, INFINITY, 0, -1};
    struct aob_exhibit *exhibit = aob_set_default(trial);
    for (size_t i = 0; exhibit && i < aob_exhibit_pixels(exhibit); i += 7) {
        size_t at = aob_exhibit_place(exhibit, i);
        exhibit->gbuffer.depth[at] = values[i % AOB_COUNT(values)];
        exhibit->gbuffer.normal[4 * at + i % 3] = values[i / 4 % 2];
    }
    return exhibit;
}

static void ask_begins_anew(struct aob_trial *trial)
{
    const struct aob_exhibit *exhibit = aob_set_default(trial), *hostile = make_hostile(trial);
    struct film fresh = {.shot = {.radius = 0.8, .set = "history=16"}}, used = fresh;
    show(&fresh, exhibit, 0, 4);
    show(&used, hostile, 0, 5);
    show(&used, exhibit, 5, 9);
    const float *wanted = draw(trial, &fresh, 4, 0);
    take_same(trial, &used, exhibit, draw(trial, &used, 9, 5), wanted, "frame 0 after five hostile frames");
    take_same(trial, &fresh, exhibit, draw(trial, &fresh, 4, 0), wanted, "the same four frames again");
}

static void ask_hostile_frame_passes(struct aob_trial *trial)
{
    const struct aob_exhibit *exhibit = aob_set_default(trial), *hostile = make_hostile(trial);
    struct film plain = {.shot = {.radius = 0.5, .set = "history=32 slices=32 steps=16"}}, hurt = plain;
    show(&plain, exhibit, 0, SHORT);
    show(&hurt, exhibit, 0, SHORT);
    hurt.frames[REST - 1] = hostile;
    for (size_t i = 0; i < SHORT; i++)
        hurt.wanted[i] = true;
    const float *image = draw(trial, &hurt, SHORT, 0), *wanted = draw(trial, &plain, SHORT, 0);
    take_same(trial, &hurt, exhibit, image, wanted, "eight frames after a hostile one");
}

static void ask_history_of_its_size(struct aob_trial *trial)
{
    static const int sizes[][2] = {{33, 17}, {200, 120}, {1, 1}};
    const struct aob_exhibit *exhibit = aob_set_default(trial);
    struct film film = {.shot = {.radius = 0.8, .set = "history=16"}}, other = film;
    show(&film, exhibit, 0, 4);
    const float *wanted = draw(trial, &film, 4, 0);
    for (size_t i = 0; i < AOB_COUNT(sizes); i++) {
        const struct aob_plane_desc plane = {.tilt_deg = 45, .width = sizes[i][0], .height = sizes[i][1]};
        char how[80];
        show(&other, aob_set_plane(trial, &plane), 0, 3);
        draw(trial, &other, 3, 0);
        aob_line_print(how, sizeof how, "four frames after three of %dx%d", sizes[i][0], sizes[i][1]);
        take_same(trial, &film, exhibit, draw(trial, &film, 4, 0), wanted, how);
    }
}

const struct aob_property aob_properties_time[] = {
    {.name = "still_converges",
     .sentence = "The mean over the frames of a still camera nears that of many, as the root of their number "
                 "or faster.",
     .measure = "what is left after eight frames, over what one has",
     .source = "docs/stress.md fault 58",
     .group = AOB_GROUP_TIME,
     .excuse = aob_excuse_no_history,
     .ask = ask_still_converges},
    {.name = "no_trail",
     .sentence = "Eight frames after all has come to rest the image is as if nothing had moved.",
     .measure = "largest difference of a pixel",
     .source = "https://github.com/nem0/LumixEngine/issues/1486",
     .group = AOB_GROUP_TIME,
     .quick = true,
     .excuse = aob_excuse_no_history,
     .ask = ask_no_trail},
    {.name = "begins_anew",
     .sentence = "Frame 0 begins a sequence, whatever its memory holds.",
     .measure = "largest difference of a pixel",
     .source = "https://github.com/godotengine/godot/issues/69067",
     .group = AOB_GROUP_TIME,
     .quick = true,
     .excuse = aob_excuse_no_history,
     .ask = ask_begins_anew},
    {.name = "hostile_frame_passes",
     .sentence = "A frame of depths and normals that are no numbers leaves nothing behind.",
     .measure = "largest difference of a pixel after eight frames",
     .source = "https://github.com/godotengine/godot/issues/69067",
     .group = AOB_GROUP_TIME,
     .excuse = aob_excuse_no_history,
     .ask = ask_hostile_frame_passes},
    {.name = "history_of_its_size",
     .sentence = "A sequence is the same after one of another size.",
     .measure = "largest difference of a pixel",
     .source = "https://github.com/godotengine/godot/issues/69067",
     .group = AOB_GROUP_TIME,
     .quick = true,
     .excuse = aob_excuse_no_history,
     .ask = ask_history_of_its_size},
    {0}};

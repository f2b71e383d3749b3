/* What more geometry and more radius must do to the truth, pixel by pixel: with the same rays neither ever brightens. */
#include "shot.h"
#include <string.h>

enum { W = 120, H = 68, SPP = 64 };

/* A box within the bounds of `cornell`, whose own pixels are not compared. */
static void build_room(struct aob_mesh *mesh, int boxes)
{
    static const double places[3][3] = {{-0.8, 0, 0.5}, {0.3, 0.7, 0.2}, {-0.2, 1.3, -0.4}};
    aob_scene_find("cornell")->build(mesh);
    for (int i = 0; i < boxes; i++) {
        const double *p = places[i];
        aob_mesh_add_box(mesh, aob_vec(p[0], p[1], p[2]), aob_vec(p[0] + 0.3, p[1] + 0.25, p[2] + 0.3), 20);
    }
}

static void shoot(struct shot *shot, int boxes)
{
    static const struct aob_visibility_term terms[] = {
        {.radius = 0.25}, {.radius = 0.5}, {.radius = 1}, {.radius = INFINITY}};
    struct aob_mesh mesh = {0};
    build_room(&mesh, boxes);
    cast_shot(shot, &mesh, aob_scene_view(aob_scene_find("cornell"), "front")->camera, W, H);
    trace_shot(shot, terms, 4, SPP);
}

/* The same surface at the same place, so the same rays start there. */
static bool unchanged(const struct shot *a, const struct shot *b, size_t i)
{
    return a->hits.primitive[i] == b->hits.primitive[i] && a->hits.depth[i] == b->hits.depth[i] &&
           memcmp(a->hits.normal[i], b->hits.normal[i], sizeof a->hits.normal[i]) == 0;
}

static void an_occluder_never_brightens(void **state)
{
    (void)state;
    struct shot bare, more;
    shoot(&bare, 0);
    for (int boxes = 1; boxes <= 3; boxes++) {
        size_t compared = 0, darker = 0;
        shoot(&more, boxes);
        for (size_t i = 0; i < pixel_count(&bare); i++) {
            if (!unchanged(&bare, &more, i))
                continue;
            compared++;
            for (size_t t = 0; t < 4; t++) {
                assert_true(more.visibility[t].ao[i] <= bare.visibility[t].ao[i]);
                darker += more.visibility[t].ao[i] < bare.visibility[t].ao[i];
            }
        }
        print_message("           %d boxes: %zu pixels unchanged, %zu values darker, none brighter\n", boxes,
                      compared, darker);
        assert_true(compared > pixel_count(&bare) / 2 && compared < pixel_count(&bare));
        assert_true(darker > 500);
        finish_shot(&more);
    }
    finish_shot(&bare);
}

static void more_radius_never_brightens(void **state)
{
    (void)state;
    struct shot shot;
    size_t darker = 0;
    shoot(&shot, 0);
    for (size_t i = 0; i < pixel_count(&shot); i++)
        for (size_t t = 1; t < 4; t++) {
            assert_true(shot.visibility[t].ao[i] <= shot.visibility[t - 1].ao[i]);
            darker += shot.visibility[t].ao[i] < shot.visibility[t - 1].ao[i];
        }
    assert_true(darker > 1000);
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(an_occluder_never_brightens),
                                       cmocka_unit_test(more_radius_never_brightens)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

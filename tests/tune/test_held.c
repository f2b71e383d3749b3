/* What is held out of a fit, by the names that records have. */
#include "check.h"
#include "tune/held.h"
#include <stdlib.h>
#include "base/memory.h"

static char path[] = "c.yaml";

static struct aob_scene_choice *add(struct aob_config *config, const char *name, const char *view,
                                    bool camera)
{
    struct aob_scene_choice *choice = AOB_PUSH(config->scenes, config->scene_count, config->scene_capacity);
    choice->name = aob_strdup(name);
    choice->view = aob_strdup(view);
    choice->has_camera = camera;
    return choice;
}

static void begin(struct aob_config *config)
{
    aob_config_init(config);
    config->path = aob_strdup(path);
    add(config, "corner", NULL, false); /* its first view, front */
    add(config, "corner", "far", false);
    add(config, "cornell", NULL, true);
    add(config, "cornell", NULL, true);
    struct aob_scene_choice *mesh = add(config, "x", NULL, false);
    free(mesh->name);
    mesh->name = NULL;
    mesh->file = aob_strdup("/a/models/my.ply");
    mesh->given = aob_strdup("models/my.ply");
}

/* Which are held out, as digits; what was added follows a plus. */
static const char *held_of(const char *names, struct aob_error *error)
{
    static char text[256];
    struct aob_config config;
    bool *held;
    begin(&config);
    bool ok = aob_tune_held_mark(&config, names, &held, error);
    size_t size = 0;
    for (size_t i = 0; i < config.scene_count && ok; i++) {
        if (i >= 5)
            size += (size_t)snprintf(text + size, sizeof text - size, "+%s/%s", config.scenes[i].name,
                                     config.scenes[i].view ? config.scenes[i].view : "");
        text[size++] = held[i] ? '1' : '0';
    }
    text[size] = '\0';
    free(held);
    aob_config_finish(&config);
    return ok ? text : NULL;
}

static void scenes_and_views(void **state)
{
    (void)state;
    assert_string_equal(held_of(NULL, NULL), "00000");
    assert_string_equal(held_of("corner", NULL), "11000");
    assert_string_equal(held_of("corner/front", NULL), "10000");
    assert_string_equal(held_of("cornell/camera-2,corner/far", NULL), "01010");
    assert_string_equal(held_of("cornell/camera", NULL), "00100");
    assert_string_equal(held_of("models/my.ply", NULL), "00001");
}

static void what_the_config_has_not(void **state)
{
    (void)state;
    assert_string_equal(held_of("bunny,corner/front", NULL), "10000+bunny/1");
    assert_string_equal(held_of("atrium/aisle,bunny", NULL), "00000+atrium/aisle1+bunny/1");
}

static void what_is_wrong(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    assert_null(held_of("corner,,cornell", &error));
    assert_contains(error.text, "empty name");
    assert_null(held_of("corner,cornell,models/my.ply", &error));
    assert_contains(error.text, "leaves no view of c.yaml to fit");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_and_views),
        cmocka_unit_test(what_the_config_has_not),
        cmocka_unit_test(what_is_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

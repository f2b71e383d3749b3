#include "motion_choice.h"
#include <math.h>
#include <string.h>

struct motion_reader {
    struct aob_motion_choice *motion;
    bool eye, target;
};

static bool read_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct motion_reader *reader = user;
    double frames;
    if (strcmp(key, "eye") == 0)
        return (reader->eye = true) && aob_yaml_vec3(yaml, node, reader->motion->last.eye);
    if (strcmp(key, "target") == 0)
        return (reader->target = true) && aob_yaml_vec3(yaml, node, reader->motion->last.target);
    if (!aob_yaml_number(yaml, node, AOB_CONFIG_MIN_FRAMES, AOB_CONFIG_MAX_FRAMES, &frames))
        return false;
    reader->motion->frames = (int)frames;
    return frames == floor(frames) || aob_yaml_fail(yaml, node, "frames must be a whole number");
}

bool aob_motion_choice_read(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_motion_choice *motion)
{
    static const char *const keys[] = {"frames", "eye", "target", NULL};
    struct motion_reader reader = {.motion = motion};
    if (!aob_yaml_mapping(yaml, node, keys, read_entry, &reader))
        return false;
    motion->camera = reader.eye;
    if (!motion->frames)
        return aob_yaml_fail(yaml, node, "motion needs frames, %d to %d", AOB_CONFIG_MIN_FRAMES,
                             AOB_CONFIG_MAX_FRAMES);
    return reader.eye == reader.target ||
           aob_yaml_fail(yaml, node, "the camera of a motion needs both eye and target, or neither");
}

bool aob_motion_choice_judge(const struct aob_yaml *yaml, const yaml_node_t *node,
                             const struct aob_scene_choice *choice)
{
    if (!choice->motion.frames)
        return true;
    if (choice->capture)
        return aob_yaml_fail(yaml, node, "a capture is one frame: it takes no motion");
    if (choice->moves)
        return aob_yaml_fail(yaml, node,
                             "motion says where the camera was in each frame: leave previous out");
    return !choice->file || choice->has_camera ||
           aob_yaml_fail(yaml, node, "the motion of a mesh file needs its camera: give eye and target");
}

#include "pose.h"
#include <string.h>

struct pose_reader {
    struct aob_pose *pose;
    bool eye, target;
};

static bool read_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct pose_reader *reader = user;
    if (strcmp(key, "eye") == 0)
        return (reader->eye = true) && aob_yaml_vec3(yaml, node, reader->pose->eye);
    return (reader->target = true) && aob_yaml_vec3(yaml, node, reader->pose->target);
}

bool aob_pose_read(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_pose *pose)
{
    static const char *const keys[] = {"eye", "target", NULL};
    struct pose_reader reader = {.pose = pose};
    if (!aob_yaml_mapping(yaml, node, keys, read_entry, &reader))
        return false;
    return (reader.eye && reader.target) ||
           aob_yaml_fail(yaml, node, "a previous camera needs both eye and target");
}

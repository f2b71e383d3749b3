#include "config_capture.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

bool aob_config_is_convention(const char *key, enum aob_convention_key *at)
{
    for (int k = 0; k < AOB_CONVENTION_COUNT; k++)
        if (strcmp(key, aob_convention_keys[k]) == 0) {
            *at = (enum aob_convention_key)k;
            return true;
        }
    return false;
}

bool aob_config_read_convention(struct aob_yaml *yaml, const yaml_node_t *node, enum aob_convention_key key,
                                struct aob_convention *convention)
{
    struct aob_error error = {{0}};
    char vector[96];
    const char *text = vector;
    double up[3];
    if (key == AOB_CONVENTION_UP) {
        if (!aob_yaml_vec3(yaml, node, up))
            return false;
        snprintf(vector, sizeof vector, "%.17g,%.17g,%.17g", up[0], up[1], up[2]);
    } else if (!aob_yaml_text(yaml, node, &text))
        return false;
    return aob_convention_set(convention, key, text, &error) || aob_yaml_fail(yaml, node, "%s", error.text);
}

void aob_config_take_capture(struct aob_scene_choice *choice)
{
    const char *file = aob_capture_file(choice->name);
    if (!file || choice->capture)
        return;
    choice->capture = aob_strdup(file);
    free(choice->name);
    choice->name = NULL;
}

bool aob_config_judge_capture(struct aob_yaml *yaml, const yaml_node_t *node,
                              const struct aob_scene_choice *choice)
{
    struct aob_error error = {{0}};
    if (choice->moves || choice->shift[0] != 0 || choice->shift[1] != 0)
        return aob_yaml_fail(yaml, node,
                             "a capture is read as centred and still: leave shift and previous out");
    return aob_convention_check(&choice->convention, &error) || aob_yaml_fail(yaml, node, "%s", error.text);
}

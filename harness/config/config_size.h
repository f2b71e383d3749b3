/* For config.c: how many cases a config asks for. */
#ifndef AOB_CONFIG_CONFIG_SIZE_H
#define AOB_CONFIG_CONFIG_SIZE_H
#include "config.h"

/* False with a line if the product of scenes, sizes, backends, axes and options exceeds AOB_CONFIG_MAX_CASES, counted
 * before equal points become one. The line names the longest list that the product is made of, and where it stands. */
bool aob_config_judge_size(const struct aob_config *config, struct aob_error *error);
#endif

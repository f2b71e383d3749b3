/* `aobudget list` and `aobudget plan`: what there is, and what a config comes to. Nothing is measured. */
#ifndef AOB_COMMAND_LIST_H
#define AOB_COMMAND_LIST_H
#include <stdbool.h>
#include "base/error.h"
#include "run/dispatch.h"

/* what: techniques, scenes or backends. json: a file or "-"; NULL: a table on standard output. */
enum aob_exit aob_list(const struct aob_dispatch *dispatch, const char *what, const char *json,
                       struct aob_error *error);
enum aob_exit aob_plan_print(const struct aob_dispatch *dispatch, const char *config, const char *json,
                             bool quiet, struct aob_error *error);
#endif

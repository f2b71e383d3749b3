/* A message as it travels: through the text of one line. */
#ifndef AOB_TESTS_JOB_SEND_H
#define AOB_TESTS_JOB_SEND_H
#include <jansson.h>
#include <stdlib.h>
#include "base/json.h"
#include "check.h"

/* Takes the message; decref what comes back. */
static json_t *send(json_t *message)
{
    char *line = aob_json_line(message, 17);
    json_t *read = json_loads(line, JSON_REJECT_DUPLICATES, NULL);
    free(line);
    json_decref(message);
    assert_non_null(read);
    return read;
}
#endif

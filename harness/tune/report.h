/* A fit as a document, and as lines for people. */
#ifndef AOB_TUNE_REPORT_H
#define AOB_TUNE_REPORT_H
#include <jansson.h>
#include "tune.h"

/* docs/design.md, tune. `out`: the config that was written, or NULL. A new object. */
json_t *aob_tune_to_json(const struct aob_tune_desc *desc, const struct aob_tune *tune, const char *out);

/* The parameters, what each view gains and costs, and the means, of the setting that is chosen, which there must be; of the others a line
 * each. */
void aob_tune_print(const struct aob_tune *tune, struct aob_text *out);
#endif
